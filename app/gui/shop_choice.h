// The shop of a project: its own, else that of the settings, which is at first the built-in one.
#pragma once

#include "engine/project/project.h"
#include "engine/shop/shop_file.h"

namespace lathelier {

class Session;

/// Of the project's text or the settings, which are read. What cannot be read (of a later version, damaged) is left
/// out.
shop::StatedShop shopOf(const project::Project& project);

/// Of the settings, as Project::shop.
Values startingShop();

/// For this project, and for new ones. One undo step.
void keepShop(Session& session, const shop::StatedShop& shop);

}  // namespace lathelier
