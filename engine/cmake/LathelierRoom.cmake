# Sources of one target compiled several at once: most of a unit's time goes into headers and templates that its
# neighbours need as well. LATHELIER_UNITY=OFF compiles each by itself, as ./dev lint does, so that every file includes
# what it uses. Names at file scope are therefore unique within a target.
function(join_sources target batch)
    set_target_properties(${target} PROPERTIES UNITY_BUILD ${LATHELIER_UNITY} UNITY_BUILD_BATCH_SIZE ${batch})
endfunction()

# A source named *_<kernel>.cpp is the only one that sees a large foreign library, and stands by itself:
# - CGAL makes every user compile with -frounding-math: the room takes the objects;
# - the others become a module lib/lathelier/lathelier-<kernel>.so, which the program loads when it is first used
#   (engine/core/module.h), so that nobody waits for libraries that his question does not need.
set(kernel_links_occt OpenCASCADE::Step)
set(kernel_links_pcl PCL::Segmentation)
set(kernel_links_opencv OpenCV::Imgproc)
add_custom_target(lathelier_modules)

function(add_kernel_module kernel uses)
    set(module lathelier-${kernel})
    add_library(${module} MODULE ${ARGN})
    set_target_properties(${module} PROPERTIES PREFIX "" LIBRARY_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/lib/lathelier)
    target_link_libraries(${module} PRIVATE lathelier_options Eigen3::Eigen ${uses} ${kernel_links_${kernel}})
    # What it takes of the engine is a copy of its own, and only its table of functions is seen.
    target_link_options(${module} PRIVATE LINKER:--exclude-libs,ALL)
    add_dependencies(lathelier_modules ${module})
    set_property(GLOBAL APPEND PROPERTY lathelier_module_targets ${module})
endfunction()

# add_room(name [USES rooms…] [LINKS libraries…]): static library engine_<name> from the folder <name>. Its users get the
# rooms that it uses; the libraries stay its own, but for their place on the linker's line.
function(add_room name)
    cmake_parse_arguments(PARSE_ARGV 1 room "" "" "USES;LINKS")
    file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${name}/*.cpp ${name}/*.h)
    set(objects "")
    foreach(kernel cgal occt pcl opencv)
        set(kernel_sources ${sources})
        list(FILTER kernel_sources INCLUDE REGEX "_${kernel}\\.cpp$")
        list(FILTER sources EXCLUDE REGEX "_${kernel}\\.cpp$")
        if(NOT kernel_sources)
            continue()
        elseif(kernel STREQUAL "cgal")
            add_library(engine_${name}_cgal OBJECT ${kernel_sources})
            target_link_libraries(engine_${name}_cgal PRIVATE lathelier_options Eigen3::Eigen CGAL::CGAL)
            set(objects $<TARGET_OBJECTS:engine_${name}_cgal>)
            list(APPEND room_LINKS $<LINK_ONLY:CGAL::CGAL>)
        else()
            add_kernel_module(${kernel} "engine_shaft" ${kernel_sources})
        endif()
    endforeach()
    add_library(engine_${name} STATIC ${sources} ${objects})
    join_sources(engine_${name} 8)
    list(TRANSFORM room_USES PREPEND engine_)
    target_link_libraries(engine_${name} PUBLIC lathelier_options Eigen3::Eigen nlohmann_json::nlohmann_json ${room_USES}
                                         PRIVATE ${room_LINKS})
endfunction()
