// A bent body of revolution: its sections are round, but their centres lie on a curve.
#pragma once

#include <Eigen/Geometry>
#include <cmath>
#include <vector>

#include "engine/registration/revolution/meridian_bins.h"

namespace lathelier::registration {

/// When a bend is seen, and when a part is no body of revolution any more (README, "Thresholds").
struct BendThresholds {
    double seen_sigmas = 3;     ///< standard uncertainties: a smaller bow may be noise
    double seen_mm = 0.02;      ///< a smaller bow is not subtracted
    double largest_mm = 1;      ///< a larger bow is a bent part
    double largest_part = 200;  ///< the same for a bow above this part (1 / n) of the length
    double shape_share = 0.02;  ///< uncertainty of the bow: that of a beam bent at mid length comes out 1.8 % short
};
inline constexpr BendThresholds bendThresholds{};

/// The curve of the section centres over the length, t from -1 to 1: a parabola, and terms of the third and the fourth
/// degree where these are significant (a bar bent over a support is no parabola). Its least-squares line is the axis.
struct Bend {
    Eigen::Vector3d along = Eigen::Vector3d::UnitZ();
    double middle_mm = 0;                                  ///< of the data, along that direction
    double half_mm = 1;                                    ///< half their length
    Eigen::Vector3d bow_mm = Eigen::Vector3d::Zero();      ///< times t² - 1/3
    Eigen::Vector3d cubic_mm = Eigen::Vector3d::Zero();    ///< times t³ - 3t/5
    Eigen::Vector3d quartic_mm = Eigen::Vector3d::Zero();  ///< times t⁴ - 6t²/7 + 3/35
    double largest_mm = 0;                                 ///< distance of the curve from the chord between the ends
    double sigma_mm = 0;                                   ///< standard uncertainty of the bow
    double scatter_mm = 0;                                 ///< of the points about the circles of their sections

    double size_mm() const { return largest_mm; }
    double length_mm() const { return 2 * half_mm; }
    /// More than its uncertainty (3 sigma) and 20 µm.
    bool isSeen() const
    {
        return size_mm() > bendThresholds.seen_sigmas * sigma_mm && size_mm() > bendThresholds.seen_mm;
    }
    /// Expanded (k = 2): from the scatter of the centres, and from curves that no quartic is.
    double uncertainty_mm() const { return std::hypot(2 * sigma_mm, bendThresholds.shape_share * size_mm()); }
    /// More than 1 mm or a 200th of the length, by more than its uncertainty: no body of revolution any more.
    bool isLarge() const
    {
        const double least_mm = size_mm() - uncertainty_mm();
        return isSeen() &&
               (least_mm > bendThresholds.largest_mm || least_mm > length_mm() / bendThresholds.largest_part);
    }

    Eigen::Vector3d straightened(const Eigen::Vector3d& point) const
    {
        const double t = (along.dot(point) - middle_mm) / half_mm, square = t * t;
        return point - bow_mm * (square - 1.0 / 3) - cubic_mm * (t * (square - 0.6)) -
               quartic_mm * (square * (square - 6.0 / 7) + 3.0 / 35);
    }
    /// The total bend when `rest` was found after `first` had been removed.
    static Bend sum(const Bend& first, const Bend& rest);
};

/// Degree of the curve through the centres.
enum class BendShape { Parabola, Quartic };

/// The bend of a sample about its axis (in the frame of the points). A robust circle for each section and a curve
/// through the centres, whose scatter about it enters the uncertainty; where the terms of a quartic are not significant
/// it is a parabola too.
Bend findBend(const std::vector<Eigen::Vector3d>& sample, const Eigen::Isometry3d& axis_T_scan,
              const MeridianBins& bins, BendShape shape = BendShape::Parabola);

}  // namespace lathelier::registration
