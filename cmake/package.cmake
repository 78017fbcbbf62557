# SPDX-License-Identifier: BSD-3-Clause
# What other projects need to find the headers: CMake package, pkg-config file, archives.
include(CMakePackageConfigHelpers)
include(GNUInstallDirs)

set(package_dir ${CMAKE_INSTALL_DATADIR}/cmake/vcavity)
install(DIRECTORY include/vcavity DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} FILES_MATCHING PATTERN *.hpp)
install(TARGETS vcavity EXPORT vcavity INCLUDES DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(EXPORT vcavity NAMESPACE vcavity:: FILE vcavity-targets.cmake DESTINATION ${package_dir})

# Headers only, so one package serves every architecture. Before 1.0, minor versions may differ in interface.
write_basic_package_version_file(${PROJECT_BINARY_DIR}/vcavity-config-version.cmake
  COMPATIBILITY SameMinorVersion ARCH_INDEPENDENT)
install(FILES cmake/vcavity-config.cmake ${PROJECT_BINARY_DIR}/vcavity-config-version.cmake
        DESTINATION ${package_dir})

# The prefix is found from the place of the file itself, so that an installation may be moved.
file(RELATIVE_PATH prefix_from_pkgconfig
     ${CMAKE_INSTALL_FULL_DATADIR}/pkgconfig ${CMAKE_INSTALL_PREFIX})
string(REGEX REPLACE "/$" "" prefix_from_pkgconfig "${prefix_from_pkgconfig}")
configure_file(cmake/vcavity.pc.in vcavity.pc @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/vcavity.pc DESTINATION ${CMAKE_INSTALL_DATADIR}/pkgconfig)

install(FILES LICENSE DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/vcavity RENAME copyright)

# dpkg-shlibdeps (of dpkg-dev) says which libraries the program needs; a .deb made without it would not start.
set(CPACK_GENERATOR TGZ)
find_program(VCAVITY_DPKG_SHLIBDEPS dpkg-shlibdeps)
mark_as_advanced(VCAVITY_DPKG_SHLIBDEPS)
if(VCAVITY_DPKG_SHLIBDEPS OR NOT VCAVITY_BUILD_TOOLS)
  list(APPEND CPACK_GENERATOR DEB)
else()
  message(STATUS "dpkg-shlibdeps not found (Debian package dpkg-dev): cpack makes no .deb of the program")
endif()
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
    OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_PACKAGE_CONTACT "the vcavity authors")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "${PROJECT_DESCRIPTION}")
set(CPACK_RESOURCE_FILE_LICENSE ${PROJECT_SOURCE_DIR}/LICENSE)
set(CPACK_PACKAGE_VERSION ${PROJECT_VERSION})
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ${VCAVITY_BUILD_TOOLS})
set(CPACK_DEBIAN_PACKAGE_DEPENDS libglm-dev)
include(CPack)
