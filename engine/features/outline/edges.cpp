#include "engine/features/outline/edges.h"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "engine/core/statistics.h"

namespace lathelier::features {
namespace {

using registration::Ray;

constexpr double sureOfRay = 0.997;
constexpr std::array<double, 13> candidateWidths_mm{0.01, 0.02, 0.04, 0.06, 0.08, 0.1, 0.12,
                                                    0.15, 0.18, 0.22, 0.28, 0.36, widestSpot_mm};
constexpr int edgeSectors = 24;

/// Sum of log P over the rays, which are in order of height.
double logLikelihood(const std::vector<Ray>& rays, const std::vector<std::size_t>& hits_before, double place,
                     double width)
{
    const auto at = [&](double height) {
        return static_cast<std::size_t>(std::lower_bound(rays.begin(), rays.end(), height,
                                                         [](const Ray& ray, double h) { return ray.height < h; }) -
                                        rays.begin());
    };
    const std::size_t low = at(place - width / 2), high = at(place + width / 2);
    const double sure = std::log(sureOfRay), wrong = std::log(1 - sureOfRay);
    const auto hits = [&](std::size_t from, std::size_t to) {
        return static_cast<double>(hits_before[to] - hits_before[from]);
    };
    const double below_hits = hits(0, low), above_hits = hits(high, rays.size());
    double sum = below_hits * wrong + (static_cast<double>(low) - below_hits) * sure + above_hits * sure +
                 (static_cast<double>(rays.size() - high) - above_hits) * wrong;
    for (std::size_t i = low; i < high; ++i) {
        const double p = std::clamp((rays[i].height - place) / width + 0.5, 1 - sureOfRay, sureOfRay);
        sum += std::log(rays[i].hit ? p : 1 - p);
    }
    return sum;
}

}  // namespace

std::optional<PlanePlace> placeOf(const registration::EdgeRays& edge)
{
    const std::vector<Ray>& rays = edge.rays;
    std::vector<std::size_t> hits(rays.size() + 1, 0);
    for (std::size_t i = 0; i < rays.size(); ++i) hits[i + 1] = hits[i] + (rays[i].hit ? 1 : 0);
    const std::size_t all_hits = hits.back();
    if (all_hits < 10 || rays.size() - all_hits < 10) return std::nullopt;
    // Start: the place with the fewest contradicting rays.
    double start = rays.front().height, least = 1e300;
    for (std::size_t i = 0; i <= rays.size(); ++i) {
        const double wrong =
            static_cast<double>(hits[i]) + static_cast<double>((rays.size() - i) - (all_hits - hits[i]));
        if (wrong < least) {
            least = wrong;
            start = i == 0             ? rays.front().height
                    : i == rays.size() ? rays.back().height
                                       : (rays[i - 1].height + rays[i].height) / 2;
        }
    }
    double best = -1e300, place = start, width = candidateWidths_mm[0];
    for (const double w : candidateWidths_mm) {
        double centre = start, step = 0.04;
        double value = logLikelihood(rays, hits, centre, w);
        for (int round = 0; round < 7; ++round, step /= 4) {
            const double around = centre;
            for (int k = -6; k <= 6; ++k) {
                const double trial = logLikelihood(rays, hits, around + k * step, w);
                if (trial > value) {
                    value = trial;
                    centre = around + k * step;
                }
            }
        }
        if (value > best) {
            best = value;
            place = centre;
            width = w;
        }
    }
    const auto near =
        std::lower_bound(rays.begin(), rays.end(), place, [](const Ray& ray, double h) { return ray.height < h; });
    double gap = 0;
    for (auto ray = near - std::min<std::ptrdiff_t>(8, near - rays.begin()); ray + 1 < rays.end() && ray < near + 8;
         ++ray)
        gap = std::max(gap, (ray + 1)->height - ray->height);
    const double reach = std::max(0.3, width);
    const auto low = std::lower_bound(rays.begin(), rays.end(), place - reach,
                                      [](const Ray& ray, double h) { return ray.height < h; });
    const auto high = std::lower_bound(rays.begin(), rays.end(), place + reach,
                                       [](const Ray& ray, double h) { return ray.height < h; });
    const double density = std::max(1.0, static_cast<double>(high - low)) / (2 * reach);
    PlanePlace found;
    found.z_mm = place * edge.edge.sign;
    found.spot_mm = width;
    found.sigma_mm = std::sqrt(width / (6 * density) + gap * gap / 12 + 1e-6 + edge.lean_sigma_mm * edge.lean_sigma_mm);
    return found;
}

std::optional<PlanePlace> seenFace(const MeridianCloud& cloud, double z_mm, double inner_mm, double outer_mm,
                                   double sigma_mm, double walls_per_mm2)
{
    constexpr double least_mm = 1e-3;  // lower bound, for data without noise
    sigma_mm = std::max(sigma_mm, least_mm);
    const double margin = 6 * sigma_mm + 0.15, reach = 8 * sigma_mm + 0.3;
    const double low = inner_mm + (inner_mm > 0 ? margin : 0), high = outer_mm - margin;
    if (!(high > low)) return std::nullopt;
    std::vector<double> heights;
    for (std::size_t i = 0; i < cloud.z_mm.size(); ++i) {
        const double z = static_cast<double>(cloud.z_mm[i]), r = static_cast<double>(cloud.r_mm[i]);
        if (std::abs(z - z_mm) < reach && r > low && r < high) heights.push_back(z);
    }
    const double area = std::numbers::pi * (high * high - low * low);
    if (heights.size() < 30 || static_cast<double>(heights.size()) < walls_per_mm2 * area / 3) return std::nullopt;
    for (int round = 0; round < 3; ++round) {
        const double middle = upperMedianInPlace(heights);
        std::erase_if(heights, [&](double z) { return std::abs(z - middle) > 4 * sigma_mm; });
        if (heights.size() < 20) return std::nullopt;
    }
    double sum = 0, squares = 0;
    for (const double z : heights) sum += z - z_mm;
    const double n = static_cast<double>(heights.size()), mean = sum / n;
    for (const double z : heights) squares += (z - z_mm - mean) * (z - z_mm - mean);
    if (std::sqrt(squares / n) > 2 * sigma_mm) return std::nullopt;  // a slope, no face
    return PlanePlace{z_mm + mean, std::sqrt(squares / n / n + 1e-6 * 0.25), 0};
}

std::optional<EndPlace> endOf(const MeridianCloud& cloud, const Model& model, const Run& run, bool start,
                              const std::optional<registration::ScannerAxis>& scanner)
{
    const double sign = start ? -1 : 1;  // heights grow toward the end
    const double guess = start ? run.nodes_mm.front() : run.nodes_mm.back();
    const double deep = std::min(5.0, 0.8 * (run.nodes_mm.back() - run.nodes_mm.front()));
    struct Hit {
        double height;
        int sector;
    };
    std::vector<Hit> hits;
    for (std::size_t i = 0; i < cloud.z_mm.size(); ++i) {
        const double z = static_cast<double>(cloud.z_mm[i]);
        const double height = (z - guess) * sign;
        if (height < -deep || height > 1) continue;
        const double at = std::clamp(z, run.nodes_mm.front(), run.nodes_mm.back());
        const std::size_t element = start ? 0 : run.elements.size() - 1;
        const double end_node = start ? run.nodes_mm[1] : run.nodes_mm[run.nodes_mm.size() - 2];
        // Beyond the estimated end the last element is extrapolated.
        const double model_r = (z - end_node) * sign > 0 ? run.elements[element].radiusAt_mm(z) : radiusAt_mm(run, at);
        const double slope = std::abs(run.elements[element].slopeAt(at));
        if (std::abs(static_cast<double>(cloud.r_mm[i]) - model_r) >
            5 * model.sigma_mm + 0.5 * model.spot_mm * std::min(slope, 2.0))
            continue;
        hits.push_back({height, std::min(edgeSectors - 1, static_cast<int>(cloud.turn[i] * edgeSectors))});
    }
    if (hits.size() < 60) return std::nullopt;
    std::sort(hits.begin(), hits.end(), [](const Hit& a, const Hit& b) { return a.height < b.height; });
    // Sectors in which the wall is whole: as many hits over the last millimetres as the median sector has.
    std::array<double, edgeSectors> counts{}, last{};
    last.fill(-deep);
    for (const Hit& hit : hits) counts[static_cast<std::size_t>(hit.sector)] += 1;
    std::vector<double> sorted(counts.begin(), counts.end());
    std::sort(sorted.begin(), sorted.end());
    const double usual = sorted[edgeSectors * 3 / 4];
    std::array<std::vector<double>, edgeSectors> heights;
    for (const Hit& hit : hits) heights[static_cast<std::size_t>(hit.sector)].push_back(hit.height);
    std::vector<double> lasts;
    for (std::size_t s = 0; s < edgeSectors; ++s)
        if (heights[s].size() > 3) {
            last[s] = heights[s][heights[s].size() - 3];  // stray points are not counted as the last hit
            lasts.push_back(last[s]);
        }
    if (lasts.size() < 3) return std::nullopt;
    std::sort(lasts.begin(), lasts.end());
    const double common = lasts[lasts.size() / 2];
    std::array<bool, edgeSectors> whole{};
    for (std::size_t s = 0; s < edgeSectors; ++s)
        whole[s] = counts[s] > 0.8 * usual && std::abs(last[s] - common) < 0.6;
    std::vector<double> used;
    for (const Hit& hit : hits)
        if (whole[static_cast<std::size_t>(hit.sector)]) used.push_back(hit.height);
    if (used.size() < 40) return std::nullopt;
    // Density from the stretch before the ramp.
    const double from = -deep, to = common - 0.4;
    const auto count =
        std::lower_bound(used.begin(), used.end(), to) - std::lower_bound(used.begin(), used.end(), from);
    const double density = static_cast<double>(count) / std::max(0.1, to - from);
    const double width = model.spot_mm > 0 ? model.spot_mm : 0.02;
    const auto value = [&](double place) {
        const auto ramp = std::lower_bound(used.begin(), used.end(), place - width / 2);
        double sum = -density * place;
        for (auto h = ramp; h != used.end(); ++h) sum += std::log(std::clamp(0.5 - (*h - place) / width, 0.003, 1.0));
        return sum;
    };
    double place = common, best = value(place), step = 0.05;
    for (int round = 0; round < 7; ++round, step /= 4) {
        const double around = place;
        for (int k = -8; k <= 8; ++k) {
            const double trial = value(around + k * step);
            if (trial > best) {
                best = trial;
                place = around + k * step;
            }
        }
    }
    double gap = 0;
    const auto near = std::lower_bound(used.begin(), used.end(), place - width);
    for (auto h = near - std::min<std::ptrdiff_t>(20, near - used.begin()); h + 1 < used.end() && h < near; ++h)
        gap = std::max(gap, *(h + 1) - *h);
    EndPlace found;
    found.place.z_mm = guess + sign * place;
    // The density is that of the wall before; the scatter over the sectors includes the effect of regular rows.
    found.place.sigma_mm = std::sqrt(width / (6 * density) + gap * gap / 12 + 36e-6);
    found.place.spot_mm = width;
    if (!scanner) return found;
    // First harmonic of the last hits against the tilt of the rows.
    const double radius = start ? startRadius_mm(run) : endRadius_mm(run);
    const Eigen::Vector2d tilt = -scanner->direction.head<2>() / scanner->direction.z() * radius;
    Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
    Eigen::Vector3d right = Eigen::Vector3d::Zero();
    std::vector<std::pair<Eigen::Vector3d, double>> rows;
    for (std::size_t s = 0; s < edgeSectors; ++s) {
        if (!whole[s]) continue;
        const double angle = 2 * std::numbers::pi * (static_cast<double>(s) + 0.5) / edgeSectors;
        const Eigen::Vector3d row(1, std::cos(angle), std::sin(angle));
        rows.emplace_back(row, sign * last[s]);
        normal += row * row.transpose();
        right += row * sign * last[s];
    }
    if (rows.size() < 6 || tilt.norm() < 0.01) return found;
    const Eigen::Vector3d fit = normal.ldlt().solve(right);
    double scatter = 0;
    for (const auto& [row, z] : rows) scatter += std::pow(z - row.dot(fit), 2);
    scatter = std::sqrt(scatter / static_cast<double>(rows.size() - 3));
    const Eigen::Matrix3d inverse = normal.inverse();
    const Eigen::Vector2d along = tilt.normalized();
    found.tilt_share = fit.tail<2>().dot(along) / tilt.norm();
    found.tilt_share_sigma = scatter * std::sqrt(along.dot(inverse.bottomRightCorner<2, 2>() * along)) / tilt.norm();
    return found;
}

}  // namespace lathelier::features
