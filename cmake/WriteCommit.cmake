# SPDX-License-Identifier: GPL-2.0-or-later
# cmake -DSOURCE=<dir> -DHEADER=<file> -P WriteCommit.cmake: writes the commit of the source into a header, at each build;
# the header is touched only when that has changed. "-dirty" if tracked files differ, "unknown" without git.
set(commit "")
find_program(GIT_EXECUTABLE git)
if(GIT_EXECUTABLE AND EXISTS "${SOURCE}/.git")
  # Who builds may not own the folder: containers.
  set(git "${GIT_EXECUTABLE}" -c safe.directory=* -C "${SOURCE}")
  execute_process(COMMAND ${git} rev-parse HEAD OUTPUT_VARIABLE commit OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
  execute_process(COMMAND ${git} --no-optional-locks status --porcelain --untracked-files=no
    OUTPUT_VARIABLE changes OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
endif()
if(commit STREQUAL "")
  set(commit unknown)
elseif(NOT changes STREQUAL "")
  string(APPEND commit -dirty)
endif()
set(text "#define MUCKPILE_COMMIT \"${commit}\"\n")
set(before "")
if(EXISTS "${HEADER}")
  file(READ "${HEADER}" before)
endif()
if(NOT text STREQUAL before)
  file(WRITE "${HEADER}" "${text}")
endif()
