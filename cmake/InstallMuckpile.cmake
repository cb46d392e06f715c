# SPDX-License-Identifier: GPL-2.0-or-later
# Installs muckpile_core for other projects: find_package(Muckpile) gives muckpile::core.
# The programs install themselves where they are made.
include(CMakePackageConfigHelpers)
set(_package_dir "${CMAKE_INSTALL_LIBDIR}/cmake/Muckpile")

set_target_properties(muckpile_core PROPERTIES EXPORT_NAME core)
install(TARGETS muckpile_core EXPORT MuckpileTargets ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(DIRECTORY "${PROJECT_SOURCE_DIR}/src/core/" DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/muckpile
  FILES_MATCHING PATTERN "*.h")
install(EXPORT MuckpileTargets NAMESPACE muckpile:: DESTINATION ${_package_dir})

configure_package_config_file("${PROJECT_SOURCE_DIR}/cmake/MuckpileConfig.cmake.in"
  "${PROJECT_BINARY_DIR}/MuckpileConfig.cmake" INSTALL_DESTINATION ${_package_dir})
# Exact: laws and file formats may change in any 0.x version.
write_basic_package_version_file("${PROJECT_BINARY_DIR}/MuckpileConfigVersion.cmake"
  COMPATIBILITY ExactVersion)
install(FILES "${PROJECT_BINARY_DIR}/MuckpileConfig.cmake" "${PROJECT_BINARY_DIR}/MuckpileConfigVersion.cmake"
  DESTINATION ${_package_dir})
