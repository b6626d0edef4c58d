// Where the programs of a plan are written.
#pragma once

#include <string>
#include <vector>

#include "engine/cam/plan.h"
#include "engine/core/input_file.h"

namespace lathelier::cam {

/// One path for each program: the stated one, or of two clampings "p_1.nc" and "p_2.nc" where "p.nc" is stated.
std::vector<std::string> programPaths(const std::string& stated, std::size_t count);

/// Error outputIsInput, naming `parameter`, where one of the files is an input.
void refuseInputs(const std::vector<std::string>& paths, const std::vector<InputFile>& inputs,
                  const std::string& parameter);

/// All programs or none: where the second cannot be written, the first is as it was. Precondition: a path for each
/// set-up. Error fileNotWritable.
void writePrograms(const TurningPlan& plan, const std::vector<std::string>& paths);

/// Refused programs beside the paths they are planned for, as stoppedText(); what stands there is replaced. Error
/// fileNotWritable.
void writeRefused(const TurningPlan& plan, const std::vector<std::string>& paths);

}  // namespace lathelier::cam
