# SPDX-License-Identifier: BSD-3-Clause
# Installs vcavity to a scratch prefix and builds the consumer against it in every documented way.
#   cmake -D source=… -D scratch=… -D compiler=… -D version=… -D generator=… -P check_package.cmake

set(ENV{CMAKE_GENERATOR} ${generator})  # of all that follows

function(run)
  execute_process(COMMAND ${ARGV} RESULT_VARIABLE status OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(NOT status EQUAL 0)
    list(JOIN ARGV " " command)
    message(FATAL_ERROR "${command}\nended with ${status}:\n${output}")
  endif()
endfunction()

# The consumer prints the version and the white furnace, computed by the headers it found.
function(expect_output program)
  execute_process(COMMAND "${program}" OUTPUT_VARIABLE output COMMAND_ERROR_IS_FATAL ANY)
  if(NOT output STREQUAL "vcavity ${version}: a white groove reflects 1.000\n")
    message(FATAL_ERROR "${program} printed:\n${output}")
  endif()
endfunction()

file(REMOVE_RECURSE ${scratch})
set(prefix "${scratch}/a prefix")
set(consumer ${source}/tests/package/consumer)
set(without_tools)
foreach(package OpenEXR Imath yaml-cpp CLI11 TBB nlohmann_json embree Catch2 Boost PkgConfig)
  list(APPEND without_tools -D CMAKE_DISABLE_FIND_PACKAGE_${package}=ON)
endforeach()

run(${CMAKE_COMMAND} -S ${source} -B ${scratch}/vcavity -D CMAKE_CXX_COMPILER=${compiler} ${without_tools}
    -D VCAVITY_BUILD_TOOLS=OFF -D VCAVITY_BUILD_TESTS=OFF -D VCAVITY_BUILD_EXAMPLES=OFF)
run(${CMAKE_COMMAND} --install ${scratch}/vcavity --prefix ${prefix})
# What follows must work without the place of installation that was configured, from wherever it is now.
file(RENAME ${prefix} "${scratch}/moved (prefix) $it & ü")
set(prefix "${scratch}/moved (prefix) $it & ü")

# Of the names of folders nothing is asked.
foreach(way find_package add_subdirectory FetchContent own_glm)
  set(build "${scratch}/${way} (build) $it & ü")
  run(${CMAKE_COMMAND} -S ${consumer} -B "${build}" -D CMAKE_CXX_COMPILER=${compiler} ${without_tools}
      -D way=${way} -D "CMAKE_PREFIX_PATH=${prefix}" -D vcavity_source=${source} -D wanted=${version})
  run(${CMAKE_COMMAND} --build "${build}")
  expect_output("${build}/consumer")
endforeach()

# A version that is not there is refused.
execute_process(
  COMMAND ${CMAKE_COMMAND} -S ${consumer} -B ${scratch}/other_version -D CMAKE_CXX_COMPILER=${compiler}
          -D way=find_package -D "CMAKE_PREFIX_PATH=${prefix}" -D wanted=99.0
  RESULT_VARIABLE status OUTPUT_QUIET ERROR_VARIABLE output)
if(status EQUAL 0 OR NOT output MATCHES "version: ${version}")
  message(FATAL_ERROR "version 99.0 was not refused:\n${output}")
endif()

find_program(pkg_config pkg-config)
if(pkg_config)
  set(ENV{PKG_CONFIG_PATH} "${prefix}/share/pkgconfig")
  execute_process(COMMAND ${pkg_config} --cflags "vcavity = ${version}" OUTPUT_VARIABLE flags
                  OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
  separate_arguments(flags UNIX_COMMAND "${flags}")
  run(${compiler} -std=c++20 -Wall -Wextra -Werror ${flags} ${consumer}/main.cpp ${consumer}/second.cpp
      -o ${scratch}/by_pkg_config)
  expect_output(${scratch}/by_pkg_config)
endif()
