# SPDX-License-Identifier: BSD-3-Clause
include(CMakeFindDependencyMacro)
if(NOT TARGET glm::glm)
  find_dependency(glm)
endif()
include(${CMAKE_CURRENT_LIST_DIR}/vcavity-targets.cmake)
