# SPDX-FileCopyrightText: 2026 the SLAM product line authors
# SPDX-License-Identifier: BSD-3-Clause

# How the cameras see a world: part of slam_sim_core.
find_package(apriltag REQUIRED)
if(TARGET apriltag::apriltag-utils)
  # The package makes only its other target global, and then refuses to be found by another folder.
  set_target_properties(apriltag::apriltag-utils PROPERTIES IMPORTED_GLOBAL TRUE)
endif()

set(slam_sim_cameras ${CMAKE_CURRENT_LIST_DIR}/..)
target_sources(slam_sim_core PRIVATE
  ${slam_sim_cameras}/src/camera_rays.cpp
  ${slam_sim_cameras}/src/camera_renderer.cpp
  ${slam_sim_cameras}/src/ceiling_texture.cpp
  ${slam_sim_cameras}/src/dead_leaves.cpp
  ${slam_sim_cameras}/src/fractal_noise.cpp
  ${slam_sim_cameras}/src/light_map.cpp
  ${slam_sim_cameras}/src/marker_stand.cpp
  ${slam_sim_cameras}/src/marker_texture.cpp
  ${slam_sim_cameras}/src/painted_wall.cpp
  ${slam_sim_cameras}/src/patterned_textures.cpp
  ${slam_sim_cameras}/src/pixel_noise.cpp
  ${slam_sim_cameras}/src/sample_pattern.cpp
  ${slam_sim_cameras}/src/scene.cpp
  ${slam_sim_cameras}/src/scene_textures.cpp
  ${slam_sim_cameras}/src/surface_textures.cpp
  ${slam_sim_cameras}/src/texture.cpp
  ${slam_sim_cameras}/src/texture_sampler.cpp
  ${slam_sim_cameras}/src/tile_renderer.cpp
  ${slam_sim_cameras}/src/viewed_surface.cpp)
target_link_libraries(slam_sim_core PRIVATE apriltag::apriltag
  $<TARGET_NAME_IF_EXISTS:apriltag::apriltag-utils>)

if(CATKIN_ENABLE_TESTING)
  catkin_add_gtest(slam_sim_camera_tests
    ${slam_sim_cameras}/test/camera_geometry_test.cpp
    ${slam_sim_cameras}/test/camera_image_test.cpp
    ${slam_sim_cameras}/test/tag_reader.cpp
    ${slam_sim_cameras}/test/textures_test.cpp
    ${slam_sim_cameras}/test/visible_features_test.cpp)
  slam_sim_target(slam_sim_camera_tests)
  target_link_libraries(slam_sim_camera_tests
    slam_sim_core apriltag::apriltag opencv_imgproc opencv_imgcodecs opencv_aruco opencv_features2d
    ${GTEST_MAIN_LIBRARIES})
endif()
