// The inputs that the panels of workspace Roundness share, and where a dropped file belongs.
#pragma once

#include <vector>

#include "widgets/core/files/kind_finder.h"
#include "widgets/core/panel/panel_facts.h"

namespace lathelier::trajectory_common {

const InputRole& recordRole();   ///< probe records, one or one for each section
const InputRole& profileRole();  ///< a measured profile
const InputRole& traceRole();    ///< a second one, to be laid over

bool hasRecord(const project::PanelState& state);
bool hasProfile(const project::PanelState& state);

/// Records go to the record; other files are profiles: the first one is the profile, a second one the trace. Profiles
/// go nowhere when `profiles` is false: then they are assigned to the record, whose reader reports the error.
void assignSpindleFiles(project::PanelState& state, const std::vector<FoundFile>& files, bool profiles);

}  // namespace lathelier::trajectory_common
