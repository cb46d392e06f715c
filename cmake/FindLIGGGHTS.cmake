# SPDX-License-Identifier: GPL-2.0-or-later
# Imported target LIGGGHTS::liggghts: headers, library and MPI of LIGGGHTS 3.8 (Debian: libliggghts-dev).
# The headers carry LAMMPS' date only, the library's file name (libliggghts.so.3.8.0) LIGGGHTS' own version.
# A library of another name: -DLIGGGHTS_VERSION=3.8.0 says what it is.
find_package(MPI QUIET COMPONENTS CXX)
find_path(LIGGGHTS_INCLUDE_DIR NAMES fix_multisphere.h PATH_SUFFIXES liggghts)
find_library(LIGGGHTS_LIBRARY NAMES liggghts)
mark_as_advanced(LIGGGHTS_INCLUDE_DIR LIGGGHTS_LIBRARY)

if(LIGGGHTS_LIBRARY AND NOT LIGGGHTS_VERSION)
  file(REAL_PATH "${LIGGGHTS_LIBRARY}" _liggghts_file)
  get_filename_component(_liggghts_file "${_liggghts_file}" NAME)
  string(REGEX MATCH "[0-9]+\\.[0-9]+(\\.[0-9]+)?" LIGGGHTS_VERSION "${_liggghts_file}")
endif()

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(LIGGGHTS
  REQUIRED_VARS LIGGGHTS_LIBRARY LIGGGHTS_INCLUDE_DIR MPI_CXX_FOUND
  VERSION_VAR LIGGGHTS_VERSION
  REASON_FAILURE_MESSAGE "install libliggghts-dev and libopenmpi-dev (./muckpile install-deps)")
if(LIGGGHTS_FOUND AND NOT LIGGGHTS_VERSION MATCHES "^3\\.8(\\.|$)")
  message(FATAL_ERROR "Muckpile reaches into LIGGGHTS 3.8.x; ${LIGGGHTS_LIBRARY} is version "
    "'${LIGGGHTS_VERSION}'. If that is wrong, give the version with -DLIGGGHTS_VERSION=3.8.0.")
endif()

if(LIGGGHTS_FOUND AND NOT TARGET LIGGGHTS::liggghts)
  add_library(LIGGGHTS::liggghts UNKNOWN IMPORTED)
  set_target_properties(LIGGGHTS::liggghts PROPERTIES
    IMPORTED_LOCATION "${LIGGGHTS_LIBRARY}"
    INTERFACE_INCLUDE_DIRECTORIES "${LIGGGHTS_INCLUDE_DIR}"
    INTERFACE_LINK_LIBRARIES MPI::MPI_CXX)
endif()
