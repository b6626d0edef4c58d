#include "engine/beam/natural_frequencies.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/beam/beam_chain.h"
#include "engine/core/units.h"

namespace lathelier::beam {
namespace {

constexpr double precise = 1e-13;  // relative width of the last interval
constexpr int mostHalvings = 200;

/// Bisection for the frequencies at which the count increases.
class Counter {
public:
    Counter(const BeamModel& model, double most_rad_s) : chain_(cutForCounting(model, most_rad_s / turn_rad))
    {
        rigid_ = rigidBodyMotions(model);
        const int count = chain_.negativeEigenvalues(most_rad_s) - rigid_;
        low_.assign(static_cast<std::size_t>(std::max(0, count)), 0.0);
        high_.assign(low_.size(), most_rad_s);
    }

    /// Natural frequencies in Hz, ascending.
    std::vector<double> all(const Progress& progress)
    {
        std::vector<double> result;
        for (std::size_t mode = 0; mode < low_.size(); ++mode) {
            progress.report(static_cast<double>(mode) / static_cast<double>(low_.size()));
            for (int i = 0; i < mostHalvings && high_[mode] - low_[mode] > precise * high_[mode]; ++i) {
                progress.check();
                halve(mode);
            }
            result.push_back((low_[mode] + high_[mode]) / 2 / turn_rad);
        }
        return result;
    }

private:
    void halve(std::size_t mode)
    {
        const double middle = (low_[mode] + high_[mode]) / 2;
        const int below = chain_.negativeEigenvalues(middle) - rigid_;
        for (std::size_t other = 0; other < low_.size(); ++other) {
            if (static_cast<int>(other) < below)
                high_[other] = std::min(high_[other], middle);
            else
                low_[other] = std::max(low_[other], middle);
        }
    }

    BeamChain chain_;
    int rigid_ = 0;
    std::vector<double> low_, high_;  // bracket of each mode, rad/s
};

}  // namespace

std::vector<double> naturalFrequencies(const BeamModel& model, double most_hz, const Progress& progress)
{
    if (!(most_hz > 0)) return {};
    return Counter(model, 2 * std::numbers::pi * most_hz).all(progress);
}

}  // namespace lathelier::beam
