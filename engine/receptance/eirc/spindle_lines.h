// Measurements by frequency line: measured receptances with weights, and the receptances of the free rods.
#pragma once

#include <vector>

#include "engine/beam/beam_section.h"
#include "engine/core/progress.h"
#include "engine/core/used_value.h"
#include "engine/receptance/eirc/spindle_line.h"
#include "engine/receptance/eirc/spindle_noise.h"

namespace lathelier::receptance {

/// All lines of all responses, in the order of SpindleMeasurements::frfs.
struct SpindleLines {
    std::vector<double> frequency_hz;  ///< of each line, above 0
    std::vector<SpindleLine> lines;    ///< of all rods, including the held-out one
    std::vector<SpindleLine> bare;     ///< the same rods without accelerometers, for the linear start; empty: `lines`
};

/// Errors of identifySpindle() for rods, points and responses that do not fit together.
void checkMeasurements(const SpindleMeasurements& measurements);

/// An accelerometer of mass m at point a is part of the free rod: Hb_pq + Hb_pa ω²m Hb_aq / (1 - ω²m Hb_aa), since it
/// also moves where force and motion of another pair are measured. Weights: 1/σ of `noise`.
/// Errors, materials and notes: see identifySpindle(). Precondition: checkMeasurements().
SpindleLines spindleLines(const SpindleMeasurements& measurements, const SpindleNoise& noise, beam::ShearModel shear,
                          UsedValues& used, Notes& notes, const Progress& progress);

/// A line of a measured response as receptance, mm/N.
Complex measuredReceptance(const Frf& frf, std::size_t line);

}  // namespace lathelier::receptance
