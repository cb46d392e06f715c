# SPDX-License-Identifier: GPL-2.0-or-later
# muckpile_add_style(<command|fix|pair|compute> <name> <folder>): adds a style's source in the folder to
# muckpile_fixes and insists on its page. `fix muckpile/blast explosive` is explosive/fix_muckpile_blast.cpp and
# docs/styles/fix_muckpile_blast.md; a command has no prefix: blocks/create_blocks.cpp and docs/styles/create_blocks.md.
function(muckpile_add_style kind name folder)
  if(NOT kind MATCHES "^(command|fix|pair|compute)$")
    message(FATAL_ERROR "muckpile_add_style: kind must be command, fix, pair or compute, got '${kind}'")
  endif()
  string(REPLACE "/" "_" stem "${name}")
  if(NOT kind STREQUAL "command")
    string(PREPEND stem "${kind}_")
  endif()
  foreach(needed IN ITEMS "${CMAKE_CURRENT_SOURCE_DIR}/${folder}/${stem}.cpp" "${PROJECT_SOURCE_DIR}/docs/styles/${stem}.md")
    if(NOT EXISTS "${needed}")
      message(FATAL_ERROR "style '${kind} ${name}' needs ${needed} (see CONTRIBUTING.md)")
    endif()
  endforeach()
  target_sources(muckpile_fixes PRIVATE "${CMAKE_CURRENT_SOURCE_DIR}/${folder}/${stem}.cpp")
endfunction()
