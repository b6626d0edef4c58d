#include "widgets/recognise/recognise_panel.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "engine/features/recognition_plots.h"
#include "engine/features/recognition_quantities.h"
#include "engine/features/recognition_report.h"
#include "engine/features/refit.h"
#include "engine/features/stock_part.h"
#include "engine/io/file.h"
#include "engine/report/plot_svg.h"
#include "engine/report/result_json.h"
#include "engine/shaft/shaft_codes.h"
#include "engine/shaft/shaft_item.h"
#include "widgets/core/language.h"
#include "widgets/part_common/part_exports.h"
#include "widgets/recognise/recognise_views.h"

namespace lathelier::recognise_panel {
namespace {

PanelInputs panelInputs()
{
    InputRole scan;
    scan.role = scanRole;
    scan.label = LT_TEXT("Engine", "Scan");
    scan.hint = LT_TEXT("Engine", "Points or mesh of a turned part, in any pose");
    scan.kinds = {&io::scanFiles()};
    scan.takes_next = true;
    PanelInputs inputs;
    inputs.roles = {scan};
    inputs.fields = infos<features::RecognitionParameters>();
    inputs.defaults = toValues(features::RecognitionParameters{});
    inputs.invitation = LT_TEXT("Engine", "Drop the scan of a turned part here.");
    return inputs;
}

report::Document reportOf(const RecogniseOutcome& outcome, const Language& language)
{
    features::Recognition result = *outcome.result;
    result.notes = outcome.notes;  // those of the file as well
    report::Document document = recognitionReport(result, outcome.steps, outcome.inputs, language);
    document.synthetic = outcome.synthetic;
    Json json = features::toJson(result);
    if (outcome.result->paper_steps.empty()) {
        json["steps"] = Json::array();
        for (const ShaftStep& step : outcome.steps) json["steps"].push_back(nestedJson(describedValues(step)));
    }
    document.results = {report::toText(
        report::wholeResult("recognize", outcome.inputs, toValues(result.parameters), json, result.notes))};
    return document;
}

void requireComplete(const RecogniseOutcome& outcome)
{
    const features::Recognition& result = *outcome.result;
    if (result.complete) return;
    throw Error(
        errors::shaftIncomplete,
        {{"reason", result.gaps.empty() ? LT_TEXT("Engine", "an end is not seen; state the length to confirm it")
                                        : LT_TEXT("Engine", "there is a gap in the data")}});
}

}  // namespace

PanelFacts recognisePanelFacts()
{
    PanelFacts facts;
    facts.id = "recognise";
    facts.title = LT_TEXT("Engine", "Recognise");
    facts.icon = "recognise";
    facts.workspaces = {workspaceOf("copy")};
    facts.kinds = {&io::scanFiles()};
    facts.part_inputs = {scanRole};
    facts.make = [](Session& session) -> PanelBase* { return new RecognisePanel(session); };
    facts.roles = panelInputs().roles;
    facts.report = [](const project::PanelState& state, Stores& stores, const Language& language,
                      const Progress& progress) {
        return reportOf(LastRecognition().find(state, *stores.of<ScanStore>(), progress), language);
    };
    return facts;
}

RecognisePanel::RecognisePanel(Session& session, QWidget* parent)
    : Panel(session, recognisePanelFacts(), panelInputs(), parent),
      views_(new RecogniseViews),
      last_(std::make_shared<LastRecognition>())
{
    setViews(views_, views_->primaryViews());
    connect(views_->rows(), &RowsView::sizesAccepted, this, &RecognisePanel::toggle);
    connect(views_->rows(), &RowsView::allAccepted, this, &RecognisePanel::acceptAll);
    connect(views_, &RecogniseViews::shaftRequested, this, &RecognisePanel::keepShaft);
    connect(views_, &RecogniseViews::changeRequested, this, &RecognisePanel::change);
    connect(views_, &RecogniseViews::foundRequested, this, [this] {
        editState(tr("Take back all changes of the rows"), [](project::PanelState& state) {
            lathelier::set(state.parameters, changesKey, std::string());
            lathelier::set(state.parameters, acceptedKey, std::string());
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
    editState(
        taken_back > 0 ? tr("Take back the size of row %1").arg(row) : tr("Accept the size of row %1").arg(row),
        [&](project::PanelState& state) { lathelier::set(state.parameters, acceptedKey, features::textOf(accepted)); });
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
            lathelier::set(state.parameters, changesKey, features::textOf(changes));
            lathelier::set(state.parameters, changesOfKey, state.inputs.at(scanRole).path);
            lathelier::set(state.parameters, acceptedKey,
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
        requireComplete(*outcome);
        keepItem(outcome->shaft.name, shaftItem, itemValues(measuredRows(*outcome), recoveredFrom(*outcome)));
    } catch (const Error& error) {
        emit messageRaised({error, facts().title});
    }
}

RecognisePanel::Compute RecognisePanel::compute(const project::PanelState& state) const
{
    fromValues<features::RecognitionParameters>(state.parameters);  // validates ranges before the computation
    return [state, last = last_, scans = session().stores().of<ScanStore>()](const Progress& progress) {
        return last->find(state, *scans, progress);
    };
}

void RecognisePanel::showResult(const std::shared_ptr<const RecogniseOutcome>& outcome)
{
    views_->setOutcome(outcome);
}

report::Answer RecognisePanel::answer(const RecogniseOutcome& outcome) const
{
    return features::answer(*outcome.result);
}

void RecognisePanel::showPlace(const report::Place& place)
{
    if (place.z_mm) views_->markStretch(place.z_mm->from, place.z_mm->to);
}

Notes RecognisePanel::notes(const RecogniseOutcome& outcome) const
{
    return outcome.notes;
}

report::Document RecognisePanel::document(const RecogniseOutcome& outcome) const
{
    return reportOf(outcome, screenLanguage());
}

std::vector<PanelExport> RecognisePanel::exports() const
{
    const auto outcome = result();
    if (!outcome) return {};
    const auto write = [](const QString& path, const std::string& text) { io::writeFile(path.toStdString(), text); };
    const double chucked_mm = outcome->result->parameters.length_of_chucked_mm.value_or(0);
    part_common::PartToWrite part;
    part.shaft = outcome->shaft;
    part.stock = outcome->result->complete ? features::outOfChuck(outcome->shaft, chucked_mm) : outcome->shaft;
    part.drawing = [outcome](const Language& language) { return drawingOf(*outcome, language); };
    part.require_complete = [outcome] { requireComplete(*outcome); };
    part.csv = [outcome] { return features::rowsCsv(*outcome->result); };
    std::vector<PanelExport> all =
        part_common::exportsOf(std::make_shared<const part_common::PartToWrite>(std::move(part)));
    all.push_back({tr("Meridian and residuals (CSV)…"), tr("Table (*.csv)"), "csv",
                   [outcome, write](const QString& path) { write(path, features::meridianCsv(*outcome->result)); }});
    all.push_back(
        {tr("Meridian (SVG)…"), tr("Picture (*.svg)"), "svg", [outcome, write](const QString& path) {
             write(path, report::toSvg(features::meridianPlot(*outcome->result, screenLanguage()), screenLanguage()));
         }});
    all.push_back({tr("Residuals (SVG)…"), tr("Picture (*.svg)"), "svg", [outcome, write](const QString& path) {
                       write(path, report::toSvg(features::residualPlot(*outcome->result), screenLanguage()));
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
