// The questions of the bar at the top: each a saved arrangement of panels.
#pragma once

#include <string>
#include <vector>

#include "widgets/core/panel/panel_facts.h"

namespace lathelier {

/// The questions that `panels` name, each once, in the order of the bar.
std::vector<Question> questionsOf(const std::vector<PanelFacts>& panels);

/// The question that a project opens with, by the key in its file: that of a workspace of version 5 and older where it
/// was one, the first where there is none of this id. Empty without questions.
std::string questionFor(const std::string& kept, const std::vector<Question>& questions);

}  // namespace lathelier
