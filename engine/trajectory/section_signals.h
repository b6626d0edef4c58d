// The four displacements of one section as matrices [revolution][angle], and their cleaning.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "engine/trajectory/revolutions.h"

namespace lathelier::trajectory {

/// Displacements in µm at `points` uniform angles of several revolutions. NaN: missing or rejected.
struct SectionSignals {
    std::size_t points = 0;                 ///< angles of a revolution
    std::vector<std::int64_t> numbers;      ///< number of each revolution within the record
    std::array<std::vector<double>, 4> um;  ///< by Probe: revolution after revolution
    std::size_t revolutions() const { return numbers.size(); }
    double& at(std::size_t probe, std::size_t revolution, std::size_t i) { return um[probe][revolution * points + i]; }
    double at(std::size_t probe, std::size_t revolution, std::size_t i) const
    {
        return um[probe][revolution * points + i];
    }
};

/// Samples the probes at `points` angles of each of the revolutions. Channel c of frame f was sampled at t_f + c ·
/// skew: its value at time t is looked up at t - c · skew. A revolution with a tenth of its samples missing is
/// excluded.
SectionSignals resample(const io::ProbeRecord& record, const FrameClock& clock, const ChannelMap& map,
                        const Revolutions& revolutions, std::span<const Revolution> chosen, std::size_t points,
                        double channel_skew_s);

/// Drift of each probe in µm for one revolution: the slope of the revolutions' median distances from the mean curve.
std::array<double, 4> driftPerRevolution_um(const SectionSignals& signals);

/// Removes a linear drift within and between revolutions. The section's mean is kept, since it is the size.
void removeDrift(SectionSignals& signals, const std::array<double, 4>& drift_um);

struct Rejected {
    std::int64_t revolutions = 0;  ///< number of revolutions rejected as a whole
    std::int64_t samples = 0;      ///< number of single samples rejected (set to NaN), all probes together
};

/// Hampel's rule over the revolutions: a revolution whose median distance from the median curve is an outlier in any
/// probe is rejected as a whole; then samples further than `sigmas` robust standard deviations from the median at their
/// angle become NaN. Requires at least five revolutions; fewer are unchanged.
Rejected rejectOutliers(SectionSignals& signals, double sigmas);

}  // namespace lathelier::trajectory
