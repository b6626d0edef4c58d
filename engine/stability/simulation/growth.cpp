#include "engine/stability/simulation/growth.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/stability/simulation/growth_rate.h"
#include "engine/stability/simulation/mode_step.h"

namespace lathelier::stability {
namespace {

constexpr int batchSize = 8;         ///< cuts simulated side by side with common mode constants
constexpr double fewestPeriods = 2;  ///< smallest length of a revolution, in periods of the highest mode
constexpr double weakPeak = 0.01;    ///< of the highest peak: modes with less go on exactly, but do not chatter first
constexpr double smallest = 1e-60;   ///< magnitudes outside are rescaled
constexpr int growthStepsBetweenChecks = 1 << 15;

using Lanes = Eigen::Array<double, batchSize, 1>;

/// A batch of eight cuts of one speed and direction.
class CutBatch {
public:
    CutBatch(std::span<const Mode> modes, std::span<const CutForces> cuts, double revolution_s, int steps)
        : steps_(static_cast<std::size_t>(steps)),
          constants_(modeSteps(modes, revolution_s / steps, cuts.front().direction_factor)),
          deflection_(modes.size(), Lanes::Zero()),
          speed_(modes.size(), Lanes::Zero())
    {
        for (int lane = 0; lane < batchSize; ++lane) {
            const CutForces& cut = cuts[std::min<std::size_t>(static_cast<std::size_t>(lane), cuts.size() - 1)];
            stiffness_[lane] = cut.stiffness_N_mm;
            damping_[lane] = cut.damping_N_s_mm;
        }
        share_ = 1 / (1 + stiffness_ * constants_.q1 + damping_ * constants_.v1);
        // Initial impulse on every mode.
        for (std::size_t m = 0; m < modes.size(); ++m)
            if (modes[m].hasMass()) speed_[m] = Lanes::Constant(2 * std::numbers::pi * modes[m].frequency_hz);
    }

    /// One revolution: `now` from the deflections of the revolution before.
    void turn(const Lanes* before, Lanes* now, const Progress& progress)
    {
        for (std::size_t i = 0; i < steps_; ++i) {
            if (i % growthStepsBetweenChecks == 0) progress.check();
            Lanes x = Lanes::Zero(), v = Lanes::Zero();
            for (std::size_t m = 0; m < constants_.modes.size(); ++m) {
                const ModeStep& c = constants_.modes[m];
                const Lanes q = deflection_[m], u = speed_[m];
                deflection_[m] = c.qq * q + c.qv * u + c.q0 * force_;
                speed_[m] = c.vq * q + c.vv * u + c.v0 * force_;
                x += deflection_[m] + c.lag_s * speed_[m];
                v += c.rate_q * deflection_[m] + c.rate_v * speed_[m];
            }
            force_ = (stiffness_ * (before[i] - x) - damping_ * v) * share_;
            for (std::size_t m = 0; m < constants_.modes.size(); ++m) {
                deflection_[m] += constants_.modes[m].q1 * force_;
                speed_[m] += constants_.modes[m].v1 * force_;
            }
            now[i] = x + constants_.q1 * force_;
        }
    }

