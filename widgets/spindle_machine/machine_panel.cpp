#include "widgets/spindle_machine/machine_panel.h"

#include <QFileInfo>

#include "engine/io/file.h"
#include "engine/receptance/spindle_file.h"
#include "engine/receptance/spindle_item.h"
#include "engine/receptance/spindle_kind.h"
#include "engine/receptance/spindle_plots.h"
#include "engine/report/chart_csv.h"
#include "widgets/core/form/input_box.h"
#include "widgets/core/form/input_column.h"
#include "widgets/core/language.h"
#include "widgets/core/session.h"
#include "widgets/spindle_machine/machine_views.h"

namespace lathelier::machine_panel {
namespace {

PanelInputs panelInputs()
{
    InputRole tests;
    tests.role = measurementsRole;
    tests.label = LT_TEXT("Engine", "Tap tests");
    tests.hint = LT_TEXT("Engine", "MEASUREMENTS.json, with the file of frequency responses beside it");
    tests.kinds = {&receptance::measurementFiles()};
    tests.required = false;
    tests.takes_next = true;
    PanelInputs inputs;
    inputs.roles = {tests};
    inputs.fields = infos<MachineQuestion>();
    inputs.defaults = toValues(MachineQuestion{});
    inputs.invitation =
        LT_TEXT("Engine", "Drop tap tests on rods here (MEASUREMENTS.json), or choose springs or a known machine.");
    return inputs;
}

bool isMeasured(const project::PanelState& state)
{
    const Value* const source = find(state.parameters, sourceKey);
    return !source || *source == Value(std::string("measured"));
}

bool isThere(const project::PanelState& state)
{
    return !isMeasured(state) || state.inputs.count(measurementsRole) > 0;
}

}  // namespace

PanelFacts machinePanelFacts()
{
    PanelFacts facts;
    facts.id = "spindle";
    facts.title = LT_TEXT("Engine", "Spindle");
    facts.icon = "spindle";
    facts.workspaces = {workspaceOf("chatter")};
    facts.kinds = {&receptance::measurementFiles()};
    facts.roles = panelInputs().roles;
    facts.make = [](Session& session) -> PanelBase* { return new MachinePanel(session); };
    facts.missing = [](const project::PanelState& state) {
        return isThere(state) ? std::vector<Text>{} : std::vector<Text>{LT_TEXT("Engine", "Tap tests or springs")};
    };
    facts.has_work = isThere;
    facts.report = [](const project::PanelState& state, Stores& stores, const Language& language,
                      const Progress& progress) { return reportOf(machineOutcome(state, stores, progress), language); };
    return facts;
}

MachinePanel::MachinePanel(Session& owner, QWidget* parent)
    : Panel(owner, machinePanelFacts(), panelInputs(), parent), views_(new MachineViews)
{
    setViews(views_, views_->primaryViews());
    connect(views_, &MachineViews::spindleRequested, this, &MachinePanel::offerSpindle);
    connect(views_, &MachineViews::notWritten, this, &MachinePanel::reportWriteFailure);
}

void MachinePanel::offerSpindle()
{
    const auto outcome = result();
    if (!outcome) return;
    QString name = tr("spindle");
    if (!outcome->inputs.empty())
        name =
            tr("spindle of %1").arg(QFileInfo(QString::fromStdString(outcome->inputs.front().path)).completeBaseName());
    try {
        offerItem(name.toStdString(), receptance::spindleItem, receptance::toValues(outcome->spindle),
                  outcome->synthetic);
    } catch (const Error& error) {
        emit messageRaised({error, facts().title});
    }
}

/// Opening tap tests selects them as the source.
void MachinePanel::assignFiles(project::PanelState& state, const std::vector<FoundFile>& files) const
{
    if (files.empty()) return;
    state.inputs[measurementsRole] = newSource(QString::fromStdString(files.front().path));
    lathelier::set(state.parameters, sourceKey, std::string("measured"));
}

MachinePanel::Compute MachinePanel::compute(const project::PanelState& state) const
{
    fromValues<MachineQuestion>(state.parameters);  // validates ranges before the computation
    return [state, stores = session().sharedStores()](const Progress& progress) {
        return machineOutcome(state, *stores, progress);
    };
}

Worker::Job MachinePanel::makeReadingJob(const project::PanelState&) const
{
    return [](const Progress&) -> std::shared_ptr<const void> { return nullptr; };  // nothing to read in advance
}

QString MachinePanel::understood(const InputRole&, const project::Source& source) const
{
    const auto loaded = session().stores().of<MeasurementStore>()->known(source);
    if (!loaded) return {};
    const receptance::SpindleMeasurements& measured = loaded->file.measurements;
    return understoodText(loaded->file.facts,
                          tr("%L1 rods, %L2 responses").arg(measured.rods.size()).arg(measured.frfs.size()));
}

void MachinePanel::showResult(const std::shared_ptr<const MachineOutcome>& outcome)
{
    views_->setOutcome(outcome);
}

report::Answer MachinePanel::answer(const MachineOutcome& outcome) const
{
    return machine_panel::answer(outcome, screenLanguage());
}

Notes MachinePanel::notes(const MachineOutcome& outcome) const
{
    return outcome.notes;
}

report::Document MachinePanel::document(const MachineOutcome& outcome) const
{
    return reportOf(outcome, screenLanguage());
}

std::vector<PanelExport> MachinePanel::exports() const
{
    const auto outcome = result();
    if (!outcome) return {};
    return {{tr("Spindle (SPINDLE.json)…"), tr("JSON (*.json)"), "json",
             [outcome](const QString& path) {
                 io::writeFile(path.toStdString(), receptance::spindleText(outcome->spindle));
             }},
            {tr("Magnitude over frequency (CSV)…"), tr("Table (*.csv)"), "csv", [outcome](const QString& path) {
                 io::writeFile(path.toStdString(), report::toCsv(receptance::spindleMagnitudePlot(outcome->spindle)));
             }}};
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
