#include "engine/surface/feed_marks.h"

#include <algorithm>
#include <cmath>

namespace lathelier::surface {
namespace {

constexpr int combLines = 5;
constexpr std::size_t mostCandidates = 12;

}  // namespace

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
        if (++tried > mostCandidates) break;
        const Vector frequency = picture.refined(peak.frequency);
        if (expected && std::abs(length(frequency) / *expected - 1) > tolerance) continue;
        FeedComb comb{frequency, peak.significance, picture.amplitudeAt(frequency), 0};
        comb.comb = comb.amplitude;
        for (int j = 2; j <= combLines; ++j) {
            const Vector line = double(j) * frequency;
            if (std::abs(line.x) >= 0.5 || std::abs(line.y) >= 0.5) break;
            comb.comb += picture.amplitudeAt(line);
        }
        if (!best || comb.comb > best->comb) best = comb;
    }
    return best;
}

}  // namespace lathelier::surface
