# The installed package: find_package(RANSMeshing) gives RANSMeshing::Core, ::Surface, ::TetGen, ::BoundaryLayer,
# ::IO.
include(CMakePackageConfigHelpers)
configure_package_config_file(
  "${PROJECT_SOURCE_DIR}/Filters/CMake/RANSMeshingConfig.cmake.in"
  "${PROJECT_BINARY_DIR}/RANSMeshingConfig.cmake"
  INSTALL_DESTINATION "${RANSMESHING_CMAKE_DIR}")
write_basic_package_version_file("${PROJECT_BINARY_DIR}/RANSMeshingConfigVersion.cmake"
  COMPATIBILITY SameMinorVersion)
install(FILES
  "${PROJECT_BINARY_DIR}/RANSMeshingConfig.cmake"
  "${PROJECT_BINARY_DIR}/RANSMeshingConfigVersion.cmake"
  DESTINATION "${RANSMESHING_CMAKE_DIR}")
install(FILES "${PROJECT_SOURCE_DIR}/LICENSE" DESTINATION "${CMAKE_INSTALL_DOCDIR}")
