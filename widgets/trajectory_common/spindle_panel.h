// Common base of the three panels of Roundness: their state, the files dropped on them, one chosen
// section and one marked angle.
#pragma once

#include "engine/trajectory/task/record_evaluation.h"
#include "widgets/core/panel/task_panel.h"
#include "widgets/trajectory_common/marked_angle.h"

namespace lathelier::trajectory_common {

/// Facts common to the panels: they share one state, and a recipe excludes their files.
PanelFacts spindleFacts(PanelFacts facts);

/// The left column: `plain` fields, then the `folded` ones.
PanelInputs spindleInputs(const task::Task& task, const std::vector<InputRole>& roles,
                          const std::vector<std::string>& plain, const std::vector<std::string>& folded,
                          Text invitation);

/// Records go to the record; other files are profiles: the first one is the profile, a second one the trace. Without
/// `profiles` all files are records, whose reader refuses what is none.
void assignSpindleFiles(project::PanelState& state, const std::vector<FoundFile>& files, bool profiles);

/// Facts of the file of an input, in the user's language; empty when it was not read.
QString understoodSpindle(const std::string& role, const project::Source& source, Stores& stores);

/// The step of the undo stack that chooses this section; none: the worst one.
QString chooseSectionStep(std::optional<int> section);

bool isSectionChosen(const project::PanelState& state);

/// R: the typed outcome of a task of Roundness.
template <class R>
class SpindlePanel : public TaskPanel<R> {
public:
    using TaskPanel<R>::TaskPanel;

    /// The section with this number for all panels of Roundness; none: the worst one. One undo step for a row of
    /// such choices.
    void chooseSection(std::optional<int> section)
    {
        this->editState(
            chooseSectionStep(section),
            [&](project::PanelState& state) {
                lathelier::set(state.parameters, trajectory::sectionKey,
                               section ? Value(std::int64_t{*section}) : Value());
            },
            QStringLiteral("roundness/section"));
    }
    bool isSectionChosen() const { return trajectory_common::isSectionChosen(this->state()); }

protected:
    MarkedAngle& markedAngle() const { return *this->session().stores().template of<MarkedAngle>(); }
    void assignFiles(project::PanelState& state, const std::vector<FoundFile>& files) const override
    {
        assignSpindleFiles(state, files, this->inputs().roles.size() > 1);
    }
    QString understood(const InputRole& role, const project::Source& source) const override
    {
        return understoodSpindle(role.role, source, this->session().stores());
    }
};

}  // namespace lathelier::trajectory_common
