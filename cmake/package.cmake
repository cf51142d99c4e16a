# What lets others find_package(ice_ice_baby): the targets, and without catkin, which writes its own,
# the files that CMake looks for.
install(EXPORT ${PROJECT_NAME}-targets NAMESPACE ${PROJECT_NAME}::
  DESTINATION ${IIB_INSTALL_CMAKE})
if(IIB_ROS)
  export(EXPORT ${PROJECT_NAME}-targets NAMESPACE ${PROJECT_NAME}::
    FILE ${CATKIN_DEVEL_PREFIX}/share/${PROJECT_NAME}/cmake/${PROJECT_NAME}-targets.cmake)
else()
  #catkin_lint: ignore missing_file wrong_install_destination
  include(CMakePackageConfigHelpers)
  set(generated ${CMAKE_CURRENT_BINARY_DIR}/${PROJECT_NAME}Config)
  configure_file(cmake/${PROJECT_NAME}-extras.cmake.in ${generated}.cmake @ONLY)
  write_basic_package_version_file(${generated}Version.cmake COMPATIBILITY SameMinorVersion)
  install(FILES ${generated}.cmake ${generated}Version.cmake DESTINATION ${IIB_INSTALL_CMAKE})
endif()
