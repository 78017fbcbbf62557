# SPDX-License-Identifier: BSD-3-Clause
# Fails when a file includes one of a room above its own, or when a header of the library is not reachable from the
# umbrella. Run as: cmake -DROOT=... -P check_layers.cmake
cmake_minimum_required(VERSION 3.25)

# From the ground up: a file uses only rooms named before its own, and its own.
set(library_rooms numbers conventions.hpp facet groove polarization hemisphere profiles matte render rough plan)
set(tool_rooms support materials colour images surfaces kernel maps cost commands main.cpp)

set(failures 0)

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
