// The drawing as a row of points: the free end's face from the axis outward, then the outside up to the end of the
// part. Faces between rows are pieces of their own. Points are (z, radius) in mm, z from the free end.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "engine/core/shaft.h"
#include "engine/core/shaft_contour.h"
#include "engine/stock/convex_polygon.h"

namespace lathelier::cam {

using stock::Corner;

/// What a program stands off from the drawing on purpose, along the axis: straight between places, constant beyond the
/// first and the last.
struct StatedCorrection {
    std::vector<double> z_mm;       ///< ascending
    std::vector<double> radius_mm;  ///< what is added to the radius
    bool isAny() const { return !z_mm.empty(); }
    double at_mm(double z_mm) const;  ///< 0 without places
    friend bool operator==(const StatedCorrection&, const StatedCorrection&) = default;
};

/// A place on the drawing.
struct DrawnPoint {
    Corner at;                ///< with the correction
    double along_mm = 0;      ///< length of the polyline of points before it
    double t = 0;             ///< share of its piece, 0 … 1
    std::uint32_t piece = 0;  ///< of pieces()
};

inline constexpr double usualSpacing_mm = 0.02;
inline constexpr std::size_t mostDrawnPoints = 200000;

/// Points no more than `spacing` apart, with all ends of pieces; farther apart where they would be more than
/// mostDrawnPoints. A piece begins with the point that the one before ends with.
class DrawnContour {
public:
    /// Precondition: checkPart() holds. Within a centre hole of this radius nothing of the end face is drawn.
    explicit DrawnContour(const Shaft& part, StatedCorrection correction = {}, double spacing_mm = usualSpacing_mm,
                          double hole_radius_mm = 0);

    const std::vector<DrawnPoint>& points() const { return points_; }
    const Contour& pieces() const { return pieces_; }
    double spacing_mm() const { return spacing_mm_; }  ///< as used

    Corner at(std::uint32_t piece, double t) const;
    /// Out of the material, of length 1; that of the drawing without the correction.
    Corner normalAt(std::uint32_t piece, double t) const;

private:
    Contour pieces_;
    StatedCorrection correction_;
    std::vector<DrawnPoint> points_;
    double spacing_mm_ = usualSpacing_mm;
};

}  // namespace lathelier::cam
