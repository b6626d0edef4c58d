#include "engine/sample/sample_record.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <numbers>

#include "engine/core/random.h"

namespace lathelier::sample {
namespace {

using std::numbers::pi;

constexpr double markerLow_V = 0.05;
constexpr double markerHigh_V = 3.5;
constexpr double pulseTurns = 0.05;  ///< length of the marker's pulse
constexpr double whirlRatio = 0.43;  ///< of an oil film, about

/// Streams of random numbers, so that the effects are independent of each other.
enum RecordStream : std::uint64_t { MarkerNoise, AxisNoise, ToolNoise = AxisNoise + 2, Averages = ToolNoise + 2 };

struct Displacements {
    double X3 = 0, Y3 = 0, Xp = 0, Yp = 0;
};

void add(const std::vector<MotionWave>& waves, double turn, double& x, double& y)
{
    for (const MotionWave& wave : waves) {
        x += wave.x_um * std::cos(2 * pi * wave.upr * turn - wave.x_phase_rad);
        y += wave.y_um * std::cos(2 * pi * wave.upr * turn - wave.y_phase_rad);
    }
}

/// Deviation of the radius at z: a parabola over the middles of the sections.
double radius_um(const SpindleModel& model, double z_mm)
{
    const double first = sectionMiddle_mm(model, 0);
    const double last = sectionMiddle_mm(model, model.sections - 1);
    const double u = last > first ? (2 * z_mm - first - last) / (last - first) : 0;
    return model.taper_diameter_um / 4 * u - model.barrel_um * u * u;
}

/// Motions without anything random; turns count from the first mark.
Displacements steady(const SpindleModel& model, double turn)
{
    Displacements d;
    add(model.axis, turn, d.X3, d.Y3);
    add(model.tool, turn, d.Xp, d.Yp);
    d.Xp += radius_um(model, model.feed_mm_rev * turn);
    return d;
}

/// Mean over the revolutions of a section at one angle (in turns).
Displacements meanOf(const SpindleModel& model, int section, double turn)
{
    Displacements sum;
    for (int k = 0; k < model.revolutions; ++k) {
        const Displacements d = steady(model, section * model.revolutions + k + turn);
        sum.X3 += d.X3 / model.revolutions;
        sum.Y3 += d.Y3 / model.revolutions;
        sum.Xp += d.Xp / model.revolutions;
        sum.Yp += d.Yp / model.revolutions;
    }
    return sum;
}

/// Pulse with straight edges, as a slot gives that is wide against the sensor; its leading edge is half up at angle 0.
double marker_V(double turn, double edgeTurns)
{
    const double within = turn - std::floor(turn + 0.5);  // -0.5…0.5 about the mark
    const double up = std::clamp(0.5 + within / edgeTurns, 0.0, 1.0);
    const double down = std::clamp(0.5 + (within - pulseTurns) / edgeTurns, 0.0, 1.0);
    return markerLow_V + (markerHigh_V - markerLow_V) * (up - down);
}

double rounded(double value, double resolution)
{
    return resolution > 0 ? std::round(value / resolution) * resolution : value;
}

/// Header as in a file: all values as text.
Values headerOf(const SpindleModel& model)
{
    const auto number = [](double value) { return fmt::format("{}", value); };
    return {{"synthetic", "true"},
            {"made_by", "Lathelier, not a measurement"},
            {"D_mm", number(model.workpiece_diameter_mm)},
            {"rpm_nominal", number(model.speed_rpm)},
            {"n_rev", number(model.revolutions)},
            {"sections", number(model.sections)},
            {"feed_mm_rev", number(model.feed_mm_rev)},
            {"depth_mm", "0.5"},
            {"workpiece", "shaft D50 of steel C45"},
            {"tool", "DNMG 150608 with 0.8 mm radius"}};
}

}  // namespace

SpindleModel quietSpindle()
{
    SpindleModel model;
    model.axis = {{1, 12.0, 0.3, 11.2, 1.9},
                  {2, 1.4, 0.8, 1.1, 2.1},
                  {3, 0.8, -0.4, 0.9, 1.0},
                  {5, 0.4, 1.2, 0.3, 0.2},
                  {9, 0.15, 0.5, 0.2, -1.0}};
    model.tool = {{0, -1.0, 0, 4.0, 0}, {2, 0.9, 2.6, 0.5, 0.4}, {4, 0.5, -0.9, 0.3, 0.7}, {7, 0.3, 1.7, 0.2, 2.9}};
    model.axis_noise_um = 0;
    model.tool_noise_um = 0;
    model.whirl_um = 0;
    model.resolution_um = 0;
    model.marker_noise_V = 0;
    return model;
}

SpindleModel sampleSpindle()
{
    const SpindleModel standard;
    SpindleModel model = quietSpindle();
    model.axis_noise_um = standard.axis_noise_um;
    model.tool_noise_um = standard.tool_noise_um;
    model.whirl_um = standard.whirl_um;
    model.resolution_um = standard.resolution_um;
    model.marker_noise_V = standard.marker_noise_V;
    return model;
}

double sectionMiddle_mm(const SpindleModel& model, int section)
{
    return model.feed_mm_rev * (section + 0.5) * model.revolutions;
}

io::ProbeRecord makeProbeRecord(const SpindleModel& model)
{
    const double turns_per_s = model.speed_rpm / 60;
    const double turns = model.sections * model.revolutions + 2 * model.lead_turns;
    const auto frames = static_cast<std::size_t>(turns / turns_per_s * model.rate_hz);
    const double edgeTurns = 2.5 * turns_per_s / model.rate_hz;  // two frames see every edge
    io::ProbeRecord record;
    record.name = "probe_record.csv";
    record.rate_hz = model.rate_hz;
    record.channel_skew_s = model.channel_skew_s;
    record.header = headerOf(model);
    record.channels = {{"marker", io::ProbeChannel::Unit::Volt, 1, {}},
                       {"X3", io::ProbeChannel::Unit::Micrometre, 1, {}},
                       {"Y3", io::ProbeChannel::Unit::Micrometre, 1, {}},
                       {"Xp", io::ProbeChannel::Unit::Micrometre, 1, {}},
                       {"Yp", io::ProbeChannel::Unit::Micrometre, 1, {}}};
    for (io::ProbeChannel& channel : record.channels) channel.values.resize(frames);
    record.time_s.resize(frames);
    const auto noise = [&](RecordStream stream, int which, std::size_t frame, double sigma) {
        return sigma > 0 ? sigma * randomNormal(model.seed, stream + static_cast<std::uint64_t>(which), frame) : 0;
    };
    for (std::size_t i = 0; i < frames; ++i) {
        record.time_s[i] = static_cast<double>(i) / model.rate_hz;
        const auto turnOf = [&](int channel) {
            return turns_per_s * (record.time_s[i] + channel * model.channel_skew_s) - model.lead_turns;
        };
        const double whirl = 2 * pi * whirlRatio;
        const double drift = model.drift_um_per_rev;
        record.channels[0].values[i] = marker_V(turnOf(0), edgeTurns) + noise(MarkerNoise, 0, i, model.marker_noise_V);
        const std::array<double, 4> um{
            steady(model, turnOf(1)).X3 + model.whirl_um * std::cos(whirl * turnOf(1)) + drift * turnOf(1) +
                noise(AxisNoise, 0, i, model.axis_noise_um),
            steady(model, turnOf(2)).Y3 + model.whirl_um * std::sin(whirl * turnOf(2)) +
                noise(AxisNoise, 1, i, model.axis_noise_um),
            steady(model, turnOf(3)).Xp + noise(ToolNoise, 0, i, model.tool_noise_um),
            steady(model, turnOf(4)).Yp + drift * turnOf(4) + noise(ToolNoise, 1, i, model.tool_noise_um)};
        for (std::size_t probe = 0; probe < um.size(); ++probe)
            record.channels[probe + 1].values[i] = rounded(um[probe], model.resolution_um);
    }
    return record;
}

io::AveragedRecord makeAveragedRecord(const SpindleModel& model, int points)
{
    io::AveragedRecord record;
    record.name = "averaged.csv";
    record.header = headerOf(model);
    std::uint64_t draw = 0;
    for (int s = 0; s < model.sections; ++s) {
        io::AveragedSection section;
        section.section = s + 1;
        section.z_mm = sectionMiddle_mm(model, s);
        for (int i = 0; i < points; ++i) {
            const double turn = static_cast<double>(i) / points;
            const Displacements mean = meanOf(model, s, turn);
            const double axis_um = std::hypot(model.axis_noise_um, model.whirl_um / std::numbers::sqrt2);
            const auto scattered = [&](double value, double sigma) {
                return rounded(
                    value + sigma / std::sqrt(model.revolutions) * randomNormal(model.seed, Averages, draw++),
                    model.resolution_um);
            };
            section.angle_deg.push_back(360 * turn);
            section.X3_um.push_back(scattered(mean.X3, axis_um));
            section.Y3_um.push_back(scattered(mean.Y3, axis_um));
            section.Xp_um.push_back(scattered(mean.Xp, model.tool_noise_um));
            section.Yp_um.push_back(scattered(mean.Yp, model.tool_noise_um));
            section.sX3_um.push_back(axis_um);
            section.sY3_um.push_back(axis_um);
            section.sXp_um.push_back(model.tool_noise_um);
            section.sYp_um.push_back(model.tool_noise_um);
        }
        record.sections.push_back(std::move(section));
    }
    return record;
}

std::vector<Eigen::Vector2d> trueImage_mm(const SpindleModel& model, int section, int points)
{
    // The vector from axis to tool, turned back with the spindle; mirrored, for the angle counts as recorded.
    std::vector<Eigen::Vector2d> image;
    for (int i = 0; i < points; ++i) {
        const double turn = static_cast<double>(i) / points;
        const Displacements d = meanOf(model, section, turn);
        const std::complex<double> tool(model.workpiece_diameter_mm / 2 + 1e-3 * d.Xp, 1e-3 * d.Yp);
        const std::complex<double> axis(1e-3 * d.X3, 1e-3 * d.Y3);
        const std::complex<double> point = std::conj(tool - axis) * std::polar(1.0, 2 * pi * turn);
        image.emplace_back(point.real(), point.imag());
    }
    return image;
}

}  // namespace lathelier::sample
