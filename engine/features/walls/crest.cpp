#include "engine/features/walls/crest.h"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "engine/core/statistics.h"

namespace lathelier::features {
namespace {

constexpr double binsPerSigma = 4;  // of the histogram, in σ
constexpr double sigmasBelow = 2.5, sigmasAbove = 5;

/// Counts from `from` on.
struct Histogram {
    double from_mm = 0, step_mm = 0;
    std::vector<double> counts;
};

Histogram histogramOf(const std::vector<float>& radii, double from_mm, double to_mm, double step_mm)
{
    Histogram histogram{from_mm, step_mm, {}};
    histogram.counts.assign(static_cast<std::size_t>((to_mm - from_mm) / step_mm) + 1, 0);
    for (const float r : radii) {
        const double place = (static_cast<double>(r) - from_mm) / step_mm;
        if (place >= 0 && place < static_cast<double>(histogram.counts.size()))
            ++histogram.counts[static_cast<std::size_t>(place)];
    }
    return histogram;
}

double normal(double u)
{
    return std::exp(-u * u / 2) / std::sqrt(2 * std::numbers::pi);
}

double below(double u)
{
    return 0.5 * std::erfc(-u / std::numbers::sqrt2);
}

/// φ, its integral and the integral of that at u, each as the mean over u ± half.
std::array<double, 3> densities(double u, double half)
{
    // Integrals of Φ: u Φ + φ, then ((u² + 1) Φ + u φ) / 2.
    const auto once = [](double x) { return x * below(x) + normal(x); };
    const auto twice = [](double x) { return ((x * x + 1) * below(x) + x * normal(x)) / 2; };
    if (!(half > 0.05)) return {normal(u), below(u), once(u)};
    const auto mean = [&](const auto& integral) { return (integral(u + half) - integral(u - half)) / (2 * half); };
    return {mean(below), mean(once), mean(twice)};
}

/// Deviance of the counts, which are Poisson's, from the density with the crest at c, and 2 for each part that is used.
/// The parts' weights by repeated weighted least squares; parts that came out negative are left out.
double misfitAt(const Histogram& histogram, double c, double sigma, double blur)
{
    constexpr int rounds = 4;
    constexpr double leastExpected = 0.02;
    const auto n = static_cast<Eigen::Index>(histogram.counts.size());
    Eigen::MatrixXd parts(n, 3);
    Eigen::VectorXd seen(n);
    for (Eigen::Index i = 0; i < n; ++i) {
        const double u = (c - histogram.from_mm - (static_cast<double>(i) + 0.5) * histogram.step_mm) / sigma;
        const auto [crest, plateau, ramp] = densities(u, blur / (2 * sigma));
        parts.row(i) << crest, plateau, ramp;
        seen[i] = histogram.counts[static_cast<std::size_t>(i)];
    }
    double best = std::numeric_limits<double>::infinity();
    for (const Eigen::Index used : {1, 2, 3}) {
        const Eigen::MatrixXd own = parts.leftCols(used);
        Eigen::VectorXd expected = seen.array() + 1, found;
        for (int round = 0; round < rounds; ++round) {
            const Eigen::MatrixXd weighted = expected.cwiseInverse().asDiagonal() * own;
            found = (own.transpose() * weighted).ldlt().solve(weighted.transpose() * seen);
            expected = (own * found).cwiseMax(leastExpected);
        }
        if (!found.allFinite() || found.head(std::min<Eigen::Index>(used, 2)).minCoeff() < 0) continue;
        double sum = 2 * static_cast<double>(used);
        for (Eigen::Index i = 0; i < n; ++i)
            sum += 2 * (expected[i] - seen[i] + (seen[i] > 0 ? seen[i] * std::log(seen[i] / expected[i]) : 0));
        best = std::min(best, sum);
    }
    return best;
}

/// The densest place among the outermost third of the radii.
double densest(std::vector<float> radii, double sigma)
{
    const auto third = radii.begin() + static_cast<std::ptrdiff_t>(radii.size() * 2 / 3);
    std::nth_element(radii.begin(), third, radii.end());
    std::sort(third, radii.end());
    double most = 0, place = static_cast<double>(radii.back());
    for (auto low = third, high = third; low != radii.end(); ++low) {
        while (high != radii.end() && *high - *low < static_cast<float>(2 * sigma)) ++high;
        const auto count = static_cast<double>(high - low);
        if (count < most) continue;
        most = count;
        place = static_cast<double>(*low) + sigma;
    }
    return place;
}

}  // namespace

std::optional<Crest> crestOf(const std::vector<float>& radii, double sigma_mm, double blur_mm)
{
    if (radii.size() < 60 || !(sigma_mm > 0)) return std::nullopt;
    const double start = densest(radii, std::hypot(sigma_mm, blur_mm / std::sqrt(12.0)));
    const Histogram histogram = histogramOf(radii, start - sigmasBelow * sigma_mm - blur_mm,
                                            start + sigmasAbove * sigma_mm + blur_mm / 2, sigma_mm / binsPerSigma);
    double place = start, step = 0.25 * sigma_mm, least = misfitAt(histogram, start, sigma_mm, blur_mm);
    for (int round = 0; round < 5; ++round, step /= 4) {
        const double around = place;
        for (int k = -8; k <= 8; ++k)
            if (const double trial = misfitAt(histogram, around + k * step, sigma_mm, blur_mm); trial < least) {
                least = trial;
                place = around + k * step;
            }
    }
    const double h = 0.1 * sigma_mm;
    const double bend = misfitAt(histogram, place + h, sigma_mm, blur_mm) +
                        misfitAt(histogram, place - h, sigma_mm, blur_mm) - 2 * least;
    return Crest{place, bend > 0 ? std::min(sigma_mm, h * std::sqrt(2 / bend)) : sigma_mm};
}

Lead leadIn(const MeridianCloud& cloud, double border_mm, bool toward_end, double longest_mm, double level_mm,
            double sigma_mm)
{
    constexpr double shareWidth_mm = 0.1, crestTolerance_mm = 0.03, endMargin_mm = 0.15, assumedSpot_mm = 0.15,
                     groupLength_mm = 0.6, shortestLead_mm = 0.2;
    constexpr double leastErrorFactor = 2.5,
                     crestShareFactor = 1.7;  // allows for the unknown share of the points on the crest
    constexpr int rounds = 4;
    const double sign = toward_end ? 1 : -1;
    std::vector<std::pair<double, double>> points;  // how far inside the border, radius
    for (std::size_t i = 0; i < cloud.z_mm.size(); ++i) {
        const double place = (static_cast<double>(cloud.z_mm[i]) - border_mm) * sign;
        const double r = static_cast<double>(cloud.r_mm[i]);
        if (place >= 0 && place < longest_mm && r > 0.5 * level_mm && r < level_mm + 1) points.emplace_back(place, r);
    }
    std::sort(points.begin(), points.end());
    // Crest of what lies between two places, moved along the slope to the middle between them.
    const auto crestAt = [&](double from, double to, double slope) {
        const auto at = [](const std::pair<double, double>& point, double place) { return point.first < place; };
        const auto first = std::lower_bound(points.begin(), points.end(), from, at);
        const auto last = std::lower_bound(first, points.end(), to, at);
        std::vector<float> radii;
        radii.reserve(static_cast<std::size_t>(last - first));
        for (auto point = first; point != last; ++point)
            radii.push_back(static_cast<float>(point->second - slope * (point->first - (from + to) / 2)));
        return std::pair(crestOf(radii, sigma_mm, std::abs(slope) * assumedSpot_mm), last - first);
    };
    // First bin by bin; the median of the slopes between all pairs (Theil and Sen) is robust to bins with a wrong
    // crest.
    std::vector<std::pair<double, double>> crests;
    for (double from = 0; from + shareWidth_mm <= longest_mm; from += shareWidth_mm) {
        const auto crest = crestAt(from, from + shareWidth_mm, 0).first;
        if (!crest || crest->radius_mm > level_mm - crestTolerance_mm) break;
        crests.emplace_back(from + shareWidth_mm / 2, crest->radius_mm);
    }
    if (crests.size() < 3) return {};
    const auto middleOf = [](std::vector<double> values) { return upperMedianInPlace(values); };
    std::vector<double> slopes, levels;
    for (std::size_t i = 0; i < crests.size(); ++i)
        for (std::size_t j = i + 1; j < crests.size(); ++j)
            slopes.push_back((crests[j].second - crests[i].second) / (crests[j].first - crests[i].first));
    double slope = middleOf(slopes);
    for (const auto& [place, r] : crests) levels.push_back(r - slope * place);
    double level = middleOf(levels);
    // Then over groups of bins, with the slope removed.
    Lead lead;
    for (int round = 0; round < rounds; ++round) {
        if (!(slope > 0.1)) return {};
        const double length = std::min(longest_mm, (level_mm - level) / slope - endMargin_mm);
        if (!(length >= shortestLead_mm)) return {};
        const int groups = std::max(3, static_cast<int>(length / groupLength_mm));
        const double scatter = std::hypot(sigma_mm, slope * assumedSpot_mm / std::sqrt(12.0)), step = length / groups;
        lead.walls.clear();
        lead.reached_mm = border_mm + sign * (length + endMargin_mm);
        double s = 0, sx = 0, sy = 0, sxx = 0, sxy = 0;
        for (int g = 0; g < groups; ++g) {
            const auto [crest, count] = crestAt(g * step, (g + 1) * step, slope);
            if (!crest) return {};
            const double error = std::max(crestShareFactor * crest->sigma_mm,
                                          leastErrorFactor * scatter / std::sqrt(static_cast<double>(count)));
            const double x = (g + 0.5) * step, w = 1 / (error * error);
            const int shares = std::max(1, static_cast<int>(std::lround(step / shareWidth_mm)));
            for (int k = 0; k < shares; ++k) {
                const double off = ((k + 0.5) / shares - 0.5) * step;
                Wall wall;
                wall.z_mm = border_mm + sign * (x + off);
                wall.r_mm = crest->radius_mm + slope * off;
                wall.sigma_mm = scatter;
                wall.points = std::max(1.0, std::pow(scatter / error, 2)) / shares;
                wall.width_mm = step / shares;
                wall.coverage = 1;
                lead.walls.push_back(wall);
            }
            s += w;
            sx += w * x;
            sy += w * crest->radius_mm;
            sxx += w * x * x;
            sxy += w * x * crest->radius_mm;
        }
        slope = (s * sxy - sx * sy) / (s * sxx - sx * sx);
        level = (sy - slope * sx) / s;
    }
    if (!toward_end) std::reverse(lead.walls.begin(), lead.walls.end());
    return lead;
}

}  // namespace lathelier::features
