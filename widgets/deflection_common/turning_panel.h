// Common base of the panels of the question Deflection: programs with set-ups as inputs of a task.
#pragma once

#include "engine/deflection/deflection_task.h"
#include "engine/gcode/program_input.h"
#include "widgets/core/panel/task_panel.h"

namespace lathelier::deflection_common {

/// Facts common to the panels: they share a state and a question, and open by programs and set-ups.
PanelFacts turningFacts(PanelFacts facts);

/// Reads the facts of the program where it is a file; a file that is refused has none.
void readProgramFacts(const project::PanelState& state, Stores& stores, const Progress& progress);

/// Facts of the file of an input, in the user's language; empty when it was not read.
QString understoodTurning(const std::string& role, const project::Source& source, Stores& stores);

template <class R>
class TurningPanel : public TaskPanel<R> {
public:
    using TaskPanel<R>::TaskPanel;

protected:
    typename Panel<R>::Compute compute(const project::PanelState& state) const override
    {
        return [state, answer = TaskPanel<R>::compute(state),
                stores = this->session().sharedStores()](const Progress& progress) {
            readProgramFacts(state, *stores, progress.part(0, 0.1, LT_TEXT("Engine", "Reading")));
            return answer(progress.part(0.1, 1));
        };
    }
    Worker::Job makeReadingJob(const project::PanelState& state) const override
    {
        return [state, read = TaskPanel<R>::makeReadingJob(state),
                stores = this->session().sharedStores()](const Progress& progress) {
            readProgramFacts(state, *stores, progress.part(0, 0.5, LT_TEXT("Engine", "Reading")));
            return read(progress.part(0.5, 1));
        };
    }
    QString understood(const InputRole& role, const project::Source& source) const override
    {
        return understoodTurning(role.role, source, this->session().stores());
    }
};

}  // namespace lathelier::deflection_common
