#include "engine/features/outline/change_point.h"

#include <algorithm>
#include <cmath>

#include "engine/features/outline/outline_limits.h"

namespace lathelier::features {

std::optional<PlanePlace> placeOfChange(std::vector<LogLikelihoodRatio> points, double from_mm, double to_mm,
                                        double spot_mm)
{
    constexpr double coarse_mm = planeLimits.coarse_step_mm;
    constexpr int steps = planeLimits.fine_steps;
    if (points.size() < planeLimits.least_points || !(to_mm > from_mm)) return std::nullopt;
    std::sort(points.begin(), points.end(),
              [](const LogLikelihoodRatio& a, const LogLikelihoodRatio& b) { return a.z_mm < b.z_mm; });
    std::vector<double> behind(points.size() + 1, 0), ratio(points.size());
    for (std::size_t i = points.size(); i-- > 0;) {
        behind[i] = behind[i + 1] + points[i].log_ratio;
        ratio[i] = std::expm1(points[i].log_ratio);
    }
    const double spot = std::max(spot_mm, planeLimits.least_spot_mm);
    const auto likelihood = [&](double place) {
        const auto at = [](const LogLikelihoodRatio& one, double z) { return one.z_mm < z; };
        const auto low = std::lower_bound(points.begin(), points.end(), place - spot / 2, at);
        auto point = low;
        double sum = 0;
        for (; point != points.end() && point->z_mm < place + spot / 2; ++point)
            sum += std::log1p(((point->z_mm - place) / spot + 0.5) *
                              ratio[static_cast<std::size_t>(point - points.begin())]);
        return sum + behind[static_cast<std::size_t>(point - points.begin())];
    };
    // A coarse grid to bracket the likelihood, then a fine one within.
    std::vector<double> places, values;
    for (double z = from_mm; z <= to_mm; z += coarse_mm) {
        places.push_back(z);
        values.push_back(likelihood(z));
    }
    const double most = *std::max_element(values.begin(), values.end());
    double low = to_mm, high = from_mm;
    for (std::size_t i = 0; i < places.size(); ++i) {
        if (values[i] < most - planeLimits.negligible_log_ratio) continue;
        low = std::min(low, places[i]);
        high = std::max(high, places[i]);
    }
    low = std::max(from_mm, low - coarse_mm);
    high = std::min(to_mm, high + coarse_mm);
    double sum = 0, first = 0, second = 0, best = most;
    std::vector<double> fine(steps + 1);
    for (int k = 0; k <= steps; ++k) {
        fine[static_cast<std::size_t>(k)] = likelihood(low + (high - low) * k / steps);
        best = std::max(best, fine[static_cast<std::size_t>(k)]);
    }
    for (int k = 0; k <= steps; ++k) {
        const double z = low + (high - low) * k / steps, weight = std::exp(fine[static_cast<std::size_t>(k)] - best);
        sum += weight;
        first += weight * (z - low);
        second += weight * (z - low) * (z - low);
    }
    PlanePlace found;
    found.z_mm = low + first / sum;
    found.sigma_mm = std::sqrt(std::max(0.0, second / sum - first * first / (sum * sum)) + planeLimits.place_floor_mm2);
    found.spot_mm = spot_mm;
    return found;
}

}  // namespace lathelier::features
