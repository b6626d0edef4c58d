#include "widgets/drawing/drawing_panel.h"

#include "engine/core/understanding.h"
#include "engine/core/units.h"
#include "engine/io/file.h"
#include "engine/shaft/shaft_item.h"
#include "engine/shaft/shaft_rules.h"
#include "widgets/core/form/form.h"
#include "widgets/core/form/input_box.h"
#include "widgets/core/form/input_column.h"
#include "widgets/core/language.h"
#include "widgets/core/session.h"
#include "widgets/drawing/drawing_views.h"
#include "widgets/part_common/part_exports.h"

namespace lathelier::drawing_panel {
namespace {

const std::vector<std::string> roles{cad::shaftRole};

/// What CAD leaves out is remarked in any case: every file can be written.
cad::DrawOutcome checkAndDraw(const project::PanelState& state, Stores& stores, task::Sources& sources,
                              const Progress& progress)
{
    return cad::answerDraw(state, true, stores, sources, progress);
}

PanelInputs panelInputs()
{
    PanelInputs inputs = inputsOf(cad::drawTask(), roles, {}, false,
                                  LT_TEXT("Engine", "Drop a shaft here (SHAFT.json, STEP), or state its segments."));
    for (const FieldInfo& info : cad::drawTask().fields)
        if (info.key != task::segmentsOfKey && info.key != cad::boresOfKey && info.key != "check" &&
            info.key != "undated")
            inputs.fields.push_back(info);
    foldAllBut(inputs, {task::segmentsKey, cad::boresKey, "name", "library_material", "general_tolerances", "sheet",
                        "lengths"});
    inputs.roles.front().takes_next = true;
    return inputs;
}

/// The segments of the form; none when they are not a table.
std::optional<ShaftRows> rowsIn(const Value& table)
{
    cad::DrawQuestion question;
    Values values;
    set(values, task::segmentsKey, table);
    return fromValues<cad::DrawQuestion>(values).segments;
}

}  // namespace

PanelFacts drawingPanelFacts()
{
    PanelFacts facts = factsOf(cad::drawTask(), "drawing", "drawing", roles, {});
    facts.alone = facts.kinds;
    facts.has_work = [](const project::PanelState& state) { return task::hasShaft(state, cad::shaftRole); };
    facts.answer = answeredBy(checkAndDraw);
    facts.make = [](Session& session) -> PanelBase* { return new DrawingPanel(session); };
    return facts;
}

DrawingPanel::DrawingPanel(Session& owner, QWidget* parent)
    : TaskPanel(owner, drawingPanelFacts(), panelInputs(), parent), views_(new DrawingViews)
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
            step, [&](project::PanelState& state) { task::setTable(state, cad::shaftRole, shaft.segments); },
            merge_key);
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
        editState(step, [&](project::PanelState& state) { cad::setBores(state, shaft.bores); });
    } catch (const Error& error) {
        emit messageRaised({error, facts().title});
    }
}

/// A table edited by hand is assigned to the present input, and tied rows follow, within the same undo step.
void DrawingPanel::followTable(const std::string& key, const Value& table, int gesture, const QString& step)
{
    if (key == cad::boresKey)
        return editState(
            step,
            [&](project::PanelState& state) { lathelier::set(state.parameters, cad::boresOfKey, cad::boresOf(state)); },
            QString("drawing/bores/%1").arg(gesture));
    if (key != task::segmentsKey) return;
    const auto outcome = result();
    const std::optional<ShaftRows> typed = rowsIn(table);
    editState(
        step,
        [&](project::PanelState& state) {
            if (outcome && typed)
                task::setTable(state, cad::shaftRole, followTies(outcome->shaft.segments, *typed));
            else
                task::takeTable(state, cad::shaftRole);
        },
        QString("drawing/segments/%1").arg(gesture));
}

void DrawingPanel::keepShaft()
{
    const auto outcome = result();
    if (!outcome) return;
    if (const auto made = productOf(outcomeOf(outcome), shaftItem, {})) keepItem(made->name, shaftItem, made->values());
}

void DrawingPanel::assignFiles(project::PanelState& state, const std::vector<FoundFile>& files) const
{
    for (const FoundFile& file : files) {
        openShaft(state, cad::shaftRole, file.path);
        lathelier::set(state.parameters, cad::boresOfKey, std::string());
    }
}

QString DrawingPanel::understood(const InputRole&, const project::Source& source) const
{
    const auto loaded = session().stores().of<task::CacheOf<cad::PartInput>>()->known(source);
    if (!loaded) return {};
    const Shaft& shaft = loaded->file.shaft;
    return understoodText(
        loaded->file.facts,
        tr("%L1 segments · %2").arg(shaft.segments.size()).arg(screenQuantity(shaft.length_mm(), unit::mm, 1)));
}

void DrawingPanel::showResult(const std::shared_ptr<const cad::DrawOutcome>& outcome)
{
    cad::DrawQuestion rows;
    rows.bores = cad::rowsOfBores(outcome->shaft.bores);
    inputColumn().form().setValues({{task::segmentsKey, task::rowsOf(outcome->shaft.segments)},
                                    // also for those of a file
                                    {cad::boresKey, *lathelier::find(toValues(rows), cad::boresKey)}});
    views_->setOutcome(outcome);
}

std::vector<PanelExport> DrawingPanel::exports() const
{
    std::vector<PanelExport> all = TaskPanel::exports();
    const auto outcome = result();
    if (!outcome) return all;
    all.insert(all.begin(), {tr("Drawing (PDF)…"), tr("Document (*.pdf)"), "pdf", [outcome](const QString& path) {
                                 requireUnderstood(outcome->understanding);
                                 io::writeFile(path.toStdString(),
                                               part_common::toPdf(drawingOf(*outcome, screenLanguage())));
                             }});
    return all;
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
