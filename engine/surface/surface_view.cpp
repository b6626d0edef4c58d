#include "engine/surface/surface_view.h"

#include <algorithm>
#include <cmath>

#include "engine/surface/picture_lines.h"

namespace lathelier::surface {
namespace {

constexpr double shownFeedLines = 4.5;  // extent of the displayed spectrum, in lines of the comb
constexpr int mostBins = 401;           // width of the displayed spectrum

/// Maximum of the bins represented by one cell of the displayed spectrum.
float largestIn(const Grid& power, int x0, int x1, int y0, int y1)
{
    float largest = 0;
    for (int y = y0; y < std::max(y1, y0 + 1); ++y)
        for (int x = x0; x < std::max(x1, x0 + 1); ++x)
            if (x >= 0 && y >= 0 && x < power.columns && y < power.rows) largest = std::max(largest, power.at(x, y));
    return largest;
}

}  // namespace

void drawSpectrum(SurfaceView& view, const PictureLines& lines)
{
    const PowerSpectrum& spectrum = lines.spectrum;
    if (lines.feed) view.spectrum_edge = std::min(0.5, shownFeedLines * length(lines.feed->frequency));
    const int bins = std::min(
        mostBins, static_cast<int>(2 * view.spectrum_edge * std::max(spectrum.power.columns, spectrum.power.rows)));
    view.spectrum = Grid(std::max(1, bins), std::max(1, bins));
    const std::vector<double> medians = ringMedians(spectrum);
    const auto edge = [&](int cell, int count, int zero) {
        return zero + static_cast<int>(std::floor((2.0 * cell / bins - 1) * view.spectrum_edge * count + 0.5));
    };
    for (int row = 0; row < view.spectrum.rows; ++row)
        for (int column = 0; column < view.spectrum.columns; ++column) {
            const int x0 = edge(column, spectrum.power.columns, spectrum.zeroColumn());
            const int x1 = edge(column + 1, spectrum.power.columns, spectrum.zeroColumn());
            const int y0 = edge(row, spectrum.power.rows, spectrum.zeroRow());
            const int y1 = edge(row + 1, spectrum.power.rows, spectrum.zeroRow());
            const float power = largestIn(spectrum.power, x0, x1, y0, y1);
            const int x = std::clamp(x0, 0, spectrum.power.columns - 1), y = std::clamp(y0, 0, spectrum.power.rows - 1);
            view.spectrum.row(row)[column] =
                static_cast<float>(std::log10(double(power) / medians[ringOf(spectrum, x, y)] + 1e-9));
        }
    if (lines.feed) {
        view.feed = lines.feed->frequency;
        for (int j = 1; j * length(lines.feed->frequency) < view.spectrum_edge; ++j)
            view.lines.push_back({double(j) * lines.feed->frequency, true, j, 0,
                                  j == 1 ? std::optional(lines.feed->significance) : std::nullopt});
    }
    if (!lines.chatter) return;
    for (const LatticeLine& line : lines.chatter->lines)
        view.lines.push_back({line.frequency, false, line.multiple, line.order, line.significance});
    if (!lines.feed) return;
    const Vector comb = lines.feed->frequency, wave = lines.chatter->fundamental;
    view.bands = wave - std::round(dot(wave, comb) / dot(comb, comb)) * comb;
}

}  // namespace lathelier::surface
