// The task cylindricity: how far is this surface from a cylinder, where, and is its axis straight? The verb and the
// panel Cylindricity.
#pragma once

#include <memory>

#include "engine/form/cylinder/cylinder_surface.h"
#include "engine/io/cloud/scan_input.h"
#include "engine/task/task.h"

namespace lathelier::form {

inline constexpr const char* pointsRole = "points";

struct CylindricityOutcome : task::Answered {
    std::shared_ptr<const Loaded<io::ScanFile>> points;  ///< never null
    std::shared_ptr<const CylindricityResult> result;    ///< never null
    std::shared_ptr<const CylinderSurface> surface;      ///< about the minimum-zone cylinder; never null

    const Scan& scan() const { return points->file.scan; }
};

/// Another tolerance or decision rule fits nothing anew. Errors: those of readScan(), cylindricity(). Throws Cancelled.
CylindricityOutcome answerCylindricity(const project::PanelState& state, Stores& stores, task::Sources& sources,
                                       const Progress& progress);

task::Outcome outcomeOf(const std::shared_ptr<const CylindricityOutcome>& outcome);

inline constexpr const char* alongAxisExport = "csv";

const task::Task& cylindricityTask();

}  // namespace lathelier::form
