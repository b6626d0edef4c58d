// What must hold for any machine: the truth comes back, wherever the recording starts and whichever way it is cabled.
#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <Eigen/QR>
#include <algorithm>
#include <numbers>

#include "engine/core/random.h"
#include "tests/engine/trajectory/truth.h"

namespace lathelier::trajectory {
namespace {

/// A machine without noise: any speed, motions of up to 12 waves a turn, any taper and barrel, at least 100 frames a
/// turn, a converter that samples one channel after the other or all at once.
sample::SpindleModel anyMachine()
{
    sample::SpindleModel model = sample::quietSpindle();
    const auto seed = static_cast<std::uint64_t>(*rc::gen::inRange(1, 1000000));
    std::uint64_t draw = 0;
    const auto any = [&](double from, double to) { return from + (to - from) * randomUniform(seed, 1, ++draw); };
    model.seed = seed;
    model.speed_rpm = any(60, 4000);
    model.rate_hz = any(100, 200) * model.speed_rpm / 60;
    model.channel_skew_s = *rc::gen::element(0.0, 1.0) / (5 * model.rate_hz);
    model.sections = *rc::gen::inRange(3, 5);
    model.revolutions = *rc::gen::inRange(3, 6);
    model.lead_turns = any(0.05, 0.95);
    model.workpiece_diameter_mm = any(5, 200);
    model.feed_mm_rev = any(0.02, 1);
    model.taper_diameter_um = any(-30, 30);
    model.barrel_um = any(-15, 15);
    const auto waves = [&](double largest_um) {
        std::vector<sample::MotionWave> result;
        for (const int upr : {1, 2, 3, 5, 12})
            result.push_back({upr, any(0, largest_um) / upr, any(0, 2 * std::numbers::pi), any(0, largest_um) / upr,
                              any(0, 2 * std::numbers::pi)});
        return result;
    };
    model.axis = waves(15);
    model.tool = waves(4);
    return model;
}

TrajectoryParameters parametersFor(const sample::SpindleModel& model)
{
    TrajectoryParameters parameters;
    parameters.revolutions = model.revolutions;
    return parameters;
}

RC_GTEST_PROP(TrajectoryProperty, TheTruthOfAnyMachineComesBack, ())
{
    const sample::SpindleModel model = anyMachine();
    const TrajectoryResult result = trajectory({fileOf(sample::makeProbeRecord(model))}, parametersFor(model));
    RC_ASSERT(result.sections.size() == static_cast<std::size_t>(model.sections));
    for (int s = 0; s < model.sections; ++s)
        RC_ASSERT(worstDifference_um(result.sections[static_cast<std::size_t>(s)], model, s) <= 0.05);
    // The line and the parabola through the radii of the true images.
    Eigen::MatrixX3d rows(model.sections, 3);
    Eigen::VectorXd radius_um(model.sections);
    for (int s = 0; s < model.sections; ++s) {
        const double u = 2.0 * s / (model.sections - 1) - 1;
        rows.row(s) << 1, u, u * u;
        radius_um[s] = form::fitCircles(sample::trueImage_mm(model, s)).LSCI.radius_mm * 1e3;
    }
    const Eigen::Vector3d fit = rows.colPivHouseholderQr().solve(radius_um);
    RC_ASSERT(result.longitudinal);
    RC_ASSERT(std::abs(result.longitudinal->taper_diameter_um - 4 * fit[1]) <= 0.02);
    RC_ASSERT(std::abs(result.longitudinal->barrel_um + fit[2]) <= 0.02);
}

RC_GTEST_PROP(TrajectoryProperty, CablesMayGoAnywhere, ())
{
    sample::SpindleModel model = anyMachine();
    model.channel_skew_s = 0;  // else the order is part of the measurement
    model.sections = 1;        // read frame by frame like any other
    const io::ProbeRecord record = sample::makeProbeRecord(model);
    const std::vector<std::size_t> order = *rc::gen::map(rc::gen::arbitrary<std::uint32_t>(), [&](std::uint32_t seed) {
        std::vector<std::size_t> places{0, 1, 2, 3, 4};
        for (std::size_t i = 4; i > 0; --i) std::swap(places[i], places[(seed >> (4 * i)) % (i + 1)]);
        return places;
    });
    io::ProbeRecord cabled = record;
    const char* const names[] = {"marker", "X3", "Y3", "Xp", "Yp"};
    TrajectoryParameters parameters = parametersFor(model);
    parameters.channels.clear();
    for (std::size_t place = 0; place < order.size(); ++place) {
        cabled.channels[place] = record.channels[order[place]];
        std::string number = std::to_string(place);
        if (place > 0) parameters.channels.append(",");
        parameters.channels.append(names[order[place]]).append("=").append(number);
        cabled.channels[place].name = std::move(number);
    }
    const TrajectoryResult plain = trajectory({fileOf(record)}, parametersFor(model));
    const TrajectoryResult other = trajectory({fileOf(cabled)}, parameters);
    for (std::size_t s = 0; s < plain.sections.size(); ++s)
        RC_ASSERT(other.sections[s].radius_mm == plain.sections[s].radius_mm);
}

RC_GTEST_PROP(TrajectoryProperty, FramesBeforeTheFirstMarkDoNotCount, ())
{
    sample::SpindleModel model = anyMachine();
    model.lead_turns = 0.9;
    model.sections = 1;
    io::ProbeRecord record = sample::makeProbeRecord(model);
    const TrajectoryResult whole = trajectory({fileOf(record)}, parametersFor(model));
    const auto dropped = static_cast<std::ptrdiff_t>(*rc::gen::inRange(1, 60));
    for (io::ProbeChannel& channel : record.channels)
        channel.values.erase(channel.values.begin(), channel.values.begin() + dropped);
    const auto frames = std::min(record.time_s.size(), static_cast<std::size_t>(dropped));
    record.time_s.erase(record.time_s.begin(), record.time_s.begin() + static_cast<std::ptrdiff_t>(frames));
    const TrajectoryResult rest = trajectory({fileOf(record)}, parametersFor(model));
    RC_ASSERT(rest.sections.size() == whole.sections.size());
    for (std::size_t s = 0; s < whole.sections.size(); ++s)
        RC_ASSERT(std::abs(rest.sections[s].roundness.circles.MZCI.RONt_um -
                           whole.sections[s].roundness.circles.MZCI.RONt_um) < 1e-3);
}

}  // namespace
}  // namespace lathelier::trajectory
