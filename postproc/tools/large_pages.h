// SPDX-License-Identifier: GPL-2.0-or-later
// Memory in large pages: half of the time of a run of 200,000 blocks is spent on the page faults
// of millions of small allocations otherwise (docs/perf.md).
#pragma once

namespace muckpile {

// Starts the program once more with glibc told to ask the system for large pages and for memory in
// pieces of 64 MB. glibc reads that from GLIBC_TUNABLES before main() only. Returns, with nothing
// changed, where the user has set the variable, at the second start, and where there is no glibc
// or no second start. argv: that of main(), ended by a null pointer.
void start_with_large_pages(char** argv);

}  // namespace muckpile
