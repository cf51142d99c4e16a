# Where tests are built: with catkin by its target `tests`, so that a plain catkin_make builds none;
# without it by `all` too, as usual with CTest.
if(NOT TARGET tests)
  add_custom_target(tests)
endif()
find_package(GTest)
if(NOT GTest_FOUND AND NOT GTEST_FOUND)
  message(FATAL_ERROR "The tests need GoogleTest (libgtest-dev). To build without tests:
-DCATKIN_ENABLE_TESTING=OFF, without ROS -DBUILD_TESTING=OFF")
endif()
# The names of GoogleTest's own CMake package, which CMake's finder gives from 3.20 on.
if(NOT TARGET GTest::gtest)
  add_library(GTest::gtest INTERFACE IMPORTED GLOBAL)
  target_link_libraries(GTest::gtest INTERFACE GTest::GTest)
  add_library(GTest::gtest_main INTERFACE IMPORTED GLOBAL)
  target_link_libraries(GTest::gtest_main INTERFACE GTest::GTest GTest::Main)
endif()
include(GoogleTest)

# Tests of a folder, all of whose targets are built for testing alone.
function(iib_add_tests folder)
  set(built_by_all "")
  if(IIB_ROS)
    set(built_by_all EXCLUDE_FROM_ALL)
  endif()
  add_subdirectory(${folder} ${built_by_all})
  get_property(targets DIRECTORY ${folder} PROPERTY BUILDSYSTEM_TARGETS)
  if(targets)
    add_dependencies(tests ${targets})
  endif()
endfunction()

# Labels the tests of the calling folder. rostest calls a run that was broken off before its first
# test a success.
function(iib_label_ros_tests)
  get_property(tests DIRECTORY PROPERTY TESTS)
  set_tests_properties(${tests} PROPERTIES LABELS ros FAIL_REGULAR_EXPRESSION " \\* TESTS: 0")
endfunction()
