// Scans of a stepped shaft with its faces, their points spread evenly over the surface, in poses drawn by a seed.
#pragma once

#include <Eigen/Geometry>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

#include "engine/core/random.h"
#include "engine/core/scan.h"

namespace lathelier::testing_steps {

struct Step {
    double radius_mm = 0;
    double length_mm = 0;
};

/// A round plateau on a cylinder.
struct Plateau {
    double z_mm = 0;  ///< of its middle, from the shaft's first end
    double angle_rad = 0;
    double across_mm = 4;
    double height_mm = 0;  ///< 0: none
};

struct SteppedShaft {
    std::vector<Step> steps{{15, 40}, {19, 34}, {13, 50}};
    Plateau plateau;
};

struct SteppedScan {
    Scan scan;
    Eigen::Isometry3d scan_T_part;
};

/// Any position within 9 mm and any direction within `most_rad` of the z axis.
inline Eigen::Isometry3d poseOf(std::uint64_t seed, double most_rad)
{
    std::uint64_t drawn = 0;
    const auto draw = [&] { return 2 * randomUniform(seed, 61, drawn++) - 1; };
    const Eigen::Vector3d shift(9 * draw(), 9 * draw(), 9 * draw());
    const Eigen::Vector3d about = Eigen::Vector3d(draw(), draw(), 0.1).normalized();
    return Eigen::Translation3d(shift) * Eigen::AngleAxisd(most_rad * draw(), about) *
           Eigen::AngleAxisd(std::numbers::pi * draw(), Eigen::Vector3d::UnitZ());
}

/// `count` points, with noise along the surface's normal.
inline SteppedScan scanByArea(const SteppedShaft& shaft, double sigma_mm, std::size_t count, std::uint64_t seed,
                              double most_rad = 0.1)
{
    struct Piece {
        bool is_face;
        double inner_mm, outer_mm;  ///< of a side both its radius
        double z_mm, end_mm;
        double area_mm2;
    };
    std::vector<Piece> pieces;
    double z = 0;
    double before = 0;
    const auto face = [&](double from, double to) {
        const double inner = std::min(from, to), outer = std::max(from, to);
        pieces.push_back({true, inner, outer, z, z, std::numbers::pi * (outer * outer - inner * inner)});
    };
    for (const Step& step : shaft.steps) {
        face(before, step.radius_mm);
        pieces.push_back({false, step.radius_mm, step.radius_mm, z, z + step.length_mm,
                          2 * std::numbers::pi * step.radius_mm * step.length_mm});
        z += step.length_mm;
        before = step.radius_mm;
    }
    face(before, 0);
    double area = 0;
    for (const Piece& piece : pieces) area += piece.area_mm2;

    SteppedScan made{{}, poseOf(seed, most_rad)};
    for (std::size_t i = 0; i < count; ++i) {
        double at = area * randomUniform(seed, 62, i);
        std::size_t k = 0;
        while (k + 1 < pieces.size() && at > pieces[k].area_mm2) at -= pieces[k++].area_mm2;
        const Piece& piece = pieces[k];
        const double share = randomUniform(seed, 63, i);
        const double angle = 2 * std::numbers::pi * randomUniform(seed, 64, i);
        const double noise = sigma_mm * randomNormal(seed, 65, i);
        Eigen::Vector3d p;
        if (piece.is_face) {
            const double r =
                std::sqrt(std::lerp(piece.inner_mm * piece.inner_mm, piece.outer_mm * piece.outer_mm, share));
            p = {r * std::cos(angle), r * std::sin(angle), piece.z_mm + noise};
        } else {
            const double along = std::lerp(piece.z_mm, piece.end_mm, share);
            const Plateau& plateau = shaft.plateau;
            const double around = piece.inner_mm * std::remainder(angle - plateau.angle_rad, 2 * std::numbers::pi);
            const bool raised = std::hypot(along - plateau.z_mm, around) < plateau.across_mm / 2;
            const double r = piece.inner_mm + noise + (raised ? plateau.height_mm : 0);
            p = {r * std::cos(angle), r * std::sin(angle), along};
        }
        made.scan.points_mm.push_back(made.scan_T_part * p);
    }
    return made;
}

/// A plateau of +`height_mm`, 4 mm across, somewhere on a side and away from its edges.
inline Plateau plateauOf(const SteppedShaft& shaft, std::uint64_t seed, double height_mm)
{
    const auto k = static_cast<std::size_t>(randomUniform(seed, 66, 0) * static_cast<double>(shaft.steps.size()));
    double z = 0;
    for (std::size_t i = 0; i < k; ++i) z += shaft.steps[i].length_mm;
    const double margin = 4;
    return {z + margin + (shaft.steps[k].length_mm - 2 * margin) * randomUniform(seed, 66, 1),
            2 * std::numbers::pi * randomUniform(seed, 66, 2), 4, height_mm};
}

}  // namespace lathelier::testing_steps
