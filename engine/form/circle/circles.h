// The four reference circles of ISO 12181-1 and roundness deviations about them.
// MZCI and MICI by a minimax exchange, proved by branch and bound (circle_zone.h).
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "engine/core/progress.h"

namespace lathelier::form {

/// Least squares, minimum zone, maximum inscribed, minimum circumscribed reference circle.
enum class ReferenceCircle { LSCI, MZCI, MICI, MCCI };

/// "LSCI"…
std::string_view name(ReferenceCircle circle);

/// A contact point of a reference circle.
struct CircleContact {
    enum class Side { Outer, Inner };
    std::size_t index = 0;    ///< of the point in the input
    Side side = Side::Outer;  ///< which of the circles passes through the point
    friend bool operator==(const CircleContact&, const CircleContact&) = default;
};

struct FittedCircle {
    Eigen::Vector2d centre_mm = Eigen::Vector2d::Zero();        ///< in the coordinates of the points given
    double radius_mm = 0;                                       ///< MZCI: mean of inner and outer
    double inner_radius_mm = 0;                                 ///< smallest distance of a point from the centre
    double outer_radius_mm = 0;                                 ///< largest distance of a point from the centre
    double RONt_um = 0;                                         ///< outer - inner radius
    double RONp_um = std::numeric_limits<double>::quiet_NaN();  ///< outer - radius; LSCI only
    double RONv_um = std::numeric_limits<double>::quiet_NaN();  ///< radius - inner; LSCI only
    double RONq_um = std::numeric_limits<double>::quiet_NaN();  ///< root mean square of d - radius; LSCI only
    std::vector<CircleContact> contacts;                        ///< of MZCI, MICI, MCCI; empty for LSCI
    std::optional<double> certified_gap_um;                     ///< MZCI, MICI: certified optimality gap
    bool unique = true;  ///< MICI, MZCI: false: another centre reaches the same value (known with a certificate only)
    bool held = false;   ///< MICI: the centre lies on the edge of the feasible region, so that contacts alone do not
                         ///< determine it (arcs, sparse points)
};

struct ReferenceCircles {
    FittedCircle LSCI, MZCI, MICI, MCCI;  ///< fitted to the same points

    const FittedCircle& of(ReferenceCircle circle) const;
};

struct CircleOptions {
    bool certify = true;                 ///< branch and bound for MZCI and MICI: costs two to six times the computation
    double certificate_um = 1e-6;        ///< the gap to reach, or `certificate_relative` of the deviation if larger
    double certificate_relative = 1e-8;  ///< gap to reach as a share of the deviation
    int certificate_nodes = 20000;       ///< most squares examined; then the gap reached is reported
};

/// All four circles of 4 to 1e6 points in any order, any offset, partial arcs, duplicates. The points need not be
/// uniform. Results do not depend on the order of the points beyond the last bits, nor on the number of threads. MICI:
/// the centre is sought inside the convex hull of the points and LSCI's centre. MZCI: within two radii of LSCI's.
/// Errors: tooFewPoints (fewer than 4 different ones), pointsDegenerate (`found`: in one place, on a line),
/// coordinateTooLarge (also NaN). Throws Cancelled.
ReferenceCircles fitCircles(std::span<const Eigen::Vector2d> points_mm, const CircleOptions& options = {},
                            const Progress& progress = {});

/// The geometric least-squares circle alone, of three points or more. Errors as fitCircles().
FittedCircle fitLeastSquaresCircle(std::span<const Eigen::Vector2d> points_mm);

}  // namespace lathelier::form
