// Two synthetic scans with known poses, and the error measure of the practice data (shaft_truth.json, "score").
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "engine/core/random.h"
#include "engine/sample/sample.h"

namespace lathelier::testing_pair {

struct Pair {
    Scan reference;
    Scan copy;
    Eigen::Isometry3d reference_T_part;
    Eigen::Isometry3d copy_T_part;
};

struct PairOptions {
    sample::ShaftModel reference = sample::nominalShaft();
    sample::ShaftModel copy = sample::nominalShaft();
    double angle_step_deg = 3.6;  ///< a quarter of the points of a full scan
    double dropout_share = 0;
    double spurious_share = 0;
    bool flip = false;
    double copy_from_mm = -1e9;
    double copy_to_mm = 1e9;
};

/// Scans in poses drawn by `seed`: leaning up to 1.5° on the turntable, then moved by up to 10° and 16 mm.
inline Pair makePair(std::uint64_t seed, const PairOptions& options = {})
{
    const auto draw = [&](std::uint64_t k) { return 2 * randomUniform(77, seed, k) - 1; };
    sample::ScannerModel a;
    a.angle_step_deg = options.angle_step_deg;
    a.dropout_share = options.dropout_share;
    a.spurious_share = options.spurious_share;
    sample::ScannerModel b = a;
    a.seed = 1000 + 2 * seed;
    b.seed = 1001 + 2 * seed;
    a.scan_T_part = Eigen::Translation3d(draw(0), draw(1), draw(2)) *
                    Eigen::AngleAxisd(draw(3) * 0.01, Eigen::Vector3d(draw(4), draw(5), 0).normalized());
    b.scan_T_part = Eigen::Translation3d(draw(6), draw(7), draw(8)) *
                    Eigen::AngleAxisd(draw(12) * 3, Eigen::Vector3d::UnitZ()) *
                    Eigen::AngleAxisd(draw(9) * 0.026, Eigen::Vector3d(draw(10), draw(11), 0).normalized());
    b.frame_T_scan = Eigen::Translation3d(draw(13) * 9, draw(14) * 9, draw(15) * 9) *
                     Eigen::AngleAxisd(draw(16) * 0.1745, Eigen::Vector3d(draw(17), draw(18), draw(19)).normalized());
    if (options.flip)
        b.frame_T_scan = b.frame_T_scan * Eigen::Translation3d(0, 0, 183) *
                         Eigen::AngleAxisd(std::acos(-1.0), Eigen::Vector3d(1, 0.3, 0).normalized());
    b.part_z_from_mm = options.copy_from_mm;
    b.part_z_to_mm = options.copy_to_mm;
    return {sample::scanShaft(options.reference, a), sample::scanShaft(options.copy, b), a.frame_T_scan * a.scan_T_part,
            b.frame_T_scan * b.scan_T_part};
}

struct PoseError {
    double axial_um, radial_um, axis_deg;
};

inline PoseError errorOf(const Eigen::Isometry3d& reference_T_copy, const Eigen::Isometry3d& reference_T_part,
                         const Eigen::Isometry3d& copy_T_part, double middle_mm = 91.5)
{
    const Eigen::Vector3d middle(0, 0, middle_mm);
    const Eigen::Vector3d e = reference_T_copy * (copy_T_part * middle) - reference_T_part * middle;
    const Eigen::Vector3d axis = reference_T_part.linear().col(2);
    const double sine = (reference_T_copy.linear() * copy_T_part.linear().col(2)).cross(axis).norm();
    return {std::abs(e.dot(axis)) * 1e3, (e - axis * e.dot(axis)).norm() * 1e3,
            std::asin(std::min(1.0, sine)) * 180 / std::acos(-1.0)};
}

}  // namespace lathelier::testing_pair
