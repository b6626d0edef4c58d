// Inputs and facts that the panels of the workspace Deflection have alike.
#pragma once

#include <QString>

#include "engine/project/project.h"
#include "widgets/core/files/kind_finder.h"
#include "widgets/core/panel/panel_facts.h"
#include "widgets/core/task/worker.h"
#include "widgets/deflection_common/deflection_picture.h"

namespace lathelier::deflection_common {

/// Program, set-up, stock. `unfolded`: keys of the fields that stand open, in order; the others are folded.
PanelInputs deflectionInputs(const std::vector<std::string>& unfolded, Text invitation);

/// Of the panel "Program": it needs no more than a program, and asks for these fields alone.
PanelInputs programInputs(const std::vector<std::string>& keys, Text invitation);

/// The facts that all three panels have alike.
PanelFacts turningFacts(const char* id, Text title, const char* icon);

/// Of a panel that predicts: all but `make`.
PanelFacts deflectionFacts(const char* id, Text title, const char* icon, Wanted wanted);

/// Gives files to the inputs of their kinds.
void assignTurningFiles(project::PanelState& state, const std::vector<FoundFile>& files);

/// Reads what is there of a state that is not complete.
Worker::Job readingJob(const project::PanelState& state, std::shared_ptr<Stores> stores);

/// What was understood of the file of an input, in the language of the screen; empty when it was not read.
QString understoodTurning(const std::string& role, const project::Source& source, Stores& stores);

}  // namespace lathelier::deflection_common
