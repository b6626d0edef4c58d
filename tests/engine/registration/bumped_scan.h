// Pairs of scans of the same part, with noise of several kinds, and with a bump of known place and height.
#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdint>

#include "engine/core/random.h"
#include "engine/registration/surface/surface_samples.h"
#include "engine/sample/sample.h"

namespace lathelier::testing_bump {

struct ShaftOptions {
    double sigma_mm = 0.05;
    double step_deg = 3.6;
    double dropout = 0;
    double spurious = 0;
    bool one_sided = false;  ///< the copy shows 180° only
    double alike_mm = 0;     ///< noise is a moving average over this length along the rows
    sample::ShaftModel reference = sample::nominalShaft();
    sample::ShaftModel copy = sample::nominalShaft();
};

struct ShaftScans {
    Scan reference;
    Scan copy;
    Eigen::Isometry3d reference_T_part;
    Eigen::Isometry3d copy_T_part;
    double bump_z_mm = 0;  ///< along the part's axis from its free end
};

/// Noise along the radius, in the order of the scan: a moving average over neighbours of a row.
inline void addAlikeNoise(Scan& scan, const Eigen::Isometry3d& scan_T_part, double sigma_mm, int span,
                          std::uint64_t seed)
{
    const Eigen::Isometry3d part_T_scan = scan_T_part.inverse();
    const Eigen::Matrix3d turn = scan_T_part.linear();
    double sum = 0;
    for (int k = 0; k < span; ++k) sum += randomNormal(seed, 41, static_cast<std::uint64_t>(k));
    for (std::size_t i = 0; i < scan.points_mm.size(); ++i) {
        Eigen::Vector3d radial = part_T_scan * scan.points_mm[i];
        radial.z() = 0;
        scan.points_mm[i] += sigma_mm * sum / std::sqrt(static_cast<double>(span)) * (turn * radial.normalized());
        sum += randomNormal(seed, 41, i + static_cast<std::uint64_t>(span)) - randomNormal(seed, 41, i);
    }
}

/// Two scans in poses drawn by `seed`.
inline ShaftScans shaftTwice(std::uint64_t seed, const ShaftOptions& options = {})
{
    const auto draw = [&](std::uint64_t k) { return 2 * randomUniform(78, seed, k) - 1; };
    sample::ScannerModel a;
    a.angle_step_deg = options.step_deg;
    a.dropout_share = options.dropout;
    a.spurious_share = options.spurious;
    a.sigma_mm = options.alike_mm > 0 ? 0.2 * options.sigma_mm : options.sigma_mm;
    sample::ScannerModel b = a;
    a.seed = 2000 + 2 * seed;
    b.seed = 2001 + 2 * seed;
    a.scan_T_part = Eigen::Translation3d(draw(0), draw(1), draw(2)) *
                    Eigen::AngleAxisd(draw(3) * 0.01, Eigen::Vector3d(draw(4), draw(5), 0).normalized());
    b.scan_T_part = Eigen::Translation3d(draw(6), draw(7), draw(8)) *
                    Eigen::AngleAxisd(draw(12) * 3, Eigen::Vector3d::UnitZ()) *
                    Eigen::AngleAxisd(draw(9) * 0.026, Eigen::Vector3d(draw(10), draw(11), 0).normalized());
    b.frame_T_scan = Eigen::Translation3d(draw(13) * 9, draw(14) * 9, draw(15) * 9) *
                     Eigen::AngleAxisd(draw(16) * 0.1745, Eigen::Vector3d(draw(17), draw(18), draw(19)).normalized());
    ShaftScans scans{sample::scanShaft(options.reference, a), sample::scanShaft(options.copy, b),
                     a.frame_T_scan * a.scan_T_part, b.frame_T_scan * b.scan_T_part, 0};
    if (options.alike_mm > 0) {
        const int span =
            std::max(2, static_cast<int>(std::lround(options.alike_mm / (16 * options.step_deg * 0.01745))));
        addAlikeNoise(scans.reference, scans.reference_T_part, options.sigma_mm, span, a.seed);
        addAlikeNoise(scans.copy, scans.copy_T_part, options.sigma_mm, span, b.seed);
    }
    if (options.one_sided) {
        const Eigen::Isometry3d part_T_copy = scans.copy_T_part.inverse();
        std::erase_if(scans.copy.points_mm, [&](const Eigen::Vector3d& p) { return (part_T_copy * p).y() < 0; });
    }
    return scans;
}

/// Raises the copy's shaft by `height_mm` on a disc `across_mm` wide, anywhere but at edges.
inline void addBump(ShaftScans& scans, std::uint64_t seed, double height_mm, double across_mm)
{
    const double z = 5 + 85 * randomUniform(79, seed, 0);
    const double angle = 6.28 * randomUniform(79, seed, 1);
    const Eigen::Vector3d middle(15 * std::cos(angle), 15 * std::sin(angle), z);
    const Eigen::Isometry3d part_T_copy = scans.copy_T_part.inverse();
    for (Eigen::Vector3d& p : scans.copy.points_mm) {
        const Eigen::Vector3d here = part_T_copy * p;
        if ((here - middle).norm() > across_mm / 2) continue;
        const Eigen::Vector3d radial = Eigen::Vector3d(here.x(), here.y(), 0).normalized();
        p += height_mm * (scans.copy_T_part.linear() * radial);
    }
    scans.bump_z_mm = z;
}

/// A shaft of R 15 and R 20 mm with two end faces and a shoulder, seen all over.
struct FacedShaft {
    double front_radius_mm = 15;  ///< 20: no shoulder
    double shoulder_mm = 60;
    double length_mm = 100;
    double shoulder_tilt = 0;  ///< dz/dx of the shoulder's face
};

inline Scan scanFacedShaft(const FacedShaft& shaft, double sigma_mm, double points_per_mm2,
                           const Eigen::Isometry3d& scan_T_part, std::uint64_t seed)
{
    Scan scan;
    std::uint64_t drawn = 0;
    const auto uniform = [&] { return randomUniform(seed, 51, drawn++); };
    const auto normal = [&] { return sigma_mm * randomNormal(seed, 52, drawn++); };
    const auto add = [&](double r, double z, double tilt) {
        const double angle = 2 * 3.14159265358979 * uniform();
        const double x = r * std::cos(angle);
        scan.points_mm.emplace_back(scan_T_part * Eigen::Vector3d(x, r * std::sin(angle), z + tilt * x));
    };
    const auto side = [&](double radius, double from, double to) {
        const int count = static_cast<int>(points_per_mm2 * 6.2832 * radius * (to - from));
        for (int i = 0; i < count; ++i) {
            const double z = from + (to - from) * uniform();
            add(radius + normal(), z, 0);
        }
    };
    const auto face = [&](double z, double inner, double outer, double tilt) {
        const int count = static_cast<int>(points_per_mm2 * 3.1416 * (outer * outer - inner * inner));
        for (int i = 0; i < count; ++i) {
            const double r = std::sqrt(inner * inner + (outer * outer - inner * inner) * uniform());
            add(r, z + normal(), tilt);
        }
    };
    side(shaft.front_radius_mm, 0, shaft.shoulder_mm);
    side(20, shaft.shoulder_mm, shaft.length_mm);
    face(0, 0, shaft.front_radius_mm, 0);
    face(shaft.shoulder_mm, shaft.front_radius_mm, 20, shaft.shoulder_tilt);
    face(shaft.length_mm, 0, 20, 0);
    return scan;
}

/// Two shafts, each in a pose of its own.
inline ShaftScans facedShafts(std::uint64_t seed, double sigma_mm, double points_per_mm2, const FacedShaft& copy = {},
                              const FacedShaft& reference = {})
{
    const auto draw = [&](std::uint64_t k) { return 2 * randomUniform(81, seed, k) - 1; };
    const auto pose = [&](std::uint64_t k, double most_rad) {
        return Eigen::Isometry3d(
            Eigen::Translation3d(9 * draw(k), 9 * draw(k + 1), 9 * draw(k + 2)) *
            Eigen::AngleAxisd(most_rad * draw(k + 3), Eigen::Vector3d(draw(k + 4), draw(k + 5), 0.3).normalized()));
    };
    ShaftScans scans;
    scans.reference_T_part = pose(0, 0.1);
    scans.copy_T_part = pose(6, 0.2);
    scans.reference = scanFacedShaft(reference, sigma_mm, points_per_mm2, scans.reference_T_part, 4000 + 2 * seed);
    scans.copy = scanFacedShaft(copy, sigma_mm, points_per_mm2, scans.copy_T_part, 4001 + 2 * seed);
    return scans;
}

struct BoxScans {
    Scan reference;
    Scan copy;
    Eigen::Vector3d bump_mm = Eigen::Vector3d::Zero();  ///< in the reference's frame
};

inline Scan boxMesh(double x = 60, double y = 40, double z = 30)
{
    Scan mesh;
    for (int i = 0; i < 8; ++i) mesh.points_mm.emplace_back(i & 1 ? x : 0, i & 2 ? y : 0, i & 4 ? z : 0);
    mesh.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                      {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
    return mesh;
}

/// A box of 60 × 40 × 30 mm in scan lines of any direction, its noise a moving average over `alike_mm` of a line.
inline Scan boxInLines(std::uint64_t stream, double sigma_mm, double points_per_mm2, double alike_mm)
{
    const double spacing = 1 / std::sqrt(points_per_mm2);
    const int span = std::max(1, static_cast<int>(std::lround(alike_mm / spacing)));
    const Eigen::Vector3d size(60, 40, 30);
    Scan scan;
    std::uint64_t drawn = 0;
    for (int face = 0; face < 6; ++face) {
        const int across = face / 2;
        const Eigen::Vector3d normal = (face % 2 == 0 ? -1 : 1) * Eigen::Vector3d::Unit(across);
        const Eigen::Vector3d u = Eigen::Vector3d::Unit((across + 1) % 3);
        const Eigen::Vector3d v = Eigen::Vector3d::Unit((across + 2) % 3);
        const double turn = 3.14159 * randomUniform(stream, 43, static_cast<std::uint64_t>(face));
        const Eigen::Vector3d along = std::cos(turn) * u + std::sin(turn) * v;
        const Eigen::Vector3d beside = normal.cross(along);
        const Eigen::Vector3d middle = (size.cwiseProduct(Eigen::Vector3d::Ones() + normal)).eval() / 2;
        const int reach = static_cast<int>(size.norm() / 2 / spacing) + 1;
        for (int row = -reach; row <= reach; ++row) {
            const double begin = randomUniform(stream, 44, drawn);
            double sum = 0;
            for (int k = 0; k < span; ++k) sum += randomNormal(stream, 45, drawn++);
            for (int k = -reach; k <= reach; ++k) {
                const Eigen::Vector3d at = middle + spacing * ((k + begin) * along + row * beside);
                sum += randomNormal(stream, 45, drawn) -
                       randomNormal(stream, 45, drawn - static_cast<std::uint64_t>(span));
                ++drawn;
                const Eigen::Vector3d inside = (size - at).cwiseMin(at);
                if (inside.minCoeff() < -1e-9) continue;
                scan.points_mm.emplace_back(at + sigma_mm * sum / std::sqrt(static_cast<double>(span)) * normal);
            }
        }
    }
    return scan;
}

/// A box of 60 × 40 × 30 mm twice; the copy with a raised disc on its top, in another pose. Clouds carry no normals.
/// With `alike_mm` both are in scan lines, with noise correlated over that length.
inline BoxScans boxTwice(std::uint64_t seed, double sigma_mm, double points_per_mm2, double height_mm, double across_mm,
                         bool reference_is_mesh, double alike_mm = 0)
{
    const Scan mesh = boxMesh();
    const auto count = static_cast<std::size_t>(points_per_mm2 * 2 * (60 * 40 + 60 * 30 + 40 * 30));
    const auto noisy = [&](std::uint64_t stream) {
        if (alike_mm > 0) return boxInLines(stream, sigma_mm, points_per_mm2, alike_mm);
        Scan scan = registration::sampleSurface(mesh, count, stream);
        for (std::size_t i = 0; i < scan.points_mm.size(); ++i)
            scan.points_mm[i] += sigma_mm * randomNormal(stream, 42, i) * scan.normals[i].cast<double>();
        scan.normals.clear();
        return scan;
    };
    BoxScans scans;
    scans.reference = reference_is_mesh ? mesh : noisy(3000 + 2 * seed);
    scans.copy = noisy(3001 + 2 * seed);
    const double x = 6 + 48 * randomUniform(80, seed, 0);
    const double y = 6 + 28 * randomUniform(80, seed, 1);
    scans.bump_mm = {x, y, 30};
    if (height_mm != 0)
        for (Eigen::Vector3d& p : scans.copy.points_mm)
            if ((p - scans.bump_mm).norm() < across_mm / 2) p.z() += height_mm;
    const Eigen::Isometry3d pose = Eigen::Translation3d(5, -7, 3) *
                                   Eigen::AngleAxisd(0.3 * randomUniform(80, seed, 2),
                                                     Eigen::Vector3d(0.3, 1, randomUniform(80, seed, 3)).normalized());
    for (Eigen::Vector3d& p : scans.copy.points_mm) p = pose * p;
    return scans;
}

}  // namespace lathelier::testing_bump
