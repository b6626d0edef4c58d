#include "engine/surface/picture_lines.h"

#include <algorithm>
#include <cmath>

namespace lathelier::surface {
namespace {

/// Power of all bins for which `counts` holds, on one side of zero.
template <class Counts>
double powerWhere(const PowerSpectrum& spectrum, Counts counts)
{
    double sum = 0;
    const int zero = spectrum.zeroColumn();
    for (int y = 0; y < spectrum.power.rows; ++y)
        for (int x = zero; x < spectrum.power.columns; ++x)
            if (counts(spectrum.frequencyOf(x, y))) sum += double(spectrum.power.at(x, y)) * (x == zero ? 0.5 : 1);
    return sum;
}

/// `lines`: the strongest first.
Weight weightOf(const WindowedPicture& picture, const PowerSpectrum& spectrum, const std::vector<Vector>& lines)
{
    constexpr double lineHalfWidth_bins = 1.5, band = 0.2;
    const auto near = [&](Vector f, Vector line) {
        return picture.binsBetween(f, line) <= lineHalfWidth_bins ||
               picture.binsBetween(f, -1.0 * line) <= lineHalfWidth_bins;
    };
    const double radius = length(lines.front());
    const double all = powerWhere(spectrum, [](Vector) { return true; });
    const double around = powerWhere(spectrum, [&](Vector f) { return std::abs(length(f) / radius - 1) <= band; });
    const double strongest = powerWhere(spectrum, [&](Vector f) { return near(f, lines.front()); });
    double family = 0;
    for (std::size_t i = 0; i < lines.size(); ++i)
        family += powerWhere(spectrum, [&](Vector f) { return near(f, lines[i]); });
    return {around > 0 ? std::min(1.0, strongest / around) : 0, all > 0 ? std::min(1.0, family / all) : 0};
}

std::vector<Vector> combLines(const FeedComb& feed)
{
    std::vector<Vector> lines;
    for (int j = 1; std::abs(j * feed.frequency.x) < 0.5 && std::abs(j * feed.frequency.y) < 0.5 && j <= 10; ++j)
        lines.push_back(double(j) * feed.frequency);
    return lines;
}

std::vector<Vector> latticeLines(const ChatterLattice& lattice)
{
    std::vector<Vector> lines;
    for (const LatticeLine& line : lattice.lines) lines.push_back(line.frequency);
    return lines;
}

/// The comb next to 1/f; where there is none there, the best of all.
std::optional<FeedComb> feedOf(const WindowedPicture& picture, const Significance& significance,
                               const std::vector<SpectralPeak>& peaks, const std::vector<SpectralPeak>& further,
                               double threshold, const LineSearch& search)
{
    if (!search.feed_cycles_per_px) return feedComb(picture, peaks, std::nullopt);
    std::vector<SpectralPeak> sure = further;
    std::erase_if(sure, [&](const SpectralPeak& peak) { return peak.significance <= threshold; });
    std::optional<FeedComb> comb = feedComb(picture, peaks, search.feed_cycles_per_px, feedTolerance);
    if (!comb) comb = feedComb(picture, sure, search.feed_cycles_per_px, feedTolerance);
    const bool is_strongest = comb && !sure.empty() && coincide(picture, sure.front().frequency, comb->frequency);
    if (!is_strongest)  // strong chatter: all lines together tell which comb they stand on
        if (const auto found = feedUnderChatter(picture, further, *search.feed_cycles_per_px)) comb = found;
    if (!comb) return feedComb(picture, peaks, std::nullopt);
    comb->significance = significance.at(comb->frequency, NoiseLevel::Medians);
    return comb;
}

}  // namespace

PictureLines findLines(const Grid& flat, const LineSearch& search, const Progress& progress)
{
    PictureLines found;
    found.threshold = significanceThreshold(double(flat.columns) * flat.rows, search.alpha);
    const WindowedPicture picture(flat);
    found.spectrum = powerSpectrum(picture);
    progress.report(0.15);
    const PowerSpectrum turned = powerSpectrum(picture, turnToAxis_deg(ridgeDirection_deg(found.spectrum)));
    progress.report(0.3);
    const Significance significance(turned);
    const std::vector<SpectralPeak> peaks =
        significance.peaks(NoiseLevel::Means, found.threshold, &found.largest_significance, progress);
    progress.report(0.5);
    if (peaks.empty()) return found;
    const std::vector<SpectralPeak> further =
        significance.peaks(NoiseLevel::Medians, supportingSignificance, nullptr, progress);
    progress.report(0.7);
    found.feed = feedOf(picture, significance, peaks, further, found.threshold, search);
    if (!found.feed || search.feed_only) return found;
    found.least_chatter =
        std::max(search.least_chatter * found.feed->amplitude,
                 2 * std::sqrt(found.threshold * significance.typicalLevel(length(found.feed->frequency))) /
                     picture.windowSum());
    found.feed_weight = weightOf(picture, found.spectrum, combLines(*found.feed));
    found.chatter = chatterLattice(picture, significance, *found.feed, further,
                                   {found.threshold, search.least_chatter, search.old_grid});
    if (found.chatter) found.feed->frequency = found.chatter->feed;
    if (found.chatter) found.chatter_weight = weightOf(picture, found.spectrum, latticeLines(*found.chatter));
    progress.report(1);
    return found;
}

}  // namespace lathelier::surface
