// Whether the stated uncertainty of a turned part's pose holds: the truth lies within k = 2 in 90 to 99 of 100 scans.
#include <gtest/gtest.h>

#include <functional>
#include <numbers>

#include "engine/registration/registration_codes.h"
#include "engine/registration/revolution/revolution.h"
#include "tests/engine/registration/synthetic_pair.h"

namespace lathelier::registration {
namespace {

using namespace testing_pair;
using Eigen::Isometry3d;
using Eigen::Vector3d;
using std::numbers::pi;

/// How a part stands under the scanner: turned about its middle, then moved.
Isometry3d standing(double tilt_deg, double azimuth, double offset_mm, double offset_azimuth, double lift_mm,
                    double roll)
{
    const Vector3d middle(0, 0, 91.5);
    return Isometry3d(
        Eigen::Translation3d(offset_mm * std::cos(offset_azimuth), offset_mm * std::sin(offset_azimuth), lift_mm) *
        Eigen::Translation3d(middle) *
        Eigen::AngleAxisd(tilt_deg * pi / 180, Vector3d(std::cos(azimuth), std::sin(azimuth), 0)) *
        Eigen::AngleAxisd(roll, Vector3d::UnitZ()) * Eigen::Translation3d(-middle));
}

struct LeaningScan {
    Isometry3d reference_T_part, copy_T_part;
    Alignment alignment;
    double axial_um = 0;  ///< signed error at mid length
};

/// The reference nearly upright and whole; the copy leans, and what stands beyond the scanner's 183 mm is missing.
class LeaningScans {
public:
    explicit LeaningScans(double angle_step_deg) : step_(angle_step_deg)
    {
        sample::ScannerModel a;
        a.angle_step_deg = step_;
        a.seed = 900;
        pose_ = a.scan_T_part = standing(0.4, 0.5, 0.8, 1.2, 0, 0);
        points_ = sample::scanShaft(sample::nominalShaft(), a).points_mm;
        reference_.fit = fitRevolution(points_);
    }
    LeaningScan operator()(sample::ScannerModel b, const sample::ShaftModel& shaft = sample::nominalShaft()) const
    {
        b.angle_step_deg = step_;
        b.scan_z_from_mm = 0;
        b.scan_z_to_mm = 183;
        const Scan scan = sample::scanShaft(shaft, b);
        TurnedPart reference = reference_;
        TurnedPart copy{fitRevolution(scan.points_mm), {}};
        ShoulderPair shoulders = findShoulders(points_, reference.fit, scan.points_mm, copy.fit);
        reference.shoulders = shoulders.reference;
        copy.shoulders = shoulders.copy;
        LeaningScan result;
        result.reference_T_part = pose_;
        result.copy_T_part = b.frame_T_scan * b.scan_T_part;
        result.alignment = alignRevolution(reference, copy, InitialPose::Auto);
        const Vector3d middle(0, 0, 91.5);
        const Vector3d e = result.alignment.reference_T_copy * (result.copy_T_part * middle) - pose_ * middle;
        result.axial_um = 1e3 * e.dot(pose_.linear().col(2));
        return result;
    }

private:
    double step_;
    Isometry3d pose_;
    std::vector<Vector3d> points_;
    TurnedPart reference_;
};

TEST(LeaningScans, KeepTheAxialPositionWithAnEndMissing)
{
    const LeaningScans scans(0.9);  // the limit is that of a full scan
    for (int k = 0; k < 4; ++k) {
        sample::ScannerModel b;
        b.seed = 910 + static_cast<std::uint64_t>(k);
        b.sigma_mm = k % 2 ? 0.05 : 0.10;
        b.dropout_share = k % 3 == 2 ? 0.3 : 0;
        b.spurious_share = k % 4 == 3 ? 0.02 : 0;
        // Beside the scanner's axis in the direction in which it leans: there rays toward the part's axis are most
        // wrong.
        b.scan_T_part =
            standing(4 + k * 1.0, 0.7 * k, 2.5, 0.7 * k + (k % 4 < 2 ? -pi / 2 : pi / 2), k < 3 ? 8 : -9, k);
        const LeaningScan scan = scans(b);
        EXPECT_FALSE(contains(scan.alignment.notes, notes::motionNotDetermined)) << k;
        EXPECT_LT(std::abs(scan.axial_um), 8) << k;
        EXPECT_LT(scan.alignment.uncertainty.axial_um, 20) << k;
    }
}

TEST(LeaningScans, AxialUncertaintyCoversTheTruth)
{
    const LeaningScans scans(7.2);
    int covered = 0;
    constexpr int setCount = 30;
    for (int k = 0; k < setCount; ++k) {
        const auto draw = [&](std::uint64_t i) { return randomUniform(431, static_cast<std::uint64_t>(k), i); };
        sample::ScannerModel b;
        b.seed = 2000 + static_cast<std::uint64_t>(k);
        b.sigma_mm = k % 2 ? 0.05 : 0.10;
        b.dropout_share = 0.15 * (k % 3);
        b.spurious_share = 0.01 * (k / 3 % 3);
        b.scan_T_part = standing(10 * draw(0), 2 * pi * draw(1), 3 * draw(2), 2 * pi * draw(3), 24 * draw(4) - 12,
                                 2 * pi * draw(5));
        const LeaningScan scan = scans(b);
        EXPECT_FALSE(contains(scan.alignment.notes, notes::motionNotDetermined)) << k;
        if (std::abs(scan.axial_um) <= scan.alignment.uncertainty.axial_um) ++covered;
        EXPECT_LT(std::abs(scan.axial_um), 2.5 * scan.alignment.uncertainty.axial_um) << k;
    }
    EXPECT_GE(covered, setCount * 90 / 100);
}

/// Adds noise along the scanner's rays, which run toward z.
void disturb(std::vector<Vector3d>& points, const std::function<double(std::size_t)>& noise_mm)
{
    for (std::size_t i = 0; i < points.size(); ++i) {
        const double r = points[i].head<2>().norm();
        if (r > 0) points[i].head<2>() *= (r + noise_mm(i)) / r;
    }
}

TEST(AxisUncertainty, CoversTheTruthForEveryKindOfNoise)
{
    enum Kind { White, Correlated, Quantised, Spiky, Stepped, Kinds };
    constexpr int setCount = 20;
    int all_radial = 0, all_angle = 0;
    for (int kind = 0; kind < Kinds; ++kind) {
        int radial = 0, angle = 0;
        for (int k = 0; k < setCount; ++k) {
            const auto seed = static_cast<std::uint64_t>(100 * kind + k);
            sample::ScannerModel scanner;
            scanner.row_pitch_mm = 0.5;
            scanner.angle_step_deg = 6;
            scanner.seed = 3000 + seed;
            scanner.sigma_mm = kind == White ? 0.05 : 0.03;
            scanner.scan_T_part = standing(2 * randomUniform(77, seed, 0), 6 * randomUniform(77, seed, 1), 1, 2, 0, 0);
            Scan scan = sample::scanShaft(sample::nominalShaft(), scanner);
            auto& points = scan.points_mm;
            double state = 0;
            if (kind == Correlated)  // along the rows, over about five points
                disturb(points, [&](std::size_t i) {
                    state = 0.8 * state + 0.03 * randomNormal(seed, 50, i);
                    return state;
                });
            if (kind == Quantised)
                disturb(points, [&](std::size_t i) {
                    const double r = points[i].head<2>().norm();
                    return 0.1 * std::round(r / 0.1) - r;
                });
            if (kind == Spiky)
                disturb(points, [&](std::size_t i) {
                    return randomUniform(seed, 51, i) < 0.03 ? 2 * randomNormal(seed, 52, i) : 0.0;
                });
            if (kind == Stepped)
                disturb(points, [&](std::size_t i) {  // the range jumps every 40 points
                    return 0.05 * randomNormal(seed, 53, i / 40 % 700);
                });
            const RevolutionFit fit = fitRevolution(points);
            ASSERT_TRUE(isBodyOfRevolution(fit)) << kind << " " << k;
            const Isometry3d part_T_axis = (fit.axis_T_scan * scanner.scan_T_part).inverse();
            const Vector3d place = part_T_axis.translation();
            const Vector3d direction = part_T_axis.linear().col(2);
            const auto& c = fit.covariance;
            if (place.head<2>().norm() <= 2 * std::sqrt(c(0, 0) + c(1, 1))) ++radial;
            if (direction.head<2>().norm() <= 2 * std::sqrt(c(2, 2) + c(3, 3))) ++angle;
        }
        // With 20 sets at a coverage of 95 %, fewer than 16 contain the true value with probability 1/400.
        EXPECT_GE(radial, setCount * 80 / 100) << "noise of kind " << kind;
        EXPECT_GE(angle, setCount * 80 / 100) << "noise of kind " << kind;
        all_radial += radial;
        all_angle += angle;
    }
    EXPECT_GE(all_radial, Kinds * setCount * 90 / 100);
    EXPECT_GE(all_angle, Kinds * setCount * 90 / 100);
}

}  // namespace
}  // namespace lathelier::registration
