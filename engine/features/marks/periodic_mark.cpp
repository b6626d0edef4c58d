#include "engine/features/marks/periodic_mark.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>

#include "engine/core/statistics.h"
#include "engine/core/units.h"
#include "engine/features/marks/mark_limits.h"
#include "engine/features/structure/mark_proof.h"
#include "engine/features/walls/crest.h"

namespace lathelier::features {
namespace {

using Complex = std::complex<double>;

/// Of the order m among all from -most_teeth on.
std::size_t indexOfOrder(int m)
{
    const int index = periodicLimits.most_teeth + m;
    return static_cast<std::size_t>(index);
}

/// A wave 2πfz + mθ over the surface.
struct SurfaceWave {
    double frequency_per_mm = 0;
    int order = 0;
    double power = 0;
};

/// Search for the strongest wave in one rough zone.
class PeriodicSearch {
public:
    PeriodicSearch(const MeridianCloud& cloud, double from_mm, double to_mm, double about_mm, double sigma_mm)
        : cloud_(cloud),
          from_mm_(from_mm),
          to_mm_(to_mm),
          about_mm_(about_mm),
          sigma_mm_(sigma_mm),
          step_mm_(std::max(periodicLimits.row_mm, (to_mm - from_mm) / periodicLimits.most_rows)),
          rows_(static_cast<std::size_t>((to_mm - from_mm) / step_mm_)),
          sums_(rows_ * columns, 0),
          counts_(rows_ * columns, 0)
    {
        for (std::size_t i = 0; i < cloud.z_mm.size(); ++i) {
            const double z = static_cast<double>(cloud.z_mm[i]), r = static_cast<double>(cloud.r_mm[i]);
            const auto row = static_cast<std::size_t>((z - from_mm) / step_mm_);
            if (z < from_mm || row >= rows_ || std::abs(r - about_mm) > periodicLimits.radius_share * about_mm)
                continue;
            points_.push_back(static_cast<std::uint32_t>(i));
            const auto column =
                std::min(columns - 1, static_cast<std::size_t>(cloud.turn[i] * static_cast<float>(columns)));
            sums_[row * columns + column] += r;
            counts_[row * columns + column] += 1;
        }
        for (const std::uint32_t i : points_)
            mean_mm_ += static_cast<double>(cloud.r_mm[i]) / static_cast<double>(points_.size());
    }

    std::optional<ShaftMark> find(const Progress& progress) const
    {
        if (points_.size() < periodicLimits.least_points || rows_ < periodicLimits.least_rows) return std::nullopt;
        SurfaceWave wave = strongestWave(ordersOfRows(progress), progress);
        const auto n = static_cast<double>(points_.size());
        const double amplitude = 2 * std::sqrt(wave.power) / n;
        const double least = periodicLimits.amplitude_sigmas * sigma_mm_ / std::sqrt(n) + periodicLimits.amplitude_mm;
        if (amplitude < least || wave.order == 0) return std::nullopt;
        refine(wave, progress);
        if (isEccentric(wave)) return std::nullopt;
        const Folded folded = foldedBy(wave);
        if (!explains(folded)) return std::nullopt;
        std::vector<float> radii;
        radii.reserve(points_.size());
        for (const std::uint32_t i : points_) radii.push_back(cloud_.r_mm[i]);
        const std::optional<Crest> crest = crestOf(radii, sigma_mm_);
        const double crest_mm = crest ? crest->radius_mm : about_mm_;
        ShaftMark mark = std::abs(wave.order) <= periodicLimits.most_starts
                             ? threadOf(wave, crest_mm, rootOf_mm(folded))
                             : knurlOf(wave, crest_mm, radii);
        if (mark.kind == MarkKind::Knurl && *mark.pitch_mm > proofThresholds.most_knurl_pitch_mm) return std::nullopt;
        mark.z_start_mm = from_mm_;
        mark.z_end_mm = to_mm_;
        return mark;
    }

private:
    static constexpr std::size_t columns = periodicLimits.columns;
    using Orders = std::vector<std::vector<Complex>>;  ///< by indexOfOrder(), then by row

