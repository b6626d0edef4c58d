// Fixed bodies: chuck and tailstock as convex regions of the meridian plane, from the axis outward. z from the free end
// toward the chuck.
#pragma once

#include <optional>
#include <vector>

#include "engine/core/fields.h"
#include "engine/stock/convex_polygon.h"

namespace lathelier::stock {

/// Extent of unbounded regions.
inline constexpr double endless_mm = 1e6;

/// Largest coordinate and size accepted as input.
inline constexpr double longest_mm = 1e5;

/// The chuck with its jaws: everything beyond its face, up to a radius.
struct ChuckBody {
    std::optional<double> face_z_mm;  ///< none: the end of the stock
    double radius_mm = 0;             ///< of the jaws; 0: unbounded
    friend bool operator==(const ChuckBody&, const ChuckBody&) = default;
};

/// The tailstock: a cone whose edge lies on the end of the work, and the quill behind it.
struct TailstockBody {
    double end_z_mm = 0;            ///< of the work, after facing
    double centre_hole_mm = 5;      ///< largest diameter of the centre hole: of the cone at the end of the work
    double cone_angle_deg = 60;     ///< included
    double quill_diameter_mm = 50;  ///< of the centre's body or the quill
    /// Outline that replaces cone and quill: the region between these corners and the axis. Empty: cone and quill.
    std::vector<Corner> outline;
    friend bool operator==(const TailstockBody&, const TailstockBody&) = default;
};

const std::vector<Field<ChuckBody>>& fieldsOf(const ChuckBody*);
const std::vector<Field<TailstockBody>>& fieldsOf(const TailstockBody*);

ConvexPolygon regionOf(const ChuckBody& chuck, double stock_length_mm);
/// An outline is divided into trapezoids.
std::vector<ConvexPolygon> regionsOf(const TailstockBody& tailstock);

}  // namespace lathelier::stock
