#include "engine/surface/feed_marks.h"

#include <algorithm>
#include <cmath>

#include "engine/surface/lattice_fit.h"

namespace lathelier::surface {
namespace {

constexpr int combHarmonics = 5;
constexpr std::size_t mostTriedCombs = 12;

constexpr double merged_bins = 1.6;  // lines closer than this are not resolved by the window
constexpr std::size_t pairedPeaks = 12;
constexpr std::size_t mostFits = 6;

/// Distinct differences of strong lines, and lines, with length near `expected`, sorted by the number of pairs.
std::vector<Vector> distances(const WindowedPicture& picture, const std::vector<SpectralPeak>& peaks, double expected)
{
    struct Distance {
        Vector frequency;
        double weight;
    };
    std::vector<Distance> found;
    const auto add = [&](Vector frequency, double weight) {
        const double bin = 1.0 / std::min(picture.columns(), picture.rows());
        if (std::abs(length(frequency) - expected) > feedTolerance * expected + 0.5 * bin) return;
        for (Distance& other : found)
            if (coincide(picture, other.frequency, frequency)) {
                other.weight += weight;
                return;
            }
        found.push_back({frequency, weight});
    };
    const std::size_t count = std::min(peaks.size(), pairedPeaks);
    for (std::size_t i = 0; i < count; ++i)
        for (std::size_t k = 0; k < i; ++k) {
            const double weight = std::sqrt(std::min(peaks[i].power, peaks[k].power));
            add(peaks[i].frequency - peaks[k].frequency, weight);
            add(peaks[i].frequency + peaks[k].frequency, weight);
        }
    for (const SpectralPeak& peak : peaks) add(peak.frequency, std::sqrt(peak.power));
    std::stable_sort(found.begin(), found.end(),
                     [](const Distance& a, const Distance& b) { return a.weight > b.weight; });
    std::vector<Vector> result;
    for (std::size_t i = 0; i < std::min(found.size(), mostFits); ++i) result.push_back(found[i].frequency);
    return result;
}

/// A line with its harmonics.
FeedComb combOf(const WindowedPicture& picture, Vector frequency, double significance)
{
    FeedComb comb{frequency, significance, picture.amplitudeAt(frequency), 0};
    comb.comb = comb.amplitude;
    for (int j = 2; j <= combHarmonics; ++j) {
        const Vector line = double(j) * frequency;
        if (std::abs(line.x) >= 0.5 || std::abs(line.y) >= 0.5) break;
        comb.comb += picture.amplitudeAt(line);
    }
    return comb;
}

/// The strongest line outside the comb.
const SpectralPeak* strongestOutsideComb(const WindowedPicture& picture, const std::vector<SpectralPeak>& peaks,
                                         Vector comb)
{
    for (const SpectralPeak& peak : peaks) {
        const double order = dot(peak.frequency, comb) / dot(comb, comb);
        if (!coincide(picture, peak.frequency, std::round(order) * comb)) return &peak;
    }
    return nullptr;
}

}  // namespace

bool coincide(const WindowedPicture& picture, Vector a, Vector b)
{
    return picture.binsBetween(a, b) <= merged_bins || picture.binsBetween(a, -1.0 * b) <= merged_bins;
}

std::optional<FeedComb> feedUnderChatter(const WindowedPicture& picture, const std::vector<SpectralPeak>& peaks,
                                         double expected)
{
    std::optional<LatticeVectors> best;
    for (const Vector& distance : distances(picture, peaks, expected)) {
        const SpectralPeak* seed = strongestOutsideComb(picture, peaks, distance);
        if (!seed) continue;
        const auto fit = fittedLattice(picture, distance, picture.refined(seed->frequency), 4);
        if (!fit || std::abs(length(fit->feed) / expected - 1) > feedTolerance) continue;
        if (!best || fit->explained > best->explained) best = fit;
    }
    if (!best) return std::nullopt;
    FeedComb comb{best->feed, 0, picture.amplitudeAt(best->feed), 0};
    comb.comb = comb.amplitude;
    return comb;
}

Vector folded(Vector frequency)
{
    return {frequency.x - std::round(frequency.x), frequency.y - std::round(frequency.y)};
}

std::optional<FeedComb> feedComb(const WindowedPicture& picture, const std::vector<SpectralPeak>& peaks,
                                 std::optional<double> expected, double tolerance)
{
    std::optional<FeedComb> best;
    std::size_t tried = 0;
    for (const SpectralPeak& peak : peaks) {  // largest first
        const double radius = length(peak.frequency);
        if (expected && std::abs(radius / *expected - 1) > tolerance + 0.5 / picture.columns() / *expected) continue;
        if (++tried > mostTriedCombs) break;
        const Vector frequency = picture.refined(peak.frequency);
        if (expected && std::abs(length(frequency) / *expected - 1) > tolerance) continue;
        const FeedComb comb = combOf(picture, frequency, peak.significance);
        if (!best || comb.comb > best->comb) best = comb;
    }
    return best;
}

std::optional<FeedComb> feedCombAlong(const WindowedPicture& picture, const std::vector<SpectralPeak>& peaks,
                                      double direction_deg)
{
    constexpr double usual_deg = 0.5;  // typical error of a stated direction
    std::optional<FeedComb> best;
    double best_score = 0;
    std::size_t tried = 0;
    for (const SpectralPeak& peak : peaks) {  // largest first
        const double off_deg = angleModulo180(angle_deg(peak.frequency) - direction_deg);
        if (std::abs(off_deg) > directionTolerance_deg) continue;
        if (++tried > mostTriedCombs) break;
        const FeedComb comb = combOf(picture, picture.refined(peak.frequency), peak.significance);
        const double off = angleModulo180(angle_deg(comb.frequency) - direction_deg) / usual_deg;
        const double score = comb.comb * std::exp(-0.5 * off * off);
        if (!best || score > best_score) best = comb, best_score = score;
    }
    return best;
}

}  // namespace lathelier::surface
