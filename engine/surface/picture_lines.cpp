#include "engine/surface/picture_lines.h"

#include <algorithm>
#include <cmath>

#include "engine/surface/line_origin.h"

namespace lathelier::surface {
namespace {

constexpr double lineHalfWidth_bins = 1.5;

/// Power of the bins about a frequency.
double powerAbout(const PowerSpectrum& spectrum, Vector line)
{
    const double x = line.x * spectrum.power.columns + spectrum.zeroColumn();
    const double y = line.y * spectrum.power.rows + spectrum.zeroRow();
    double sum = 0;
    for (int row = static_cast<int>(std::ceil(y - lineHalfWidth_bins)); row <= y + lineHalfWidth_bins; ++row)
        for (int column = static_cast<int>(std::ceil(x - lineHalfWidth_bins)); column <= x + lineHalfWidth_bins;
             ++column)
            if (row >= 0 && column >= 0 && row < spectrum.power.rows && column < spectrum.power.columns &&
                std::hypot(column - x, row - y) <= lineHalfWidth_bins)
                sum += double(spectrum.power.at(column, row));
    return sum;
}

/// Power on one side of zero between two radii, in cycles per pixel. Precondition: the spectrum is not rotated.
double powerBetween(const PowerSpectrum& spectrum, double inner, double outer)
{
    double sum = 0;
    for (int y = 0; y < spectrum.power.rows; ++y) {
        const double fy = double(y - spectrum.zeroRow()) / spectrum.power.rows;
        for (int x = 0; x < spectrum.power.columns; ++x) {
            const double fx = double(x - spectrum.zeroColumn()) / spectrum.power.columns;
            const double square = fx * fx + fy * fy;
            if (square >= inner * inner && square <= outer * outer) sum += double(spectrum.power.at(x, y));
        }
    }
    return 0.5 * sum;
}

/// `lines`: the strongest first.
Weight weightOf(const PowerSpectrum& spectrum, const std::vector<Vector>& lines)
{
    constexpr double band = 0.2;
    const double radius = length(lines.front());
    const double all = powerBetween(spectrum, 0, 1);
    const double around = powerBetween(spectrum, (1 - band) * radius, (1 + band) * radius);
    double family = 0;
    for (const Vector& line : lines) family += powerAbout(spectrum, line);
    return {around > 0 ? std::min(1.0, powerAbout(spectrum, lines.front()) / around) : 0,
            all > 0 ? std::min(1.0, family / all) : 0};
}

std::vector<Vector> linesOfComb(const FeedComb& feed)
{
    std::vector<Vector> lines;
    for (int j = 1; std::abs(j * feed.frequency.x) < 0.5 && std::abs(j * feed.frequency.y) < 0.5 && j <= 10; ++j)
        lines.push_back(double(j) * feed.frequency);
    return lines;
}

std::vector<Vector> linesOfLattice(const ChatterLattice& lattice)
{
    std::vector<Vector> lines;
    for (const LatticeLine& line : lattice.lines) lines.push_back(line.frequency);
    return lines;
}

/// The comb nearest to 1/f; if none is near, the best of all.
std::optional<FeedComb> feedOf(const WindowedPicture& picture, const Significance& significance,
                               const std::vector<SpectralPeak>& peaks, const std::vector<SpectralPeak>& further,
                               double threshold, const LineSearch& search)
{
    std::vector<SpectralPeak> significant = further;
    std::erase_if(significant, [&](const SpectralPeak& peak) { return peak.significance <= threshold; });
    if (!search.feed_cycles_per_px) {
        if (search.direction_deg)
            if (const auto comb = feedCombAlong(picture, significant, *search.direction_deg)) return comb;
        return feedComb(picture, peaks, std::nullopt);
    }
    std::optional<FeedComb> comb = feedComb(picture, peaks, search.feed_cycles_per_px, feedTolerance);
    if (!comb) comb = feedComb(picture, significant, search.feed_cycles_per_px, feedTolerance);
    std::vector<SpectralPeak> marks = further;
    if (comb) {  // a highlight may be stronger than the feed, and is no chatter
        const auto isLight = [&](const SpectralPeak& peak) {
            return !coincide(picture, peak.frequency, comb->frequency) &&
                   isOfLight(picture, comb->frequency, peak.frequency);
        };
        std::erase_if(significant, isLight);
        std::erase_if(marks, isLight);
    }
    const auto isWeaker = [&](const SpectralPeak& peak) {
        return picture.amplitudeAt(peak.frequency) <= comb->amplitude;
    };
    const bool is_strongest = comb && !significant.empty() &&
                              (coincide(picture, significant.front().frequency, comb->frequency) ||
                               std::all_of(significant.begin(), significant.end(), isWeaker));
    if (!is_strongest && !(comb && search.feed_only))  // under strong chatter the comb follows from all lines together
        if (const auto found = feedUnderChatter(picture, marks, *search.feed_cycles_per_px)) comb = found;
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
    found.feed_weight = weightOf(found.spectrum, linesOfComb(*found.feed));
    found.chatter = chatterLattice(picture, significance, *found.feed, further,
                                   {found.threshold, search.least_chatter, search.old_grid});
    if (found.chatter && isSecondFeed(flat, found.feed->frequency, found.chatter->lines.front().frequency)) {
        const LatticeLine& line = found.chatter->lines.front();
        found.second_feed = FeedComb{line.frequency, line.significance, line.amplitude, 0};
    }
    if (found.chatter && !found.second_feed) found.feed->frequency = found.chatter->feed;
    if (found.chatter) found.chatter_weight = weightOf(found.spectrum, linesOfLattice(*found.chatter));
    progress.report(1);
    return found;
}

}  // namespace lathelier::surface
