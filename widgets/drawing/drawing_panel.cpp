#include "widgets/drawing/drawing_panel.h"

#include "engine/cad/step_kind.h"
#include "engine/core/understanding.h"
#include "engine/io/shaft/shaft_kind.h"
#include "engine/shaft/shaft_item.h"
#include "engine/shaft/shaft_rules.h"
#include "widgets/core/form/form.h"
#include "widgets/core/form/input_box.h"
#include "widgets/core/form/input_column.h"
#include "widgets/core/language.h"
#include "widgets/core/panel/task_panel.h"
#include "widgets/core/session.h"
#include "widgets/drawing/drawing_views.h"
#include "widgets/part_common/part_exports.h"
#include "widgets/part_common/part_store.h"

namespace lathelier::drawing_panel {
namespace {

PanelInputs panelInputs()
{
    InputRole shaft;
    shaft.role = shaftRole;
    shaft.label = LT_TEXT("Engine", "Shaft");
    shaft.hint = LT_TEXT("Engine", "SHAFT.json, a STEP file of a turned part, or what another panel made");
    shaft.kinds = {&io::shaftFiles(), &cad::stepFiles()};
    shaft.item_kind = shaftItem;
    shaft.required = false;
    shaft.takes_next = true;
    PanelInputs inputs;
    inputs.roles = {shaft};
    for (FieldInfo& info : infos<DrawingQuestion>())
        if (info.key != segmentsOfKey && info.key != boresOfKey) inputs.fields.push_back(std::move(info));
    inputs.defaults = toValues(DrawingQuestion{});
    inputs.invitation = LT_TEXT("Engine", "Drop a shaft here (SHAFT.json, STEP), or state its segments.");
    return inputs;
}

/// The segments of the form; none when they are not a table.
std::optional<ShaftRows> rowsIn(const Value& table)
{
    DrawingQuestion question;
    Values values;
    set(values, segmentsKey, table);
    return fromValues<DrawingQuestion>(values).segments;
}

}  // namespace

PanelFacts drawingPanelFacts()
{
    PanelFacts facts;
    facts.id = "drawing";
    facts.title = LT_TEXT("Engine", "Drawing");
    facts.icon = "drawing";
    facts.workspaces = {workspaceOf("copy")};
    facts.kinds = {&io::shaftFiles(), &cad::stepFiles()};
    facts.roles = panelInputs().roles;
    facts.part_inputs = {shaftRole};
    facts.item_inputs = {{shaftItem, shaftRole}};
    facts.make = [](Session& session) -> PanelBase* { return new DrawingPanel(session); };
    facts.missing = [](const project::PanelState& state) {
        return task::hasShaft(state, shaftRole) ? std::vector<Text>{}
                                                : std::vector<Text>{LT_TEXT("Engine", "Shaft or segments")};
    };
    facts.has_work = [](const project::PanelState& state) { return task::hasShaft(state, shaftRole); };
    facts.report = [](const project::PanelState& state, Stores& stores, const Language& language,
                      const Progress& progress) { return reportOf(drawingOutcome(state, stores, progress), language); };
    return facts;
}

DrawingPanel::DrawingPanel(Session& owner, QWidget* parent)
    : Panel(owner, drawingPanelFacts(), panelInputs(), parent), views_(new DrawingViews)
{
    setViews(views_, views_->primaryViews());
    connect(views_, &DrawingViews::shaftRequested, this, &DrawingPanel::keepShaft);
    connect(views_, &DrawingViews::editRequested, this, &DrawingPanel::editRows);
    connect(views_, &DrawingViews::notWritten, this, &DrawingPanel::reportWriteFailure);
    connect(views_, &DrawingViews::boresEditRequested, this, &DrawingPanel::editBores);
    connect(&inputColumn(), &InputColumn::parameterEdited, this, &DrawingPanel::followTable);
}

/// Applies an edit of a view as one undo step, unless the shaft would violate a rule.
void DrawingPanel::editRows(const QString& step, const RowsChange& change, const QString& merge_key)
{
    const auto outcome = result();
    if (!outcome) return;
    try {
        Shaft shaft = outcome->shaft;
        const ShaftRows before = shaft.segments;
        shaft.segments = change(before);
        if (shaft.segments == before) return;
        if (outcome->question.measured) shaft.segments = keepMeasured(before, std::move(shaft.segments));
        checkShaft(shaft);
        editState(
            step, [&](project::PanelState& state) { task::setTable(state, shaftRole, shaft.segments); }, merge_key);
    } catch (const Error& error) {
        emit messageRaised({error, facts().title});
    }
}

void DrawingPanel::editBores(const QString& step, const BoresChange& change)
{
    const auto outcome = result();
    if (!outcome) return;
    try {
        Shaft shaft = outcome->shaft;
        shaft.bores = change(shaft.bores);
        if (shaft.bores == outcome->shaft.bores) return;
        checkShaft(shaft);
        editState(step, [&](project::PanelState& state) { setBores(state, shaft.bores); });
    } catch (const Error& error) {
        emit messageRaised({error, facts().title});
    }
}

/// A table edited by hand is assigned to the present input, and tied rows follow, within the same undo step.
void DrawingPanel::followTable(const std::string& key, const Value& table, int gesture, const QString& step)
{
    if (key == boresKey)
        return editState(
            step, [&](project::PanelState& state) { lathelier::set(state.parameters, boresOfKey, boresOf(state)); },
            QString("drawing/bores/%1").arg(gesture));
    if (key != segmentsKey) return;
    const auto outcome = result();
    const std::optional<ShaftRows> typed = rowsIn(table);
    editState(
        step,
        [&](project::PanelState& state) {
            if (outcome && typed)
                task::setTable(state, shaftRole, followTies(outcome->shaft.segments, *typed));
            else
                task::takeTable(state, shaftRole);
        },
        QString("drawing/segments/%1").arg(gesture));
}

/// With a new name, so that the item does not replace its origin.
void DrawingPanel::keepShaft()
{
    const auto outcome = result();
    if (!outcome) return;
    std::string name = outcome->shaft.name;
    if (name.empty()) name = tr("shaft, %1 mm").arg(screenNumber(outcome->shaft.length_mm(), 1)).toStdString();
    const auto source = state().inputs.find(shaftRole);
    if (source != state().inputs.end() && source->second.item == name)
        name = tr("%1, edited").arg(QString::fromStdString(name)).toStdString();
    const Shaft& shaft = outcome->shaft;
    keepItem(name, shaftItem, outcome->recovered ? itemValues(shaft, *outcome->recovered) : toValues(shaft));
}

void DrawingPanel::assignFiles(project::PanelState& state, const std::vector<FoundFile>& files) const
{
    for (const FoundFile& file : files) {
        openShaft(state, shaftRole, file.path);
        lathelier::set(state.parameters, boresOfKey, std::string());
    }
}

DrawingPanel::Compute DrawingPanel::compute(const project::PanelState& state) const
{
    fromValues<DrawingQuestion>(state.parameters);  // validates ranges before the computation
    return [state, stores = session().sharedStores()](const Progress& progress) {
        return drawingOutcome(state, *stores, progress);
    };
}

QString DrawingPanel::understood(const InputRole&, const project::Source& source) const
{
    const auto loaded = session().stores().of<part_common::PartStore>()->known(source);
    if (!loaded) return {};
    const Shaft& shaft = loaded->file.shaft;
    return understoodText(
        loaded->file.facts,
        tr("%L1 segments · %2").arg(shaft.segments.size()).arg(screenQuantity(shaft.length_mm(), millimetre, 1)));
}

void DrawingPanel::showResult(const std::shared_ptr<const DrawingOutcome>& outcome)
{
    DrawingQuestion rows;
    rows.bores = rowsOfBores(outcome->shaft.bores);
    inputColumn().form().setValues({{segmentsKey, task::rowsOf(outcome->shaft.segments)},
                                    // also for those of a file
                                    {boresKey, *lathelier::find(toValues(rows), boresKey)}});
    views_->setOutcome(outcome);
}

report::Answer DrawingPanel::answer(const DrawingOutcome& outcome) const
{
    return drawing_panel::answerOf(outcome);
}

Notes DrawingPanel::notes(const DrawingOutcome& outcome) const
{
    return outcome.notes;
}

report::Document DrawingPanel::document(const DrawingOutcome& outcome) const
{
    return reportOf(outcome, screenLanguage());
}

std::vector<PanelExport> DrawingPanel::exports() const
{
    const auto outcome = result();
    if (!outcome) return {};
    part_common::PartToWrite part{outcome->shaft, outcome->shaft,
                                  [outcome](const Language& language) { return drawingOf(*outcome, language); }};
    part.require_complete = [outcome] { requireUnderstood(understandingOf(outcome->notes)); };
    return part_common::exportsOf(std::make_shared<const part_common::PartToWrite>(std::move(part)));
}

void DrawingPanel::setPresenting(bool presenting)
{
    Panel::setPresenting(presenting);
    views_->setPresenting(presenting);
}

void DrawingPanel::retranslate()
{
    views_->retranslate();
}

}  // namespace lathelier::drawing_panel
