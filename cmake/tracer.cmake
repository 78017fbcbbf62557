# SPDX-License-Identifier: BSD-3-Clause
# An independent check of the closed form by ray tracing, for the tests and as a method of `vcavity_maps cost`. It
# needs Embree, version 4 or 3; everything else does not.
find_package(embree 4 QUIET)
if(NOT embree_FOUND)
  find_package(embree 3 QUIET)
endif()
if(NOT embree_FOUND)
  message(STATUS "Embree 4 or 3 not found: leaving out the ray tracer and all that is compared with it")
  return()
endif()
message(STATUS "Ray tracer: Embree ${embree_VERSION}")

# The tracer is not linked to vcavity: it could not include a header of it by mistake.
set(tracer ${PROJECT_SOURCE_DIR}/tests/tracer)
add_library(groove_tracer STATIC
  ${tracer}/embree_scene.cpp
  ${tracer}/light_ray.cpp
  ${tracer}/relief.cpp
  ${tracer}/tracer.cpp)
target_include_directories(groove_tracer PUBLIC ${tracer})
target_compile_features(groove_tracer PUBLIC cxx_std_20)
target_compile_definitions(groove_tracer PUBLIC GLM_FORCE_XYZW_ONLY)
target_link_libraries(groove_tracer PUBLIC glm::glm PRIVATE embree vcavity_options)
