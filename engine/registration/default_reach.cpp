#include "engine/registration/default_reach.h"

#include <algorithm>

#include "engine/core/statistics.h"
#include "engine/registration/general/general_reference.h"

namespace lathelier::registration {
namespace {

constexpr double leastReachShare = 0.006;
constexpr double farthest = 0.02;
constexpr double largestNoiseShare = 0.01;

}  // namespace

double robustSize_mm(const std::vector<Eigen::Vector3d>& points_mm)
{
    const std::vector<Eigen::Vector3d> some = everyNth(points_mm, 20000);
    Eigen::Vector3d middle;
    std::vector<double> values(some.size());
    for (int a = 0; a < 3; ++a) {
        std::transform(some.begin(), some.end(), values.begin(), [a](const auto& p) { return p[a]; });
        middle[a] = upperMedianInPlace(values);
    }
    std::transform(some.begin(), some.end(), values.begin(), [&](const auto& p) { return (p - middle).norm(); });
    return 2 * quantileInPlace(values, 0.9);
}

double defaultReach_mm(double size_mm, double noise_mm, double scatter_mm)
{
    const double noise = noise_mm <= largestNoiseShare * size_mm ? noise_mm : 0;
    return std::max({leastReachShare * size_mm, 10 * noise, std::min(10 * scatter_mm, farthest * size_mm)});
}

}  // namespace lathelier::registration
