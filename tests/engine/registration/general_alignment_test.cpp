#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <bit>
#include <cmath>
#include <numbers>
#include <random>
#include <stop_token>

#include "engine/core/core_codes.h"
#include "engine/core/parallel.h"
#include "engine/core/units.h"
#include "engine/io/io_codes.h"
#include "engine/registration/general/general.h"
#include "engine/registration/general/observability.h"
#include "engine/registration/registration_codes.h"
#include "engine/sample/sample.h"

namespace lathelier::registration {
namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;

const Vector3d bracket_centre(40, 40, 30);

Isometry3d randomPose(std::mt19937& random, double angle, double shift_mm)
{
    std::normal_distribution<double> normal;
    const auto direction = [&] { return Vector3d(normal(random), normal(random), normal(random)).normalized(); };
    return Eigen::Translation3d(shift_mm * direction()) * Eigen::AngleAxisd(angle, direction());
}

Scan movedScan(Scan scan, const Isometry3d& pose)
{
    for (Vector3d& p : scan.points_mm) p = pose * p;
    return scan;
}

struct MotionError {
    double translation_um;
    double rotation_deg;
};

/// Of reference_T_copy for a copy that was moved by `copy_T_reference`, at `at_mm` of the reference.
MotionError motionError(const Alignment& alignment, const Isometry3d& copy_T_reference,
                        const Vector3d& at_mm = bracket_centre)
{
    const Isometry3d error = alignment.reference_T_copy * copy_T_reference;
    return {1000 * (error * at_mm - at_mm).norm(), Eigen::AngleAxisd(error.linear()).angle() / rad_per_deg};
}

template <class Place>
Scan scanOf(int count, double sigma, unsigned seed, Place place)
{
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> unit(0, 1);
    std::normal_distribution<double> noise(0, sigma);
    Scan scan;
    for (int i = 0; i < count; ++i) {
        const double s = unit(random);
        const double t = unit(random);
        scan.points_mm.push_back(place(s, t, noise(random)));
    }
    return scan;
}

TEST(AlignGeneral, RecoversAnyPoseWithinItsUncertainty)
{
    std::mt19937 random(5);
    const GeneralReference reference = prepareReference(sample::scanBracket(30000, 0.05, Isometry3d::Identity(), 1));
    for (int i = 0; i < 4; ++i) {
        const Isometry3d pose = randomPose(random, (i * 60) * rad_per_deg, 500);
        const Scan copy = sample::scanBracket(30000, 0.05, pose, 100 + static_cast<unsigned>(i));
        const Alignment a = alignGeneral(reference, copy, CompareMethod::Plane, InitialPose::Auto);
        EXPECT_TRUE(a.converged);
        EXPECT_TRUE(a.free_motions.empty());
        const MotionError e = motionError(a, pose);
        EXPECT_LT(e.translation_um, 10) << "pose " << i;
        EXPECT_LT(e.rotation_deg, 0.006) << "pose " << i;
        EXPECT_GT(a.uncertainty.axial_um, 0.5);
        EXPECT_LT(a.uncertainty.axial_um, 5);
    }
}

TEST(AlignGeneral, FindsAPartThatIsPartlyMissingAmongSpuriousPoints)
{
    std::mt19937 random(7);
    std::uniform_real_distribution<double> place(-10, 110);
    const Scan reference = sample::scanBracket(30000, 0.05, Isometry3d::Identity(), 1);
    const GeneralReference prepared = prepareReference(reference);
    for (int i = 0; i < 3; ++i) {
        const Isometry3d pose = randomPose(random, (20 + 75 * i) * rad_per_deg, 200);
        const Vector3d cut = Vector3d(i == 0, i == 1, i == 2) + Vector3d(0.1, 0.3, 0.2);
        Scan copy = sample::scanBracket(30000, 0.05, Isometry3d::Identity(), 50 + static_cast<unsigned>(i));
        std::vector<double> heights;
        for (const Vector3d& p : copy.points_mm) heights.push_back(cut.dot(p));
        std::nth_element(heights.begin(), heights.begin() + 21000, heights.end());
        std::erase_if(copy.points_mm, [&](const Vector3d& p) { return cut.dot(p) > heights[21000]; });
        for (int s = 0; s < 420; ++s) copy.points_mm.emplace_back(place(random), place(random), place(random));
        const Alignment a = alignGeneral(prepared, movedScan(copy, pose), CompareMethod::Plane, InitialPose::Auto);
        EXPECT_TRUE(a.converged);
        const MotionError e = motionError(a, pose);
        EXPECT_LT(e.translation_um, 12) << "cut " << i;
        EXPECT_LT(e.rotation_deg, 0.01) << "cut " << i;
        const Alignment b = alignGeneral(movedScan(copy, pose), reference, CompareMethod::Plane, InitialPose::Auto);
        EXPECT_LT(motionError(b, pose.inverse(), pose * bracket_centre).translation_um, 12) << "swapped, cut " << i;
    }
}

TEST(AlignGeneral, TakesMeshesOnEitherSide)
{
    std::mt19937 random(9);
    const Isometry3d pose = randomPose(random, 70 * rad_per_deg, 100);
    const Scan cloud = sample::scanBracket(30000, 0.05, pose, 3);
    const Alignment onto_mesh = alignGeneral(sample::bracketMesh(), cloud, CompareMethod::Plane, InitialPose::Auto);
    EXPECT_LT(motionError(onto_mesh, pose).translation_um, 6);
    const Alignment of_mesh = alignGeneral(cloud, sample::bracketMesh(), CompareMethod::Plane, InitialPose::Auto);
    EXPECT_LT(motionError(of_mesh, pose.inverse(), pose * bracket_centre).translation_um, 6);
    const Alignment both = alignGeneral(sample::bracketMesh(), movedScan(sample::bracketMesh(), pose),
                                        CompareMethod::Plane, InitialPose::Auto);
    EXPECT_LT(motionError(both, pose).translation_um, 0.01);
}

TEST(AlignGeneral, ForwardAndInverseAgree)
{
    std::mt19937 random(11);
    const Isometry3d pose = randomPose(random, 25 * rad_per_deg, 20);
    const Scan a = sample::scanBracket(40000, 0.05, Isometry3d::Identity(), 1);
    const Scan b = sample::scanBracket(40000, 0.05, pose, 2);
    const Alignment forward = alignGeneral(a, b, CompareMethod::Plane, InitialPose::Auto);
    const Alignment inverse = alignGeneral(b, a, CompareMethod::Plane, InitialPose::Auto);
    const MotionError e = motionError(forward, inverse.reference_T_copy);
    EXPECT_LT(e.translation_um, 4);
    EXPECT_LT(e.rotation_deg, 0.004);
}

TEST(AlignGeneral, DoesNotDependOnWhereBothStand)
{
    std::mt19937 random(13);
    const Isometry3d pose = randomPose(random, 10 * rad_per_deg, 5);
    const Isometry3d far = Eigen::Translation3d(1e6, -2e6, 5e5) * Eigen::AngleAxisd(2, Vector3d(1, 2, 3).normalized());
    const Scan a = sample::scanBracket(20000, 0.05, Isometry3d::Identity(), 1);
    const Scan b = sample::scanBracket(20000, 0.05, pose, 2);
    const Alignment here = alignGeneral(a, b, CompareMethod::Plane, InitialPose::Auto);
    const Alignment there = alignGeneral(movedScan(a, far), movedScan(b, far), CompareMethod::Plane, InitialPose::Auto);
    const Isometry3d expected = far * here.reference_T_copy * far.inverse();
    const Vector3d at = far * bracket_centre;
    EXPECT_LT(1000 * (there.reference_T_copy * at - expected * at).norm(), 2);
}

TEST(AlignGeneral, OfACloudWithItselfIsExact)
{
    std::mt19937 random(15);
    const Scan a = sample::scanBracket(20000, 0.05, Isometry3d::Identity(), 1);
    const Isometry3d pose = randomPose(random, 100 * rad_per_deg, 50);
    for (const Isometry3d& p : {Isometry3d::Identity(), pose}) {
        const Alignment alignment = alignGeneral(a, movedScan(a, p), CompareMethod::Plane, InitialPose::Auto);
        EXPECT_TRUE(alignment.converged);
        const MotionError e = motionError(alignment, p);
        EXPECT_LT(e.translation_um, 1e-6);
        EXPECT_LT(e.rotation_deg, 1e-9);
    }
}

TEST(AlignGeneral, IsTheSameForAnyNumberOfThreads)
{
    std::mt19937 random(17);
    const Scan a = sample::scanBracket(20000, 0.05, Isometry3d::Identity(), 1);
    const Scan b = sample::scanBracket(20000, 0.05, randomPose(random, 2, 30), 2);
    const Alignment many = alignGeneral(a, b, CompareMethod::Plane, InitialPose::Auto);
    const ThreadLimit limit(1);
    ASSERT_EQ(threadsAllowed(), 1u);
    const Alignment one = alignGeneral(a, b, CompareMethod::Plane, InitialPose::Auto);
    EXPECT_EQ(many.iterations, one.iterations);
    EXPECT_EQ(many.uncertainty.axial_um, one.uncertainty.axial_um);
    for (int i = 0; i < 16; ++i)
        EXPECT_EQ(many.reference_T_copy.matrix().data()[i], one.reference_T_copy.matrix().data()[i]);
}

TEST(AlignGeneral, ThePlaneLeavesThreeMotionsFree)
{
    const auto plate = [](unsigned seed) {
        return scanOf(20000, 0.02, seed, [](double s, double t, double e) { return Vector3d(60 * s, 40 * t, e); });
    };
    const Isometry3d pose =
        Eigen::Translation3d(0, 0, 3) * Eigen::AngleAxisd(4 * rad_per_deg, Vector3d(1, 1, 0).normalized());
    const Alignment a = alignGeneral(plate(1), movedScan(plate(2), pose), CompareMethod::Plane, InitialPose::Identity);
    EXPECT_TRUE(a.converged);
    ASSERT_EQ(a.free_motions.size(), 3U);
    int translations = 0;
    for (const FreeMotion& m : a.free_motions) {
        if (m.kind == FreeMotion::Kind::Translation) {
            ++translations;
            EXPECT_LT(std::abs(m.direction.z()), 0.01);
        } else {
            EXPECT_GT(std::abs(m.direction.z()), 0.999);
        }
    }
    EXPECT_EQ(translations, 2);
    EXPECT_TRUE(contains(a.notes, notes::motionNotDetermined));
    const Vector3d turned = a.reference_T_copy.linear() * pose.linear() * Vector3d::UnitZ();
    EXPECT_LT(std::acos(std::min(1.0, std::abs(turned.z()))) / rad_per_deg, 0.01);
    // The tilt is undone, nothing else: no turn about the normal, no shift along the plane.
    EXPECT_NEAR(Eigen::AngleAxisd(a.reference_T_copy.linear()).angle() / rad_per_deg, 4, 0.05);
}

TEST(AlignGeneral, TheCylinderLeavesRollAndShiftFree)
{
    const auto tube = [](unsigned seed) {
        return scanOf(40000, 0.02, seed, [](double s, double t, double e) {
            const double a = 2 * std::numbers::pi * s;
            return Vector3d((12 + e) * std::cos(a), (12 + e) * std::sin(a), 90 * t);
        });
    };
    const Isometry3d pose =
        Eigen::Translation3d(1, 0.5, 0) * Eigen::AngleAxisd(3 * rad_per_deg, Vector3d(1, 2, 0).normalized());
    const Alignment a = alignGeneral(tube(1), movedScan(tube(2), pose), CompareMethod::Plane, InitialPose::Identity);
    EXPECT_TRUE(a.converged);
    ASSERT_EQ(a.free_motions.size(), 2U);
    bool roll = false;
    bool shift = false;
    for (const FreeMotion& m : a.free_motions) {
        EXPECT_GT(std::abs(m.direction.z()), 0.999);
        (m.kind == FreeMotion::Kind::Rotation ? roll : shift) = true;
        if (m.kind == FreeMotion::Kind::Rotation) {
            EXPECT_LT(m.point_mm.head<2>().norm(), 0.1);
        }
    }
    EXPECT_TRUE(roll && shift);
    const Vector3d axis = a.reference_T_copy.linear() * pose.linear() * Vector3d::UnitZ();
    EXPECT_LT(std::acos(std::min(1.0, std::abs(axis.z()))) / rad_per_deg, 0.005);
}

TEST(AlignGeneral, TheSphereLeavesThreeRotationsFree)
{
    const auto ball = [](unsigned seed) {
        return scanOf(40000, 0.02, seed, [](double s, double t, double e) {
            const double z = 2 * s - 1;
            const double a = 2 * std::numbers::pi * t;
            const double r = std::sqrt(1 - z * z);
            return Vector3d((25 + e) * Vector3d(r * std::cos(a), r * std::sin(a), z));
        });
    };
    const Isometry3d pose = Eigen::Translation3d(1, -2, 0.5) * Eigen::AngleAxisd(30 * rad_per_deg, Vector3d::UnitX());
    const Alignment a = alignGeneral(ball(1), movedScan(ball(2), pose), CompareMethod::Plane, InitialPose::Identity);
    EXPECT_TRUE(a.converged);
    ASSERT_EQ(a.free_motions.size(), 3U);
    for (const FreeMotion& m : a.free_motions) {
        EXPECT_EQ(m.kind, FreeMotion::Kind::Rotation);
        EXPECT_LT(m.point_mm.norm(), 0.5);
    }
    EXPECT_LT(Eigen::AngleAxisd(a.reference_T_copy.linear()).angle() / rad_per_deg, 0.1)
        << "nothing asks for a rotation";
    EXPECT_LT(1000 * (a.reference_T_copy * pose * Vector3d::Zero()).norm(), 3);
}

TEST(AlignGeneral, ASymmetricPlateTakesTheSmallestRotationAndSaysSo)
{
    // 80 × 50 × 6 mm: four poses fit.
    const auto box = [](unsigned seed) {
        return scanOf(40000, 0.02, seed, [&](double s, double t, double e) {
            const Vector3d half(40, 25, 3);
            const double areas[3] = {4 * half.y() * half.z(), 4 * half.x() * half.z(), 4 * half.x() * half.y()};
            double along = s * 2 * (areas[0] + areas[1] + areas[2]);
            int axis = 0;
            while (axis < 2 && along > 2 * areas[axis]) along -= 2 * areas[axis++];
            const int u = (axis + 1) % 3;
            const int v = (axis + 2) % 3;
            Vector3d p;
            const bool far = along > areas[axis];
            const double rest = (far ? along - areas[axis] : along) / areas[axis];
            p[axis] = (far ? 1 : -1) * (half[axis] + e);
            p[u] = (2 * rest - 1) * half[u];
            p[v] = (2 * t - 1) * half[v];
            return p;
        });
    };
    const Isometry3d pose =
        Eigen::Translation3d(3, 4, 5) * Eigen::AngleAxisd(35 * rad_per_deg, Vector3d(1, 2, 3).normalized());
    const Alignment a = alignGeneral(box(1), movedScan(box(2), pose), CompareMethod::Plane, InitialPose::Auto);
    EXPECT_TRUE(a.converged);
    EXPECT_TRUE(contains(a.notes, notes::severalPosesFit));
    EXPECT_LT(motionError(a, pose, Vector3d::Zero()).translation_um, 5);
}

TEST(AlignGeneral, DifferentPartsDoNotFit)
{
    const Scan bracket = sample::scanBracket(20000, 0.05, Isometry3d::Identity(), 1);
    sample::ScannerModel scanner;
    scanner.row_pitch_mm = 1;
    scanner.angle_step_deg = 3;
    const Scan shaft = sample::scanShaft(sample::nominalShaft(), scanner);
    const Alignment a = alignGeneral(bracket, shaft, CompareMethod::Plane, InitialPose::Auto);
    EXPECT_TRUE(a.reference_T_copy.matrix().allFinite());
}

TEST(AlignGeneral, PointToPointStaysHonest)
{
    std::mt19937 random(19);
    const Scan a = sample::scanBracket(30000, 0.05, Isometry3d::Identity(), 1);
    const Isometry3d pose = randomPose(random, 5 * rad_per_deg, 2);
    const Alignment alignment =
        alignGeneral(a, sample::scanBracket(30000, 0.05, pose, 2), CompareMethod::Point, InitialPose::Identity);
    if (alignment.converged) {
        EXPECT_LT(motionError(alignment, pose).translation_um, 60);
    }
}

TEST(AlignGeneral, RefusesWhatDeterminesNothing)
{
    const Scan bracket = sample::scanBracket(5000, 0.05, Isometry3d::Identity(), 1);
    const auto refusal = [&](std::vector<Vector3d> points) {
        Scan scan;
        scan.points_mm = std::move(points);
        try {
            alignGeneral(bracket, scan, CompareMethod::Plane, InitialPose::Auto);
        } catch (const Error& e) {
            return e.code();
        }
        return errors::noPoints;
    };
    EXPECT_EQ(refusal({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}), errors::tooFewPoints);
    EXPECT_EQ(refusal(std::vector<Vector3d>(1000, Vector3d(1, 2, 3))), errors::pointsDegenerate);
    std::vector<Vector3d> line;
    for (int i = 0; i < 1000; ++i) line.emplace_back(0.1 * i, 0.2 * i, 1e6);
    EXPECT_EQ(refusal(line), errors::pointsDegenerate);
}

TEST(AlignGeneral, SurvivesTinyAndScatteredClouds)
{
    std::mt19937 random(21);
    std::uniform_real_distribution<double> unit(0, 1);
    const Scan bracket = sample::scanBracket(5000, 0.05, Isometry3d::Identity(), 1);
    for (double scale : {1e-3, 1.0, 1e3}) {
        for (int count : {4, 30}) {
            Scan cloud;
            for (int i = 0; i < count; ++i)
                cloud.points_mm.emplace_back(scale * Vector3d(unit(random), unit(random), unit(random)));
            using Pair = std::pair<const Scan*, const Scan*>;
            for (const auto& [reference, copy] :
                 {Pair{&bracket, &cloud}, Pair{&cloud, &bracket}, Pair{&cloud, &cloud}}) {
                const Alignment a = alignGeneral(*reference, *copy, CompareMethod::Plane, InitialPose::Auto);
                EXPECT_TRUE(a.reference_T_copy.matrix().allFinite());
                EXPECT_TRUE(std::isfinite(a.uncertainty.axial_um));
            }
        }
    }
}

TEST(AlignGeneral, CanBeCancelled)
{
    std::stop_source stop;
    stop.request_stop();
    const Scan bracket = sample::scanBracket(20000, 0.05, Isometry3d::Identity(), 1);
    EXPECT_THROW(
        alignGeneral(bracket, bracket, CompareMethod::Plane, InitialPose::Auto, Progress(stop.get_token(), {})),
        Cancelled);
}

}  // namespace
}  // namespace lathelier::registration