    /// Rescales the vibration, as the equation is linear.
    void scale(Lanes* now)
    {
        Lanes size = Lanes::Zero();
        for (std::size_t i = 0; i < steps_; ++i) size = size.max(now[i].abs());
        bool ordinary = true;
        for (int lane = 0; lane < batchSize; ++lane)
            ordinary = ordinary && size[lane] > smallest && size[lane] < 1 / smallest;
        if (ordinary) return;
        for (int lane = 0; lane < batchSize; ++lane)
            size[lane] = size[lane] > 0 && std::isfinite(size[lane]) ? 1 / size[lane] : 1;
        for (std::size_t i = 0; i < steps_; ++i) now[i] *= size;
        for (Lanes& q : deflection_) q *= size;
        for (Lanes& v : speed_) v *= size;
        force_ *= size;
    }

private:
    std::size_t steps_;
    ModeSteps constants_;
    std::vector<Lanes> deflection_, speed_;  ///< of the modes
    Lanes stiffness_, damping_, share_;
    Lanes force_ = Lanes::Zero();
};

/// Growths of up to eight cuts.
void growthsOfBatch(std::span<const Mode> modes, std::span<const CutForces> cuts, double revolution_s,
                    const GrowthEffort& effort, const Progress& progress, std::span<Growth> result)
{
    const auto steps = static_cast<std::size_t>(effort.steps);
    const int snapshots = std::clamp(effort.snapshots, 1, mostSnapshots);
    const auto count = static_cast<std::size_t>(snapshots) + 1;
    CutBatch all(modes, cuts, revolution_s, effort.steps);
    std::vector<Lanes> room((count + 1) * steps, Lanes::Zero());
    Lanes* before = room.data();
    Lanes* now = before + steps;
    for (int turn = 0; turn < effort.warm_up; ++turn) {
        all.turn(before, now, progress);
        all.scale(now);
        std::swap(before, now);
    }
    if (before != room.data()) std::copy(before, before + steps, room.data());
    const Lanes* const seen = room.data() + steps;
    for (std::size_t turn = 0; turn < count; ++turn)
        all.turn(room.data() + turn * steps, room.data() + (turn + 1) * steps, progress);
    std::vector<SnapshotProducts> products(cuts.size(),
                                           {Small(snapshots + 1, snapshots + 1), Small(snapshots, snapshots)});
    for (std::size_t a = 0; a < count; ++a)
        for (std::size_t b = 0; b < count; ++b) {
            progress.check();
            Lanes same = Lanes::Zero(), later = Lanes::Zero();
            const Lanes* const one = seen + a * steps;
            const Lanes* const other = seen + b * steps;
            const auto row = static_cast<Eigen::Index>(a), column = static_cast<Eigen::Index>(b);
            if (b >= a)
                for (std::size_t i = 0; i < steps; ++i) same += one[i] * other[i];
            const bool has_later = a + 1 < count && b + 1 < count;
            if (has_later)
                for (std::size_t i = 0; i < steps; ++i) later += one[i] * other[i + 1];
            for (std::size_t cut = 0; cut < cuts.size(); ++cut) {
                const auto lane = static_cast<Eigen::Index>(cut);
                if (b >= a) products[cut].same(row, column) = products[cut].same(column, row) = same[lane];
                if (has_later) products[cut].later(row, column) = later[lane];
            }
        }
    for (std::size_t cut = 0; cut < cuts.size(); ++cut)
        result[cut] = growthOf(products[cut], revolution_s, effort.steps);
}

}  // namespace

double stepsOfRevolution(std::span<const Mode> modes, double revolution_s, double per_period)
{
    const auto peak_mm_N = [](const Mode& mode) {
        return mode.isResonance() ? 1 / std::abs(mode.stiffness_N_mm * mode.damping_ratio) : 0;
    };
    double largest_mm_N = 0, highest_hz = 0;
    for (const Mode& mode : modes) largest_mm_N = std::max(largest_mm_N, peak_mm_N(mode));
    for (const Mode& mode : modes)
        if (peak_mm_N(mode) > weakPeak * largest_mm_N) highest_hz = std::max(highest_hz, mode.frequency_hz);
    if (highest_hz == 0) highest_hz = highestFrequency(modes);
    return std::ceil(std::max(fewestPeriods, highest_hz * revolution_s) * per_period);
}

std::vector<Growth> growthsOf(std::span<const Mode> modes, std::span<const CutForces> cuts, double revolution_s,
                              const GrowthEffort& effort, const Progress& progress)
{
    std::vector<Growth> result(cuts.size());
    for (std::size_t first = 0; first < cuts.size(); first += batchSize) {
        const std::size_t count = std::min<std::size_t>(batchSize, cuts.size() - first);
        growthsOfBatch(modes, cuts.subspan(first, count), revolution_s, effort, progress,
                       std::span(result).subspan(first, count));
    }
    return result;
}

}  // namespace lathelier::stability
