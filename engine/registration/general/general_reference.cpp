#include "engine/registration/general/general_reference.h"

#include <algorithm>

#include "engine/core/error.h"
#include "engine/core/statistics.h"
#include "engine/registration/point_checks.h"
#include "engine/registration/surface/drawn_surface.h"
#include "engine/registration/surface/surface_samples.h"

namespace lathelier::registration {
namespace {

using Points = std::vector<Eigen::Vector3d>;

constexpr std::size_t referenceSamples = 200000;
constexpr std::size_t medianSamples = 100000;

}  // namespace

std::vector<Eigen::Vector3d> everyNth(const std::vector<Eigen::Vector3d>& points_mm, std::size_t count)
{
    if (points_mm.size() <= count) return points_mm;
    Points result;
    result.reserve(count);
    for (std::size_t i = 0; i < count; ++i) result.push_back(points_mm[i * points_mm.size() / count]);
    return result;
}

CentredPoints centrePoints(const Scan& scan, const char* role, const Progress& progress)
{
    CentredPoints result;
    result.points_mm = scan.isMesh() ? sampleSurface(scan, referenceSamples, 0, progress).points_mm : scan.points_mm;
    checkPoints(result.points_mm, role, progress, 4);
    const Points some = everyNth(result.points_mm, medianSamples);
    std::vector<double> values(some.size());
    for (int a = 0; a < 3; ++a) {
        std::transform(some.begin(), some.end(), values.begin(), [a](const auto& p) { return p[a]; });
        result.middle_mm[a] = upperMedianInPlace(values);
    }
    std::transform(some.begin(), some.end(), values.begin(),
                   [&](const auto& p) { return (p - result.middle_mm).norm(); });
    result.size_mm = quantileInPlace(values, 0.9);
    progress.check();
    for (auto& p : result.points_mm) p -= result.middle_mm;
    return result;
}

GeneralReference prepareReference(const Scan& reference, const Progress& progress)
{
    GeneralReference result;
    result.points = centrePoints(reference, "reference", progress);
    progress.report(0.1);
    Scan shifted;
    shifted.normals = reference.normals;
    shifted.triangles = reference.triangles;
    shifted.points_mm = result.points.points_mm;
    if (reference.isMesh()) {
        shifted.points_mm = reference.points_mm;
        for (auto& p : shifted.points_mm) p -= result.points.middle_mm;
    }
    result.surface = makeSurface(shifted, progress.part(0.1, 1));
    return result;
}

GeneralReference prepareReference(const Scan& mesh, const Contour& meridian, const Progress& progress)
{
    GeneralReference result;
    result.points = centrePoints(mesh, "reference", progress);
    result.surface = std::make_shared<DrawnSurface>(meridian, result.points.middle_mm);
    return result;
}

}  // namespace lathelier::registration