    /// Spectrum of each row around the circle, its mean taken out: A_m(z).
    Orders ordersOfRows(const Progress& progress) const
    {
        constexpr int most = periodicLimits.most_teeth;
        std::vector<Complex> turns(columns);
        for (std::size_t c = 0; c < columns; ++c)
            turns[c] = std::polar(1.0, -turn_rad * (static_cast<double>(c) + 0.5) / columns);
        Orders orders(2 * most + 1, std::vector<Complex>(rows_, 0));
        for (std::size_t row = 0; row < rows_; ++row) {
            if (row % periodicLimits.check_rows == 0) progress.check();
            std::array<double, columns> values{};
            for (std::size_t c = 0; c < columns; ++c) {
                const double n = counts_[row * columns + c];
                values[c] = n > 0 ? sums_[row * columns + c] - n * mean_mm_ : 0;
            }
            for (int m = 0; m <= most; ++m) {
                Complex sum = 0;
                std::size_t place = 0;
                for (std::size_t c = 0; c < columns; ++c) {
                    sum += values[c] * turns[place];
                    place = (place + static_cast<std::size_t>(m)) % columns;
                }
                // The half step of the first column: the sum runs over c·m, the angle of a column is (c + ½)·m.
                sum *= std::polar(1.0, -turn_rad * 0.5 * m / columns) / turns[0];
                orders[indexOfOrder(m)][row] = sum;
                orders[indexOfOrder(-m)][row] = std::conj(sum);
            }
        }
        return orders;
    }

    double frequencyStep() const { return 1 / (periodicLimits.padding * (to_mm_ - from_mm_)); }

    /// Along z, f from 0 upward for both signs of m.
    SurfaceWave strongestWave(const Orders& orders, const Progress& progress) const
    {
        const double f_step = frequencyStep(), f_most = std::min(periodicLimits.most_frequency_per_mm,
                                                                 periodicLimits.most_frequency_per_row / step_mm_);
        SurfaceWave best;
        for (int m = -periodicLimits.most_teeth; m <= periodicLimits.most_teeth; ++m) {
            progress.check();
            const bool is_thread = std::abs(m) <= periodicLimits.most_starts;
            const double last = is_thread ? f_most : std::min(f_most, periodicLimits.most_knurl_frequency_per_mm);
            const double first = m == 0 ? periodicLimits.least_ring_waves / (to_mm_ - from_mm_) : 0;
            for (double f = first; f < last; f += f_step) {
                if (is_thread && f < periodicLimits.least_thread_frequency_per_mm) continue;
                const Complex turn = std::polar(1.0, -turn_rad * f * step_mm_);
                Complex sum = 0, phase = 1;
                for (const Complex& value : orders[indexOfOrder(m)]) {
                    sum += value * phase;
                    phase *= turn;
                }
                if (std::norm(sum) > best.power) best = {f, m, std::norm(sum)};
            }
        }
        return best;
    }

    /// Phase of a point in turns.
    double phaseOf(std::uint32_t i, const SurfaceWave& wave) const
    {
        return wave.frequency_per_mm * (static_cast<double>(cloud_.z_mm[i]) - from_mm_) +
               wave.order * static_cast<double>(cloud_.turn[i]);
    }

    double powerOf(const SurfaceWave& wave) const
    {
        Complex sum = 0;
        for (const std::uint32_t i : points_)
            sum += (static_cast<double>(cloud_.r_mm[i]) - mean_mm_) * std::polar(1.0, -turn_rad * phaseOf(i, wave));
        return std::norm(sum);
    }

    /// Is the wave what a finite length makes of one that is the same all along z: an eccentric, lobes, a spline? A
    /// thread of so few starts has no such part.
    bool isEccentric(const SurfaceWave& wave) const
    {
        return std::abs(wave.order) <= periodicLimits.most_starts &&
               powerOf({0, wave.order}) > periodicLimits.most_constant_power * wave.power;
    }

