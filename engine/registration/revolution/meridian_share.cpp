#include "engine/registration/revolution/meridian_share.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/registration/revolution/meridian_bins.h"
#include "engine/registration/revolution/quick_turn.h"

namespace lathelier::registration {
namespace {

struct SamplePlace {
    double z, r;
    int sector;  ///< of 16
};

constexpr std::size_t roughnessSectors = 16;

double widestOf(const MeridianBins& bins, double noise_mm)
{
    return std::max(0.02 * bins.largest_mm, 3 * noise_mm);
}

bool isOnBin(const MeridianBins& bins, int key, double z, double r, double widest)
{
    const MeridianBin& bin = bins.bins[static_cast<std::size_t>(key)];
    const bool side = key < bins.wall_count;
    const double error = bin.cosine * ((side ? r : z) - bin.value - bin.slope * ((side ? z : r) - bin.middle));
    return std::abs(error) < std::min(6 * bin.sigma, widest);
}

std::vector<bool> roughOf(const std::vector<SamplePlace>& places, const MeridianBins& bins)
{
    constexpr int leastRun_bins = 5;
    const auto sides = static_cast<std::size_t>(bins.side_count);
    std::vector<int> run_of(sides, -1);
    std::vector<int> lengths;
    for (std::size_t b = 0; b < sides; ++b) {
        const MeridianBin& bin = bins.bins[b];
        if (bin.active || bin.points < 4 || bin.own_mm > 0.1 * bins.largest_mm) continue;
        if (b == 0 || run_of[b - 1] < 0) lengths.push_back(0);
        run_of[b] = static_cast<int>(lengths.size()) - 1;
        ++lengths.back();
    }
    struct Sector {
        double n = 0, sum = 0;
    };
    std::vector<std::array<Sector, roughnessSectors>> sums(lengths.size());
    std::vector<double> squares(lengths.size(), 0), counts(lengths.size(), 0);
    for (const SamplePlace& p : places) {
        const double place = (p.z - bins.z_start_mm) / bins.step_mm;
        if (!(place >= 0) || place >= bins.side_count) continue;
        const auto b = static_cast<std::size_t>(place);
        if (run_of[b] < 0) continue;
        const double reach = 4 * bins.bins[b].own_mm;
        const double off = p.r - bins.bins[b].value;
        if (std::abs(off) > reach) continue;
        const auto run = static_cast<std::size_t>(run_of[b]);
        Sector& sector = sums[run][static_cast<std::size_t>(p.sector)];
        sector.n += 1;
        sector.sum += off;
        squares[run] += off * off;
        counts[run] += 1;
    }
    std::vector<bool> round(lengths.size(), false);
    for (std::size_t run = 0; run < lengths.size(); ++run) {
        if (lengths[run] < leastRun_bins || counts[run] < 10 * roughnessSectors) continue;
        double mean = 0;
        for (const Sector& s : sums[run]) mean += s.sum / counts[run];
        const double scatter = std::sqrt(squares[run] / counts[run]);
        double worst = 0;
        for (const Sector& s : sums[run])
            if (s.n >= 5) worst = std::max(worst, std::abs(s.sum / s.n - mean) - 3 * scatter / std::sqrt(s.n));
        round[run] = worst < 0.4 * scatter;
    }
    std::vector<bool> rough(sides, false);
    for (std::size_t b = 0; b < sides; ++b) rough[b] = run_of[b] >= 0 && round[static_cast<std::size_t>(run_of[b])];
    return rough;
}

std::vector<SamplePlace> samplePlaces(const std::vector<Eigen::Vector3d>& sample, const Eigen::Isometry3d& axis_T_scan)
{
    std::vector<SamplePlace> places;
    places.reserve(sample.size());
    for (const Eigen::Vector3d& point : sample) {
        const Eigen::Vector3d p = axis_T_scan * point;
        const double turn = quickTurn(p.y(), p.x()) + 0.5;
        places.push_back({p.z(), p.head<2>().norm(), std::min(15, static_cast<int>(turn * roughnessSectors))});
    }
    return places;
}

}  // namespace

std::vector<bool> roughBins(const std::vector<Eigen::Vector3d>& sample, const Eigen::Isometry3d& axis_T_scan,
                            const MeridianBins& bins)
{
    return roughOf(samplePlaces(sample, axis_T_scan), bins);
}

double shareOnBins(const std::vector<Eigen::Vector3d>& sample, const Eigen::Isometry3d& axis_T_scan,
                   const MeridianBins& bins, double noise_mm)
{
    const double widest = widestOf(bins, noise_mm);
    std::size_t good = 0;
    for (const Eigen::Vector3d& point : sample) {
        const Eigen::Vector3d p = axis_T_scan * point;
        const double r = p.head<2>().norm();
        const int key = bins.find(p.z(), r);
        if (key >= 0 && isOnBin(bins, key, p.z(), r, widest)) ++good;
    }
    return static_cast<double>(good) / static_cast<double>(sample.size());
}

double consistentShare(const std::vector<Eigen::Vector3d>& sample, const Eigen::Isometry3d& axis_T_scan,
                       const MeridianBins& bins, double noise_mm)
{
    const double widest = widestOf(bins, noise_mm);
    // Radii on either side of bins without one: a point between them lies on the shoulder.
    const auto sides = static_cast<std::size_t>(bins.side_count);
    std::vector<double> low(sides, 0), high(sides, 0);
    double before = 0;
    for (std::size_t b = 0; b < sides; ++b) {
        if (bins.bins[b].active) before = bins.bins[b].value;
        low[b] = high[b] = before;
    }
    double after = 0;
    for (std::size_t b = sides; b-- > 0;) {
        if (bins.bins[b].active) after = bins.bins[b].value;
        low[b] = std::min(low[b], after);
        high[b] = std::max(high[b], after);
    }
    const std::vector<SamplePlace> places = samplePlaces(sample, axis_T_scan);
    const std::vector<bool> rough = roughOf(places, bins);
    std::size_t good = 0;
    for (const SamplePlace& p : places) {
        const int key = bins.find(p.z, p.r);
        if (key >= 0 && isOnBin(bins, key, p.z, p.r, widest)) {
            ++good;
            continue;
        }
        if (key >= 0 && key < bins.wall_count) continue;
        const double place = (p.z - bins.z_start_mm) / bins.step_mm;
        if (place < 0 || place >= bins.side_count) continue;
        const auto b = static_cast<std::size_t>(place);
        if (bins.bins[b].active || bins.bins[b].points <= 0) continue;
        const double reach = std::min(6 * bins.sigma_mm, widest);
        // A supposed face may be a thread.
        const bool on_shoulder = key < 0 && p.r > low[b] - reach && p.r < high[b] + reach;
        if (on_shoulder || (rough[b] && std::abs(p.r - bins.bins[b].value) < 4 * bins.bins[b].own_mm)) ++good;
    }
    return static_cast<double>(good) / static_cast<double>(sample.size());
}

}  // namespace lathelier::registration
