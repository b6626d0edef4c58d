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
    facts.workspaces = {{"chatter", LT_TEXT("Engine", "Chatter"), "chatter", 30}};
    facts.kinds = {&receptance::measurementFiles()};
    facts.roles = panelInputs().roles;
    facts.make = [](Session& session) -> PanelBase* { return new MachinePanel(session); };
    facts.missing = [](const project::PanelState& state) {
        return isThere(state) ? std::vector<Text>{} : std::vector<Text>{LT_TEXT("Engine", "Tap tests or springs")};
    };
    facts.hasWork = isThere;
    facts.report = [](const project::PanelState& state, Stores& stores, const Language& language,
                      const Progress& progress) { return reportOf(machinePicture(state, stores, progress), language); };
    return facts;
}

MachinePanel::MachinePanel(Session& owner, QWidget* parent)
    : Panel(owner, machinePanelFacts(), panelInputs(), parent), views_(new MachineViews)
{
    setViews(views_, views_->heroes());
    connect(views_, &MachineViews::spindleWanted, this, &MachinePanel::offerSpindle);
    connect(views_, &MachineViews::notWritten, this, &MachinePanel::sayNotWritten);
}

void MachinePanel::offerSpindle()
{
    const auto picture = result();
    if (!picture) return;
    QString name = tr("spindle");
    if (!picture->inputs.empty())
        name =
            tr("spindle of %1").arg(QFileInfo(QString::fromStdString(picture->inputs.front().path)).completeBaseName());
    try {
        offerItem(name.toStdString(), receptance::spindleItem, receptance::toValues(picture->spindle),
                  picture->synthetic);
    } catch (const Error& error) {
        emit messageRaised({error, facts().title});
    }
}

/// Tap tests that are opened are what is meant, whatever machine was chosen before.
void MachinePanel::assignFiles(project::PanelState& state, const std::vector<FoundFile>& files) const
{
    if (files.empty()) return;
    state.inputs[measurementsRole] = newSource(QString::fromStdString(files.front().path));
    lathelier::set(state.parameters, sourceKey, std::string("measured"));
}

MachinePanel::Compute MachinePanel::compute(const project::PanelState& state) const
{
    fromValues<MachineQuestion>(state.parameters);  // refuses now what is out of range
    return [state, stores = session().sharedStores()](const Progress& progress) {
        return machinePicture(state, *stores, progress);
    };
}

Worker::Job MachinePanel::makeReadingJob(const project::PanelState&) const
{
    return [](const Progress&) -> std::shared_ptr<const void> { return nullptr; };  // what is there is computed
}

QString MachinePanel::understood(const InputRole&, const project::Source& source) const
{
    const auto loaded = session().stores().of<MeasurementStore>()->known(source);
    if (!loaded) return {};
    const receptance::SpindleMeasurements& measured = loaded->file.measurements;
    return understoodText(loaded->file.facts,
                          tr("%L1 rods, %L2 responses").arg(measured.rods.size()).arg(measured.frfs.size()));
}

void MachinePanel::showResult(const std::shared_ptr<const MachinePicture>& picture)
{
    views_->setPicture(picture);
}

report::Answer MachinePanel::answer(const MachinePicture& picture) const
{
    return machine_panel::answer(picture, screenLanguage());
}

Notes MachinePanel::notes(const MachinePicture& picture) const
{
    return picture.notes;
}

report::Document MachinePanel::document(const MachinePicture& picture) const
{
    return reportOf(picture, screenLanguage());
}

std::vector<PanelExport> MachinePanel::exports() const
{
    const auto picture = result();
    if (!picture) return {};
    return {{tr("Spindle (SPINDLE.json)…"), tr("JSON (*.json)"), "json",
             [picture](const QString& path) {
                 io::writeFile(path.toStdString(), receptance::spindleText(picture->spindle));
             }},
            {tr("Magnitude over frequency (CSV)…"), tr("Table (*.csv)"), "csv", [picture](const QString& path) {
                 io::writeFile(path.toStdString(), report::toCsv(receptance::spindleMagnitudePlot(picture->spindle)));
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
