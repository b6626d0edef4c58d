// Synthetic probe records with known truth: spindle error motion of a mandrel with its workpiece, tool vibration, four
// probes behind a multiplexed converter, a marker.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <string>
#include <vector>

#include "engine/io/probe/probe_record.h"

namespace lathelier::sample {

/// One wave of a motion: x = x_um cos(upr θ - x_phase_rad), y = y_um cos(upr θ - y_phase_rad).
struct MotionWave {
    int upr = 1;                       ///< undulations per revolution; 0: a constant offset
    double x_um = 0, x_phase_rad = 0;  ///< amplitude and phase in x
    double y_um = 0, y_phase_rad = 0;  ///< amplitude and phase in y
};

struct SpindleModel {
    double workpiece_diameter_mm = 50;
    double speed_rpm = 975;
    double feed_mm_rev = 0.125;                ///< along the workpiece, from its free end
    int sections = 20;                         ///< number of sections recorded one after the other
    int revolutions = 40;                      ///< of a section
    double lead_turns = 0.3;                   ///< before the first mark and after the last
    double rate_hz = 1625;                     ///< frames per second
    double channel_skew_s = 1 / (5 * 1625.0);  ///< from one channel to the next
    std::vector<MotionWave> axis;              ///< of the workpiece: X3, Y3
    std::vector<MotionWave> tool;              ///< Xp, Yp
    double taper_diameter_um = 16;             ///< over the sections' middles, + when the diameter grows with z
    double barrel_um = 5;                      ///< on radius
    double axis_noise_um = 0.4;                ///< standard deviation, every sample anew
    double tool_noise_um = 0.3;                ///< standard deviation, every sample of Xp and Yp anew
    double whirl_um = 0.8;                     ///< asynchronous whirl of the axis at 0.43 of the speed
    double drift_um_per_rev = 0;               ///< of X3 and Yp, upward
    double resolution_um = 0.001;              ///< 0: none
    double marker_noise_V = 0.01;              ///< on levels of 0.05 and 3.5 V
    std::uint64_t seed = 1;                    ///< of all random numbers
};

/// The practice model: eccentricity 12 µm, a few lobes, a tool motion of the same orders.
SpindleModel sampleSpindle();

/// The same without noise, whirl and rounding: expected results without random errors.
SpindleModel quietSpindle();

/// The whole recording: marker (V), X3, Y3, Xp, Yp (µm), with cutting data and "synthetic" in its header.
io::ProbeRecord makeProbeRecord(const SpindleModel& model);

/// Averages over the revolutions with the remaining scatter of the mean.
io::AveragedRecord makeAveragedRecord(const SpindleModel& model, int points = 200);

/// Middle of a section (from 0) along the workpiece, from the free end.
double sectionMiddle_mm(const SpindleModel& model, int section);

/// The true image of a section: mean motions without noise, drift and whirl, at `points` even angles of the spindle.
std::vector<Eigen::Vector2d> trueImage_mm(const SpindleModel& model, int section, int points = 200);

/// The records as text of the sample files.
std::string toCsv(const io::ProbeRecord& record);
std::string toCsv(const io::AveragedRecord& record);

}  // namespace lathelier::sample
