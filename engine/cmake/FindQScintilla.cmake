# QScintilla (Debian: libqscintilla2-qt5-dev), the editor of NC programs. Defines QScintilla::QScintilla. Needs Qt5.
find_path(QScintilla_INCLUDE_DIR NAMES Qsci/qsciscintilla.h HINTS ${Qt5Widgets_INCLUDE_DIRS} PATH_SUFFIXES qt5)
find_library(QScintilla_LIBRARY NAMES qscintilla2_qt5 qscintilla2-qt5)
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(QScintilla DEFAULT_MSG QScintilla_LIBRARY QScintilla_INCLUDE_DIR)
mark_as_advanced(QScintilla_INCLUDE_DIR QScintilla_LIBRARY)
if(QScintilla_FOUND AND NOT TARGET QScintilla::QScintilla)
    add_library(QScintilla::QScintilla UNKNOWN IMPORTED)
    set_target_properties(QScintilla::QScintilla PROPERTIES IMPORTED_LOCATION "${QScintilla_LIBRARY}"
                          INTERFACE_INCLUDE_DIRECTORIES "${QScintilla_INCLUDE_DIR}"
                          INTERFACE_LINK_LIBRARIES "Qt5::Widgets;Qt5::PrintSupport")
endif()
