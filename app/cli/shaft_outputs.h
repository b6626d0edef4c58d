// The files that are made of a shaft: the shaft itself, stock, CAD, drawings.
#pragma once

#include "app/cli/verb.h"
#include "engine/core/input_file.h"
#include "engine/shaft/shaft.h"

namespace lathelier::cli {

/// Options that name these files.
std::vector<OutputOption> shaftOutputs();

/// How they are written: schema of STEP, contour or drawing as DXF.
std::vector<Option> cadOptions();

/// Further content of the files.
struct ShaftToWrite {
    const Shaft& shaft;
    bool complete = true;                ///< false: only the shaft itself is written, the others are refused
    Text missing = {};                   ///< reason why it is not complete
    double chucked_mm = 0;               ///< of its end: not in the stock file
    std::optional<InputFile> scan = {};  ///< that it was recovered from; none: it is a design
    bool measured = false;               ///< its sizes were measured
    std::vector<SizeUncertainty> uncertainties = {};                    ///< of its rows
    std::vector<std::vector<SizeUncertainty>> bore_uncertainties = {};  ///< of its bores' rows
};

/// Writes those that were asked for, the shaft first. Errors shaftIncomplete, those of checkShaft() and of the writers.
void writeShaftOutputs(const Request& request, const ShaftToWrite& asked, const Progress& progress, Answer& answer);

}  // namespace lathelier::cli
