// Scans of the sample's scanner with what is no body of revolution put into them: each point is moved along its ray.
#pragma once

#include <functional>
#include <optional>

#include "made_scan.h"

namespace lathelier::features {

/// A point about the axis of the part.
struct AroundPoint {
    double z_mm = 0, angle_rad = 0, r_mm = 0;
    std::size_t index = 0;  ///< in the scan
};

/// The new radius of a point, or nothing where its ray hits nothing.
using Shape = std::function<std::optional<double>(const AroundPoint&)>;

inline Scan shapedScan(const sample::ShaftModel& shaft, const sample::ScannerModel& scanner, const Shape& shape)
{
    const Scan plain = scanShaft(shaft, scanner);
    const Eigen::Isometry3d part_T_scan = scanner.scan_T_part.inverse();
    Scan shaped;
    for (std::size_t i = 0; i < plain.points_mm.size(); ++i) {
        Eigen::Vector3d p = part_T_scan * plain.points_mm[i];
        const double r = std::hypot(p.x(), p.y());
        const std::optional<double> moved = shape({p.z(), std::atan2(p.y(), p.x()), r, i});
        if (!moved) continue;
        p.head<2>() *= *moved / r;
        shaped.points_mm.push_back(scanner.scan_T_part * p);
    }
    return shaped;
}

/// Ø25 x 41, collar Ø40 from 41 to 56, Ø25 to 97, chamfers 1 × 45° at both ends.
inline sample::ShaftModel collarPart()
{
    return {piece(0, 1, 23, 25), piece(1, 41, 25, 25), piece(41, 56, 40, 40), piece(56, 96, 25, 25),
            piece(96, 97, 25, 23)};
}

/// A row every 0.15 mm, a ray every 1.5°.
inline sample::ScannerModel coarser(std::uint64_t seed)
{
    sample::ScannerModel scanner = askew(seed, 0.03);
    scanner.row_pitch_mm = 0.15;
    scanner.angle_step_deg = 1.5;
    return scanner;
}

}  // namespace lathelier::features
