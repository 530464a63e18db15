# SPDX-License-Identifier: Apache-2.0
# What is installed beside the programs, the exported library, and packages (DEB, TGZ).
include(CMakePackageConfigHelpers)

install(DIRECTORY shaders assets DESTINATION ${CMAKE_INSTALL_DATADIR}/myoface)
install(DIRECTORY docs/user DESTINATION ${CMAKE_INSTALL_DATADIR}/myoface/docs)
install(FILES LICENSE README.md CHANGELOG.md DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(FILES packaging/myoface.desktop DESTINATION ${CMAKE_INSTALL_DATADIR}/applications)
install(FILES packaging/myoface-mime.xml DESTINATION ${CMAKE_INSTALL_DATADIR}/mime/packages
        RENAME myoface.xml)
install(FILES assets/icons/myoface.svg
        DESTINATION ${CMAKE_INSTALL_DATADIR}/icons/hicolor/scalable/apps)
install(FILES packaging/myoface.1 packaging/myoface-cli.1 DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)
install(FILES packaging/myoface-cli.bash
        DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions RENAME myoface-cli)

# find_package(myoface) and link myoface::core.
set(config_dir ${CMAKE_INSTALL_LIBDIR}/cmake/myoface)
install(TARGETS myoface_core EXPORT myoface-targets ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(DIRECTORY include/myoface DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(EXPORT myoface-targets NAMESPACE myoface:: DESTINATION ${config_dir})
configure_package_config_file(cmake/myoface-config.cmake.in
  ${CMAKE_BINARY_DIR}/myoface-config.cmake INSTALL_DESTINATION ${config_dir})
write_basic_package_version_file(${CMAKE_BINARY_DIR}/myoface-config-version.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_BINARY_DIR}/myoface-config.cmake
              ${CMAKE_BINARY_DIR}/myoface-config-version.cmake DESTINATION ${config_dir})

set(CPACK_GENERATOR DEB TGZ)
set(CPACK_PACKAGE_NAME myoface)
set(CPACK_PACKAGE_VENDOR Myoface)
set(CPACK_PACKAGE_CONTACT "The Myoface developers <developers@myoface.invalid>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "${PROJECT_DESCRIPTION}")
set(CPACK_RESOURCE_FILE_LICENSE ${PROJECT_SOURCE_DIR}/LICENSE)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_DEPENDS "libqt5svg5, libgl1-mesa-dri | libgl1, fonts-dejavu-core")
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "fonts-ipafont-gothic | fonts-noto-cjk")
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
include(CPack)
