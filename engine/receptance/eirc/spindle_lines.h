// Measurements by frequency line: measured receptances with weights, and the receptances of the free rods.
#pragma once

#include <vector>

#include "engine/core/progress.h"
#include "engine/receptance/eirc/identify_spindle.h"
#include "engine/receptance/eirc/spindle_line.h"

namespace lathelier::receptance {

/// All lines of all responses, in the order of SpindleMeasurements::frfs.
struct SpindleLines {
    std::vector<double> frequency_hz;  ///< of each line, above 0
    std::vector<SpindleLine> lines;    ///< of all rods, including the held-out one
};

/// Errors, materials and notes: see identifySpindle().
SpindleLines spindleLines(const SpindleMeasurements& measurements, const IdentificationParameters& parameters,
                          UsedValues& used, Notes& notes, const Progress& progress);

/// The responses of one rod only (`keep` true), or of all others.
SpindleLine onlyRod(const SpindleLine& line, std::size_t rod, bool keep);

}  // namespace lathelier::receptance
