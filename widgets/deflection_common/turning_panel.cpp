#include "widgets/deflection_common/turning_panel.h"

#include "widgets/core/language.h"
#include "widgets/core/session.h"
#include "widgets/deflection_common/deflection_inputs.h"

namespace lathelier::deflection_common {

TurningPanel::TurningPanel(Session& owner, const PanelFacts& facts, const PanelInputs& inputs, StudyKind studyKind,
                           QWidget* parent)
    : Panel(owner, facts, inputs, parent), studyKind_(studyKind)
{
}

TurningPanel::Compute TurningPanel::compute(const project::PanelState& state) const
{
    fromValues<DeflectionQuestion>(state.parameters);  // validates ranges before the computation
    return [state, studyKind = studyKind_, stores = session().sharedStores()](const Progress& progress) {
        return deflectionOutcome(state, studyKind, *stores, progress);
    };
}

report::Document TurningPanel::document(const DeflectionOutcome& outcome) const
{
    return reportOf(outcome, screenLanguage());
}

void TurningPanel::assignFiles(project::PanelState& state, const std::vector<FoundFile>& files) const
{
    assignTurningFiles(state, files);
}

QString TurningPanel::understood(const InputRole& role, const project::Source& source) const
{
    return understoodTurning(role.role, source, session().stores());
}

Worker::Job TurningPanel::makeReadingJob(const project::PanelState& state) const
{
    return readingJob(state, session().sharedStores());
}

}  // namespace lathelier::deflection_common
