#include "engine/trajectory/revolutions.h"

#include <algorithm>
#include <cmath>

#include "engine/core/core_codes.h"
#include "engine/core/statistics.h"
#include "engine/signal/hampel.h"
#include "engine/trajectory/marker.h"
#include "engine/trajectory/trajectory_codes.h"

namespace lathelier::trajectory {
namespace {

constexpr double fewestFrames = 8;    ///< least frames per revolution that resolve a pulse and the form
constexpr double longestPause = 3.5;  ///< longest gap between frames, in steps, with acceptable interpolation error

Error tooFew(std::size_t found)
{
    return Error(errors::tooFewRevolutions,
                 {{"found", static_cast<std::int64_t>(found)}, {"minimum", fewestRevolutions}});
}

/// Numbers the periods between marks and classifies them as regular or not.
Revolutions judged(const std::vector<double>& marks_s, const FrameClock& clock)
{
    Revolutions result;
    if (marks_s.size() < 2) throw tooFew(marks_s.empty() ? 0 : marks_s.size() - 1);
    std::vector<double> periods;
    for (std::size_t i = 1; i < marks_s.size(); ++i) periods.push_back(marks_s[i] - marks_s[i - 1]);
    result.period_s = median(periods);
    const double allowed = std::max(periodTolerance * result.period_s, clock.step_s());
    std::int64_t number = 0;
    double pieces_s = 0;  // accumulated length of short periods caused by false marks
    for (std::size_t i = 0; i < periods.size(); ++i) {
        const bool regular = std::abs(periods[i] - result.period_s) <= allowed &&
                             clock.longestStep_s(marks_s[i], marks_s[i + 1]) <= longestPause * clock.step_s();
        result.all.push_back({number, marks_s[i], marks_s[i + 1], regular});
        if (regular) {
            ++number;
            pieces_s = 0;
        } else {
            ++result.irregular;
            pieces_s += periods[i];
            const auto turns = static_cast<std::int64_t>(std::llround(pieces_s / result.period_s));
            number += turns;
            pieces_s -= static_cast<double>(turns) * result.period_s;
        }
    }
    return result;
}

Error elsewhere(const io::ProbeRecord& record, const FrameClock& clock, std::size_t marker, Text reason)
{
    Values values{
        {"channel", record.channels[marker].name}, {"place", static_cast<std::int64_t>(marker)}, {"reason", reason}};
    for (std::size_t other = 0; other < record.channels.size(); ++other) {
        if (other == marker) continue;
        const MarkerLevels levels = findMarkerLevels(record.channels[other].values);
        if (!levels.isMarker() || findMarks(record.channels[other].values, clock, levels).size() < 3) continue;
        set(values, "candidate", static_cast<std::int64_t>(other));
        set(values, "candidate_channel", record.channels[other].name);
        return Error(errors::markerElsewhere, values);
    }
    return Error(errors::markerNotFound, values);
}

Revolutions fromMarker(const io::ProbeRecord& record, const FrameClock& clock, std::size_t marker,
                       const TrajectoryParameters& parameters, double skew_s)
{
    const std::vector<double>& values = record.channels[marker].values;
    MarkerLevels levels = findMarkerLevels(values);
    if (!levels.isMarker()) throw elsewhere(record, clock, marker, levels.complaint);
    if (parameters.marker_threshold_V) {
        levels.threshold = *parameters.marker_threshold_V;
        if (!(levels.threshold > levels.low && levels.threshold < levels.high))
            throw Error(errors::valueOutOfRange, {{"parameter", "marker_threshold_V"},
                                                  {"found", levels.threshold},
                                                  {"expected", LT_TEXT("Engine", "a threshold between the levels")},
                                                  {"minimum", levels.low},
                                                  {"maximum", levels.high}});
    }
    std::vector<double> marks_s = findMarks(values, clock, levels);
    for (double& mark : marks_s) mark += static_cast<double>(marker) * skew_s;
    Revolutions result = judged(marks_s, clock);
    result.threshold = levels.threshold;
    if (result.period_s < fewestFrames * clock.step_s())
        throw elsewhere(record, clock, marker, LT_TEXT("Engine", "its pulses follow each other within a few frames"));
    if (2 * static_cast<std::size_t>(result.irregular) > result.all.size() && result.all.size() > 2)
        throw elsewhere(record, clock, marker, LT_TEXT("Engine", "its pulses come at irregular times"));
    return result;
}

/// Time at which an encoder had made a given number of turns, on the clock of its own channel; straight between frames.
double timeOfTurn(const std::vector<double>& turns, const FrameClock& clock, double target)
{
    const auto after = std::lower_bound(turns.begin(), turns.end(), target);
    const auto i = static_cast<std::size_t>(
        std::clamp<std::ptrdiff_t>(after - turns.begin(), 1, static_cast<std::ptrdiff_t>(turns.size()) - 1));
    const double share = turns[i] > turns[i - 1] ? (target - turns[i - 1]) / (turns[i] - turns[i - 1]) : 0;
    return clock.time_s(i - 1) + share * (clock.time_s(i) - clock.time_s(i - 1));
}

Revolutions fromAngle(const io::ProbeRecord& record, const FrameClock& clock, std::size_t channel, double skew_s)
{
    const std::vector<double>& angle_deg = record.channels[channel].values;
    const auto still = [&](Text reason) {
        return Error(errors::angleNotTurning, {{"channel", record.channels[channel].name},
                                               {"place", static_cast<std::int64_t>(channel)},
                                               {"reason", reason}});
    };
    // Unwraps the angle by the shorter way between frames; a missing angle is bridged to the next one.
    const auto known = std::find_if(angle_deg.begin(), angle_deg.end(), [](double v) { return std::isfinite(v); });
    if (known == angle_deg.end() || angle_deg.size() < 2) throw still(LT_TEXT("Engine", "it has hardly any values"));
    std::vector<double> turns(angle_deg.size());
    double last = *known / 360;
    double total = last;
    for (std::size_t i = 0; i < angle_deg.size(); ++i) {
        const double turn = angle_deg[i] / 360;
        if (std::isfinite(turn)) {
            const double step = turn - last;
            total += step - std::round(step);
            last = turn;
        }
        turns[i] = total;
    }
    const double advance = turns.back() - turns.front();
    const bool falling = advance < 0;
    double top = falling ? -turns.front() : turns.front();
    double back = 0;  // largest backward rotation
    for (double& turn : turns) {
        if (falling) turn = -turn;
        back = std::max(back, top - turn);
        top = std::max(top, turn);
        turn = top;
    }
    if (std::abs(advance) < 1) throw still(LT_TEXT("Engine", "it makes no whole turn"));
    if (back > 0.1) throw still(LT_TEXT("Engine", "it runs back and forth"));

    const double first = std::ceil(turns.front());
    std::vector<double> marks_s;
    for (double turn = first; turn <= turns.back(); ++turn) marks_s.push_back(timeOfTurn(turns, clock, turn) + skew_s);
    Revolutions result = judged(marks_s, clock);
    if (result.period_s < fewestFrames * clock.step_s())
        throw still(LT_TEXT("Engine", "its turns follow each other within a few frames"));
    // With an encoder a varying speed does no harm: only gaps in the recording make a revolution irregular.
    result.irregular = 0;
    for (std::size_t i = 0; i < result.all.size(); ++i) {
        Revolution& revolution = result.all[i];
        revolution.number = static_cast<std::int64_t>(i);
        revolution.regular = clock.longestStep_s(revolution.start_s, revolution.end_s) <= longestPause * clock.step_s();
        result.irregular += !revolution.regular;
    }
    for (double& turn : turns) turn -= first;
    result.turns = std::move(turns);
    result.falling = falling;
    result.angle_skew_s = skew_s;
    return result;
}

}  // namespace

double Revolutions::timeAt(const FrameClock& clock, const Revolution& revolution, double fraction) const
{
    if (turns.empty()) return revolution.start_s + fraction * (revolution.end_s - revolution.start_s);
    const double within = falling && fraction > 0 ? 1 - fraction : fraction;
    const double target = static_cast<double>(revolution.number) + within;
    return timeOfTurn(turns, clock, target) + angle_skew_s;
}

Revolutions findRevolutions(const io::ProbeRecord& record, const FrameClock& clock, const ChannelMap& map,
                            const TrajectoryParameters& parameters, double channel_skew_s)
{
    Revolutions result =
        map.is_angle ? fromAngle(record, clock, map.reference, static_cast<double>(map.reference) * channel_skew_s)
                     : fromMarker(record, clock, map.reference, parameters, channel_skew_s);
    const auto regular = result.all.size() - static_cast<std::size_t>(result.irregular);
    if (static_cast<std::int64_t>(regular) < fewestRevolutions) throw tooFew(regular);
    return result;
}

}  // namespace lathelier::trajectory
