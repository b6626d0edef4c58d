#include "engine/features/walls/crest.h"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "engine/core/statistics.h"
#include "engine/features/walls/grid_search.h"
#include "engine/features/walls/wall_limits.h"

namespace lathelier::features {
namespace {

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
    if (!(half > crestLimits.least_blur_sigmas)) return {normal(u), below(u), once(u)};
    const auto mean = [&](const auto& integral) { return (integral(u + half) - integral(u - half)) / (2 * half); };
    return {mean(below), mean(once), mean(twice)};
}

/// Deviance of the counts, which are Poisson's, from the density with the crest at c, and 2 for each part that is used.
/// The parts' weights by repeated weighted least squares; parts that came out negative are left out.
double misfitAt(const Histogram& histogram, double c, double sigma, double blur)
{
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
        for (int round = 0; round < crestLimits.weight_rounds; ++round) {
            const Eigen::MatrixXd weighted = expected.cwiseInverse().asDiagonal() * own;
            found = (own.transpose() * weighted).ldlt().solve(weighted.transpose() * seen);
            expected = (own * found).cwiseMax(crestLimits.least_expected);
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
    const auto width = static_cast<float>(crestLimits.densest_width_sigmas * sigma);
    double most = 0, place = static_cast<double>(radii.back());
    for (auto low = third, high = third; low != radii.end(); ++low) {
        while (high != radii.end() && *high - *low < width) ++high;
        const auto count = static_cast<double>(high - low);
        if (count < most) continue;
        most = count;
        place = static_cast<double>(*low) + sigma;
    }
    return place;
}

/// A straight line over the place inside the border.
struct LeadLine {
    double slope = 0, level_mm = 0;
};

/// Search for the cone at the start of a rough zone; places count from the border inward.
class LeadSearch {
public:
    LeadSearch(const MeridianCloud& cloud, double border_mm, bool toward_end, double longest_mm, double level_mm,
               double sigma_mm)
        : border_mm_(border_mm),
          sign_(toward_end ? 1 : -1),
          longest_mm_(longest_mm),
          level_mm_(level_mm),
          sigma_mm_(sigma_mm)
    {
        for (std::size_t i = 0; i < cloud.z_mm.size(); ++i) {
            const double place = (static_cast<double>(cloud.z_mm[i]) - border_mm) * sign_;
            const double r = static_cast<double>(cloud.r_mm[i]);
            if (place >= 0 && place < longest_mm && r > crestLimits.lead_inner_share * level_mm &&
                r < level_mm + crestLimits.lead_outer_mm)
                points_.emplace_back(place, r);
        }
        std::sort(points_.begin(), points_.end());
    }

    Lead find() const
    {
        std::optional<LeadLine> line = startingLine();
        Lead lead;
        for (int round = 0; line && round < crestLimits.lead_rounds; ++round) line = refined(*line, lead);
        if (!line) return {};
        if (sign_ < 0) std::reverse(lead.walls.begin(), lead.walls.end());
        return lead;
    }

private:
    /// Crest of the points between two places, moved along the slope to the middle between them, and their number.
    std::pair<std::optional<Crest>, std::ptrdiff_t> crestAt(double from, double to, double slope) const
    {
        const auto at = [](const std::pair<double, double>& point, double place) { return point.first < place; };
        const auto first = std::lower_bound(points_.begin(), points_.end(), from, at);
        const auto last = std::lower_bound(first, points_.end(), to, at);
        std::vector<float> radii;
        radii.reserve(static_cast<std::size_t>(last - first));
        for (auto point = first; point != last; ++point)
            radii.push_back(static_cast<float>(point->second - slope * (point->first - (from + to) / 2)));
        return {crestOf(radii, sigma_mm_, std::abs(slope) * crestLimits.assumed_spot_mm), last - first};
    }

    /// Crests bin by bin; the median of the slopes between all pairs (Theil and Sen) is robust to wrong ones.
    std::optional<LeadLine> startingLine() const
    {
        const double bin_mm = crestLimits.lead_bin_mm;
        std::vector<std::pair<double, double>> crests;
        for (double from = 0; from + bin_mm <= longest_mm_; from += bin_mm) {
            const auto crest = crestAt(from, from + bin_mm, 0).first;
            if (!crest || crest->radius_mm > level_mm_ - crestLimits.lead_level_mm) break;
            crests.emplace_back(from + bin_mm / 2, crest->radius_mm);
        }
        if (crests.size() < crestLimits.least_lead_bins) return std::nullopt;
        std::vector<double> slopes, levels;
        for (std::size_t i = 0; i < crests.size(); ++i)
            for (std::size_t j = i + 1; j < crests.size(); ++j)
                slopes.push_back((crests[j].second - crests[i].second) / (crests[j].first - crests[i].first));
        const double slope = upperMedianInPlace(slopes);
        for (const auto& [place, r] : crests) levels.push_back(r - slope * place);
        return LeadLine{slope, upperMedianInPlace(levels)};
    }

    /// The line through the crests of groups of bins from which the slope is removed, and the walls along it. None: no
    /// such cone.
    std::optional<LeadLine> refined(const LeadLine& line, Lead& lead) const
    {
        const auto [slope, level] = line;
        if (!(slope > crestLimits.least_lead_slope)) return std::nullopt;
        const double length = std::min(longest_mm_, (level_mm_ - level) / slope - crestLimits.lead_margin_mm);
        if (!(length >= crestLimits.shortest_lead_mm)) return std::nullopt;
        const int groups =
            std::max(crestLimits.least_lead_groups, static_cast<int>(length / crestLimits.lead_group_mm));
        const double scatter = std::hypot(sigma_mm_, slope * crestLimits.assumed_spot_mm / std::sqrt(12.0)),
                     step = length / groups;
        lead.walls.clear();
        lead.reached_mm = border_mm_ + sign_ * (length + crestLimits.lead_margin_mm);
        double s = 0, sx = 0, sy = 0, sxx = 0, sxy = 0;
        for (int g = 0; g < groups; ++g) {
            const auto [crest, count] = crestAt(g * step, (g + 1) * step, slope);
            if (!crest) return std::nullopt;
            const double error =
                std::max(crestLimits.crest_error_factor * crest->sigma_mm,
                         crestLimits.point_error_factor * scatter / std::sqrt(static_cast<double>(count)));
            const double x = (g + 0.5) * step, w = 1 / (error * error);
            addWalls(lead.walls, x, step, crest->radius_mm, slope, scatter, error);
            s += w;
            sx += w * x;
            sy += w * crest->radius_mm;
            sxx += w * x * x;
            sxy += w * x * crest->radius_mm;
        }
        const double next_slope = (s * sxy - sx * sy) / (s * sxx - sx * sx);
        return LeadLine{next_slope, (sy - next_slope * sx) / s};
    }

    /// Walls of the usual width over one group of length `step`, its crest in the middle.
    void addWalls(std::vector<Wall>& walls, double middle, double step, double crest_mm, double slope, double scatter,
                  double error) const
    {
        const int shares = std::max(1, static_cast<int>(std::lround(step / crestLimits.lead_bin_mm)));
        for (int k = 0; k < shares; ++k) {
            const double off = ((k + 0.5) / shares - 0.5) * step;
            Wall wall;
            wall.z_mm = border_mm_ + sign_ * (middle + off);
            wall.r_mm = crest_mm + slope * off;
            wall.sigma_mm = scatter;
            wall.points = std::max(1.0, std::pow(scatter / error, 2)) / shares;
            wall.width_mm = step / shares;
            wall.coverage = 1;
            walls.push_back(wall);
        }
    }

    double border_mm_, sign_, longest_mm_, level_mm_, sigma_mm_;
    std::vector<std::pair<double, double>> points_;  ///< place and radius, in order
};

}  // namespace

std::optional<Crest> crestOf(const std::vector<float>& radii, double sigma_mm, double blur_mm)
{
    if (radii.size() < crestLimits.least_radii || !(sigma_mm > 0)) return std::nullopt;
    const double start = densest(radii, std::hypot(sigma_mm, blur_mm / std::sqrt(12.0)));
    const Histogram histogram =
        histogramOf(radii, start - crestLimits.inner_sigmas * sigma_mm - blur_mm,
                    start + crestLimits.outer_sigmas * sigma_mm + blur_mm / 2, sigma_mm / crestLimits.bins_per_sigma);
    const auto misfit = [&](double place) { return misfitAt(histogram, place, sigma_mm, blur_mm); };
    const auto [place, largest] =
        gridMaximum([&](double at) { return -misfit(at); }, start, crestLimits.search_step_sigmas * sigma_mm,
                    crestLimits.search_rounds, crestLimits.search_steps);
    const double h = crestLimits.curvature_step_sigmas * sigma_mm;
    const double bend = misfit(place + h) + misfit(place - h) + 2 * largest;
    return Crest{place, bend > 0 ? std::min(sigma_mm, h * std::sqrt(2 / bend)) : sigma_mm};
}

Lead leadIn(const MeridianCloud& cloud, double border_mm, bool toward_end, double longest_mm, double level_mm,
            double sigma_mm)
{
    return LeadSearch(cloud, border_mm, toward_end, longest_mm, level_mm, sigma_mm).find();
}

}  // namespace lathelier::features
