# SPDX-License-Identifier: GPL-2.0-or-later
# Imported target LIGGGHTS::liggghts: headers, library and MPI of LIGGGHTS 3.8 (Debian: libliggghts-dev).
find_package(MPI QUIET COMPONENTS CXX)
find_path(LIGGGHTS_INCLUDE_DIR NAMES fix_multisphere.h PATH_SUFFIXES liggghts)
find_library(LIGGGHTS_LIBRARY NAMES liggghts)

# The headers carry LAMMPS' date only; the library's file name carries LIGGGHTS' own version.
if(LIGGGHTS_LIBRARY)
  file(REAL_PATH "${LIGGGHTS_LIBRARY}" _library)
  string(REGEX MATCH "[0-9]+\\.[0-9]+(\\.[0-9]+)?" LIGGGHTS_VERSION "${_library}")
endif()

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(LIGGGHTS
  REQUIRED_VARS LIGGGHTS_LIBRARY LIGGGHTS_INCLUDE_DIR MPI_CXX_FOUND
  VERSION_VAR LIGGGHTS_VERSION
  REASON_FAILURE_MESSAGE "install libliggghts-dev and libopenmpi-dev")
if(LIGGGHTS_FOUND AND NOT LIGGGHTS_VERSION MATCHES "^3\\.8")
  message(FATAL_ERROR "Muckpile is written for LIGGGHTS 3.8.x, found '${LIGGGHTS_VERSION}' in ${LIGGGHTS_INCLUDE_DIR}")
endif()

if(LIGGGHTS_FOUND AND NOT TARGET LIGGGHTS::liggghts)
  add_library(LIGGGHTS::liggghts UNKNOWN IMPORTED)
  set_target_properties(LIGGGHTS::liggghts PROPERTIES
    IMPORTED_LOCATION "${LIGGGHTS_LIBRARY}"
    INTERFACE_INCLUDE_DIRECTORIES "${LIGGGHTS_INCLUDE_DIR}"
    INTERFACE_LINK_LIBRARIES MPI::MPI_CXX)
endif()
