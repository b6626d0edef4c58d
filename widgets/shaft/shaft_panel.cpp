#include "widgets/shaft/shaft_panel.h"

#include <nlohmann/json.hpp>

#include "engine/core/frf_item.h"
#include "engine/io/file.h"
#include "engine/io/frf/frf_writer.h"
#include "engine/io/shaft/shaft_file.h"
#include "engine/io/shaft/shaft_kind.h"
#include "engine/receptance/receptance_quantities.h"
#include "engine/receptance/shaft_plots.h"
#include "engine/receptance/shaft_report.h"
#include "engine/receptance/spindle_item.h"
#include "engine/receptance/spindle_kind.h"
#include "engine/report/result_json.h"
#include "engine/shaft/shaft_item.h"
#include "widgets/chatter_common/model_inputs.h"
#include "widgets/chatter_common/shaft_files.h"
#include "widgets/core/form/form.h"
#include "widgets/core/form/input_box.h"
#include "widgets/core/form/input_column.h"
#include "widgets/core/language.h"
#include "widgets/core/session.h"
#include "widgets/part_common/shaft_table.h"
#include "widgets/shaft/shaft_views.h"

namespace lathelier::shaft_panel {
namespace {

PanelInputs panelInputs()
{
    InputRole shaft;
    shaft.role = shaftRole;
    shaft.label = LT_TEXT("Engine", "Shaft");
    shaft.hint = LT_TEXT("Engine", "SHAFT.json or a stock file; fills the table of segments");
    shaft.kinds = {&io::shaftFiles()};
    shaft.item_kind = shaftItem;
    shaft.required = false;
    shaft.takes_next = true;
    InputRole spindle;
    spindle.role = spindleRole;
    spindle.label = LT_TEXT("Engine", "Spindle");
    spindle.hint = LT_TEXT("Engine", "SPINDLE.json, or what the panel Spindle made; without it the shaft is free");
    spindle.kinds = {&receptance::spindleFiles()};
    spindle.item_kind = receptance::spindleItem;
    spindle.required = false;
    PanelInputs inputs;
    inputs.roles = {shaft, spindle};
    for (FieldInfo& info : infos<ShaftQuestion>())
        if (info.key != segmentsOfKey) inputs.fields.push_back(std::move(info));
    inputs.defaults = toValues(ShaftQuestion{});
    inputs.invitation = LT_TEXT("Engine", "Drop a shaft here (SHAFT.json, stock text), or state its segments.");
    return inputs;
}

report::Document reportOf(const ShaftOutcome& outcome, const Language& language)
{
    receptance::ShaftStudy study = outcome.study;
    study.response.notes = outcome.notes;  // those of the files as well
    report::Document document = shaftReport(study, outcome.shaft, outcome.holding, language);
    document.inputs = outcome.inputs;
    document.synthetic = outcome.synthetic;
    document.results = {
        report::toText(report::wholeResult("frf", outcome.inputs, toValues(outcome.question),
                                           nestedJson(describedValues(study.response)), outcome.notes))};
    return document;
}

std::string nameOf(const ShaftOutcome& outcome)
{
    if (!outcome.shaft.name.empty()) return outcome.shaft.name;
    return ShaftPanel::tr("shaft, %1 mm").arg(screenNumber(outcome.shaft.length_mm(), 1)).toStdString();
}

/// One response between two places, as files of responses have it.
io::MeasuredFrf measuredOf(const ShaftOutcome& outcome)
{
    io::MeasuredFrf response;
    response.frf = usableResponse(outcome);
    return response;
}

}  // namespace

PanelFacts shaftPanelFacts()
{
    PanelFacts facts;
    facts.id = "shaft";
    facts.title = LT_TEXT("Engine", "Shaft");
    facts.icon = "shaft";
    facts.workspaces = {workspaceOf("chatter")};
    facts.kinds = {&io::shaftFiles(), &receptance::spindleFiles()};
    facts.roles = panelInputs().roles;
    facts.part_inputs = {shaftRole};
    facts.item_inputs = {{shaftItem, shaftRole}, {receptance::spindleItem, spindleRole}};
    facts.make = [](Session& session) -> PanelBase* { return new ShaftPanel(session); };
    facts.missing = [](const project::PanelState& state) {
        return part_common::hasShaft(state) ? std::vector<Text>{}
                                            : std::vector<Text>{LT_TEXT("Engine", "Shaft or segments")};
    };
    facts.has_work = part_common::hasShaft;
    facts.report = [](const project::PanelState& state, Stores& stores, const Language& language,
                      const Progress& progress) { return reportOf(shaftOutcome(state, stores, progress), language); };
    return facts;
}

ShaftPanel::ShaftPanel(Session& owner, QWidget* parent)
    : Panel(owner, shaftPanelFacts(), panelInputs(), parent), views_(new ShaftViews)
{
    setViews(views_, views_->primaryViews());
    connect(views_, &ShaftViews::endMoved, this, &ShaftPanel::moveEnd);
    connect(views_, &ShaftViews::shaftRequested, this, &ShaftPanel::keepShaft);
    connect(views_, &ShaftViews::responseRequested, this, &ShaftPanel::offerResponse);
    connect(views_, &ShaftViews::notWritten, this, &ShaftPanel::reportWriteFailure);
    // A table changed by hand is of the input that is there now: the same undo step as the change itself.
    connect(&inputColumn(), &InputColumn::parameterEdited, this,
            [this](const std::string& key, const Value&, int gesture, const QString& step) {
                if (key != segmentsKey) return;
                editState(step, part_common::takeTable, QString("shaft/segments/%1").arg(gesture));
            });
}

void ShaftPanel::moveEnd(std::size_t segment, double z_mm, double radius_mm, bool dropped)
{
    const auto outcome = result();
    if (!outcome) return;
    const Shaft dragged = receptance::dragged(outcome->shaft, segment, z_mm, radius_mm);
    editState(
        tr("Move the end of segment %1").arg(segment + 1),
        [&](project::PanelState& state) { part_common::setTable(state, dragged.segments); },
        QString("shaft/drag/%1").arg(gesture_));
    gesture_ += dropped;
}

void ShaftPanel::keepShaft()
{
    const auto outcome = result();
    if (!outcome) return;
    keepItem(nameOf(*outcome), shaftItem, toValues(outcome->shaft));
}

void ShaftPanel::offerResponse()
{
    const auto outcome = result();
    if (!outcome) return;
    try {
        Frf frf = usableResponse(*outcome);
        frf.name = tr("response of %1").arg(QString::fromStdString(nameOf(*outcome))).toStdString();
        offerItem(frf.name, frfItem, toValues(frf), outcome->synthetic);
    } catch (const Error& error) {
        emit messageRaised({error, facts().title});
    }
}

void ShaftPanel::assignFiles(project::PanelState& state, const std::vector<FoundFile>& files) const
{
    for (const FoundFile& file : files) {
        const bool spindle = file.kind == &receptance::spindleFiles();
        if (spindle)
            state.inputs[spindleRole] = newSource(QString::fromStdString(file.path));
        else
            part_common::openShaft(state, file.path);
    }
}

ShaftPanel::Compute ShaftPanel::compute(const project::PanelState& state) const
{
    fromValues<ShaftQuestion>(state.parameters);  // validates ranges before the computation
    return [state, stores = session().sharedStores()](const Progress& progress) {
        return shaftOutcome(state, *stores, progress);
    };
}

Worker::Job ShaftPanel::makeReadingJob(const project::PanelState& state) const
{
    return [state, store = session().stores().of<chatter_common::SpindleStore>()](
               const Progress& progress) -> std::shared_ptr<const void> {
        const auto spindle = state.inputs.find(spindleRole);
        if (spindle != state.inputs.end() && spindle->second.item.empty()) store->load(spindle->second, progress);
        return nullptr;
    };
}

QString ShaftPanel::understood(const InputRole& role, const project::Source& source) const
{
    return chatter_common::understoodModel(role.role, source, session().stores());
}

void ShaftPanel::showResult(const std::shared_ptr<const ShaftOutcome>& outcome)
{
    inputColumn().form().setValues(
        {{segmentsKey, part_common::rowsOf(outcome->shaft.segments)}});  // also those of a file
    views_->setOutcome(outcome);
}

report::Answer ShaftPanel::answer(const ShaftOutcome& outcome) const
{
    return receptance::answer(outcome.study, screenLanguage());
}

Notes ShaftPanel::notes(const ShaftOutcome& outcome) const
{
    return outcome.notes;
}

report::Document ShaftPanel::document(const ShaftOutcome& outcome) const
{
    return reportOf(outcome, screenLanguage());
}

std::vector<PanelExport> ShaftPanel::exports() const
{
    const auto outcome = result();
    if (!outcome) return {};
    return {{tr("Shaft (SHAFT.json)…"), tr("JSON (*.json)"), "json",
             [outcome](const QString& path) { io::writeFile(path.toStdString(), io::shaftText(outcome->shaft)); }},
            {tr("Stock text…"), tr("Text (*.txt)"), "txt",
             [outcome](const QString& path) { io::writeFile(path.toStdString(), io::stockText(outcome->shaft)); }},
            {tr("Receptance (CSV)…"), tr("Table (*.csv)"), "csv",
             [outcome](const QString& path) { io::writeFrfCsv(path.toStdString(), usableResponse(*outcome)); }},
            {tr("Receptance (UFF)…"), tr("Universal file (*.uff)"), "uff", [outcome](const QString& path) {
                 const io::MeasuredFrf response = measuredOf(*outcome);
                 io::writeUff(path.toStdString(), {&response, 1});
             }}};
}

void ShaftPanel::setPresenting(bool presenting)
{
    Panel::setPresenting(presenting);
    views_->setPresenting(presenting);
}

void ShaftPanel::retranslate()
{
    views_->retranslate();
}

}  // namespace lathelier::shaft_panel
