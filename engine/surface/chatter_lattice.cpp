#include "engine/surface/chatter_lattice.h"

#include <algorithm>
#include <cmath>

#include "engine/surface/lattice_fit.h"
#include "engine/surface/line_origin.h"

namespace lathelier::surface {
namespace {

constexpr double onFeed_bins = 1.6;                    // lines closer than this to a feed line are part of it
constexpr double supporting = supportingSignificance;  // S of a further line of a seeded lattice
constexpr int mostOrders = 4;                          // feed orders to either side in the search for lattice lines
constexpr int mostMultiples = 3;
constexpr int aliases = 150;  // harmonics of the feed considered as aliases
constexpr double leastShownPeriods = 4;

/// True for a harmonic of the feed marks, or an alias of one, whose amplitude decreases as 1/j.
bool belongsToFeed(const WindowedPicture& picture, const FeedComb& feed, Vector frequency, double amplitude)
{
    for (int j = 0; j <= aliases; ++j)
        for (const double sign : {1.0, -1.0}) {
            const Vector harmonic = (sign * j) * feed.frequency;
            const bool is_folded = std::abs(harmonic.x) > 0.5 || std::abs(harmonic.y) > 0.5;
            if (picture.binsBetween(folded(harmonic), frequency) > onFeed_bins) continue;
            if (!is_folded || amplitude < 3 * feed.amplitude / j) return true;
        }
    return false;
}

/// True for a weak replica of the comb caused by interpolation when the picture was rotated.
bool isImageOfFeed(const WindowedPicture& picture, const FeedComb& feed, Vector frequency, double amplitude,
                   const std::optional<Vector>& old_grid)
{
    constexpr double faint = 0.1;
    constexpr int harmonics = 12, grids = 2;
    if (!old_grid || amplitude > faint * feed.amplitude) return false;
    for (const Vector grid : {*old_grid, turned(*old_grid, 90)})
        for (int a = -grids; a <= grids; ++a)
            for (int j = -harmonics; j <= harmonics; ++j)
                if (a != 0 && coincide(picture, folded(double(a) * grid + double(j) * feed.frequency), frequency))
                    return true;
    return false;
}

bool isShown(const WindowedPicture& picture, Vector frequency)
{
    return std::abs(frequency.x) < 0.48 && std::abs(frequency.y) < 0.48 &&
           picture.binsBetween(frequency, {}) >= leastShownPeriods;
}

/// Lines of a lattice that exceed `supporting` and lie within a bin of their expected position. Of two unresolved
/// lines, the one of the lower multiple.
std::vector<LatticeLine> linesOf(const WindowedPicture& picture, const Significance& significance, const FeedComb& feed,
                                 Vector fundamental, int multiples)
{
    std::vector<LatticeLine> lines;
    for (int l = 1; l <= multiples; ++l)
        for (int j = -mostOrders; j <= mostOrders; ++j) {
            const Vector expected = double(l) * fundamental + double(j) * feed.frequency;
            if (!isShown(picture, expected)) continue;
            const double s = significance.at(expected, NoiseLevel::Medians);
            if (s < supporting) continue;
            LatticeLine line{l, j, picture.refined(expected), s, 0};
            if (picture.binsBetween(line.frequency, expected) > 1.0) continue;
            line.amplitude = picture.amplitudeAt(line.frequency);
            if (belongsToFeed(picture, feed, line.frequency, line.amplitude)) continue;
            const bool known = std::any_of(lines.begin(), lines.end(), [&](const LatticeLine& other) {
                return coincide(picture, other.frequency, line.frequency);
            });
            if (!known) lines.push_back(line);
        }
    std::stable_sort(lines.begin(), lines.end(),
                     [](const LatticeLine& a, const LatticeLine& b) { return a.amplitude > b.amplitude; });
    return lines;
}

/// True if the line belongs to the lattice with the seed as fundamental.
bool isExplained(const WindowedPicture& picture, const FeedComb& feed, Vector seed, Vector line)
{
    constexpr int explained = 5, orders = 12;
    for (int l = 1; l <= explained; ++l)
        for (int j = -orders; j <= orders; ++j)
            if (coincide(picture, double(l) * seed + double(j) * feed.frequency, line)) return true;
    return false;
}

/// True if a smaller fundamental has two further lines, not much weaker than the seed, that are not explained by the
/// seed.
bool hasLinesOfItsOwn(const WindowedPicture& picture, const Significance& significance, const FeedComb& feed,
                      Vector seed, Vector fundamental)
{
    constexpr double least = 0.1;
    const double seed_amplitude = picture.amplitudeAt(seed);
    int count = 0;
    for (const LatticeLine& line : linesOf(picture, significance, feed, fundamental, 1))
        if (line.amplitude > least * seed_amplitude && !isExplained(picture, feed, seed, line.frequency)) ++count;
    return count >= 2;
}

/// Weighted least squares of all lines: the variance of the frequency of a line is inversely proportional to its
/// significance.
Vector fitted(const std::vector<LatticeLine>& lines, const FeedComb& feed)
{
    Vector sum{};
    double weights = 0;
    for (const LatticeLine& line : lines) {
        sum = sum + (line.significance * line.multiple) * (line.frequency - double(line.order) * feed.frequency);
        weights += line.significance * line.multiple * line.multiple;
    }
    return (1 / weights) * sum;
}

}  // namespace

std::optional<ChatterLattice> chatterLattice(const WindowedPicture& picture, const Significance& significance,
                                             const FeedComb& feed, const std::vector<SpectralPeak>& peaks,
                                             const LatticeSearch& search)
{
    std::optional<Vector> seed;
    double seed_significance = 0;
    for (const SpectralPeak& peak : peaks) {  // largest first
        if (peak.significance <= search.threshold) continue;
        const Vector frequency = picture.refined(peak.frequency);
        const double amplitude = picture.amplitudeAt(frequency);
        if (amplitude < search.least_amplitude * feed.amplitude) break;
        if (belongsToFeed(picture, feed, frequency, amplitude)) continue;
        if (isImageOfFeed(picture, feed, frequency, amplitude, search.old_grid)) continue;
        if (isOfLight(picture, feed.frequency, frequency) || isShorterThanFeed(feed.frequency, frequency)) continue;
        seed = frequency;
        seed_significance = peak.significance;
        break;
    }
    if (!seed) return std::nullopt;

    Vector best = *seed;
    for (int l = mostMultiples; l >= 2; --l) {
        bool found = false;
        for (int j = 0; j < l && !found; ++j) {
            const Vector candidate = (1.0 / l) * (*seed + double(j) * feed.frequency);
            if (hasLinesOfItsOwn(picture, significance, feed, *seed, candidate)) best = candidate, found = true;
        }
        if (found) break;
    }
    ChatterLattice lattice;
    lattice.lines = linesOf(picture, significance, feed, best, mostMultiples);
    if (lattice.lines.empty())
        lattice.lines.push_back({1, 0, *seed, seed_significance, picture.amplitudeAt(*seed)}), best = *seed;
    lattice.fundamental = fitted(lattice.lines, feed);
    lattice.feed = feed.frequency;
    if (const auto together = fittedLattice(picture, feed.frequency, lattice.fundamental, 10, &significance)) {
        lattice.fundamental = together->chatter;
        lattice.feed = together->feed;
    }
    if (isOfLight(picture, lattice.feed, lattice.fundamental))
        return std::nullopt;  // its comb may have been a sideband
    lattice.significance = lattice.lines.front().significance;
    lattice.amplitude = lattice.lines.front().amplitude;
    return lattice;
}

}  // namespace lathelier::surface
