# add_room(name [USES rooms…] [LINKS libraries…]): static library engine_<name> from the folder <name>. Its users get the
# rooms that it uses; the libraries stay its own, but for their place on the linker's line.
function(add_room name)
    cmake_parse_arguments(PARSE_ARGV 1 room "" "" "USES;LINKS")
    file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${name}/*.cpp ${name}/*.h)
    # CGAL stays by itself, for it makes every user compile with -frounding-math: the room takes its objects.
    set(cgal_sources ${sources})
    list(FILTER cgal_sources INCLUDE REGEX "_cgal\\.cpp$")
    list(FILTER sources EXCLUDE REGEX "_cgal\\.cpp$")
    set(objects "")
    if(cgal_sources)
        add_library(engine_${name}_cgal OBJECT ${cgal_sources})
        target_link_libraries(engine_${name}_cgal PRIVATE lathelier_options Eigen3::Eigen CGAL::CGAL)
        set(objects $<TARGET_OBJECTS:engine_${name}_cgal>)
        list(REMOVE_ITEM room_LINKS CGAL::CGAL)
        list(APPEND room_LINKS $<LINK_ONLY:CGAL::CGAL>)
    endif()
    add_library(engine_${name} STATIC ${sources} ${objects})
    target_compile_definitions(engine_${name} PRIVATE LATHELIER_VERSION="${PROJECT_VERSION}")
    list(TRANSFORM room_USES PREPEND engine_)
    target_link_libraries(engine_${name} PUBLIC lathelier_options Eigen3::Eigen nlohmann_json::nlohmann_json ${room_USES}
                                         PRIVATE ${room_LINKS})
endfunction()
