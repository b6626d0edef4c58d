#include "engine/registration/revolution/meridian_share.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/registration/revolution/meridian_bins.h"
#include "engine/registration/revolution/quick_turn.h"

namespace lathelier::registration {
namespace {

/// Which points lie on the meridian, and what a rough zone is (README, "Thresholds").
struct MeridianShareThresholds {
    double on_bin_sigmas = 6;          ///< within that of a bin a point lies on it
    double widest_share = 0.02;        ///< of the radius: no bin is taken as wider,
    double widest_noises = 3;          ///< unless the noise between neighbours is
    int rough_run_bins = 5;            ///< least length of a rough zone
    double rough_bin_points = 4;       ///< least number of points of one of its bins
    double rough_scatter_share = 0.1;  ///< of the radius: largest scatter of one of its bins
    double rough_reach_sigmas = 4;     ///< of the bin's own scatter: points further away are spurious
    double rough_sector_points = 10;   ///< of a zone in each sector, on average
    double least_sector_points = 5;    ///< for the mean of a sector
    double sector_sigmas = 3;          ///< standard errors of that mean, which noise may explain
    double roundness_share = 0.4;      ///< of the zone's scatter: a mean radius that varies by more is not round
};
constexpr MeridianShareThresholds shareThresholds{};

constexpr std::size_t roughnessSectors = 16;

struct SamplePlace {
    double z, r;
    std::size_t sector;  ///< of roughnessSectors
};

double widestOf(const MeridianBins& bins, double noise_mm)
{
    return std::max(shareThresholds.widest_share * bins.largest_mm, shareThresholds.widest_noises * noise_mm);
}

bool isOnBin(const MeridianBins& bins, int key, double z, double r, double widest)
{
    const MeridianBin& bin = bins.bins[static_cast<std::size_t>(key)];
    const bool side = key < bins.wall_count;
    const double error = bin.cosine * ((side ? r : z) - bin.value - bin.slope * ((side ? z : r) - bin.middle));
    return std::abs(error) < std::min(shareThresholds.on_bin_sigmas * bin.sigma, widest);
}

/// Runs of side bins that may be a rough zone: bins that do not count, though their radii are known.
struct RoughRuns {
    std::vector<int> run_of;   ///< of each side bin; -1: none
    std::vector<int> lengths;  ///< of each run, in bins
};

RoughRuns roughRunsOf(const MeridianBins& bins)
{
    RoughRuns runs;
    runs.run_of.assign(static_cast<std::size_t>(bins.side_count), -1);
    for (std::size_t b = 0; b < runs.run_of.size(); ++b) {
        const MeridianBin& bin = bins.bins[b];
        if (bin.active || bin.points < shareThresholds.rough_bin_points ||
            bin.own_mm > shareThresholds.rough_scatter_share * bins.largest_mm)
            continue;
        if (b == 0 || runs.run_of[b - 1] < 0) runs.lengths.push_back(0);
        runs.run_of[b] = static_cast<int>(runs.lengths.size()) - 1;
        ++runs.lengths.back();
    }
    return runs;
}

/// Sums of the radii of one run about the values of its bins.
struct RunSums {
    struct Sector {
        double n = 0, sum = 0;
    };
    std::array<Sector, roughnessSectors> sectors;
    double squares = 0;
    double count = 0;

    /// The mean radius varies from sector to sector by less than the scatter.
    bool isRound() const
    {
        double mean = 0;
        for (const Sector& s : sectors) mean += s.sum / count;
        const double scatter = std::sqrt(squares / count);
        double worst = 0;
        for (const Sector& s : sectors)
            if (s.n >= shareThresholds.least_sector_points)
                worst = std::max(
                    worst, std::abs(s.sum / s.n - mean) - shareThresholds.sector_sigmas * scatter / std::sqrt(s.n));
        return worst < shareThresholds.roundness_share * scatter;
    }
};

std::vector<bool> roughOf(const std::vector<SamplePlace>& places, const MeridianBins& bins)
{
    const RoughRuns runs = roughRunsOf(bins);
    std::vector<RunSums> sums(runs.lengths.size());
    for (const SamplePlace& p : places) {
        const double place = (p.z - bins.z_start_mm) / bins.step_mm;
        if (!(place >= 0) || place >= bins.side_count) continue;
        const auto b = static_cast<std::size_t>(place);
        if (runs.run_of[b] < 0) continue;
        const double off = p.r - bins.bins[b].value;
        if (std::abs(off) > shareThresholds.rough_reach_sigmas * bins.bins[b].own_mm) continue;
        RunSums& own = sums[static_cast<std::size_t>(runs.run_of[b])];
        own.sectors[p.sector].n += 1;
        own.sectors[p.sector].sum += off;
        own.squares += off * off;
        own.count += 1;
    }
    constexpr double leastPoints = shareThresholds.rough_sector_points * roughnessSectors;
    std::vector<bool> round;
    for (std::size_t run = 0; run < sums.size(); ++run)
        round.push_back(runs.lengths[run] >= shareThresholds.rough_run_bins && sums[run].count >= leastPoints &&
                        sums[run].isRound());
    std::vector<bool> rough;
    for (const int run : runs.run_of) rough.push_back(run >= 0 && round[static_cast<std::size_t>(run)]);
    return rough;
}

std::vector<SamplePlace> samplePlaces(const std::vector<Eigen::Vector3d>& sample, const Eigen::Isometry3d& axis_T_scan)
{
    std::vector<SamplePlace> places;
    places.reserve(sample.size());
    for (const Eigen::Vector3d& point : sample) {
        const Eigen::Vector3d p = axis_T_scan * point;
        places.push_back({p.z(), p.head<2>().norm(), sectorAbout(p.y(), p.x(), roughnessSectors)});
    }
    return places;
}

/// For each side bin the smaller and the larger radius of the nearest bins on either side that count, itself included:
/// a point between them lies on a shoulder.
struct Surrounding {
    std::vector<double> low_mm, high_mm;
};

Surrounding surroundingOf(const MeridianBins& bins)
{
    const auto sides = static_cast<std::size_t>(bins.side_count);
    Surrounding around{std::vector<double>(sides, 0), std::vector<double>(sides, 0)};
    double before = 0;
    for (std::size_t b = 0; b < sides; ++b) {
        if (bins.bins[b].active) before = bins.bins[b].value;
        around.low_mm[b] = around.high_mm[b] = before;
    }
    double after = 0;
    for (std::size_t b = sides; b-- > 0;) {
        if (bins.bins[b].active) after = bins.bins[b].value;
        around.low_mm[b] = std::min(around.low_mm[b], after);
        around.high_mm[b] = std::max(around.high_mm[b], after);
    }
    return around;
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
    const Surrounding around = surroundingOf(bins);
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
        const double reach = std::min(shareThresholds.on_bin_sigmas * bins.sigma_mm, widest);
        // A supposed face may be a thread.
        const bool on_shoulder = key < 0 && p.r > around.low_mm[b] - reach && p.r < around.high_mm[b] + reach;
        const double rough_reach = shareThresholds.rough_reach_sigmas * bins.bins[b].own_mm;
        if (on_shoulder || (rough[b] && std::abs(p.r - bins.bins[b].value) < rough_reach)) ++good;
    }
    return static_cast<double>(good) / static_cast<double>(sample.size());
}

}  // namespace lathelier::registration
