// Stretches along the axis of a body of revolution whose points are left out: clamping areas.
#pragma once

#include <algorithm>
#include <limits>
#include <vector>

#include "engine/core/value.h"

namespace lathelier::registration {

/// Zones in mm along the axis from the first data. One that begins or ends with the part includes points that noise
/// places beyond it.
class ExcludedZones {
public:
    /// `length_mm`: of the data along the axis.
    ExcludedZones(std::vector<Interval> zones_mm, double length_mm) : zones_mm_(std::move(zones_mm))
    {
        for (Interval& zone : zones_mm_) {
            if (zone.from <= 0) zone.from = -std::numeric_limits<double>::infinity();
            if (zone.to >= length_mm) zone.to = std::numeric_limits<double>::infinity();
        }
    }

    bool contains(double z_mm) const
    {
        return std::any_of(zones_mm_.begin(), zones_mm_.end(),
                           [&](const Interval& zone) { return z_mm >= zone.from && z_mm <= zone.to; });
    }
    const std::vector<Interval>& zones_mm() const { return zones_mm_; }

private:
    std::vector<Interval> zones_mm_;
};

}  // namespace lathelier::registration
