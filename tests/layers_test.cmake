# The check of the layers finds planted offences, each by its text: cmake -D SOURCE_DIR=… -D WORK_DIR=… -P layers_test.cmake
cmake_policy(VERSION 3.25)

function(plant)
    file(REMOVE_RECURSE ${WORK_DIR})
    file(WRITE ${WORK_DIR}/engine/rooms.cmake "room(core)\nroom(io USES core)\nroom(form USES core)\n")
    file(WRITE ${WORK_DIR}/engine/core/error.h "#include <string>\n")
    file(WRITE ${WORK_DIR}/engine/io/file.h "#include \"engine/core/error.h\"\n")
    file(WRITE ${WORK_DIR}/engine/form/circle.cpp "#include \"engine/core/error.h\"\n")
    file(WRITE ${WORK_DIR}/widgets/core/form/form.h "#include <QWidget>\n")
    file(WRITE ${WORK_DIR}/widgets/compare/panel.cpp "#include \"widgets/core/form/form.h\"\n")
    file(WRITE ${WORK_DIR}/app/cli/main.cpp "#include \"engine/io/file.h\"\n")
endfunction()

function(check expected)
    execute_process(COMMAND ${CMAKE_COMMAND} -D SOURCE_DIR=${WORK_DIR} -P ${SOURCE_DIR}/tests/layers.cmake
                    RESULT_VARIABLE code OUTPUT_VARIABLE out ERROR_VARIABLE out)
    string(REGEX REPLACE "[ \n]+" " " out "${out}")
    if(NOT expected)
        if(NOT code EQUAL 0)
            message(FATAL_ERROR "sound sources were refused: ${out}")
        endif()
    elseif(code EQUAL 0 OR NOT out MATCHES "${expected}")
        message(FATAL_ERROR "not found: ${expected}\nbut: ${out}")
    endif()
endfunction()

plant()
check("")
foreach(offence
        "engine/form/a.cpp|engine/io/file.h|form includes engine/io/file.h, and engine/rooms.cmake does not let it"
        "engine/core/a.h|engine/form/circle.h|core includes engine/form/circle.h"
        "engine/beam/a.cpp|engine/core/error.h|the room beam is missing"
        "engine/core/a.cpp|QString|the engine includes QString"
        "engine/core/a.h|fmt/format.h|a header shows fmt/format.h"
        "engine/core/a.cpp|widgets/core/form/form.h|upward include of widgets/core/form/form.h"
        "widgets/core/a.cpp|app/gui/main_window.h|upward include of app/gui/main_window.h"
        "widgets/roundness/a.cpp|widgets/compare/panel.h|a panel includes another panel"
        "app/cli/a.cpp|widgets/core/form/form.h|the command line includes widgets/core/form/form.h")
    string(REPLACE "|" ";" parts "${offence}")
    list(GET parts 0 file)
    list(GET parts 1 included)
    list(GET parts 2 text)
    plant()
    file(WRITE ${WORK_DIR}/${file} "#include \"${included}\"\n")
    check("${text}")
endforeach()
plant()
file(WRITE ${WORK_DIR}/widgets/compare/sums.cpp "int sum(int a, int b) { return a + b; }\n")
check("widgets/compare/sums.cpp: neither Qt nor VTK")
foreach(offence
        "engine/form/a.cpp|if (control == Control::LinuxCnc) return|linuxcnc names a control"
        "app/cli/a.cpp|if (control->key == \"linuxcnc\") return|the literal \"linuxcnc\" names a control"
        "engine/form/a.cpp|// as linuxcnc does|"
        "engine/form/a.cpp|const Text help = LT_TEXT(\"Engine\", \"Of LinuxCNC.\")|")
    string(REPLACE "|" ";" parts "${offence}")
    list(GET parts 0 file)
    list(GET parts 1 line)
    list(GET parts 2 text)
    plant()
    file(WRITE ${WORK_DIR}/engine/gcode/controls/linuxcnc.cpp "    control.key = \"linuxcnc\";\n")
    file(APPEND ${WORK_DIR}/engine/rooms.cmake "room(gcode)\n")
    file(WRITE ${WORK_DIR}/${file} "${line}\n")
    check("${text}")
endforeach()
plant()
file(WRITE ${WORK_DIR}/engine/rooms.cmake "room(core)\nroom(io USES core form)\nroom(form USES core)\n")
check("io uses form, which stands below it or nowhere")
file(REMOVE_RECURSE ${WORK_DIR})
