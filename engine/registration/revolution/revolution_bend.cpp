#include "engine/registration/revolution/revolution_bend.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "engine/core/statistics.h"

namespace lathelier::registration {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr std::size_t bendSections = 24;
constexpr std::size_t leastSectionPoints = 12;

struct SectionResidual {
    double cosine, sine, off;
};

struct Centre {
    double z;
    Vector2d place;
    double variance;  ///< of each coordinate, mm²
    double scatter;   ///< of the points about the circle
};

/// Robust circle about the section's own centre: off = c + x cos + y sin.
bool centreOf(const std::vector<SectionResidual>& section, double reach_mm, Centre& centre)
{
    if (section.size() < leastSectionPoints) return false;
    Vector3d value = Vector3d::Zero();
    double scale = reach_mm;
    Eigen::Matrix3d normal;
    std::vector<double> sizes;
    for (int round = 0; round < 8; ++round) {
        normal.setZero();
        Vector3d right = Vector3d::Zero();
        sizes.clear();
        for (const SectionResidual& r : section) {
            const Vector3d j(1, r.cosine, r.sine);
            const double e = r.off - j.dot(value);
            sizes.push_back(std::abs(e));
            const double u = e / scale;
            if (!(u * u < 1)) continue;
            const double w = (1 - u * u) * (1 - u * u);
            normal += w * j * j.transpose();
            right += w * e * j;
        }
        const Vector3d change = normal.ldlt().solve(right);
        if (!change.allFinite()) return false;
        value += change;
        const double middle = upperMedianInPlace(sizes);
        const double before = scale;
        scale = std::clamp(6 * 1.4826 * middle, 1e-9 * reach_mm, reach_mm);
        // Converged: another iteration would change less than a hundredth of the standard error.
        const double error = scale / 6 / std::sqrt(static_cast<double>(section.size()));
        if (change.norm() < 0.01 * error && std::abs(scale - before) < 0.01 * scale) break;
    }
    const Eigen::Matrix3d covariance = normal.inverse() * (scale * scale / 36);
    centre.place = value.tail<2>();
    centre.scatter = scale / 6;
    centre.variance = (covariance(1, 1) + covariance(2, 2)) / 2;
    return std::isfinite(centre.variance) && centre.variance > 0 && centre.variance < reach_mm * reach_mm;
}

}  // namespace

Bend Bend::sum(const Bend& first, const Bend& rest)
{
    Bend both = first;
    both.bow_mm += rest.bow_mm * (first.half_mm * first.half_mm) / (rest.half_mm * rest.half_mm);
    both.sigma_mm = rest.sigma_mm;
    both.scatter_mm = rest.scatter_mm;
    return both;
}

Bend findBend(const std::vector<Vector3d>& sample, const Eigen::Isometry3d& axis_T_scan, const MeridianBins& bins)
{
    Bend bend;
    // A strong bend spreads the radii of a bin, which therefore has weight 0 in the axis fit; it is used here.
    const auto isSide = [&](int i) {
        const auto b = static_cast<std::size_t>(i);
        return bins.bins[b].active ||
               (bins.bins[b].points >= 4 && bins.face_of[b] < 0 && bins.bins[b].own_mm < 0.1 * bins.largest_mm);
    };
    int from = -1;
    int to = 0;
    for (int i = 0; i < bins.side_count; ++i) {
        if (!isSide(i)) continue;
        if (from < 0) from = i;
        to = i + 1;
    }
    if (to - from < 3) return bend;
    const double start = bins.z_start_mm + from * bins.step_mm;
    const double length = (to - from) * bins.step_mm;
    const double reach = 0.15 * bins.largest_mm;  // a larger bow is rejected as an outlier
    std::vector<std::vector<SectionResidual>> sections(bendSections);
    for (const Vector3d& point : sample) {
        const Vector3d p = axis_T_scan * point;
        const double place = (p.z() - start) / length * static_cast<double>(bendSections);
        const double r = p.head<2>().norm();
        if (!(place >= 0) || place >= static_cast<double>(bendSections) || r == 0) continue;
        const auto side = static_cast<std::size_t>((p.z() - bins.z_start_mm) / bins.step_mm);
        if (side >= static_cast<std::size_t>(bins.side_count)) continue;
        const MeridianBin& bin = bins.bins[side];
        if (!isSide(static_cast<int>(side)) || std::abs(bin.slope) > 0.3)
            continue;  // beside an edge the fitted centre is biased
        const double off = r - bin.value - bin.slope * (p.z() - bin.middle);
        if (std::abs(off) < reach) sections[static_cast<std::size_t>(place)].push_back({p.x() / r, p.y() / r, off});
    }
    std::vector<Centre> centres;
    for (std::size_t k = 0; k < bendSections; ++k) {
        Centre centre{(2 * (static_cast<double>(k) + 0.5) / static_cast<double>(bendSections) - 1), Vector2d::Zero(), 1,
                      0};
        if (centreOf(sections[k], reach, centre)) centres.push_back(centre);
    }
    if (centres.size() < 6 || centres.back().z - centres.front().z < 1) return bend;

    std::vector<double> scatters;
    scatters.reserve(centres.size());
    for (const Centre& centre : centres) scatters.push_back(centre.scatter);
    const double usual = upperMedianInPlace(scatters);
    bend.scatter_mm = usual;

    // Robust over the sections: an eccentric collar is no bend.
    Eigen::Matrix3d normal;
    Eigen::Matrix<double, 3, 2> value = Eigen::Matrix<double, 3, 2>::Zero();
    std::vector<double> weights(centres.size(), 1);
    double scatter = 1;
    for (int round = 0; round < 10; ++round) {
        normal.setZero();
        Eigen::Matrix<double, 3, 2> right = Eigen::Matrix<double, 3, 2>::Zero();
        for (std::size_t k = 0; k < centres.size(); ++k) {
            const Centre& c = centres[k];
            const Vector3d j(1, c.z, c.z * c.z);
            const double w = weights[k] / c.variance;
            normal += w * j * j.transpose();
            right += w * j * c.place.transpose();
        }
        value = normal.ldlt().solve(right);
        if (!value.allFinite()) return bend;
        std::vector<double> sizes;
        for (const Centre& c : centres) {
            const Vector2d off = c.place - value.transpose() * Vector3d(1, c.z, c.z * c.z);
            sizes.push_back(off.norm() / std::sqrt(c.variance));
        }
        std::vector<double> sorted = sizes;
        const double middle = upperMedianInPlace(sorted);
        scatter = std::max(1.0, middle / 1.177);  // the median of a Rayleigh distribution
        for (std::size_t k = 0; k < centres.size(); ++k) {
            const double u = sizes[k] / (6 * scatter);
            weights[k] = u < 1 ? (1 - u * u) * (1 - u * u) : 0;
        }
    }
    const Eigen::Matrix3d covariance = normal.inverse();
    const Vector3d in_frame(value(2, 0), value(2, 1), 0);
    bend.along = axis_T_scan.linear().row(2);
    bend.half_mm = length / 2;
    bend.middle_mm = start + length / 2 - axis_T_scan.translation().z();
    bend.bow_mm = axis_T_scan.linear().transpose() * in_frame;
    bend.sigma_mm = scatter * std::sqrt(std::max(0.0, covariance(2, 2)));
    return bend;
}

}  // namespace lathelier::registration
