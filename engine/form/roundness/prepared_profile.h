// The evaluated points of a profile, about their least-squares centre and in order of angle.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/core/profile.h"
#include "engine/form/roundness/roundness.h"
#include "engine/signal/angular_sampling.h"

namespace lathelier::signal {
class ClosedFilter;
}

namespace lathelier::form {

struct PreparedProfile {
    Eigen::Vector2d centre_mm = Eigen::Vector2d::Zero();     ///< of the least-squares circle of the evaluated points
    double radius_mm = 0;                                    ///< of the least-squares circle
    std::vector<std::uint8_t> used;                          ///< by input point: 1 if evaluated
    std::vector<double> angle_rad;                           ///< atan2 of each given point as seen from the centre
    std::size_t not_finite = 0, excluded = 0, outliers = 0;  ///< numbers of input points excluded, by reason
    std::vector<std::size_t> index;          ///< input indices of the evaluated points, in order of angle
    std::vector<Eigen::Vector2d> points_mm;  ///< evaluated points in the order of `index`
    std::vector<double> distance_mm;         ///< from the centre, in the order of `index`
    signal::AngularSampling sampling;        ///< of points_mm; its order is already applied
};

/// atan2 of each point as seen from a centre.
std::vector<double> anglesAbout(const Eigen::Vector2d& centre_mm, const std::vector<Eigen::Vector2d>& points_mm,
                                const Progress& progress = {});

/// Leaves out sectors (angles as seen from the centre that results) and outliers. Errors as fitLeastSquaresCircle().
PreparedProfile prepareProfile(const Profile& profile, const std::vector<Interval>& exclude_deg, OutlierRule rule,
                               const Progress& progress = {});

/// The same points without their outliers, or those points themselves when there are none. `prepared` still has them.
PreparedProfile withoutOutliers(const Profile& profile, PreparedProfile prepared, const Progress& progress = {});

/// The prepared points after the filter, moved along the rays from the centre, in the same order; unchanged without a
/// filter.
struct EvaluatedProfile {
    std::vector<Eigen::Vector2d> points_mm;                       ///< in the order of PreparedProfile::points_mm
    signal::FilterMethod method = signal::FilterMethod::Uniform;  ///< how it was filtered; Uniform without a filter
};
EvaluatedProfile evaluateProfile(const PreparedProfile& prepared, const signal::TransmissionBand& band,
                                 const Progress& progress = {});

/// The same with `filter`, which is of the prepared distances.
EvaluatedProfile evaluateProfile(const PreparedProfile& prepared, const signal::TransmissionBand& band,
                                 signal::ClosedFilter& filter, const Progress& progress = {});

/// Is the angle in one of the sectors? Sectors may run through 0°.
bool isExcluded(double angle_deg, const std::vector<Interval>& sectors_deg);

}  // namespace lathelier::form
