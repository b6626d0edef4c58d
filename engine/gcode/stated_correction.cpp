#include "engine/gcode/stated_correction.h"

#include <algorithm>
#include <utility>

#include "engine/core/interpolate.h"

namespace lathelier::gcode {
namespace {

constexpr double besideJump_mm = 1e-6;  ///< between both sides of a jump

/// Inserts a run; where it overlaps earlier runs it replaces them.
void overlay(StatedCorrection& all, const StatedCorrection& run)
{
    if (!run.isAny()) return;
    StatedCorrection merged;
    const double begin = run.z_mm.front(), end = run.z_mm.back();
    const auto add = [&merged](double z, double radius) {
        if (!merged.z_mm.empty() && z <= merged.z_mm.back()) z = merged.z_mm.back() + besideJump_mm;
        merged.z_mm.push_back(z);
        merged.radius_mm.push_back(radius);
    };
    for (std::size_t i = 0; i < all.z_mm.size() && all.z_mm[i] < begin; ++i) add(all.z_mm[i], all.radius_mm[i]);
    if (all.isAny() && all.z_mm.front() < begin) add(begin - besideJump_mm, all.at_mm(begin - besideJump_mm));
    for (std::size_t i = 0; i < run.z_mm.size(); ++i) add(run.z_mm[i], run.radius_mm[i]);
    if (all.isAny() && all.z_mm.back() > end) {
        add(end + besideJump_mm, all.at_mm(end + besideJump_mm));
        for (std::size_t i = 0; i < all.z_mm.size(); ++i)
            if (all.z_mm[i] > end + besideJump_mm) add(all.z_mm[i], all.radius_mm[i]);
    }
    all = std::move(merged);
}

}  // namespace

double StatedCorrection::at_mm(double z) const
{
    return z_mm.empty() ? 0 : linearAt(z_mm, radius_mm, z);
}

StatedCorrection correctionOf(std::span<const CorrectedCorner> corners)
{
    StatedCorrection all, run;
    for (const CorrectedCorner& corner : corners) {
        if (run.isAny() && corner.z_mm < run.z_mm.back()) {
            overlay(all, run);
            run = {};
        }
        if (run.isAny() && corner.z_mm == run.z_mm.back()) {
            run.radius_mm.back() = corner.radius_mm;
            continue;
        }
        run.z_mm.push_back(corner.z_mm);
        run.radius_mm.push_back(corner.radius_mm);
    }
    overlay(all, run);
    return all;
}

}  // namespace lathelier::gcode
