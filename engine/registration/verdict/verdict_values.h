// The parts of a verdict: rule, worst place, findings and zones.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "engine/core/conformity.h"
#include "engine/core/fields.h"

namespace lathelier::registration {

/// Surface: local means with their uncertainty against the limits; Points: the share of single points within them.
enum class VerdictRule { Surface, Points };

/// Limits of a stretch along the axis, in place of the tolerance. Either both limits or none: without them the zone is
/// left out of the verdict.
struct ZoneLimits {
    std::string name;                ///< as the user calls it
    double z_start_mm = 0;           ///< along the axis from the reference's first data
    double z_end_mm = 0;             ///< beyond z_start_mm
    std::optional<double> lower_mm;  ///< lower limit of the deviation
    std::optional<double> upper_mm;  ///< upper limit of the deviation
    friend bool operator==(const ZoneLimits&, const ZoneLimits&) = default;
};

const std::vector<Field<ZoneLimits>>& fieldsOf(const ZoneLimits*);

/// The stretch between two places along the axis.
struct Zone {
    double z_start_mm = 0;  ///< along the axis from the reference's first data
    double z_end_mm = 0;
    double mean_mm = 0;       ///< of the deviations in the zone, without stray points and points near edges
    double std_mm = 0;        ///< standard deviation about that mean, over n - 1; NaN for one point
    std::int64_t points = 0;  ///< number of points in the zone that count
    double uncertainty_mm = std::numeric_limits<double>::quiet_NaN();  ///< of the mean, k = 2
    std::string name = {};                                             ///< as given; empty for an automatic zone
    std::optional<double> lower_mm = {};                               ///< both limits, where limits were given
    std::optional<double> upper_mm = {};
    std::optional<Verdict> verdict = {};  ///< of all local means in it; none without limits or tolerance
};

/// The place with the largest excess over the limits (or the least distance to them) in standard uncertainties; without
/// limits the most significant deviation from zero.
struct WorstPlace {
    std::optional<double> z_mm;       ///< along the axis from the reference's first data; body of revolution only
    std::optional<double> angle_deg;  ///< about the axis, 0…360; body of revolution only
    Eigen::Vector3d point_mm = Eigen::Vector3d::Zero();  ///< in the reference's frame
    double deviation_mm = 0;                             ///< mean about that place
    double uncertainty_mm = 0;                           ///< of that mean, simultaneous for all places judged
    double cell_mm = 0;                                  ///< side of a square as large as what the mean is over
};

/// A form difference in workshop terms.
struct Finding {
    /// Step: a stretch between shoulders off by a constant; Taper: off by an amount that changes linearly, `value` from
    /// its start to its end; Barrel: the middle against the ends; Bump: one place; Missing: a stretch of the reference
    /// without points of the copy, `value` its length.
    enum class Kind { Step, Taper, Barrel, Bump, Missing };
    Kind kind = Kind::Step;
    std::optional<double> z_start_mm;  ///< along the axis from the reference's first data; none without an axis
    std::optional<double> z_end_mm;
    double value_mm = 0;             ///< how large it is, + for material in excess (Taper: growing with z)
    double uncertainty_mm = 0;       ///< of the value, simultaneous; of Missing: the width of a ring
    std::optional<double> limit_mm;  ///< limit for the absolute value; none without limits
    std::optional<Verdict> verdict;  ///< none without limits
    Eigen::Vector3d point_mm = Eigen::Vector3d::Zero();  ///< of a bump, in the reference's frame
};

std::string_view key(VerdictRule rule);    ///< "surface" | "points"
std::string_view key(Finding::Kind kind);  ///< "step" | "taper" | "barrel" | "bump" | "missing"
Text name(VerdictRule rule);               ///< "local means of the surface"…
Text name(Finding::Kind kind);             ///< "off by a constant"…

}  // namespace lathelier::registration
