#include "engine/surface/spectrum.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "engine/core/statistics.h"
#include "engine/core/units.h"
#include "engine/surface/picture_kernel.h"

namespace lathelier::surface {
namespace {

struct WaveSamples {
    std::vector<float> cosine, sine;
};

WaveSamples wavesOf(double frequency, int count)
{
    WaveSamples waves{std::vector<float>(static_cast<std::size_t>(count)),
                      std::vector<float>(static_cast<std::size_t>(count))};
    for (std::size_t i = 0; i < waves.cosine.size(); ++i) {
        const double phase = turn_rad * frequency * static_cast<double>(i);
        waves.cosine[i] = static_cast<float>(std::cos(phase));
        waves.sine[i] = static_cast<float>(std::sin(phase));
    }
    return waves;
}

/// Sums in eight lanes for vectorisation, in a fixed order.
double dotProduct(const float* a, const float* b, std::size_t count)
{
    constexpr std::size_t lanes = 8;
    std::array<float, lanes> sums{};
    std::size_t i = 0;
    for (; i + lanes <= count; i += lanes)
        for (std::size_t k = 0; k < lanes; ++k) sums[k] += a[i + k] * b[i + k];
    double sum = 0;
    for (; i < count; ++i) sum += double(a[i]) * double(b[i]);
    for (const float part : sums) sum += double(part);
    return sum;
}

/// The transform along x of every row.
std::vector<std::complex<double>> alongRows(const Grid& grid, double fx)
{
    const WaveSamples waves = wavesOf(fx, grid.columns);
    std::vector<std::complex<double>> sums(static_cast<std::size_t>(grid.rows));
    const auto count = static_cast<std::size_t>(grid.columns);
    for (int y = 0; y < grid.rows; ++y)
        sums[static_cast<std::size_t>(y)] = {dotProduct(grid.row(y), waves.cosine.data(), count),
                                             -dotProduct(grid.row(y), waves.sine.data(), count)};
    return sums;
}

std::complex<double> alongColumn(const std::vector<std::complex<double>>& sums, double fy)
{
    std::complex<double> total = 0;
    for (std::size_t y = 0; y < sums.size(); ++y)
        total += sums[y] * std::polar(1.0, -turn_rad * fy * static_cast<double>(y));
    return total;
}

std::vector<float> shortHann(int count)
{
    const std::vector<double> window = hann(count);
    return {window.begin(), window.end()};
}

}  // namespace

std::vector<double> hann(int count)
{
    std::vector<double> window(static_cast<std::size_t>(count));
    for (int i = 0; i < count; ++i)
        window[static_cast<std::size_t>(i)] = 0.5 - 0.5 * std::cos(turn_rad * (i + 0.5) / count);
    return window;
}

WindowedPicture::WindowedPicture(const Grid& flat) : windowed_(flat.columns, flat.rows)
{
    const std::vector<float> across = shortHann(flat.columns), down = shortHann(flat.rows);
    double sum_x = 0, sum_y = 0;
    for (const float w : across) sum_x += double(w);
    for (const float w : down) sum_y += double(w);
    windowSum_ = sum_x * sum_y;
    for (int y = 0; y < flat.rows; ++y) {
        const float* in = flat.row(y);
        float* out = windowed_.row(y);
        const float weight = down[static_cast<std::size_t>(y)];
        for (int x = 0; x < flat.columns; ++x) out[x] = in[x] * weight * across[static_cast<std::size_t>(x)];
    }
}

std::complex<double> WindowedPicture::at(Vector frequency) const
{
    return alongColumn(alongRows(windowed_, frequency.x), frequency.y);
}

std::vector<std::complex<double>> WindowedPicture::at(double fx, const std::vector<double>& fy) const
{
    if (fy.empty()) return {};
    const auto sums = alongRows(windowed_, fx);
    std::vector<std::complex<double>> result;
    result.reserve(fy.size());
    for (const double f : fy) result.push_back(alongColumn(sums, f));
    return result;
}

double WindowedPicture::binsBetween(Vector a, Vector b) const
{
    return std::hypot((a.x - b.x) * columns(), (a.y - b.y) * rows());
}

void WindowedPicture::around(Vector middle, double step_bins, double (&magnitude)[3][3]) const
{
    for (int i = 0; i < 3; ++i) {
        const auto sums = alongRows(windowed_, middle.x + (i - 1) * step_bins / columns());
        for (int j = 0; j < 3; ++j)
            magnitude[i][j] = std::log(std::abs(alongColumn(sums, middle.y + (j - 1) * step_bins / rows())) + 1e-300);
    }
}

Vector WindowedPicture::refined(Vector start) const
{
    constexpr double step = 0.35, closest_bins = 1e-4, farthest_bins = 1.5;
    Vector found = start;
    for (int iteration = 0; iteration < 8; ++iteration) {
        double m[3][3];
        around(found, step, m);
        // least squares of a paraboloid over the nine points
        double gx = 0, gy = 0, hxx = 0, hyy = 0, hxy = 0;
        for (int k = 0; k < 3; ++k) {
            gx += (m[2][k] - m[0][k]) / 6;
            gy += (m[k][2] - m[k][0]) / 6;
            hxx += (m[2][k] - 2 * m[1][k] + m[0][k]) / 3;
            hyy += (m[k][2] - 2 * m[k][1] + m[k][0]) / 3;
        }
        hxy = (m[2][2] - m[2][0] - m[0][2] + m[0][0]) / 4;
        double dx = 0, dy = 0;  // in steps
        const double determinant = hxx * hyy - hxy * hxy;
        if (hxx < 0 && hyy < 0 && determinant > 0) {
            dx = (-gx * hyy + gy * hxy) / determinant;
            dy = (-gy * hxx + gx * hxy) / determinant;
        } else {  // far from the maximum: gradient step
            const double slope = std::hypot(gx, gy);
            if (slope == 0) break;
            dx = gx / slope;
            dy = gy / slope;
        }
        const double size = std::hypot(dx, dy);
        if (size > 2) dx *= 2 / size, dy *= 2 / size;
        const Vector next{found.x + dx * step / columns(), found.y + dy * step / rows()};
        if (binsBetween(next, start) > farthest_bins) break;
        found = next;
        if (size * step < closest_bins) break;
    }
    return found;
}

Vector PowerSpectrum::frequencyOf(int column, int row) const
{
    return turned({double(column - zeroColumn()) / power.columns, double(row - zeroRow()) / power.rows}, -turn_deg);
}

PowerSpectrum powerSpectrum(const WindowedPicture& picture, double turn_deg)
{
    const Grid& grid = picture.values();
    const double angle = turn_deg * std::numbers::pi / 180;
    const double c = std::abs(std::cos(angle)), s = std::abs(std::sin(angle));
    // size of the whole rotated picture, which the window has reduced to zero at its edges
    const PictureKernel& kernel = pictureKernel();
    const int columns = kernel.fast_size(static_cast<int>(std::ceil(grid.columns * c + grid.rows * s - 1e-6)));
    const int rows = kernel.fast_size(static_cast<int>(std::ceil(grid.columns * s + grid.rows * c - 1e-6)));
    Grid turned(columns, rows);
    if (turn_deg == 0) {
        for (int y = 0; y < grid.rows; ++y) std::copy_n(grid.row(y), grid.columns, turned.row(y));
    } else {
        const double cx = 0.5 * (grid.columns - 1), cy = 0.5 * (grid.rows - 1);
        const AffineMap move{
            std::cos(angle), -std::sin(angle), 0.5 * (columns - 1) - std::cos(angle) * cx + std::sin(angle) * cy,
            std::sin(angle), std::cos(angle),  0.5 * (rows - 1) - std::sin(angle) * cx - std::cos(angle) * cy};
        turned = kernel.moved(grid, move, columns, rows, Interpolation::Cubic);
    }
    return {kernel.power(turned), turn_deg};
}

double turnToAxis_deg(double direction_deg)
{
    double rest = std::fmod(direction_deg, 90.0);
    if (rest > 45) rest -= 90;
    if (rest <= -45) rest += 90;
    return -rest;
}

std::size_t ringOf(const PowerSpectrum& spectrum, int column, int row)
{
    const double fx = double(column - spectrum.zeroColumn()) / spectrum.power.columns;
    const double fy = double(row - spectrum.zeroRow()) / spectrum.power.rows;
    return static_cast<std::size_t>(
        std::lround(std::hypot(fx, fy) * std::max(spectrum.power.columns, spectrum.power.rows)));
}

std::vector<double> ringMedians(const PowerSpectrum& spectrum)
{
    const int columns = spectrum.power.columns, rows = spectrum.power.rows;
    std::vector<std::vector<float>> rings(static_cast<std::size_t>(std::max(columns, rows)) + 2);
    for (int y = 0; y <= spectrum.zeroRow(); ++y)  // the other half is symmetric
        for (int x = 0; x < columns; ++x) rings[ringOf(spectrum, x, y)].push_back(spectrum.power.at(x, y));
    std::vector<double> medians(rings.size(), 0.0);
    double last = 0;
    for (std::size_t i = 0; i < rings.size(); ++i) {
        std::vector<float>& ring = rings[i];
        if (!ring.empty()) last = double(upperMedianInPlace(ring));
        medians[i] = std::max(last, 1e-30);
    }
    return medians;
}

double ridgeDirection_deg(const PowerSpectrum& spectrum)
{
    constexpr int directions = 720;
    constexpr double leastRadius_bins = 6;
    const std::vector<double> medians = ringMedians(spectrum);
    const int columns = spectrum.power.columns, rows = spectrum.power.rows;
    const double bin = 1.0 / std::max(columns, rows);
    double best = -1, best_deg = 0;
    for (int i = 0; i < directions; ++i) {
        const double direction = 180.0 * i / directions;
        const Vector unit = turned({1, 0}, direction);
        double sum = 0;
        int count = 0;
        for (double radius = leastRadius_bins * bin; radius < 0.5; radius += bin) {
            const double x = spectrum.zeroColumn() + radius * unit.x * columns;
            const double y = spectrum.zeroRow() + radius * unit.y * rows;
            const int x0 = static_cast<int>(std::floor(x)), y0 = static_cast<int>(std::floor(y));
            if (x0 < 0 || y0 < 0 || x0 + 1 >= columns || y0 + 1 >= rows) break;
            const double tx = x - x0, ty = y - y0;
            const Grid& p = spectrum.power;
            const double power = (1 - ty) * ((1 - tx) * double(p.at(x0, y0)) + tx * double(p.at(x0 + 1, y0))) +
                                 ty * ((1 - tx) * double(p.at(x0, y0 + 1)) + tx * double(p.at(x0 + 1, y0 + 1)));
            sum += power / medians[ringOf(spectrum, x0, y0)];
            ++count;
        }
        if (count > 0 && sum / count > best) best = sum / count, best_deg = direction;
    }
    return best_deg;
}

}  // namespace lathelier::surface
