# Which libraries a program loads: cmake -D PROGRAM=… -D FORBIDDEN=regex -P links.cmake
execute_process(COMMAND ldd ${PROGRAM} OUTPUT_VARIABLE libraries RESULT_VARIABLE problem)
if(problem OR libraries STREQUAL "")
    message(FATAL_ERROR "ldd ${PROGRAM} says nothing")
endif()
string(REGEX MATCHALL "[^\n]*(${FORBIDDEN})[^\n]*" found "${libraries}")
if(found)
    message(FATAL_ERROR "${PROGRAM} loads:\n${found}")
endif()
