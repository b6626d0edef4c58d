// A file of resources/ embedded in the engine, so that the command line needs no data files (cmake/BuiltInTexts.cmake).
#pragma once

#include <string>

namespace lathelier {

/// A file by its name without extension.
struct BuiltInText {
    const char* name;  ///< "fanuc_a"
    std::string text;  ///< content at build time
};

}  // namespace lathelier
