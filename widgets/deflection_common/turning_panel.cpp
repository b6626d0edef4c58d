#include "widgets/deflection_common/turning_panel.h"

#include "widgets/core/language.h"
#include "widgets/core/session.h"
#include "widgets/deflection_common/deflection_inputs.h"

namespace lathelier::deflection_common {

TurningPanel::TurningPanel(Session& owner, const PanelFacts& facts, const PanelInputs& inputs, Wanted wanted,
                           QWidget* parent)
    : Panel(owner, facts, inputs, parent), wanted_(wanted)
{
}

TurningPanel::Compute TurningPanel::compute(const project::PanelState& state) const
{
    fromValues<DeflectionQuestion>(state.parameters);  // refuses now what is out of range
    return [state, wanted = wanted_, stores = session().sharedStores()](const Progress& progress) {
        return deflectionPicture(state, wanted, *stores, progress);
    };
}

report::Document TurningPanel::document(const DeflectionPicture& picture) const
{
    return reportOf(picture, screenLanguage());
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
