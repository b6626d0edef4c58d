// Common inputs and facts of the panels of the workspace Deflection.
#pragma once

#include <QString>

#include "engine/project/project.h"
#include "widgets/core/files/kind_finder.h"
#include "widgets/core/panel/panel_facts.h"
#include "widgets/core/task/worker.h"
#include "widgets/deflection_common/deflection_outcome.h"

namespace lathelier::deflection_common {

/// Program, set-up, stock. `unfolded`: keys of the unfolded fields, in order; the others are folded.
PanelInputs deflectionInputs(const std::vector<std::string>& unfolded, Text invitation);

/// For the panel Program: requires only a program, with these fields.
PanelInputs programInputs(const std::vector<std::string>& keys, Text invitation);

/// Facts common to the three panels.
PanelFacts turningFacts(const char* id, Text title, const char* icon);

/// Of a panel that predicts: all but `make`.
PanelFacts deflectionFacts(const char* id, Text title, const char* icon, StudyKind studyKind);

/// Assigns files to the inputs by kind.
void assignTurningFiles(project::PanelState& state, const std::vector<FoundFile>& files);

/// Reads the given inputs of an incomplete state.
Worker::Job readingJob(const project::PanelState& state, std::shared_ptr<Stores> stores);

/// Facts of the file of an input, in the user's language; empty when it was not read.
QString understoodTurning(const std::string& role, const project::Source& source, Stores& stores);

}  // namespace lathelier::deflection_common
