// The job of the panel's form in the state of the panel, beside the file that it was changed from.
#pragma once

#include <string>
#include <vector>

#include "engine/cam/task/turn_question.h"

namespace lathelier::turning_panel {

/// Whether this is the key of a field of the job.
bool isOfJob(const std::string& key);

/// Whether the form has precedence over the file.
bool formRules(const project::PanelState& state);

/// Stores the job in the form, assigned to the present file.
void setJob(project::PanelState& state, const Values& job);

/// Clears the form when a file is opened, which it would override.
void openJob(project::PanelState& state, const std::string& path);

/// Whether there is a job, and a part or a file that may contain one.
std::vector<Text> missingInputs(const project::PanelState& state);

}  // namespace lathelier::turning_panel
