// The intended offset of a program from the drawing, as radii added to the nominal contour.
#pragma once

#include <span>
#include <vector>

namespace lathelier::gcode {

/// Intended radial offset along the axis: linear between nodes, constant beyond the first and last.
struct StatedCorrection {
    std::vector<double> z_mm;       ///< ascending
    std::vector<double> radius_mm;  ///< added to the nominal radius
    bool isAny() const { return !z_mm.empty(); }
    double at_mm(double z_mm) const;  ///< 0 without places
    friend bool operator==(const StatedCorrection&, const StatedCorrection&) = default;
};

/// A corner of a corrected run.
struct CorrectedCorner {
    double z_mm = 0;       ///< from the free end of the clamping
    double radius_mm = 0;  ///< added to the nominal radius
};

/// Corners of all corrected runs one after the other, each run from the free end toward the chuck; straight between the
/// corners of a run. Where runs overlap, the last one counts.
StatedCorrection correctionOf(std::span<const CorrectedCorner> corners);

}  // namespace lathelier::gcode
