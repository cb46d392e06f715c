# SPDX-License-Identifier: GPL-2.0-or-later
"""The one exception for faults in results.

Scope: its text names the file, what is wrong in it and what to do.
"""


class ResultError(Exception):
    """Files of a run that are missing, cut short, damaged or of another run, or a question that
    this run has no answer to."""
