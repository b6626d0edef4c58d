// The shop of a project: its own, else that of the settings, else the built-in one.
#pragma once

#include "engine/project/project.h"
#include "engine/shop/shop_file.h"

namespace lathelier {

class Session;

/// What cannot be read (of a later version, damaged) is left out.
shop::StatedShop shopOf(const project::Project& project);

/// For this project, and for new ones. One undo step.
void keepShop(Session& session, const shop::StatedShop& shop);

}  // namespace lathelier
