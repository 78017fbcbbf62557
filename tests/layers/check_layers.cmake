# SPDX-License-Identifier: BSD-3-Clause
# Fails when a file includes one of a room above its own, when a header of the library is not reachable from the
# umbrella, or when the core no longer reads in one sitting. Run as: cmake -DROOT=... -P check_layers.cmake
cmake_minimum_required(VERSION 3.25)

# From the ground up: a file uses only rooms named before its own, and its own.
set(library_rooms numbers conventions.hpp facet groove polarization hemisphere profiles matte render rough plan)
set(tool_rooms support materials colour images surfaces kernel maps cost commands main.cpp)

# The core, from a ray to the directional reflectance: no more lines than one reads in one sitting.
set(core_headers groove/cavity.hpp groove/unfolding.hpp groove/lit_opening.hpp groove/lobes.hpp groove/reflectance.hpp)
set(core_max_lines 600)

# The floor of a path below the folder that holds the rooms; -1 if it is in no room.
function(floor_of path rooms result)
  string(REGEX MATCH "^[^/]+" room "${path}")
  list(FIND rooms "${room}" floor)
  set(${result} ${floor} PARENT_SCOPE)
endfunction()

# Checks the includes of one tree of rooms.
# folder: where the rooms lie; prefix: with which its includes begin
macro(check_tree folder prefix rooms)
  file(GLOB_RECURSE files RELATIVE ${folder} ${folder}/*.hpp ${folder}/*.cpp)
  if(NOT files)
    message(SEND_ERROR "no files in ${folder}")
  endif()
  foreach(file ${files})
    floor_of(${file} "${rooms}" floor)
    file(STRINGS ${folder}/${file} lines REGEX "^#include [<\"]${prefix}/")
    set(includes_of_${file} "")
    foreach(line ${lines})
      string(REGEX REPLACE "^#include [<\"]${prefix}/([^>\"]+).*" "\\1" included "${line}")
      list(APPEND includes_of_${file} ${included})
      floor_of(${included} "${rooms}" included_floor)
      if(floor GREATER -1 AND included_floor GREATER floor)
        message(SEND_ERROR "${prefix}/${file} includes ${prefix}/${included}, which is in a room above its own")
      endif()
    endforeach()
    if(floor EQUAL -1 AND NOT file MATCHES "^(vcavity|version)\\.hpp$")
      message(SEND_ERROR "${prefix}/${file} is in no room that is known; see ${CMAKE_CURRENT_LIST_FILE}")
    endif()
  endforeach()
endmacro()

check_tree(${ROOT}/src/tools tools "${tool_rooms}")
check_tree(${ROOT}/include/vcavity vcavity "${library_rooms}")

# What the umbrella reaches, one step of inclusion after the other.
set(reached vcavity.hpp)
set(new vcavity.hpp)
while(new)
  set(next "")
  foreach(file ${new})
    foreach(included ${includes_of_${file}})
      if(NOT included IN_LIST reached)
        list(APPEND reached ${included})
        list(APPEND next ${included})
      endif()
    endforeach()
  endforeach()
  set(new ${next})
endwhile()
foreach(file ${files})
  if(NOT file IN_LIST reached)
    message(SEND_ERROR "vcavity/${file} is not reachable from vcavity.hpp")
  endif()
endforeach()

set(core_lines 0)
foreach(file ${core_headers})
  file(READ ${ROOT}/include/vcavity/${file} text)
  # Lines are counted in what is left: a list of CMake has its own idea of semicolons and brackets.
  string(REGEX REPLACE "[^\n]" "" text "${text}")
  string(LENGTH "${text}" lines)
  math(EXPR core_lines "${core_lines} + ${lines}")
endforeach()
if(core_lines GREATER core_max_lines)
  message(SEND_ERROR "the core has ${core_lines} lines in ${core_headers}, more than the ${core_max_lines} of one sitting")
endif()
file(READ ${ROOT}/docs/structure.md page)
if(NOT page MATCHES "in ${core_lines}[ \n]lines")
  message(SEND_ERROR "docs/structure.md does not say that the core has ${core_lines} lines; run scripts/structure.py")
endif()
