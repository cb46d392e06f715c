# SPDX-License-Identifier: GPL-2.0-or-later
"""Version of the package: that of the Muckpile whose results it reads.

Scope: one text, so that packaging can read it without NumPy.
"""

VERSION = "0.1.0"
