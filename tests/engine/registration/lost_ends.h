// Scans of one shaft that lose different ends, compared.
#pragma once

#include "engine/registration/compare.h"
#include "tests/engine/registration/stepped_scan.h"
#include "tests/engine/registration/within_tolerance.h"

namespace lathelier::testing_lost_ends {

using Eigen::Isometry3d;
using Eigen::Vector3d;
using testing_steps::Steps;

inline Isometry3d anyPoseBy(std::uint64_t seed)
{
    const auto normal = [&](std::uint64_t k) { return randomNormal(831, seed, k); };
    Isometry3d pose = Isometry3d::Identity();
    pose.linear() = Eigen::Quaterniond(normal(0), normal(1), normal(2), normal(3)).normalized().toRotationMatrix();
    pose.translation() = 30 * Vector3d(normal(4), normal(5), normal(6));
    return pose;
}

inline double axialError_um(const Isometry3d& reference_T_copy, const Isometry3d& reference_T_part,
                            const Isometry3d& copy_T_part, double middle_mm)
{
    const Vector3d middle(0, 0, middle_mm);
    return 1000 * (reference_T_copy * (copy_T_part * middle) - reference_T_part * middle)
                      .dot(reference_T_part.linear().col(2));
}

struct LostEnds {
    registration::CompareResult result;
    double axial_um = 0;
};

/// The reference without its last 5 mm, the copy without its first 6 mm, each in any pose.
inline LostEnds compareWithLostEnds(const Steps& shaft, std::size_t count, std::uint64_t seed)
{
    const Isometry3d reference_T_part = anyPoseBy(2 * seed);
    const Isometry3d copy_T_part = anyPoseBy(2 * seed + 1);
    const double length = testing_steps::lengthOf(shaft);
    const Scan reference =
        testing_steps::scanEvenly(shaft, count, 0.05, -1, length - 5, reference_T_part, 2 * seed + 1);
    const Scan copy = testing_steps::scanEvenly(shaft, count, 0.05, 6, length + 1, copy_T_part, 2 * seed + 2);
    LostEnds lost{
        compare(reference, copy, registration::withinTolerance(0.1), {}, registration::CompareDetail::Summary), 0};
    lost.axial_um = axialError_um(lost.result.alignment.reference_T_copy, reference_T_part, copy_T_part, length / 2);
    return lost;
}

/// Two shoulders of 2 to 6 mm.
inline Steps randomShaft(std::uint64_t seed)
{
    const auto draw = [&](std::uint64_t k) { return randomUniform(832, seed, k); };
    const double middle = 15 + 10 * draw(3);
    const double first = middle + (draw(4) < 0.5 ? 1 : -1) * (2 + 4 * draw(5));
    const double last = middle + (draw(6) < 0.5 ? 1 : -1) * (2 + 4 * draw(7));
    return {{20 + 40 * draw(0), first}, {15 + 35 * draw(1), middle}, {20 + 40 * draw(2), last}};
}

}  // namespace lathelier::testing_lost_ends
