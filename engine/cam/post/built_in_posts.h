// Files of resources/ embedded in the engine, so that the command line needs no data files.
#pragma once

#include <string>
#include <vector>

#include "engine/core/built_in_text.h"

namespace lathelier::cam {

const std::vector<BuiltInText>& builtInPosts();      ///< resources/posts, by name
const std::vector<BuiltInText>& builtInLibraries();  ///< resources/library

/// A library by its file's name without extension. Precondition: there is one.
const std::string& builtInLibrary(const char* name);

}  // namespace lathelier::cam
