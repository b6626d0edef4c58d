// Which panel opened or dropped files go to.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "engine/project/project.h"
#include "widgets/core/files/kind_finder.h"
#include "widgets/core/panel/panel_facts.h"

namespace lathelier {

/// Files for one panel.
struct Opening {
    std::size_t panel = 0;  ///< index in the table of panels
    std::vector<FoundFile> files;
};

/// Files opened together go to one panel that takes all of them, the active one before others; each into an input of
/// its own. One file alone goes to the active panel if that takes its kind, else to where its kind belongs alone
/// (PanelFacts::alone), else to the first panel that takes it. A part without any file begins where the kind belongs
/// alone: what is in front then is nobody's choice. Files that no panel takes together are parted. Precondition: some
/// panel takes the kind of each.
std::vector<Opening> openingsOf(const std::vector<FoundFile>& files, const std::vector<const PanelFacts*>& panels,
                                std::optional<std::size_t> active, const project::Project& project);

}  // namespace lathelier
