# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause

# What reads and writes bags: kept out of slam_ros, so that only these programs link rosbag.
find_package(rosbag_storage REQUIRED)
find_package(rosgraph_msgs REQUIRED)
find_package(roslib REQUIRED)

function(slam_ros_bag_target target)
  slam_ros_target(${target})
  target_include_directories(${target} SYSTEM PRIVATE
    ${rosbag_storage_INCLUDE_DIRS} ${rosgraph_msgs_INCLUDE_DIRS} ${roslib_INCLUDE_DIRS})
endfunction()

add_library(slam_ros_bags
  src/bag_clock.cpp
  src/bag_flow.cpp
  src/bag_file.cpp
  src/bag_inputs.cpp
  src/bag_process.cpp
  src/earlier_messages.cpp
  src/bag_reader.cpp
  src/bag_run.cpp
  src/bag_transforms.cpp
  src/flow_window.cpp
  src/ground_truth.cpp
  src/offline_run.cpp
  src/run_origin.cpp
  src/product_files.cpp
  src/tune_run.cpp
  src/warning_log.cpp
)
slam_ros_bag_target(slam_ros_bags)
target_link_libraries(slam_ros_bags
  PUBLIC slam_ros slam_core::tuning ${rosbag_storage_LIBRARIES}
  PRIVATE fmt::fmt nlohmann_json::nlohmann_json ${roslib_LIBRARIES})

add_library(slam_ros_bag_source src/bag_source_nodelet.cpp)
slam_ros_bag_target(slam_ros_bag_source)
target_link_libraries(slam_ros_bag_source PRIVATE slam_ros_bags)

add_executable(slam_ros_offline src/slam_offline.cpp)
add_executable(slam_ros_merge src/slam_merge.cpp)
add_executable(slam_ros_ground_truth src/slam_ground_truth.cpp)
add_executable(slam_ros_parameters src/slam_parameters.cpp src/parameter_check.cpp)
add_executable(slam_ros_ports src/slam_ports.cpp src/product_ports.cpp)
add_executable(slam_ros_tune src/slam_tune.cpp)
add_executable(slam_ros_vocabulary src/slam_vocabulary.cpp)
set_target_properties(slam_ros_offline PROPERTIES OUTPUT_NAME slam_offline)
set_target_properties(slam_ros_merge PROPERTIES OUTPUT_NAME slam_merge)
set_target_properties(slam_ros_ground_truth PROPERTIES OUTPUT_NAME slam_ground_truth)
set_target_properties(slam_ros_parameters PROPERTIES OUTPUT_NAME slam_parameters)
set_target_properties(slam_ros_ports PROPERTIES OUTPUT_NAME slam_ports)
set_target_properties(slam_ros_tune PROPERTIES OUTPUT_NAME slam_tune)
set_target_properties(slam_ros_vocabulary PROPERTIES OUTPUT_NAME slam_vocabulary)
foreach(target
        slam_ros_offline slam_ros_ground_truth slam_ros_merge slam_ros_parameters slam_ros_ports
        slam_ros_tune slam_ros_vocabulary)
  slam_ros_bag_target(${target})
  target_link_libraries(${target} PRIVATE slam_ros_bags slam_ros_command_line fmt::fmt)
endforeach()
target_link_libraries(slam_ros_ports PRIVATE nlohmann_json::nlohmann_json)

install(TARGETS slam_ros_bags slam_ros_bag_source LIBRARY DESTINATION ${CATKIN_PACKAGE_LIB_DESTINATION})
install(TARGETS
        slam_ros_offline slam_ros_ground_truth slam_ros_merge slam_ros_parameters slam_ros_ports
        slam_ros_tune slam_ros_vocabulary
  RUNTIME DESTINATION ${CATKIN_PACKAGE_BIN_DESTINATION})
catkin_install_python(PROGRAMS scripts/slam_run
  DESTINATION ${CATKIN_PACKAGE_BIN_DESTINATION})

if(CATKIN_ENABLE_TESTING)
  catkin_add_gtest(slam_ros_test_bags
    test/bags/test_bag_flow.cpp
    test/bags/test_bag_reader.cpp
    test/bags/test_camera_bags.cpp
    test/bags/test_command_bags.cpp
    test/bags/test_damaged_bags.cpp
    test/bags/test_flow_and_metrics.cpp
    test/bags/test_offline_run.cpp
    test/bags/test_run_origin.cpp
    test/bags/test_imu_bags.cpp
    test/bags/test_scan_bags.cpp
    test/bags/test_carried_data.cpp
    test/bags/test_topic_matching.cpp
    test/bags/test_topic_remaps.cpp
    test/bags/test_tune_run.cpp
    test/bags/test_warning_log.cpp
  )
  slam_ros_bag_target(slam_ros_test_bags)
  target_link_libraries(slam_ros_test_bags
    slam_ros_bags nlohmann_json::nlohmann_json
    opencv_aruco opencv_imgcodecs opencv_imgproc ${GTEST_MAIN_LIBRARIES})
  target_compile_definitions(slam_ros_test_bags PRIVATE
    SLAM_OFFLINE="$<TARGET_FILE:slam_ros_offline>" SLAM_TUNE="$<TARGET_FILE:slam_ros_tune>"
    ODD_COMPONENTS="$<TARGET_FILE:slam_ros_test_components>")
  add_dependencies(slam_ros_test_bags slam_ros_offline slam_ros_test_components slam_ros_tune)
  add_library(slam_ros_test_components test/ports/odd_components.cpp)
  slam_ros_target(slam_ros_test_components)
  target_link_libraries(slam_ros_test_components slam_core::product)
  catkin_add_gtest(slam_ros_test_ports test/ports/test_slam_ports.cpp)
  slam_ros_target(slam_ros_test_ports)
  target_link_libraries(slam_ros_test_ports nlohmann_json::nlohmann_json ${GTEST_MAIN_LIBRARIES})
  target_compile_definitions(slam_ros_test_ports PRIVATE
    SLAM_PORTS="$<TARGET_FILE:slam_ros_ports>"
    ODD_COMPONENTS="$<TARGET_FILE:slam_ros_test_components>")
  add_dependencies(slam_ros_test_ports slam_ros_ports slam_ros_test_components)
  catkin_add_nosetests(test/bags/test_slam_run.py)
endif()
