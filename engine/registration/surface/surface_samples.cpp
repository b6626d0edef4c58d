#include "engine/registration/surface/surface_samples.h"

#include <Eigen/Geometry>
#include <algorithm>

#include "engine/core/parallel.h"
#include "engine/core/random.h"

namespace lathelier::registration {

std::vector<SurfaceSample> drawSamples(const Scan& mesh, std::size_t count, std::uint64_t seed,
                                       const Progress& progress)
{
    std::vector<double> area_until(mesh.triangles.size());
    double area = 0;
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        if (i % 65536 == 0) progress.check();
        const auto& [a, b, c] = mesh.triangles[i];
        const Eigen::Vector3d& p = mesh.points_mm[a];
        area += (mesh.points_mm[b] - p).cross(mesh.points_mm[c] - p).norm() / 2;
        area_until[i] = area;
    }
    std::vector<SurfaceSample> samples;
    if (!(area > 0)) return samples;
    samples.resize(count);
    parallelFor(count, 16384, progress, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const double place =
                area * (static_cast<double>(i) + randomUniform(seed, 0, i)) / static_cast<double>(count);
            const auto found = std::upper_bound(area_until.begin(), area_until.end(), place);
            const auto triangle = std::min<std::ptrdiff_t>(found - area_until.begin(),
                                                           static_cast<std::ptrdiff_t>(area_until.size()) - 1);
            double s = randomUniform(seed, 1, i);
            double t = randomUniform(seed, 2, i);
            if (s + t > 1) {  // fold the parallelogram's other half back into the triangle
                s = 1 - s;
                t = 1 - t;
            }
            samples[i] = {static_cast<std::uint32_t>(triangle), s, t};
        }
    });
    return samples;
}

Scan sampleSurface(const Scan& mesh, std::size_t count, std::uint64_t seed, const Progress& progress)
{
    const std::vector<SurfaceSample> samples = drawSamples(mesh, count, seed, progress);
    Scan result;
    result.points_mm.resize(samples.size());
    result.normals.resize(samples.size());
    parallelFor(samples.size(), 16384, progress, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const auto& [a, b, c] = mesh.triangles[samples[i].triangle];
            const Eigen::Vector3d& p = mesh.points_mm[a];
            const Eigen::Vector3d u = mesh.points_mm[b] - p;
            const Eigen::Vector3d v = mesh.points_mm[c] - p;
            result.points_mm[i] = p + samples[i].s * u + samples[i].t * v;
            result.normals[i] = u.cross(v).normalized().cast<float>();
        }
    });
    return result;
}

}  // namespace lathelier::registration
