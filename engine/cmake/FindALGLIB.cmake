# ALGLIB (Debian: libalglib-dev), a test-only oracle for reference circles. Defines ALGLIB::ALGLIB.
find_path(ALGLIB_INCLUDE_DIR NAMES interpolation.h PATH_SUFFIXES libalglib)
find_library(ALGLIB_LIBRARY NAMES alglib)
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(ALGLIB DEFAULT_MSG ALGLIB_LIBRARY ALGLIB_INCLUDE_DIR)
mark_as_advanced(ALGLIB_INCLUDE_DIR ALGLIB_LIBRARY)
if(ALGLIB_FOUND AND NOT TARGET ALGLIB::ALGLIB)
    add_library(ALGLIB::ALGLIB UNKNOWN IMPORTED)
    set_target_properties(ALGLIB::ALGLIB PROPERTIES IMPORTED_LOCATION "${ALGLIB_LIBRARY}"
                          INTERFACE_INCLUDE_DIRECTORIES "${ALGLIB_INCLUDE_DIR}")
endif()
