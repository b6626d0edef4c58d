// The axis of a body of revolution and the radius along it, from points of its surface.
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <vector>

#include "engine/core/progress.h"
#include "engine/registration/revolution/revolution_bend.h"

namespace lathelier::registration {

/// Radius along the axis in equal steps. Where there is no single radius (a shoulder, no data) it is NaN.
struct RadiusProfile {
    double z_start_mm = 0;          ///< lower limit of the first bin
    double step_mm = 1;             ///< width of a bin along the axis
    std::vector<double> radius_mm;  ///< at the middle of each bin
    std::vector<double> slope;      ///< dR/dz
    std::vector<double> sigma_mm;   ///< standard uncertainty of the radius
    std::vector<double> points;     ///< number of points (sum of weights)

    double middle_mm(std::size_t bin) const { return z_start_mm + (static_cast<double>(bin) + 0.5) * step_mm; }
    std::size_t size() const { return radius_mm.size(); }
    /// 0 without a known radius.
    double largestRadius_mm() const
    {
        double largest = 0;
        for (const double radius : radius_mm)
            if (!std::isnan(radius)) largest = std::max(largest, radius);
        return largest;
    }
};

/// Known bins up to this far apart may have a shoulder between them; further apart there are no data between them.
inline constexpr std::size_t longestShoulder_bins = 10;

/// Why points are not those of a body of revolution.
enum class NotTurned {
    No,             ///< a body of revolution
    Line,           ///< on a line within their scatter: the radius of a cylinder must exceed its noise
    Flat,           ///< a plate
    SeveralParts,   ///< disconnected pieces
    NoSingleAxis,   ///< a sphere
    SmallCoverage,  ///< less than 60° of the circle
    Bent,           ///< the centre line is off by more than 1 mm or a 200th of the length
    NotRound
};

/// Least coverage of the circle for an axis.
inline constexpr double leastCoverage_deg = 60;

/// Fit of a body of revolution. Its frame has the axis as z and the middle of the data near its origin.
struct RevolutionFit {
    Eigen::Isometry3d axis_T_scan = Eigen::Isometry3d::Identity();  ///< takes points of the scan into the axis frame
    RadiusProfile profile;  ///< of the outside; of the bore where that alone is seen
    RadiusProfile bore;     ///< in the same bins, where both are seen; empty without a bore
    std::vector<double>
        rough_mm;  ///< median radius of bins that are too rough for the axis fit (a thread, a knurl); NaN elsewhere
    Bend bend;     ///< subtracted from the points before the fit when significant
    NotTurned not_turned = NotTurned::NotRound;  ///< No, or the first reason against a body of revolution
    double coverage_deg = 0;                     ///< angle of the circle covered by points
    double sigma_mm = 0;                         ///< robust scatter of the points about the profile, along its normal
    double consistent_share = 0;  ///< of the points: how many lie on one surface of revolution about the axis
    double side_share = 0;        ///< of the points: on the profile, where it determines the axis across
    Eigen::Matrix4d covariance = Eigen::Matrix4d::Zero();  ///< of (x, y) at the origin in mm and the two slopes
    bool converged = false;  ///< the last step was below a tenth of the standard uncertainty
    int iterations = 0;      ///< steps of the fit in all stages

    /// A point of the scan in the axis frame, with the bend of the part subtracted.
    Eigen::Vector3d onAxis(const Eigen::Vector3d& scan_point) const
    {
        return axis_T_scan * (bend.isSeen() ? bend.straightened(scan_point) : scan_point);
    }
};

/// Robust least squares (Tukey weights) over the axis's four parameters with the radius free in every bin.
/// Starts from each candidate on a sample and finishes on all points, or two million of a larger cloud, drawn evenly
/// from it. Points: at least 50, finite, not all in a plane. The covariance is never less than that of independent
/// residuals, and more where residuals of neighbours on the surface are correlated (clusters: patches of 22.5° by a
/// 96th of the length, and whole rings of that length).
RevolutionFit fitRevolution(const std::vector<Eigen::Vector3d>& points, const Progress& progress = {});

/// True when the fit shows a body of revolution.
bool isBodyOfRevolution(const RevolutionFit& fit);

/// The same fit with z reversed: the frame turned by 180° about its x axis.
RevolutionFit reversed(const RevolutionFit& fit);

}  // namespace lathelier::registration
