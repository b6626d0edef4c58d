// Files of resources/ embedded in the engine, so that the command line needs no data files.
#pragma once

#include <vector>

#include "engine/core/built_in_text.h"

namespace lathelier::cam {

const std::vector<BuiltInText>& builtInPosts();      ///< resources/posts, by name
const std::vector<BuiltInText>& builtInMaterials();  ///< resources/library/work_materials.json

}  // namespace lathelier::cam
