// Approximation of a corrected arc by as few arcs as hold it: their ends and their radius or centre on the grid of the
// program.
//
// The ends of a corrected arc move by nearly the same amount, so one arc, or two, follow it; more only where those
// leave the tolerance. An arc by its radius passes its ends; one by its centre passes its start, and its end as near
// as the grid of the centre allows.
#pragma once

#include <cstddef>
#include <vector>

#include "engine/deflection/tool_path.h"

namespace lathelier::deflection {

/// A point of the target contour.
struct WantedPlace {
    double z_mm = 0;
    double x_mm = 0;         ///< target radius
    bool is_corner = false;  ///< a corner is required here
    bool is_free = false;    ///< of an arc in air: the radius is where it is looked for, without a tolerance
    friend bool operator==(const WantedPlace&, const WantedPlace&) = default;
};

/// Places that belong to one arc of the program.
struct WantedArc {
    std::size_t first = 0, last = 0;  ///< indices of its first and last place
    ArcCentre centre;                 ///< as programmed
    bool is_upper = false;            ///< it lies at larger radii than its centre
};

/// Grid and tolerances, of the radius.
struct ArcLimits {
    double grid_mm = 0;         ///< of X
    double centre_grid_mm = 0;  ///< of R, I and K
    double tolerance_mm = 0;
    double coarse_mm = 0;  ///< accepted where it saves more than two arcs
};

/// End of one of the arcs.
struct ArcEnd {
    std::size_t place = 0;
    double x_mm = 0;
    ArcCentre centre;
};

struct ArcChain {
    std::vector<ArcEnd> ends;  ///< the last one at the last place
    std::size_t rank = 0;      ///< chains of smaller rank are preferred
    double off_mm = 0;         ///< largest distance from the target, along x
};

/// From the first place at `from_mm` to the last at `to_mm`. Preferred: one or two arcs within the tolerance, one or
/// two within the coarse one, more. z ascends strictly. Cost: places × about 5000.
ArcChain writtenArc(const std::vector<WantedPlace>& wanted, const WantedArc& arc, double from_mm, double to_mm,
                    const ArcLimits& limits);

/// Radius of the contour at z on an arc that passes (z_mm, x_mm).
double radiusOnArc_mm(const ArcCentre& centre, bool is_upper, double z_mm, double x_mm, double at_z_mm);

}  // namespace lathelier::deflection
