// Scans of turned parts with known tables, made by the sample's ray-casting scanner.
#pragma once

#include <cmath>
#include <vector>

#include "engine/features/recognition.h"
#include "engine/sample/sample.h"

namespace lathelier::features {

inline sample::ShaftPiece piece(double from, double to, double d0, double d1)
{
    sample::ShaftPiece made;
    made.z_start_mm = from;
    made.z_end_mm = to;
    made.radius_start_mm = d0 / 2;
    made.radius_end_mm = d1 / 2;
    return made;
}

/// An arc about (centre_z, centre_r) as short cones; convex: its upper branch.
inline void addArc(sample::ShaftModel& shaft, double from, double to, double centre_z, double centre_r, double radius,
                   bool convex)
{
    constexpr int count = 24;
    const auto at = [&](double z) {
        const double off = std::min(radius, std::abs(z - centre_z));
        return 2 * (centre_r + (convex ? 1 : -1) * std::sqrt(radius * radius - off * off));
    };
    for (int i = 0; i < count; ++i) {
        const double a = from + (to - from) * i / count, b = from + (to - from) * (i + 1) / count;
        shaft.push_back(piece(a, b, at(a), at(b)));
    }
}

/// Round 1, Ø16, fillet 0.8, Ø24, cone 1:10 to Ø28, shoulder to Ø42, groove 2 × Ø38, chamfer 1 × 45°.
inline sample::ShaftModel featurePart()
{
    sample::ShaftModel shaft;
    addArc(shaft, 0, 1, 1, 7, 1, true);
    shaft.push_back(piece(1, 20, 16, 16));
    addArc(shaft, 20, 20.8, 20, 8.8, 0.8, false);
    shaft.push_back(piece(20.8, 35, 24, 24));
    shaft.push_back(piece(35, 75, 24, 28));
    shaft.push_back(piece(75, 85, 28, 28));
    shaft.push_back(piece(85, 95, 42, 42));
    shaft.push_back(piece(95, 97, 38, 38));
    shaft.push_back(piece(97, 106, 42, 42));
    shaft.push_back(piece(106, 107, 42, 40));
    return shaft;
}

inline sample::ScannerModel askew(std::uint64_t seed, double sigma_mm = 0.05)
{
    sample::ScannerModel scanner;
    scanner.seed = seed;
    scanner.sigma_mm = sigma_mm;
    scanner.scan_T_part = Eigen::Isometry3d(Eigen::Translation3d(0.3, 0.7, 0) *
                                            Eigen::AngleAxisd(0.007, Eigen::Vector3d(0.87, 0.5, 0).normalized()));
    return scanner;
}

/// The shaft of the sample, as it is recognised.
inline const Recognition& scannedTableOne()
{
    static const Recognition result = recognize(scanShaft(sample::nominalShaft(), askew(3)), {});
    return result;
}

}  // namespace lathelier::features
