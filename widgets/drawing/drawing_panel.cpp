#include "widgets/drawing/drawing_panel.h"

#include "engine/core/shaft_item.h"
#include "engine/core/shaft_rules.h"
#include "widgets/core/form/form.h"
#include "widgets/core/form/input_box.h"
#include "widgets/core/form/input_column.h"
#include "widgets/core/language.h"
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

/// The segments as the form has them; nothing where they are no table.
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
    facts.workspaces = {{"copy", LT_TEXT("Engine", "Copy a part"), "copy_part", 50}};
    facts.kinds = {&io::shaftFiles(), &cad::stepFiles()};
    facts.roles = panelInputs().roles;
    facts.part_inputs = {shaftRole};
    facts.item_inputs = {{shaftItem, shaftRole}};
    facts.make = [](Session& session) -> PanelBase* { return new DrawingPanel(session); };
    facts.missing = [](const project::PanelState& state) {
        return part_common::hasShaft(state) ? std::vector<Text>{}
                                            : std::vector<Text>{LT_TEXT("Engine", "Shaft or segments")};
    };
    facts.hasWork = part_common::hasShaft;
    facts.report = [](const project::PanelState& state, Stores& stores, const Language& language,
                      const Progress& progress) { return reportOf(drawingPicture(state, stores, progress), language); };
    return facts;
}

DrawingPanel::DrawingPanel(Session& owner, QWidget* parent)
    : Panel(owner, drawingPanelFacts(), panelInputs(), parent), views_(new DrawingViews)
{
    setViews(views_, views_->heroes());
    connect(views_, &DrawingViews::shaftWanted, this, &DrawingPanel::keepShaft);
    connect(views_, &DrawingViews::editWanted, this, &DrawingPanel::editRows);
    connect(views_, &DrawingViews::notWritten, this, &DrawingPanel::sayNotWritten);
    connect(views_, &DrawingViews::boresEditWanted, this, &DrawingPanel::editBores);
    connect(&inputColumn(), &InputColumn::parameterEdited, this, &DrawingPanel::followTable);
}

/// An edit in a view: one undo step, unless the shaft would break a rule.
void DrawingPanel::editRows(const QString& step, const RowsChange& change, const QString& merge_key)
{
    const auto picture = result();
    if (!picture) return;
    try {
        Shaft shaft = picture->shaft;
        const ShaftRows before = shaft.segments;
        shaft.segments = change(before);
        if (shaft.segments == before) return;
        if (picture->question.measured) shaft.segments = keepMeasured(before, std::move(shaft.segments));
        checkShaft(shaft);
        editState(
            step, [&](project::PanelState& state) { part_common::setTable(state, shaft.segments); }, merge_key);
    } catch (const Error& error) {
        emit messageRaised({error, facts().title});
    }
}

void DrawingPanel::editBores(const QString& step, const BoresChange& change)
{
    const auto picture = result();
    if (!picture) return;
    try {
        Shaft shaft = picture->shaft;
        shaft.bores = change(shaft.bores);
        if (shaft.bores == picture->shaft.bores) return;
        checkShaft(shaft);
        editState(step, [&](project::PanelState& state) { setBores(state, shaft.bores); });
    } catch (const Error& error) {
        emit messageRaised({error, facts().title});
    }
}

/// A table changed by hand is of the input that is there now, and rows that are tied follow: the same undo step as the
/// change itself.
void DrawingPanel::followTable(const std::string& key, const Value& table, int gesture, const QString& step)
{
    if (key == boresKey)
        return editState(
            step, [&](project::PanelState& state) { lathelier::set(state.parameters, boresOfKey, boresOf(state)); },
            QString("drawing/bores/%1").arg(gesture));
    if (key != segmentsKey) return;
    const auto picture = result();
    const std::optional<ShaftRows> typed = rowsIn(table);
    editState(
        step,
        [&](project::PanelState& state) {
            if (picture && typed)
                part_common::setTable(state, followTies(picture->shaft.segments, *typed));
            else
                part_common::takeTable(state);
        },
        QString("drawing/segments/%1").arg(gesture));
}

/// Under a name of its own: an item must not take the place of the one that it was made of.
void DrawingPanel::keepShaft()
{
    const auto picture = result();
    if (!picture) return;
    std::string name = picture->shaft.name;
    if (name.empty()) name = tr("shaft, %1 mm").arg(screenNumber(picture->shaft.length_mm(), 1)).toStdString();
    const auto source = state().inputs.find(shaftRole);
    if (source != state().inputs.end() && source->second.item == name)
        name = tr("%1, edited").arg(QString::fromStdString(name)).toStdString();
    const Shaft& shaft = picture->shaft;
    keepItem(name, shaftItem, picture->recovered ? itemValues(shaft, *picture->recovered) : toValues(shaft));
}

void DrawingPanel::assignFiles(project::PanelState& state, const std::vector<FoundFile>& files) const
{
    for (const FoundFile& file : files) {
        part_common::openShaft(state, file.path);
        lathelier::set(state.parameters, boresOfKey, std::string());
    }
}

DrawingPanel::Compute DrawingPanel::compute(const project::PanelState& state) const
{
    fromValues<DrawingQuestion>(state.parameters);  // refuses now what is out of range
    return [state, stores = session().sharedStores()](const Progress& progress) {
        return drawingPicture(state, *stores, progress);
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

void DrawingPanel::showResult(const std::shared_ptr<const DrawingPicture>& picture)
{
    DrawingQuestion rows;
    rows.bores = rowsOfBores(picture->shaft.bores);
    inputColumn().form().setValues({{segmentsKey, part_common::rowsOf(picture->shaft.segments)},
                                    {boresKey, *lathelier::find(toValues(rows), boresKey)}});  // also those of a file
    views_->setPicture(picture);
}

report::Answer DrawingPanel::answer(const DrawingPicture& picture) const
{
    return drawing_panel::answerOf(picture);
}

Notes DrawingPanel::notes(const DrawingPicture& picture) const
{
    return picture.notes;
}

report::Document DrawingPanel::document(const DrawingPicture& picture) const
{
    return reportOf(picture, screenLanguage());
}

std::vector<PanelExport> DrawingPanel::exports() const
{
    const auto picture = result();
    if (!picture) return {};
    part_common::PartToWrite part{picture->shaft, picture->shaft,
                                  [picture](const Language& language) { return drawingOf(*picture, language); }};
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
