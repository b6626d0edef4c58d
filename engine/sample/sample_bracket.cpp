// The bracket: an L-shaped profile drawn along y, with three round holes. Every face is cut into rectangles that share
// whole edges with their neighbours, each with at most one hole, so the mesh is closed.
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

#include "engine/core/parallel.h"
#include "engine/core/random.h"
#include "engine/registration/surface/surface_samples.h"
#include "engine/sample/sample.h"

namespace lathelier::sample {
namespace {

using Eigen::Vector3d;

constexpr int holeSides = 256;  // of a hole

struct Hole {
    double u_mm, v_mm, radius_mm;
};

class Builder {
public:
    /// Rectangle from `corner` along `u` and `v` (u × v points out of the material), with the hole's rim when given.
    void face(const Vector3d& corner, const Vector3d& u, const Vector3d& v, const Hole* hole = nullptr)
    {
        const std::uint32_t corners[4] = {vertex(corner), vertex(corner + u), vertex(corner + u + v),
                                          vertex(corner + v)};
        if (hole == nullptr) {
            mesh.triangles.push_back({corners[0], corners[1], corners[2]});
            mesh.triangles.push_back({corners[0], corners[2], corners[3]});
            return;
        }
        // Fans from each corner to its quarter of the rim; corner k is at angle 225° + 90° k.
        const Vector3d eu = u.normalized();
        const Vector3d ev = v.normalized();
        const auto rim = [&](int i) {
            const double angle = std::numbers::pi + 2 * std::numbers::pi * (i % holeSides) / holeSides;
            return vertex(corner + (hole->u_mm + hole->radius_mm * std::cos(angle)) * eu +
                          (hole->v_mm + hole->radius_mm * std::sin(angle)) * ev);
        };
        for (int k = 0; k < 4; ++k) {
            for (int i = k * holeSides / 4; i < (k + 1) * holeSides / 4; ++i)
                mesh.triangles.push_back({corners[k], rim(i + 1), rim(i)});
            mesh.triangles.push_back({corners[k], corners[(k + 1) % 4], rim((k + 1) * holeSides / 4)});
        }
    }

    /// Wall of a hole that runs from `centre` along `depth`; `eu`, `ev` span its plane as in face().
    void wall(const Vector3d& centre, const Vector3d& eu, const Vector3d& ev, const Vector3d& depth, double radius)
    {
        const auto rim = [&](int i, double t) {
            const double angle = 2 * std::numbers::pi * (i % holeSides) / holeSides;
            return vertex(centre + t * depth + radius * std::cos(angle) * eu + radius * std::sin(angle) * ev);
        };
        for (int i = 0; i < holeSides; ++i) {
            mesh.triangles.push_back({rim(i, 0), rim(i + 1, 0), rim(i + 1, 1)});
            mesh.triangles.push_back({rim(i, 0), rim(i + 1, 1), rim(i, 1)});
        }
    }

    Scan mesh;

private:
    std::uint32_t vertex(const Vector3d& p)
    {
        const std::array<long long, 3> key{std::llround(p.x() * 1e6), std::llround(p.y() * 1e6),
                                           std::llround(p.z() * 1e6)};
        const auto [place, is_new] = known_.try_emplace(key, static_cast<std::uint32_t>(mesh.points_mm.size()));
        if (is_new) mesh.points_mm.push_back(p);
        return place->second;
    }

    std::map<std::array<long long, 3>, std::uint32_t> known_;
};

}  // namespace

Scan bracketMesh()
{
    constexpr double length = 100, width = 80, height = 90, thick = 12, half = 56;
    const Vector3d ex(1, 0, 0), ey(0, 1, 0), ez(0, 0, 1);
    const Hole small{22, 26, 8};     // in the base, cell x 12…56
    const Hole large{24, 44, 12.5};  // in the base, cell x 56…100
    const Hole bore{32, 46, 18};     // in the upright, from y 0 and z 12
    Builder b;

    // underside (outward -z) and top of the base; the second axis of a face is its v
    const auto swapped = [](const Hole& hole) { return Hole{hole.v_mm, hole.u_mm, hole.radius_mm}; };
    const Hole small_below = swapped(small);
    const Hole large_below = swapped(large);
    b.face({0, 0, 0}, width * ey, thick * ex);
    b.face({thick, 0, 0}, width * ey, (half - thick) * ex, &small_below);
    b.face({half, 0, 0}, width * ey, (length - half) * ex, &large_below);
    b.face({thick, 0, thick}, (half - thick) * ex, width * ey, &small);
    b.face({half, 0, thick}, (length - half) * ex, width * ey, &large);
    b.wall({thick + small.u_mm, small.v_mm, 0}, ey, ex, thick * ez, small.radius_mm);
    b.wall({half + large.u_mm, large.v_mm, 0}, ey, ex, thick * ez, large.radius_mm);

    // the upright: back (-x), front (+x), top
    const Hole bore_back = swapped(bore);
    b.face({0, 0, 0}, thick * ez, width * ey);
    b.face({0, 0, thick}, (height - thick) * ez, width * ey, &bore_back);
    b.face({thick, 0, thick}, width * ey, (height - thick) * ez, &bore);
    b.face({0, 0, height}, thick * ex, width * ey);
    b.wall({0, bore.u_mm, thick + bore.v_mm}, ez, ey, thick * ex, bore.radius_mm);
    b.face({length, 0, 0}, width * ey, thick * ez);

    // the two L-shaped sides
    for (const bool far : {false, true}) {
        const auto side = [&](double x, double z, double dx, double dz) {
            if (far)
                b.face({x, width, z}, dz * ez, dx * ex);
            else
                b.face({x, 0, z}, dx * ex, dz * ez);
        };
        side(0, 0, thick, thick);
        side(thick, 0, half - thick, thick);
        side(half, 0, length - half, thick);
        side(0, thick, thick, height - thick);
    }
    return std::move(b.mesh);
}

Scan scanBracket(std::size_t count, double sigma_mm, const Eigen::Isometry3d& frame_T_part, std::uint64_t seed,
                 const Progress& progress)
{
    Scan scan = registration::sampleSurface(bracketMesh(), count, seed, progress);
    parallelFor(scan.points_mm.size(), 16384, progress, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const double off = sigma_mm * randomNormal(seed, 7, i);
            scan.points_mm[i] = frame_T_part * (scan.points_mm[i] + off * scan.normals[i].cast<double>());
        }
    });
    scan.normals.clear();
    return scan;
}

}  // namespace lathelier::sample
