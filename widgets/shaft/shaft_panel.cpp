#include "widgets/shaft/shaft_panel.h"

#include "engine/core/frf_item.h"
#include "engine/receptance/shaft/shaft_plots.h"
#include "engine/receptance/spindle/spindle_kind.h"
#include "engine/shaft/shaft_item.h"
#include "widgets/chatter_common/understood_models.h"
#include "widgets/core/form/form.h"
#include "widgets/core/form/input_column.h"
#include "widgets/core/session.h"
#include "widgets/shaft/shaft_views.h"

namespace lathelier::shaft_panel {
namespace {

using receptance::ShaftOutcome;
using receptance::shaftRole;

const std::vector<std::string> roles{shaftRole, receptance::spindleRole};

PanelInputs panelInputs()
{
    PanelInputs inputs =
        inputsOf(receptance::shaftTask(), roles, {}, false,
                 LT_TEXT("Engine", "Drop a shaft here (SHAFT.json, stock text), or state its segments."));
    for (const FieldInfo& info : receptance::shaftTask().fields)
        if (info.key != task::segmentsOfKey) inputs.fields.push_back(info);
    foldAllBut(inputs, {task::segmentsKey, "library_material", "hold", "respond_z_mm", "excite_z_mm"});
    inputs.roles.front().takes_next = true;
    return inputs;
}

}  // namespace

PanelFacts shaftPanelFacts()
{
    PanelFacts facts = factsOf(receptance::shaftTask(), "shaft", "shaft", roles, {});
    facts.has_work = [](const project::PanelState& state) { return task::hasShaft(state, shaftRole); };
    facts.answer = answeredBy(receptance::answerShaft);
    facts.make = [](Session& session) -> PanelBase* { return new ShaftPanel(session); };
    return facts;
}

ShaftPanel::ShaftPanel(Session& owner, QWidget* parent)
    : TaskPanel(owner, shaftPanelFacts(), panelInputs(), parent), views_(new ShaftViews)
{
    setViews(views_, views_->primaryViews());
    connect(views_, &ShaftViews::endMoved, this, &ShaftPanel::moveEnd);
    connect(views_, &ShaftViews::shaftRequested, this, &ShaftPanel::keepShaft);
    connect(views_, &ShaftViews::responseRequested, this, [this] { offer(frfItem); });
    connect(views_, &ShaftViews::notWritten, this, &ShaftPanel::reportWriteFailure);
    // A table changed by hand is of the input that is there now: the same undo step as the change itself.
    connect(&inputColumn(), &InputColumn::parameterEdited, this,
            [this](const std::string& key, const Value&, int gesture, const QString& step) {
                if (key != task::segmentsKey) return;
                editState(
                    step, [](project::PanelState& state) { task::takeTable(state, shaftRole); },
                    QString("shaft/segments/%1").arg(gesture));
            });
}

void ShaftPanel::moveEnd(std::size_t segment, double z_mm, double radius_mm, bool dropped)
{
    const auto outcome = result();
    if (!outcome) return;
    const Shaft dragged = receptance::dragged(outcome->shaft, segment, z_mm, radius_mm);
    editState(
        tr("Move the end of segment %1").arg(segment + 1),
        [&](project::PanelState& state) { task::setTable(state, shaftRole, dragged.segments); },
        QString("shaft/drag/%1").arg(gesture_));
    gesture_ += dropped;
}

void ShaftPanel::keepShaft()
{
    const auto outcome = result();
    if (!outcome) return;
    const auto made = productOf(outcomeOf(outcome), shaftItem, {});
    if (made) keepItem(made->name, shaftItem, made->values());
}

void ShaftPanel::assignFiles(project::PanelState& state, const std::vector<FoundFile>& files) const
{
    for (const FoundFile& file : files) {
        if (file.kind == &receptance::spindleFiles())
            state.inputs[receptance::spindleRole] = newSource(QString::fromStdString(file.path));
        else
            openShaft(state, shaftRole, file.path);
    }
}

QString ShaftPanel::understood(const InputRole&, const project::Source& source) const
{
    return chatter_common::understoodModel(source, session().stores());
}

void ShaftPanel::showResult(const std::shared_ptr<const ShaftOutcome>& outcome)
{
    inputColumn().form().setValues(
        {{task::segmentsKey, task::rowsOf(outcome->shaft.segments)}});  // also those of a file
    views_->setOutcome(outcome);
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
