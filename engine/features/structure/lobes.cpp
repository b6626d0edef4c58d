#include "engine/features/structure/lobes.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "engine/core/units.h"

namespace lathelier::features {
namespace {

/// Sums over the cells of a stretch by sector.
struct Profile {
    std::vector<double> sum_mm, points;
};

Profile profileOf(const ResidualMap& map, const SurfaceTable& surface, double from_mm, double to_mm)
{
    Profile profile{std::vector<double>(mapSectors, 0), std::vector<double>(mapSectors, 0)};
    const double half = map.cell_mm / 2;
    for (std::size_t row = 0; row < map.rows; ++row) {
        const double z = map.middle_mm(row);
        if (z - half < from_mm || z + half > to_mm || surface.at(z).run < 0) continue;
        for (std::size_t s = 0; s < mapSectors; ++s) {
            const MapCell& cell = map.at(row, s);
            if (cell.far > cell.on) continue;
            profile.sum_mm[s] += static_cast<double>(cell.sum_mm);
            profile.points[s] += static_cast<double>(cell.on);
        }
    }
    return profile;
}

/// Harmonics of a profile by weighted least squares: parameters 0, cos 1, sin 1, cos 2…, and their cofactors.
struct Harmonics {
    Eigen::VectorXd fit;
    Eigen::MatrixXd cofactor;

    double amplitude_mm(Eigen::Index k) const { return std::hypot(fit[2 * k - 1], fit[2 * k]); }
    double cofactorOf(Eigen::Index k) const { return std::max(cofactor(2 * k - 1, 2 * k - 1), cofactor(2 * k, 2 * k)); }
};

double angleOf(std::size_t sector)
{
    return turn_rad * (static_cast<double>(sector) + 0.5) / mapThresholds.sectors;
}

Harmonics harmonicsOf(const Profile& profile)
{
    const Eigen::Index count = 1 + 2 * lobeThresholds.most_lobes;
    Eigen::MatrixXd normal = Eigen::MatrixXd::Zero(count, count);
    Eigen::VectorXd right = Eigen::VectorXd::Zero(count), row(count);
    for (std::size_t s = 0; s < mapSectors; ++s) {
        if (profile.points[s] == 0) continue;
        row[0] = 1;
        for (Eigen::Index k = 1; k <= lobeThresholds.most_lobes; ++k) {
            const double angle = static_cast<double>(k) * angleOf(s);
            row[2 * k - 1] = std::cos(angle);
            row[2 * k] = std::sin(angle);
        }
        normal += profile.points[s] * row * row.transpose();
        right += profile.sum_mm[s] * row;
    }
    Harmonics found;
    found.cofactor = normal.ldlt().solve(Eigen::MatrixXd::Identity(count, count));
    found.fit = found.cofactor * right;
    return found;
}

/// Variance of the profile beyond white noise.
double varianceOf(const Profile& profile, double sigma_mm)
{
    double points = 0, sum = 0, squares = 0, noise = 0;
    for (std::size_t s = 0; s < mapSectors; ++s) {
        const double n = profile.points[s];
        if (n == 0) continue;
        points += n;
        sum += profile.sum_mm[s];
        squares += profile.sum_mm[s] * profile.sum_mm[s] / n;
        noise += sigma_mm * sigma_mm;
    }
    return std::max(0.0, (squares - sum * sum / points - noise) / points);
}

}  // namespace

LobeFit lobesOf(const ResidualMap& map, const SurfaceTable& surface, const Run& run, std::size_t element, double scale,
                double least_share)
{
    LobeFit found;
    const double from = run.nodes_mm[element], to = run.nodes_mm[element + 1];
    if (to - from < lobeThresholds.least_length_mm) return found;
    const Profile profile = profileOf(map, surface, from, to);
    const auto seen = std::count_if(profile.points.begin(), profile.points.end(), [](double n) { return n > 0; });
    if (static_cast<double>(seen) < lobeThresholds.least_cover * mapThresholds.sectors) return found;
    const Harmonics harmonics = harmonicsOf(profile);
    const double least = 2 * least_share * varianceOf(profile, map.sigma_mm);
    for (int k = 1; k <= lobeThresholds.most_lobes; ++k) {
        const double amplitude = harmonics.amplitude_mm(k);
        const double u = scale * map.sigma_mm * std::sqrt(harmonics.cofactorOf(k));
        if (!(amplitude > std::max(lobeThresholds.sigmas * u, 1e-3 * lobeThresholds.least_um)) ||
            amplitude * amplitude < least)
            continue;
        const Eigen::Index place = 2 * Eigen::Index{k};
        const double cosine = harmonics.fit[place - 1], sine = harmonics.fit[place];
        found.curve_mm.resize(mapSectors, 0);
        for (std::size_t s = 0; s < mapSectors; ++s)
            found.curve_mm[s] += cosine * std::cos(k * angleOf(s)) + sine * std::sin(k * angleOf(s));
        if (k == 1) {
            found.lobes.offset_mm = amplitude;
            found.lobes.offset_deg = std::fmod(std::atan2(sine, cosine) * deg_per_rad + 360, 360);
        } else if (2e3 * amplitude > found.lobes.height_um.value_or(0)) {
            found.lobes.lobes = k;
            found.lobes.height_um = 2e3 * amplitude;
        }
    }
    return found;
}

void removeLobes(ResidualMap& map, const SurfaceTable& surface, std::size_t run, std::size_t element,
                 const std::vector<double>& curve_mm)
{
    if (curve_mm.empty()) return;
    for (std::size_t row = 0; row < map.rows; ++row) {
        const SurfaceTable::Place& place = surface.at(map.middle_mm(row));
        if (place.run != static_cast<std::int32_t>(run) || place.element != static_cast<std::int32_t>(element))
            continue;
        for (std::size_t s = 0; s < mapSectors; ++s) {
            MapCell& cell = map.cells[row * mapSectors + s];
            cell.sum_mm -= static_cast<float>(static_cast<double>(cell.on) * curve_mm[s]);
        }
    }
}

}  // namespace lathelier::features
