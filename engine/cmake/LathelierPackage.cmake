# What is installed where, and the Debian packages that CPack makes of it (./dev package):
#   lathelier-cli  the command line, without Qt and VTK
#   lathelier      the window
# Either stands alone: each has the modules that it loads (engine/core/module.h) in lib/<program>. All paths are relative
# to the program, so any prefix does. Manual, translations, libraries, posts and lessons are inside the programs; the
# files beside them are there to be read and to be copied as a start for one's own.
include(GNUInstallDirs)
set(resources ${CMAKE_SOURCE_DIR}/resources)
set(components cli)
if(LATHELIER_GUI)
    list(APPEND components gui)
endif()
set(program_cli lathelier-cli)
set(program_gui lathelier)
get_property(modules GLOBAL PROPERTY lathelier_module_targets)
# Debian's form of the list of changes: the version and its date.
file(STRINGS ${CMAKE_SOURCE_DIR}/CHANGELOG.md released REGEX "^## \\[${PROJECT_VERSION}\\] - ")
string(REGEX REPLACE "^.* - " "" released "${released}")
execute_process(COMMAND date --utc --rfc-email --date ${released} OUTPUT_VARIABLE released OUTPUT_STRIP_TRAILING_WHITESPACE
                COMMAND_ERROR_IS_FATAL ANY)
set(maintainer "Lathelier developers <lathelier@users.noreply.github.com>")
file(CONFIGURE OUTPUT ${CMAKE_BINARY_DIR}/packed/changelog @ONLY CONTENT
     "lathelier (@PROJECT_VERSION@) bookworm; urgency=medium\n\n  * See CHANGELOG.md beside this file.\n\n -- @maintainer@  @released@\n")
# The assistant beside a control as a service: not enabled by the package.
install(FILES ${resources}/systemd/lathelier-assist@.service DESTINATION lib/systemd/system COMPONENT cli)
foreach(component ${components})
    set(program ${program_${component}})
    install(TARGETS ${program} COMPONENT ${component})
    install(TARGETS ${modules} LIBRARY DESTINATION lib/${program} COMPONENT ${component})
    foreach(folder library posts training)
        install(DIRECTORY ${resources}/${folder} DESTINATION ${CMAKE_INSTALL_DATADIR}/${program} COMPONENT ${component})
    endforeach()
    install(DIRECTORY ${resources}/manual DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/${program} COMPONENT ${component})
    install(FILES ${resources}/desktop/copyright DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/${program} COMPONENT ${component})
    # Debian wants its manual pages and the list of changes compressed, without a time stamp.
    find_program(LATHELIER_GZIP gzip REQUIRED)
    foreach(pair "${CMAKE_BINARY_DIR}/packed/changelog|changelog.gz|doc/${program}"
                 "${CMAKE_SOURCE_DIR}/CHANGELOG.md|CHANGELOG.md.gz|doc/${program}"
                 "${resources}/desktop/${program}.1|${program}.1.gz|man/man1")
        string(REPLACE "|" ";" pair "${pair}")
        list(GET pair 0 source)
        list(GET pair 1 name)
        list(GET pair 2 folder)
        set(packed ${CMAKE_BINARY_DIR}/packed/${component}/${name})
        add_custom_command(OUTPUT ${packed} DEPENDS ${source} VERBATIM
            COMMAND sh -c "mkdir -p \"$(dirname \"$2\")\" && ${LATHELIER_GZIP} -9nc \"$1\" > \"$2\"" sh ${source} ${packed})
        list(APPEND packed_files ${packed})
        install(FILES ${packed} DESTINATION ${CMAKE_INSTALL_DATADIR}/${folder} COMPONENT ${component})
    endforeach()
endforeach()
add_custom_target(lathelier_packed ALL DEPENDS ${packed_files})
if(LATHELIER_GUI)
    install(FILES ${resources}/desktop/lathelier.desktop DESTINATION ${CMAKE_INSTALL_DATADIR}/applications COMPONENT gui)
    install(FILES ${resources}/desktop/lathelier.metainfo.xml DESTINATION ${CMAKE_INSTALL_DATADIR}/metainfo COMPONENT gui)
    install(FILES ${resources}/desktop/lathelier-mime.xml RENAME lathelier.xml
            DESTINATION ${CMAKE_INSTALL_DATADIR}/mime/packages COMPONENT gui)
    install(FILES ${resources}/icons/lathelier.svg DESTINATION ${CMAKE_INSTALL_DATADIR}/icons/hicolor/scalable/apps
            COMPONENT gui)
endif()

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME lathelier)
set(CPACK_PACKAGE_VERSION ${PROJECT_VERSION})
set(CPACK_PACKAGE_CONTACT "${maintainer}")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "workbench for turning shops")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ
    WORLD_EXECUTE)
set(CPACK_COMPONENTS_ALL ${components})
set(CPACK_COMPONENTS_GROUPING IGNORE)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_COMPRESSION_TYPE xz)
set(CPACK_DEBIAN_CLI_PACKAGE_NAME lathelier-cli)
set(CPACK_DEBIAN_GUI_PACKAGE_NAME lathelier)
set(CPACK_DEBIAN_GUI_PACKAGE_DEPENDS fonts-dejavu-core)  # the 3-D view draws its letters from the file
set(CPACK_DEBIAN_GUI_PACKAGE_RECOMMENDS "lathelier-cli (= ${PROJECT_VERSION}), qttranslations5-l10n, libgl1-mesa-dri")
set(about "Follows a turned part full circle: compares scans of copies with their
originals, judges roundness and cylindricity, recognises worn parts and
draws them, finds speeds without chatter, predicts and corrects the
deflection of slender work, writes and checks turning programs, and works
without a network.")
set(CPACK_COMPONENT_CLI_DESCRIPTION "${about}\n.\nThis package is the command line: it needs neither Qt nor a display.")
set(CPACK_COMPONENT_GUI_DESCRIPTION "${about}\n.\nThis package is the window.")
include(CPack)
