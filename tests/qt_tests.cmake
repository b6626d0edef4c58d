# Widgets, panels and the window, driven as a user would: tests/widgets/<folder>/*_test.cpp and tests/app/*_test.cpp, one
# Qt Test program each. Those that show 3-D need an X server, because VTK draws nothing on the offscreen platform.
find_program(LATHELIER_XVFB xvfb-run)

function(add_widget_test name source screen)
    add_executable(test_${name} ${source})
    add_dependencies(test_${name} lathelier_modules)
    set_target_properties(test_${name} PROPERTIES AUTOMOC ON)
    target_link_libraries(test_${name} PRIVATE ${ARGN} Qt5::Test)
    target_compile_definitions(test_${name} PRIVATE LATHELIER_SOURCE_DIR="${CMAKE_SOURCE_DIR}")
    if(screen STREQUAL offscreen)
        add_test(NAME ${name} COMMAND test_${name})
        set_tests_properties(${name} PROPERTIES ENVIRONMENT QT_QPA_PLATFORM=offscreen)
    elseif(LATHELIER_XVFB)
        add_test(NAME ${name} COMMAND ${LATHELIER_XVFB} -a -s "-screen 0 1920x1080x24 +extension GLX" $<TARGET_FILE:test_${name}>)
        set_tests_properties(${name} PROPERTIES ENVIRONMENT "QT_QPA_PLATFORM=xcb;LIBGL_ALWAYS_SOFTWARE=1")
    endif()
endfunction()

# What the tests of a folder show beside its own widgets.
set(also_surface widgets_lobes)
set(also_trajectory_common widgets_longitudinal widgets_roundness widgets_trajectory)
file(GLOB widget_tests CONFIGURE_DEPENDS RELATIVE ${CMAKE_CURRENT_SOURCE_DIR} widgets/*/*_test.cpp app/*_test.cpp)
list(FILTER widget_tests EXCLUDE REGEX "^widgets/worker/")  # knows no Qt
foreach(source ${widget_tests})
    get_filename_component(name ${source} NAME_WE)
    get_filename_component(folder ${source} DIRECTORY)
    if(folder STREQUAL app)
        set(screen offscreen)
        if(name MATCHES "^(chrome|hero_looks)_test$")  # all panels, those with a scene among them
            set(screen screen)
        endif()
        add_widget_test(window_${name} ${source} ${screen} window cli)
    else()
        get_filename_component(panel ${folder} NAME)
        set(screen screen)
        if(panel MATCHES "^(core|plot)$")
            set(screen offscreen)
        endif()
        add_widget_test(view_${name} ${source} ${screen} widgets_${panel} ${also_${panel}})
    endif()
endforeach()

# One Qt only: the window on Qt 5, the command line on none. A mixed program builds without a word and dies at start.
function(add_links_test target pattern)
    add_test(NAME links_${target} COMMAND ${CMAKE_COMMAND} -D PROGRAM=$<TARGET_FILE:${target}> -D "FORBIDDEN=${pattern}"
                                          -P ${CMAKE_CURRENT_SOURCE_DIR}/links.cmake)
endfunction()
add_links_test(lathelier "libQt6")
if(TARGET lathelier-cli)
    # X11 and GLX come with OpenCV's core, which shares pictures with graphics; no display is needed.
    add_links_test(lathelier-cli "libQt|libvtk")
endif()

# What a desktop reads of the program.
set(desktop_files ${CMAKE_SOURCE_DIR}/resources/desktop)
find_program(LATHELIER_DESKTOP_FILE_VALIDATE desktop-file-validate)
if(LATHELIER_DESKTOP_FILE_VALIDATE)
    add_test(NAME desktop_entry COMMAND ${LATHELIER_DESKTOP_FILE_VALIDATE} ${desktop_files}/lathelier.desktop)
    set_tests_properties(desktop_entry PROPERTIES FAIL_REGULAR_EXPRESSION "error|warning")
endif()
find_program(LATHELIER_APPSTREAMCLI appstreamcli)
if(LATHELIER_APPSTREAMCLI)
    add_test(NAME desktop_metainfo COMMAND ${LATHELIER_APPSTREAMCLI} validate --no-net ${desktop_files}/lathelier.metainfo.xml)
endif()