    /// The frequency refined on the points themselves.
    void refine(SurfaceWave& wave, const Progress& progress) const
    {
        const auto powerAt = [&](double f) { return powerOf({f, wave.order}); };
        double centre = wave.frequency_per_mm;
        wave.power = powerAt(centre);
        for (double width = frequencyStep(); width > periodicLimits.frequency_resolution_per_mm;
             width /= periodicLimits.refinement) {
            progress.check();
            for (const double f : {centre - width, centre + width})
                if (const double power = powerAt(f); power > wave.power) {
                    wave.power = power;
                    centre = f;
                }
        }
        wave.frequency_per_mm = centre;
    }

    /// Radii folded over the phase of a wave.
    struct Folded {
        std::array<double, periodicLimits.phase_bins> sums{}, counts{};

        double mean_mm(std::size_t bin) const { return sums[bin] / counts[bin]; }
    };

    Folded foldedBy(const SurfaceWave& wave) const
    {
        constexpr std::size_t bins = periodicLimits.phase_bins;
        Folded folded;
        for (const std::uint32_t i : points_) {
            double phase = phaseOf(i, wave);
            phase -= std::floor(phase);
            const auto bin = std::min(bins - 1, static_cast<std::size_t>(phase * bins));
            folded.sums[bin] += static_cast<double>(cloud_.r_mm[i]);
            folded.counts[bin] += 1;
        }
        return folded;
    }

    /// Least mean radius over the phase.
    static double rootOf_mm(const Folded& folded)
    {
        double root = std::numeric_limits<double>::infinity();
        for (std::size_t b = 0; b < folded.counts.size(); ++b)
            if (folded.counts[b] > 0) root = std::min(root, folded.mean_mm(b));
        return root;
    }

    /// Does the wave explain enough of the scatter beyond the noise?
    bool explains(const Folded& folded) const
    {
        double scatter = 0, explained = 0;
        for (const std::uint32_t i : points_) {
            const double off = static_cast<double>(cloud_.r_mm[i]) - mean_mm_;
            scatter += off * off - sigma_mm_ * sigma_mm_;
        }
        for (std::size_t b = 0; b < folded.counts.size(); ++b) {
            if (folded.counts[b] == 0) continue;
            const double off = folded.mean_mm(b) - mean_mm_;
            explained += folded.counts[b] * off * off;
        }
        return explained >= proofThresholds.least_explained * scatter;
    }

    static ShaftMark threadOf(const SurfaceWave& wave, double crest_mm, double root_mm)
    {
        ShaftMark mark{MarkKind::Thread};
        mark.starts = std::abs(wave.order);
        // r repeats where f·z + m·turn does: z grows with the turn for m < 0, a right-hand thread.
        mark.hand = wave.order < 0 ? 1 : -1;
        mark.pitch_mm = 1 / wave.frequency_per_mm;
        mark.major_mm = 2 * crest_mm;
        mark.minor_mm = 2 * root_mm;
        return mark;
    }

    ShaftMark knurlOf(const SurfaceWave& wave, double crest_mm, const std::vector<float>& radii) const
    {
        ShaftMark mark{MarkKind::Knurl};
        mark.teeth = std::abs(wave.order);
        mark.helix_deg = std::atan(turn_rad * wave.frequency_per_mm / std::abs(wave.order) * about_mm_) * deg_per_rad;
        mark.diameter_mm = 2 * crest_mm;
        std::vector<double> sorted(radii.begin(), radii.end());
        mark.depth_mm = crest_mm - lowerQuantileInPlace(sorted, periodicLimits.root_share);
        mark.pitch_mm = std::numbers::pi * *mark.diameter_mm / *mark.teeth;
        return mark;
    }

    const MeridianCloud& cloud_;
    double from_mm_, to_mm_, about_mm_, sigma_mm_;
    double step_mm_;                     ///< height of a row of the grid
    std::size_t rows_;                   ///< of the grid, each of `columns` cells
    std::vector<double> sums_, counts_;  ///< of the radii in each cell
    std::vector<std::uint32_t> points_;  ///< of the zone
    double mean_mm_ = 0;                 ///< of their radii
};

}  // namespace

std::optional<ShaftMark> periodicMark(const MeridianCloud& cloud, double from_mm, double to_mm, double about_mm,
                                      double sigma_mm, const Progress& progress)
{
    return PeriodicSearch(cloud, from_mm, to_mm, about_mm, sigma_mm).find(progress);
}

}  // namespace lathelier::features
