// A place of a part: one panel's question, as the walk asks it.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "engine/task/task.h"

namespace lathelier::walk {

/// An answer as the panel of its place shows it.
struct PlaceAnswer {
    std::shared_ptr<const void> value;  ///< the typed outcome of the panel
    task::Outcome outcome;
    bool is_synthetic = false;  ///< an input is marked as synthetic
};

struct Place {
    std::string id;          ///< of the panel
    std::string state;       ///< key of its state in the project; several places may share one
    Text title;              ///< shown name
    const task::Task* task;  ///< its inputs and products
    Values begins_with;      ///< values in place of the task's defaults

    std::vector<std::string> gives;  ///< kinds of its products that later places take
    /// Whether it gives them in this state; none: whenever it can be answered.
    std::function<bool(const project::PanelState&)> may_give;
    std::vector<std::string> fills;  ///< roles that are filled although the task can do without them
    std::string speeds;              ///< key of the field that is filled with the speeds of that job; empty: none
    bool takes_held = false;         ///< a part is taken as it is held: with the rest of its bar, up to the chuck

    /// Missing inputs of a state; empty: it can be answered.
    std::function<std::vector<Text>(const project::PanelState&)> missing;

    /// Answers a completed state. `sources` has the notes of what was filled in. Errors of the task. Throws Cancelled.
    std::function<PlaceAnswer(const project::PanelState&, Stores&, task::Sources& sources, const Progress&)> answer;
};

}  // namespace lathelier::walk
