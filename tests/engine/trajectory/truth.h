// Results of trajectories against what the generator put in.
#pragma once

#include <algorithm>
#include <cmath>

#include "engine/sample/sample_record.h"
#include "engine/trajectory/trajectory.h"

namespace lathelier::trajectory {

template <class Record>
io::ProbeFile fileOf(Record record)
{
    io::ProbeFile file;
    file.facts.path = record.name;
    file.record = std::move(record);
    return file;
}

/// Four channels sampled finely and one after the other, five sections of eight revolutions, no noise.
inline sample::SpindleModel fineModel()
{
    sample::SpindleModel model = sample::quietSpindle();
    model.sections = 5;
    model.revolutions = 8;
    model.rate_hz = 6500;
    model.channel_skew_s = 1 / (5 * 6500.0);
    return model;
}

/// Largest difference in µm of LSC centre and radius, and of RONt(LSCI) and RONt(MZCI), from the true image's.
inline double worstDifference_um(const TrajectorySection& section, const sample::SpindleModel& model, int index)
{
    const form::ReferenceCircles truth = form::fitCircles(sample::trueImage_mm(model, index));
    const form::ReferenceCircles& found = section.roundness.circles;
    return std::max({(found.LSCI.centre_mm - truth.LSCI.centre_mm).norm() * 1e3,
                     std::abs(found.LSCI.radius_mm - truth.LSCI.radius_mm) * 1e3,
                     std::abs(found.LSCI.RONt_um - truth.LSCI.RONt_um),
                     std::abs(found.MZCI.RONt_um - truth.MZCI.RONt_um)});
}

}  // namespace lathelier::trajectory
