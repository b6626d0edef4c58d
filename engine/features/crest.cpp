#include "engine/features/crest.h"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace lathelier::features {
namespace {

constexpr double kBins = 4;  // of the histogram, in σ
constexpr double kBelow = 2.5, kAbove = 5;

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

/// Misfit of the density with the crest at c; parts that came out negative are left out.
double misfitAt(const Histogram& histogram, double c, double sigma, double blur)
{
    const auto n = static_cast<Eigen::Index>(histogram.counts.size());
    Eigen::MatrixXd parts(n, 3);
    Eigen::VectorXd seen(n);
    for (Eigen::Index i = 0; i < n; ++i) {
        const double count = histogram.counts[static_cast<std::size_t>(i)];
        const double u = (c - histogram.from_mm - (static_cast<double>(i) + 0.5) * histogram.step_mm) / sigma;
        const double weight = 1 / std::sqrt(count + 1);
        const auto [crest, plateau, ramp] = densities(u, blur / (2 * sigma));
        parts.row(i) << weight * crest, weight * plateau, weight * ramp;
        seen[i] = weight * count;
    }
    double best = seen.squaredNorm();
    for (const Eigen::Index used : {1, 2, 3}) {
        const Eigen::MatrixXd own = parts.leftCols(used);
        const Eigen::VectorXd found = own.colPivHouseholderQr().solve(seen);
        if (found.head(std::min<Eigen::Index>(used, 2)).minCoeff() < 0) continue;
        best = std::min(best, (seen - own * found).squaredNorm());
    }
    return best;
}

/// Where the radii of the outermost third lie closest together.
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

std::optional<Crest> crestOf(std::vector<float> radii, double sigma_mm, double blur_mm)
{
    if (radii.size() < 60 || !(sigma_mm > 0)) return std::nullopt;
    const double start = densest(radii, sigma_mm);
    const Histogram histogram =
        histogramOf(radii, start - kBelow * sigma_mm, start + kAbove * sigma_mm, sigma_mm / kBins);
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

std::vector<Wall> leadIn(const MeridianCloud& cloud, double border_mm, bool toward_end, double longest_mm,
                         double level_mm, double sigma_mm)
{
    constexpr double kStep_mm = 0.1, kReached_mm = 0.03, kSpot_mm = 0.12;
    const double sign = toward_end ? 1 : -1;
    const auto count = static_cast<std::size_t>(std::max(0.0, longest_mm / kStep_mm));
    std::vector<std::vector<std::pair<float, float>>> bins(count);
    for (std::size_t i = 0; i < cloud.z_mm.size(); ++i) {
        const double place = (static_cast<double>(cloud.z_mm[i]) - border_mm) * sign / kStep_mm;
        const double r = static_cast<double>(cloud.r_mm[i]);
        if (place >= 0 && place < static_cast<double>(count) && r > 0.5 * level_mm && r < level_mm + 1)
            bins[static_cast<std::size_t>(place)].emplace_back(cloud.z_mm[i], cloud.r_mm[i]);
    }
    double slope = 0;
    std::vector<Wall> walls;
    for (int round = 0; round < 2; ++round) {
        walls.clear();
        const double scatter = std::hypot(sigma_mm, slope * kSpot_mm / std::sqrt(12.0));
        for (std::size_t b = 0; b < count; ++b) {
            const double z = border_mm + sign * (static_cast<double>(b) + 0.5) * kStep_mm;
            std::vector<float> radii;
            radii.reserve(bins[b].size());
            for (const auto& [at, r] : bins[b]) radii.push_back(static_cast<float>(r - slope * (at - z)));
            const std::optional<Crest> crest = crestOf(std::move(radii), sigma_mm, std::abs(slope) * kSpot_mm);
            if (!crest || crest->radius_mm > level_mm - kReached_mm) break;
            Wall wall;
            wall.z_mm = z;
            wall.r_mm = crest->radius_mm;
            wall.sigma_mm = scatter;
            wall.points = std::max(1.0, std::pow(scatter / crest->sigma_mm, 2));
            wall.width_mm = kStep_mm;
            wall.coverage = 1;
            walls.push_back(wall);
        }
        if (walls.size() < 3) return {};
        double sz = 0, sr = 0, szz = 0, szr = 0;
        const auto n = static_cast<double>(walls.size());
        for (const Wall& wall : walls) {
            const double z = wall.z_mm - border_mm;
            sz += z;
            sr += wall.r_mm;
            szz += z * z;
            szr += z * wall.r_mm;
        }
        slope = (n * szr - sz * sr) / (n * szz - sz * sz);
    }
    if (!(slope * sign > 0.1)) return {};
    if (!toward_end) std::reverse(walls.begin(), walls.end());
    return walls;
}

}  // namespace lathelier::features
