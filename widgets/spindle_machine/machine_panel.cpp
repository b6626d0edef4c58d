#include "widgets/spindle_machine/machine_panel.h"

#include "engine/receptance/spindle/spindle_item.h"
#include "widgets/core/form/input_box.h"
#include "widgets/core/form/input_column.h"
#include "widgets/core/session.h"
#include "widgets/spindle_machine/machine_views.h"

namespace lathelier::machine_panel {
namespace {

using receptance::measurementsRole;
using receptance::sourceKey;
using receptance::SpindleOutcome;

const std::vector<std::string> roles{measurementsRole};

PanelInputs panelInputs()
{
    PanelInputs inputs = inputsOf(
        receptance::spindleTask(), roles, {}, false,
        LT_TEXT("Engine", "Drop tap tests on rods here (MEASUREMENTS.json), or choose springs or a known machine."));
    inputs.fields = receptance::spindleTask().fields;
    inputs.roles.front().takes_next = true;
    return inputs;
}

bool isThere(const project::PanelState& state)
{
    const Value* const source = find(state.parameters, sourceKey);
    const bool is_measured = !source || *source == Value(std::string(receptance::measuredSource));
    return !is_measured || state.inputs.count(measurementsRole) > 0;
}

}  // namespace

PanelFacts machinePanelFacts()
{
    PanelFacts facts = factsOf(receptance::spindleTask(), "spindle", "spindle", roles, {});
    facts.answer = answeredBy(receptance::answerSpindle);
    facts.make = [](Session& session) -> PanelBase* { return new MachinePanel(session); };
    facts.missing = [](const project::PanelState& state) {
        return isThere(state) ? std::vector<Text>{} : std::vector<Text>{LT_TEXT("Engine", "Tap tests or springs")};
    };
    facts.has_work = isThere;
    return facts;
}

MachinePanel::MachinePanel(Session& owner, QWidget* parent)
    : TaskPanel(owner, machinePanelFacts(), panelInputs(), parent), views_(new MachineViews)
{
    setViews(views_, views_->primaryViews());
    connect(views_, &MachineViews::spindleRequested, this, [this] { offer(receptance::spindleItem); });
    connect(views_, &MachineViews::notWritten, this, &MachinePanel::reportWriteFailure);
}

/// Opening tap tests selects them as the source.
void MachinePanel::assignFiles(project::PanelState& state, const std::vector<FoundFile>& files) const
{
    if (files.empty()) return;
    state.inputs[measurementsRole] = newSource(QString::fromStdString(files.front().path));
    lathelier::set(state.parameters, sourceKey, std::string(receptance::measuredSource));
}

Worker::Job MachinePanel::makeReadingJob(const project::PanelState&) const
{
    return [](const Progress&) -> std::shared_ptr<const void> { return nullptr; };  // nothing to read in advance
}

QString MachinePanel::understood(const InputRole&, const project::Source& source) const
{
    const auto loaded = session().stores().of<task::CacheOf<receptance::MeasurementsInput>>()->known(source);
    if (!loaded) return {};
    const receptance::SpindleMeasurements& measured = loaded->file.measurements;
    return understoodText(loaded->file.facts,
                          tr("%L1 rods, %L2 responses").arg(measured.rods.size()).arg(measured.frfs.size()));
}

void MachinePanel::showResult(const std::shared_ptr<const SpindleOutcome>& outcome)
{
    views_->setOutcome(outcome);
}

void MachinePanel::setPresenting(bool presenting)
{
    Panel::setPresenting(presenting);
    views_->setPresenting(presenting);
}

void MachinePanel::retranslate()
{
    views_->retranslate();
}

}  // namespace lathelier::machine_panel
