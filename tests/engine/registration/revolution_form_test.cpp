// What is a body of revolution and what is not: bores, rough zones, bends, arcs, and clouds that resemble one.
#include <gtest/gtest.h>

#include <functional>
#include <numbers>

#include "engine/core/core_codes.h"
#include "engine/core/random.h"
#include "engine/registration/compare.h"
#include "engine/registration/registration_codes.h"
#include "engine/registration/revolution/revolution_axis.h"
#include "engine/sample/sample.h"

namespace lathelier::registration {
namespace {

using Eigen::Vector3d;
using std::numbers::pi;

/// `count` points by a rule from three even random numbers, with noise in all directions.
Scan cloud(std::size_t count, double sigma_mm, const std::function<Vector3d(double, double, double)>& place)
{
    Scan scan;
    for (std::size_t i = 0; i < count; ++i) {
        const Vector3d noise(randomNormal(21, 0, i), randomNormal(21, 1, i), randomNormal(21, 2, i));
        scan.points_mm.push_back(place(randomUniform(21, 3, i), randomUniform(21, 4, i), randomUniform(21, 5, i)) +
                                 sigma_mm * noise);
    }
    return scan;
}

Scan shaftScan(double row_pitch_mm, double angle_step_deg, std::uint64_t seed)
{
    sample::ScannerModel scanner;
    scanner.row_pitch_mm = row_pitch_mm;
    scanner.angle_step_deg = angle_step_deg;
    scanner.seed = seed;
    return sample::scanShaft(sample::nominalShaft(), scanner);
}

Scan bent(Scan scan, double bow_mm)
{
    for (Vector3d& p : scan.points_mm) p.x() += bow_mm * std::sin(pi * std::clamp(p.z() / 183, 0.0, 1.0));
    return scan;
}

CompareParameters revolution()
{
    CompareParameters parameters;
    parameters.method = CompareMethod::Revolution;
    return parameters;
}

/// Code and `reason` of the refusal of a cloud compared with itself.
std::string refusalOf(const Scan& scan)
{
    try {
        compare(scan, scan, revolution());
    } catch (const Error& error) {
        EXPECT_NE(find(error.values(), "role"), nullptr);
        const Value* reason = find(error.values(), "reason");
        return std::string(error.code().key) + (reason ? " " + std::get<std::string>(*reason) : "");
    }
    return "accepted";
}

double valueOf(const Notes& notes, const NoteCode& code, const char* name)
{
    for (const Note& note : notes)
        if (note.code == code) return std::get<double>(*find(note.values, name));
    return -1;
}

TEST(NotTurned, IsRefusedWithItsReason)
{
    EXPECT_EQ(refusalOf(cloud(4000, 0.001, [](double, double, double c) { return Vector3d(0, 0, 100 * c); })),
              "points_degenerate");
    EXPECT_EQ(refusalOf(cloud(6000, 0.03, [](double a, double b, double) { return Vector3d(100 * a, 100 * b, 0); })),
              "not_a_body_of_revolution flat");
    EXPECT_EQ(refusalOf(cloud(12000, 0.03,
                              [](double a, double b, double) {
                                  const double up = 2 * a - 1;
                                  const double across = std::sqrt(1 - up * up);
                                  return Vector3d(25 * across * std::cos(2 * pi * b),
                                                  25 * across * std::sin(2 * pi * b), 25 * up);
                              })),
              "not_a_body_of_revolution no_single_axis");
    EXPECT_EQ(refusalOf(cloud(12000, 0.03,
                              [](double a, double b, double) {  // a hexagonal bar, 30 across flats
                                  const double third = pi / 3;
                                  const double angle = 2 * pi * a;
                                  const double r = 15 / std::cos(std::fmod(angle + third / 2, third) - third / 2);
                                  return Vector3d(r * std::cos(angle), r * std::sin(angle), 80 * b);
                              })),
              "not_a_body_of_revolution not_round");
    EXPECT_EQ(refusalOf(cloud(12000, 0.01,
                              [](double a, double b, double) {  // a spring of 0.8 mm wire
                                  const double t = 2 * pi * 30 * a;
                                  const Vector3d out(std::cos(t), std::sin(t), 0);
                                  const double turn = 2 * pi * b;
                                  return Vector3d(out * (12 + 0.8 * std::cos(turn)) +
                                                  Vector3d(0, 0, 90 * a + 0.8 * std::sin(turn)));
                              })),
              "not_a_body_of_revolution not_round");
    Scan two = shaftScan(0.5, 3.6, 3);
    const std::size_t half = two.points_mm.size();
    for (std::size_t i = 0; i < half; ++i) two.points_mm.push_back(two.points_mm[i] + Vector3d(60, 0, 0));
    EXPECT_EQ(refusalOf(two), "not_a_body_of_revolution several_parts");
}

TEST(NotTurned, TakesItsMeasureFromTheArc)
{
    const Scan whole = shaftScan(0.5, 3.6, 3);
    const auto arc = [&](double degrees) {
        Scan part;
        for (const Vector3d& p : whole.points_mm)
            if (std::atan2(p.y(), p.x()) * 180 / pi + 180 < degrees) part.points_mm.push_back(p);
        return part;
    };
    EXPECT_EQ(refusalOf(arc(40)), "coverage_too_small");
    const Scan half = arc(150);
    const CompareResult result = compare(half, half, revolution());
    EXPECT_NEAR(valueOf(result.notes, notes::coverageBelowHalf, "coverage_deg"), 150, 6);
    EXPECT_FALSE(contains(compare(whole, whole, revolution()).notes, notes::coverageBelowHalf));
}

/// A bar ⌀25 × 240 with chamfers, bent by `shape` of z over its length.
Scan bentBar(const std::function<double(double)>& shape, std::uint64_t seed)
{
    sample::ScannerModel scanner;
    scanner.row_pitch_mm = 0.4;
    scanner.angle_step_deg = 3;
    scanner.sigma_mm = 0.03;
    scanner.seed = seed;
    const auto piece = [](double from, double to, double r0, double r1) {
        sample::ShaftPiece made;
        made.z_start_mm = from;
        made.z_end_mm = to;
        made.radius_start_mm = r0;
        made.radius_end_mm = r1;
        return made;
    };
    Scan scan =
        sample::scanShaft({piece(0, 1, 11.5, 12.5), piece(1, 239, 12.5, 12.5), piece(239, 240, 12.5, 11.5)}, scanner);
    for (Vector3d& p : scan.points_mm) p.y() += shape(std::clamp(p.z() / 240, 0.0, 1.0));
    return scan;
}

TEST(BentPart, PlainBarsOfAnyBowAndShape)
{
    std::uint64_t seed = 30;
    for (const double bow_mm : {0.05, 0.3, 0.5, 0.95}) {
        const auto sine = [&](double t) { return bow_mm * std::sin(pi * t); };
        const auto parabola = [&](double t) { return bow_mm * 4 * t * (1 - t); };
        // A bar on two supports with a force at mid length.
        const auto beam = [&](double t) {
            const double x = std::min(t, 1 - t);
            return bow_mm * (3 * x - 4 * x * x * x);
        };
        for (const std::function<double(double)>& shape :
             {std::function<double(double)>(sine), std::function<double(double)>(parabola),
              std::function<double(double)>(beam)}) {
            const RevolutionFit fit = fitRevolution(bentBar(shape, ++seed).points_mm);
            ASSERT_TRUE(isBodyOfRevolution(fit)) << bow_mm;
            EXPECT_NEAR(fit.bend.size_mm(), bow_mm, 0.03 * bow_mm + 2 * fit.bend.sigma_mm) << seed;
            EXPECT_NEAR(fit.sigma_mm, 0.03, 0.002) << seed;
            std::vector<double> radii = fit.profile.radius_mm;
            std::erase_if(radii, [](double r) { return std::isnan(r); });
            std::nth_element(radii.begin(), radii.begin() + static_cast<std::ptrdiff_t>(radii.size() / 2), radii.end());
            EXPECT_NEAR(radii[radii.size() / 2], 12.5, 0.001) << seed;
        }
    }
    // At the limit of 1 mm noise does not decide.
    for (const std::uint64_t bar_seed : {2U, 11U, 45U}) {
        const auto bowed = [&](double bow_mm) {
            return fitRevolution(bentBar([&](double t) { return bow_mm * std::sin(pi * t); }, bar_seed).points_mm);
        };
        EXPECT_TRUE(isBodyOfRevolution(bowed(1.0))) << bar_seed;
        EXPECT_EQ(bowed(1.15).not_turned, NotTurned::Bent) << bar_seed;
    }
    const auto strong = [](double t) { return 1.6 * std::sin(pi * t); };
    EXPECT_EQ(fitRevolution(bentBar(strong, 50).points_mm).not_turned, NotTurned::Bent);
    const auto straight = [](double) { return 0.0; };
    EXPECT_FALSE(fitRevolution(bentBar(straight, 51).points_mm).bend.isSeen());
}

TEST(BentPart, IsJudgedByItsBowAndNotByTheNumberOfPoints)
{
    for (const double pitch : {0.5, 0.2}) {
        const Scan straight = shaftScan(pitch, 3.6, 4);
        EXPECT_FALSE(contains(compare(straight, straight, revolution()).notes, notes::partIsBent)) << pitch;
        const Scan crooked = bent(straight, 0.3);
        const CompareResult result = compare(crooked, crooked, revolution());
        EXPECT_NEAR(valueOf(result.notes, notes::partIsBent, "bow_mm"), 0.3, 0.03) << pitch;
        EXPECT_NEAR(valueOf(compare(straight, bent(straight, 0.05)).notes, notes::partIsBent, "bow_mm"), 0.05, 0.01);
        EXPECT_EQ(refusalOf(bent(straight, 2)), "not_a_body_of_revolution bent") << pitch;
    }
    // The noise is that of the scanner, the axis that of the straight part.
    const RevolutionFit fit = fitRevolution(bent(shaftScan(0.5, 3.6, 4), 0.3).points_mm);
    EXPECT_NEAR(fit.sigma_mm, 0.05, 0.004);
}

TEST(HollowPart, HasAWallInsideAndOneOutside)
{
    const auto hollow = [](std::uint64_t seed, const Eigen::Isometry3d& pose) {
        Scan scan;
        for (std::size_t i = 0; i < 60000; ++i) {
            const double angle = 2 * pi * randomUniform(seed, 0, i);
            const double z = 60 * randomUniform(seed, 1, i);
            const bool inside = randomUniform(seed, 2, i) < 0.35;
            const double r = (inside ? (z < 20 ? 14 : 12) : (z < 25 ? 20 : 30)) + 0.05 * randomNormal(seed, 3, i);
            scan.points_mm.push_back(pose * Vector3d(r * std::cos(angle), r * std::sin(angle), z));
        }
        return scan;
    };
    const Scan scan = hollow(6, Eigen::Isometry3d::Identity());
    const CompareResult itself = compare(scan, scan, revolution());
    EXPECT_NEAR(itself.statistics.rmse_mm, 0.05, 0.006);
    EXPECT_GT(itself.statistics.overlap_percent, 99);
    const Eigen::Isometry3d away = Eigen::Translation3d(3, 2, 1) * Eigen::AngleAxisd(0.1, Vector3d::UnitX());
    const CompareResult other = compare(scan, hollow(7, away));
    EXPECT_EQ(other.method_used, CompareMethod::Revolution);
    EXPECT_NEAR(other.statistics.std_mm, 0.05, 0.008);
    // More material on the bore's wall is more material: the sign is that of the surface.
    Scan narrow = scan;
    for (Vector3d& p : narrow.points_mm)
        if (const double r = p.head<2>().norm(); r < 16) p.head<2>() *= (r - 0.1) / r;
    const CompareResult less = compare(scan, narrow, revolution());
    double sum = 0, n = 0;
    for (std::size_t i = 0; i < narrow.points_mm.size(); ++i)
        if (less.used[i] && narrow.points_mm[i].head<2>().norm() < 16) {
            sum += less.deviation_mm[i];
            n += 1;
        }
    EXPECT_NEAR(sum / n, 0.1, 0.01);
}

TEST(RoughZones, DoNotSetTheScatter)
{
    Scan scan;  // M16 thread and a knurl on two thirds of the length
    for (std::size_t i = 0; i < 60000; ++i) {
        const double turn = randomUniform(8, 0, i);
        const double z = 90 * randomUniform(8, 1, i);
        double r = z > 40 && z < 62 ? 9 : 8;
        if (z < 40) r -= std::clamp(2.4 * std::abs(std::fmod(z / 2 - turn + 1, 1.0) - 0.5) - 0.1, 0.0, 1.0);
        if (z > 62) r -= 0.45 * std::abs(2 * std::fmod(60 * (turn + z / 90) + 60, 1.0) - 1);
        r += 0.05 * randomNormal(8, 2, i);
        scan.points_mm.emplace_back(r * std::cos(2 * pi * turn), r * std::sin(2 * pi * turn), z);
    }
    const RevolutionFit fit = fitRevolution(scan.points_mm);
    ASSERT_TRUE(isBodyOfRevolution(fit));
    EXPECT_NEAR(fit.sigma_mm, 0.05, 0.01);  // 0.3 with the rough zones
    const Vector3d direction = fit.axis_T_scan.linear().row(2);
    EXPECT_LT(std::acos(std::min(1.0, std::abs(direction.z()))) * 180 / pi, 0.02);
    EXPECT_GT(compare(scan, scan, revolution()).statistics.overlap_percent, 90);
}

TEST(ThinScans, AreNotRefusedForALastStep)
{
    for (std::uint64_t seed = 1; seed <= 12; ++seed) {
        sample::ScannerModel scanner;
        scanner.row_pitch_mm = 0.5;
        scanner.angle_step_deg = 3.6;
        scanner.part_z_from_mm = 20;
        scanner.part_z_to_mm = 120;
        scanner.seed = 30 + seed;
        scanner.scan_T_part =
            Eigen::Translation3d(0.3, 0.7, 0) * Eigen::AngleAxisd(0.007, Vector3d(1, 0.6, 0).normalized());
        const RevolutionFit fit = fitRevolution(sample::scanShaft(sample::nominalShaft(), scanner).points_mm);
        EXPECT_TRUE(isBodyOfRevolution(fit)) << "seed " << seed;
        EXPECT_NEAR(fit.sigma_mm, 0.05, 0.005) << "seed " << seed;
    }
}

}  // namespace
}  // namespace lathelier::registration
