#include "engine/surface/significance.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/core/parallel.h"

namespace lathelier::surface {
namespace {

constexpr double eulerGamma = 0.5772156649015329;
constexpr double leastPeriods = 4;  // smallest number of periods across the picture
constexpr int hole = 2;             // half width of a line under a Hann window, excluded from the noise level around it
constexpr int ringSide = 31, longRun = 81, shortRun = 25, medianRun = 61;

}  // namespace

double significanceThreshold(double pixels, double alpha)
{
    return std::log(0.5 * pixels / alpha);
}

Significance::Significance(const PowerSpectrum& spectrum)
    : spectrum_(spectrum),
      logPower_(spectrum.power.columns, spectrum.power.rows),
      logRingAt_(spectrum.power.columns, spectrum.power.rows)
{
    for (const double median : ringMedians(spectrum)) logRing_.push_back(std::log(median));
    for (int y = 0; y < spectrum.power.rows; ++y)
        for (int x = 0; x < spectrum.power.columns; ++x) {
            logPower_.row(y)[x] = std::log(spectrum.power.at(x, y) + 1e-30F);
            logRingAt_.row(y)[x] = static_cast<float>(logRing_[ringOf(spectrum, x, y)]);
        }
}

/// Periodic continuation of the spectrum beyond its edges.
int Significance::foldedColumn(int column) const
{
    const int n = spectrum_.power.columns;
    return column < 0 ? column + n : column >= n ? column - n : column;
}

int Significance::foldedRow(int row) const
{
    const int n = spectrum_.power.rows;
    return row < 0 ? row + n : row >= n ? row - n : row;
}

double Significance::logMean(int column, int row, int across, int down, int hole_bins, bool whitened) const
{
    double sum = 0;
    int count = 0;
    for (int dy = -down / 2; dy <= down / 2; ++dy) {
        const int y = foldedRow(row + dy);
        const float* powers = logPower_.row(y);
        const float* rings = logRingAt_.row(y);
        for (int dx = -across / 2; dx <= across / 2; ++dx) {
            if (std::abs(dx) <= hole_bins && std::abs(dy) <= hole_bins) continue;
            const int x = foldedColumn(column + dx);
            sum += double(powers[x]) - (whitened ? double(rings[x]) : 0);
            ++count;
        }
    }
    return sum / count + eulerGamma + (whitened ? double(logRingAt_.at(column, row)) : 0);
}

double Significance::median(int column, int row, int across, int down) const
{
    std::array<float, medianRun> values{};
    std::size_t count = 0;
    for (int dy = -down / 2; dy <= down / 2; ++dy)
        for (int dx = -across / 2; dx <= across / 2; ++dx)
            if (std::abs(dx) > hole || std::abs(dy) > hole)
                values[count++] = logPower_.at(foldedColumn(column + dx), foldedRow(row + dy));
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(count / 2);
    std::nth_element(values.begin(), middle, values.begin() + static_cast<std::ptrdiff_t>(count));
    return double(*middle) - std::log(std::log(2.0));
}

double Significance::meansLevel(int column, int row, double give_up) const
{
    double level = -1e300;
    const auto raise = [&](double candidate) {
        level = std::max(level, candidate);
        return level > give_up;
    };
    for (const int run : {shortRun, longRun})
        for (const bool whitened : {false, true})
            if (raise(logMean(column, row, run, 1, hole, whitened)) ||
                raise(logMean(column, row, 1, run, hole, whitened)))
                return level;
    raise(logMean(column, row, ringSide, ringSide, hole, true));
    return level;
}

double Significance::mediansLevel(int column, int row, double give_up) const
{
    double level = -1e300;
    for (const int run : {shortRun, medianRun})  // the short ones first, which cost less
        for (const bool is_row : {true, false}) {
            level = std::max(level, is_row ? median(column, row, run, 1) : median(column, row, 1, run));
            if (level > give_up) return level;
        }
    return level;
}

double Significance::levelAt(int column, int row, NoiseLevel level) const
{
    return std::exp(level == NoiseLevel::Means ? meansLevel(column, row, 1e300) : mediansLevel(column, row, 1e300));
}

/// False: outside the spectrum.
bool Significance::binOf(Vector frequency, int& column, int& row) const
{
    const Vector there = turned(frequency, spectrum_.turn_deg);
    column = static_cast<int>(std::lround(there.x * spectrum_.power.columns)) + spectrum_.zeroColumn();
    row = static_cast<int>(std::lround(there.y * spectrum_.power.rows)) + spectrum_.zeroRow();
    return column >= 0 && row >= 0 && column < spectrum_.power.columns && row < spectrum_.power.rows;
}

double Significance::levelAt(Vector frequency, NoiseLevel level) const
{
    int column = 0, row = 0;
    return binOf(frequency, column, row) ? levelAt(column, row, level) : typicalLevel(length(frequency));
}

double Significance::at(Vector frequency, NoiseLevel level) const
{
    int column = 0, row = 0;
    binOf(frequency, column, row);
    int best_x = -1, best_y = -1;
    float best = -1;
    for (int y = row - 1; y <= row + 1; ++y)
        for (int x = column - 1; x <= column + 1; ++x) {
            if (x < 0 || y < 0 || x >= spectrum_.power.columns || y >= spectrum_.power.rows) continue;
            if (spectrum_.power.at(x, y) > best) best = spectrum_.power.at(x, y), best_x = x, best_y = y;
        }
    return best_x < 0 ? 0 : double(best) / levelAt(best_x, best_y, level);
}

double Significance::typicalLevel(double cycles_per_px) const
{
    const auto ring =
        static_cast<std::size_t>(std::lround(cycles_per_px * std::max(spectrum_.power.columns, spectrum_.power.rows)));
    return std::exp(logRing_[std::min(ring, logRing_.size() - 1)]) / std::log(2.0);
}

std::vector<SpectralPeak> Significance::peaks(NoiseLevel level, double least, double* largest,
                                              const Progress& progress) const
{
    struct Found {
        std::vector<SpectralPeak> peaks;
        double largest = 0;
    };
    const Grid& power = spectrum_.power;
    const int zero_x = spectrum_.zeroColumn(), zero_y = spectrum_.zeroRow();
    const auto inRows = [&](std::size_t begin, std::size_t end) {
        Found found;
        for (int y = std::max(1, static_cast<int>(begin)); y < std::min(static_cast<int>(end), power.rows - 1); ++y)
            for (int x = std::max(1, zero_x); x < power.columns - 1; ++x) {
                if (x == zero_x && y <= zero_y) continue;
                const double periods = std::hypot(x - zero_x, y - zero_y);
                if (periods < leastPeriods) continue;
                const float value = power.at(x, y);
                bool is_top = value > 0;
                for (int dy = -1; dy <= 1 && is_top; ++dy)
                    for (int dx = -1; dx <= 1; ++dx)
                        if ((dx != 0 || dy != 0) && power.at(x + dx, y + dy) > value) is_top = false;
                if (!is_top) continue;
                const double wanted = std::min(least, found.largest > 0 ? found.largest : 1.0);
                const double give_up = std::log(double(value)) - std::log(wanted);
                const double noise =
                    level == NoiseLevel::Means ? meansLevel(x, y, give_up) : mediansLevel(x, y, give_up);
                const double significance = double(value) / std::exp(noise);
                found.largest = std::max(found.largest, significance);
                if (significance > least)
                    found.peaks.push_back({spectrum_.frequencyOf(x, y), double(value), significance});
            }
        return found;
    };
    Found all = parallelReduce(static_cast<std::size_t>(power.rows), 16, progress, Found{}, inRows,
                               [](Found sum, const Found& part) {
                                   sum.peaks.insert(sum.peaks.end(), part.peaks.begin(), part.peaks.end());
                                   sum.largest = std::max(sum.largest, part.largest);
                                   return sum;
                               });
    std::stable_sort(all.peaks.begin(), all.peaks.end(),
                     [](const SpectralPeak& a, const SpectralPeak& b) { return a.power > b.power; });
    if (largest) *largest = all.largest;
    return all.peaks;
}

}  // namespace lathelier::surface
