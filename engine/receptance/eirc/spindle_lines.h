// Measurements on rods turned into lines: measured receptances with weights beside the receptances of the free rods.
#pragma once

#include <vector>

#include "engine/core/progress.h"
#include "engine/receptance/eirc/identify_spindle.h"
#include "engine/receptance/eirc/spindle_line.h"

namespace lathelier::receptance {

/// All lines of all responses, in the order of SpindleMeasurements::frfs.
struct SpindleLines {
    std::vector<double> frequency_hz;  ///< of each line, above 0
    std::vector<SpindleLine> lines;    ///< with all rods, those held out too
};

/// Errors, materials and notes as identifySpindle() says.
SpindleLines spindleLines(const SpindleMeasurements& measurements, const IdentificationParameters& parameters,
                          UsedValues& used, Notes& notes, const Progress& progress);

/// The responses of one rod only (`keep` true), or of all others.
SpindleLine onlyRod(const SpindleLine& line, std::size_t rod, bool keep);

}  // namespace lathelier::receptance
