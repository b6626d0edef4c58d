// Compliance of the uncut workpiece at the tool position: by the beam of this room and, as a cross-check, by
// engine/receptance at 0 Hz with the same springs.
#pragma once

#include <vector>

#include "engine/core/quantities.h"
#include "engine/deflection/setup.h"
#include "engine/report/chart.h"
#include "engine/shaft/shaft.h"

namespace lathelier::deflection {

/// Without follower rest and tool post.
struct StaticCompliance {
    std::vector<double> z_mm, compliance_um_N;                ///< of every node of the plan
    std::vector<double> compared_z_mm, receptance_0_hz_um_N;  ///< at a subset of them
    double largest_difference = 0;                            ///< largest relative difference
};

/// Errors of workPlan() and receptance::receptanceOf().
StaticCompliance staticCompliance(const Shaft& stock, const TurningSetup& setup);

const std::vector<QuantityOf<StaticCompliance>>& quantitiesOf(const StaticCompliance*);

report::Plot compliancePlot(const StaticCompliance& compliance);

}  // namespace lathelier::deflection
