// What stands about a part in its scan, in the part's frame: a turntable, V-blocks, jaws, a chuck, a centre, a bolt,
// clusters of stray points.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <numbers>
#include <vector>

#include "engine/core/random.h"
#include "engine/core/scan.h"

namespace lathelier::features {

/// Points of surfaces, 4 to the square millimetre, with noise along the normal.
class MadeScene {
public:
    explicit MadeScene(std::uint64_t seed, double sigma_mm = 0.05) : seed_(seed), sigma_mm_(sigma_mm) {}

    std::vector<Eigen::Vector3d> points;  ///< in the part's frame

    /// A rectangle a + s·u + t·v, s and t from 0 to 1, where `is_there` holds.
    void rectangle(const Eigen::Vector3d& a, const Eigen::Vector3d& u, const Eigen::Vector3d& v,
                   const std::function<bool(const Eigen::Vector3d&)>& is_there = {}, double per_mm2 = 4)
    {
        const Eigen::Vector3d normal = u.cross(v).normalized();
        const auto count = static_cast<int>(per_mm2 * u.cross(v).norm());
        for (int i = 0; i < count; ++i) {
            const Eigen::Vector3d p = a + evenly() * u + evenly() * v;
            const double off = sigma_mm_ * bell();
            if (!is_there || is_there(p)) points.push_back(p + off * normal);
        }
    }

    /// A box with all of its faces.
    void box(const Eigen::Vector3d& a, const Eigen::Vector3d& u, const Eigen::Vector3d& v, const Eigen::Vector3d& w,
             const std::function<bool(const Eigen::Vector3d&)>& is_there = {})
    {
        for (const auto& [p, q, r] : {std::array{u, v, w}, std::array{v, w, u}, std::array{w, u, v}}) {
            rectangle(a, p, q, is_there);
            rectangle(a + r, p, q, is_there);
        }
    }

    /// A cylinder's side about a line along `axis`.
    void cylinder(const Eigen::Vector3d& foot, const Eigen::Vector3d& axis, double radius_mm, double per_mm2 = 4)
    {
        const Eigen::Vector3d u = axis.unitOrthogonal(), v = axis.normalized().cross(u);
        const auto count = static_cast<int>(per_mm2 * 2 * std::numbers::pi * radius_mm * axis.norm());
        for (int i = 0; i < count; ++i) {
            const double angle = 2 * std::numbers::pi * evenly(), r = radius_mm + sigma_mm_ * bell();
            points.push_back(foot + evenly() * axis + r * (std::cos(angle) * u + std::sin(angle) * v));
        }
    }

    /// A ring across the axis at z.
    void face(double z_mm, double inner_mm, double outer_mm, double per_mm2 = 4)
    {
        rectangle(
            {-outer_mm, -outer_mm, z_mm}, {2 * outer_mm, 0, 0}, {0, 2 * outer_mm, 0},
            [=](const Eigen::Vector3d& p) {
                const double r = std::hypot(p.x(), p.y());
                return r > inner_mm && r < outer_mm;
            },
            per_mm2);
    }

    /// A V-block of 90° from z to z + 25 under a cylinder of this radius along z; y points up.
    void vBlock(double z_mm, double radius_mm)
    {
        const double depth = radius_mm * std::numbers::sqrt2, half = 40, top = -0.3 * radius_mm, floor = -70;
        const Eigen::Vector3d along(0, 0, 25);
        const auto above_v = [=](const Eigen::Vector3d& p) { return p.y() > std::abs(p.x()) - depth; };
        const double edge = top + depth;  // where the V meets the top
        for (const double side : {-1.0, 1.0}) {
            rectangle({0, -depth, z_mm}, {side * edge, edge, 0}, along);
            rectangle({side * edge, top, z_mm}, {side * (half - edge), 0, 0}, along);
            rectangle({side * half, floor, z_mm}, {0, top - floor, 0}, along);
        }
        for (const double z : {z_mm, z_mm + 25})
            rectangle({-half, floor, z}, {2 * half, 0, 0}, {0, top - floor, 0},
                      [&](const Eigen::Vector3d& p) { return !above_v(p); });
    }

    /// Three jaws of a chuck from z to z + 40, 20 mm wide, that touch a cylinder of this radius.
    void jaws(double z_mm, double radius_mm)
    {
        for (int jaw = 0; jaw < 3; ++jaw) {
            const double angle = 2 * std::numbers::pi * jaw / 3 + 0.3;
            const Eigen::Vector3d out(std::cos(angle), std::sin(angle), 0), across(-out.y(), out.x(), 0);
            box(radius_mm * out - 10 * across + z_mm * Eigen::Vector3d::UnitZ(), 30 * out, 20 * across, {0, 0, 40},
                [=](const Eigen::Vector3d& p) { return std::hypot(p.x(), p.y()) > radius_mm; });
        }
    }

    /// A chuck behind jaws: its face with a bore, and its rim, toward larger z.
    void chuck(double z_mm, double bore_radius_mm, double radius_mm)
    {
        face(z_mm, bore_radius_mm, radius_mm);
        cylinder({0, 0, z_mm}, {0, 0, 30}, radius_mm);
    }

    /// A 60° centre whose cone comes out of the part's end at z with this radius and grows toward smaller z.
    void centre(double z_mm, double radius_mm, double length_mm, double per_mm2 = 4)
    {
        const auto count = static_cast<int>(per_mm2 * 2 * std::numbers::pi * (radius_mm + 0.3 * length_mm) * length_mm);
        for (int i = 0; i < count; ++i) {
            const double angle = 2 * std::numbers::pi * evenly(), along = length_mm * evenly(),
                         r = radius_mm + along / std::numbers::sqrt3 + sigma_mm_ * bell();
            points.emplace_back(r * std::cos(angle), r * std::sin(angle), z_mm - along);
        }
    }

    /// Stray points about a place, normally distributed.
    void cluster(const Eigen::Vector3d& middle, double spread_mm, int count)
    {
        for (int i = 0; i < count; ++i) points.push_back(middle + spread_mm * Eigen::Vector3d(bell(), bell(), bell()));
    }

    /// Puts them into a scan whose part lies as `scan_T_part` says; its points for which `is_hidden` holds go.
    void addTo(Scan& scan, const Eigen::Isometry3d& scan_T_part,
               const std::function<bool(const Eigen::Vector3d&)>& is_hidden = {}) const
    {
        const Eigen::Isometry3d part_T_scan = scan_T_part.inverse();
        if (is_hidden) std::erase_if(scan.points_mm, [&](const auto& p) { return is_hidden(part_T_scan * p); });
        for (const Eigen::Vector3d& p : points) scan.points_mm.push_back(scan_T_part * p);
    }

private:
    double evenly() { return randomUniform(seed_, 1, ++drawn_); }
    double bell() { return randomNormal(seed_, 2, ++drawn_); }

    std::uint64_t seed_;
    std::uint64_t drawn_ = 0;
    double sigma_mm_;
};

/// Are these points of the part under jaws as above?
inline bool isUnderJaws(const Eigen::Vector3d& p, double z_mm)
{
    for (int jaw = 0; jaw < 3; ++jaw) {
        const double angle = 2 * std::numbers::pi * jaw / 3 + 0.3;
        const Eigen::Vector3d out(std::cos(angle), std::sin(angle), 0), across(-out.y(), out.x(), 0);
        if (p.z() > z_mm && p.dot(out) > 0 && std::abs(p.dot(across)) < 10.5) return true;
    }
    return false;
}

}  // namespace lathelier::features
