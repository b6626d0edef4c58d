// The nominal contour as sampled points: the face of the free end from the axis outward, then the outside up to the end
// of the part. Faces between rows are pieces of their own. Points are (z, radius) in mm, z from the free end.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "engine/gcode/stated_correction.h"
#include "engine/shaft/shaft.h"
#include "engine/shaft/shaft_contour.h"
#include "engine/stock/convex_polygon.h"

namespace lathelier::cam {

using stock::Corner;

/// A sample of the nominal contour.
struct DrawnPoint {
    Corner at;                ///< with the correction
    double along_mm = 0;      ///< arc length of the sampled polyline up to this point
    double t = 0;             ///< share of its piece, 0 … 1
    std::uint32_t piece = 0;  ///< of pieces()
};

inline constexpr double usualSpacing_mm = 0.02;
inline constexpr std::size_t mostDrawnPoints = 200000;

/// Samples at most `spacing` apart, with all ends of pieces; farther apart where they would be more than
/// mostDrawnPoints. A piece begins with the point that the one before ends with.
class DrawnContour {
public:
    /// Precondition: checkPart() holds. The end face within a centre hole of this radius is excluded.
    explicit DrawnContour(const Shaft& part, gcode::StatedCorrection correction = {},
                          double spacing_mm = usualSpacing_mm, double hole_radius_mm = 0);

    const std::vector<DrawnPoint>& points() const { return points_; }
    const Contour& pieces() const { return pieces_; }
    double spacing_mm() const { return spacing_mm_; }  ///< as used

    Corner at(std::uint32_t piece, double t) const;
    /// Out of the material, of length 1; that of the drawing without the correction.
    Corner normalAt(std::uint32_t piece, double t) const;

private:
    Contour pieces_;
    gcode::StatedCorrection correction_;
    std::vector<DrawnPoint> points_;
    double spacing_mm_ = usualSpacing_mm;
};

}  // namespace lathelier::cam
