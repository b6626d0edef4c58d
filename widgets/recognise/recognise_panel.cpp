#include "widgets/recognise/recognise_panel.h"

#include <algorithm>

#include "engine/core/understanding.h"
#include "engine/features/refit/refit.h"
#include "engine/io/file.h"
#include "engine/shaft/shaft_item.h"
#include "widgets/core/language.h"
#include "widgets/part_common/part_exports.h"
#include "widgets/recognise/recognise_views.h"

namespace lathelier::recognise_panel {
namespace {

const std::vector<std::string> roles{cad::scanRole};

/// With the points of the scene, in the worker.
cad::RecognizeOutcome recogniseAndPart(const project::PanelState& state, Stores& stores, task::Sources& sources,
                                       const Progress& progress)
{
    cad::RecognizeOutcome outcome = cad::answerRecognize(state, stores, sources, progress.part(0, 0.95));
    outcome.by_kind = cad::partedByKind(outcome.points->file.scan, *outcome.result);
    return outcome;
}

PanelInputs panelInputs()
{
    PanelInputs inputs =
        inputsOf(cad::recognizeTask(), roles, {}, false, LT_TEXT("Engine", "Drop the scan of a turned part here."));
    for (const FieldInfo& info : cad::recognizeTask().fields)
        if (!info.is_kept && info.key != "undated") inputs.fields.push_back(info);
    inputs.roles.front().takes_next = true;
    return inputs;
}

}  // namespace

PanelFacts recognisePanelFacts()
{
    PanelFacts facts = factsOf(cad::recognizeTask(), "recognise", "recognise", roles, {});
    facts.alone = facts.kinds;  // a scan is drawn at once
    facts.answer = answeredBy(recogniseAndPart);
    facts.make = [](Session& session) -> PanelBase* { return new RecognisePanel(session); };
    return facts;
}

RecognisePanel::RecognisePanel(Session& session, QWidget* parent)
    : TaskPanel(session, recognisePanelFacts(), panelInputs(), parent), views_(new RecogniseViews)
{
    setViews(views_, views_->primaryViews());
    connect(views_->rows(), &RowsView::sizesAccepted, this, &RecognisePanel::toggle);
    connect(views_->rows(), &RowsView::allAccepted, this, &RecognisePanel::acceptAll);
    connect(views_, &RecogniseViews::shaftRequested, this, &RecognisePanel::keepShaft);
    connect(views_, &RecogniseViews::changeRequested, this, &RecognisePanel::change);
    connect(views_, &RecogniseViews::foundRequested, this, [this] {
        editState(tr("Take back all changes of the rows"), [](project::PanelState& state) {
            lathelier::set(state.parameters, cad::changesKey, std::string());
            lathelier::set(state.parameters, cad::acceptedKey, std::string());
        });
    });
    connect(views_, &RecogniseViews::notWritten, this, &RecognisePanel::reportWriteFailure);
}

/// Accepts the sizes of a suggestion, or revokes them.
void RecognisePanel::toggle(const std::vector<features::AcceptedSize>& sizes)
{
    const auto outcome = result();
    if (!outcome || sizes.empty()) return;
    std::vector<features::AcceptedSize> accepted = outcome->accepted;
    std::size_t taken_back = 0;
    for (const features::AcceptedSize& size : sizes) taken_back += std::erase(accepted, size);
    if (taken_back == 0) accepted.insert(accepted.end(), sizes.begin(), sizes.end());
    const std::int64_t row = sizes.front().row;
    editState(taken_back > 0 ? tr("Take back the size of row %1").arg(row) : tr("Accept the size of row %1").arg(row),
              [&](project::PanelState& state) {
                  lathelier::set(state.parameters, cad::acceptedKey, features::textOf(accepted));
              });
}

/// The joint fit is run again with the changed rows; a failed fit creates no undo step.
void RecognisePanel::change(const QString& step, const features::RowChange& asked)
{
    const auto outcome = result();
    if (!outcome) return;
    std::vector<features::RowChange> changes = outcome->changes;
    changes.push_back(asked);
    try {
        refit(*outcome->found, changes);
        editState(step, [&](project::PanelState& state) {
            lathelier::set(state.parameters, cad::changesKey, features::textOf(changes));
            lathelier::set(state.parameters, cad::changesOfKey, state.inputs.at(cad::scanRole).path);
            lathelier::set(state.parameters, cad::acceptedKey,
                           features::textOf(features::afterChange(outcome->accepted, asked)));
        });
    } catch (const Error& error) {
        emit messageRaised({error, facts().title});
    }
}

void RecognisePanel::acceptAll()
{
    editState(tr("Accept all nominal sizes"),
              [](project::PanelState& state) { lathelier::set(state.parameters, "snap", std::string("apply")); });
}

void RecognisePanel::keepShaft()
{
    const auto outcome = result();
    if (!outcome) return;
    try {
        cad::requireComplete(*outcome->result);
        if (const auto made = productOf(outcomeOf(outcome), shaftItem, {}))
            keepItem(made->name, shaftItem, made->values());
    } catch (const Error& error) {
        emit messageRaised({error, facts().title});
    }
}

void RecognisePanel::showResult(const std::shared_ptr<const cad::RecognizeOutcome>& outcome)
{
    views_->setOutcome(outcome);
}

void RecognisePanel::showPlace(const report::Place& place)
{
    if (place.z_mm) views_->markStretch(place.z_mm->from, place.z_mm->to);
}

std::vector<PanelExport> RecognisePanel::exports() const
{
    std::vector<PanelExport> all = TaskPanel::exports();
    const auto outcome = result();
    if (!outcome) return all;
    all.insert(all.begin(), {tr("Drawing (PDF)…"), tr("Document (*.pdf)"), "pdf", [outcome](const QString& path) {
                                 cad::requireComplete(*outcome->result);
                                 requireUnderstood(outcome->understanding);
                                 io::writeFile(path.toStdString(),
                                               part_common::toPdf(drawingOf(*outcome, screenLanguage())));
                             }});
    return all;
}

Values RecognisePanel::view() const
{
    return views_->view();
}

void RecognisePanel::restoreView(const Values& kept)
{
    views_->restoreView(kept);
}

void RecognisePanel::retranslate()
{
    views_->retranslate();
}

}  // namespace lathelier::recognise_panel
