# Interface target lathelier_options: what every target of ours is compiled with.
add_library(lathelier_options INTERFACE)
target_include_directories(lathelier_options INTERFACE ${CMAKE_SOURCE_DIR})
target_compile_options(lathelier_options INTERFACE -Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor -Woverloaded-virtual
                       -Wconversion -Wsign-conversion -Wold-style-cast -Wformat=2)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    target_compile_options(lathelier_options INTERFACE -Wlogical-op)
    if(LATHELIER_UNITY)
        # GCC 12 inlines more where it sees more, and then finds uninitialised strings in moved variants and pieces of
        # blocks freed that are not.
        target_compile_options(lathelier_options INTERFACE -Wno-maybe-uninitialized -Wno-free-nonheap-object)
    endif()
else()
    # Not with GCC: version 12 finds null pointers in std::vector::resize() and insert() once it has inlined them.
    target_compile_options(lathelier_options INTERFACE -Wnull-dereference)
endif()
if(LATHELIER_WERROR)
    target_compile_options(lathelier_options INTERFACE -Werror)
endif()
if(LATHELIER_ODR)  # definitions are compared before anything is optimised
    add_compile_options(-O0 -flto=auto)
    add_link_options(-O0 -flto=auto -Wodr -Werror=odr)
endif()
# No contraction of a*b+c into one rounding: where a compiler does so depends on its version and the processor.
target_compile_options(lathelier_options INTERFACE -ffp-contract=off)
# Hardened, where no sanitizer checks more: guarded stack frames, checked calls of the C library, addresses that change
# from run to run, tables of the linker that cannot be written once the program runs. tests/hardening.cmake looks at
# the binaries.
include(CheckPIESupported)
check_pie_supported()
set(CMAKE_POSITION_INDEPENDENT_CODE ON)
if(NOT LATHELIER_SANITIZE AND NOT LATHELIER_FUZZ AND NOT LATHELIER_ODR)
    target_compile_options(lathelier_options INTERFACE -fstack-protector-strong -fstack-clash-protection
                           $<$<NOT:$<CONFIG:Debug>>:-U_FORTIFY_SOURCE -D_FORTIFY_SOURCE=2>)
endif()
add_link_options(LINKER:-z,relro,-z,now LINKER:--as-needed)
if(LATHELIER_SANITIZE)
    add_compile_options(-fsanitize=${LATHELIER_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all)
    add_link_options(-fsanitize=${LATHELIER_SANITIZE})
    # GCC 12 sees uninitialised strings in moved variants once it instruments them.
    target_compile_options(lathelier_options INTERFACE -Wno-maybe-uninitialized)
endif()
if(LATHELIER_FUZZ)
    add_compile_options(-fsanitize=fuzzer-no-link,address,undefined -fno-sanitize-recover=all)
    add_link_options(-fsanitize=address,undefined)
endif()
# A change is compiled once and linked into many programs: lld links in a quarter of the time. Link-time optimisation of
# GCC is the business of GCC's own linker.
find_program(LATHELIER_LLD ld.lld)
if(LATHELIER_LLD AND NOT LATHELIER_ODR)
    add_link_options(-fuse-ld=lld)
endif()
find_program(LATHELIER_CCACHE ccache)
if(LATHELIER_CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
    set(CMAKE_CXX_COMPILER_LAUNCHER ${LATHELIER_CCACHE})
    set(CMAKE_C_COMPILER_LAUNCHER ${LATHELIER_CCACHE})
endif()
