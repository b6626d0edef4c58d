#include "widgets/recognise/recognise_panel.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "engine/core/shaft_codes.h"
#include "engine/core/shaft_item.h"
#include "engine/features/recognition_plots.h"
#include "engine/features/recognition_quantities.h"
#include "engine/features/recognition_report.h"
#include "engine/features/refit.h"
#include "engine/features/stock_part.h"
#include "engine/io/file.h"
#include "engine/report/plot_svg.h"
#include "engine/report/result_json.h"
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

report::Document reportOf(const RecognisePicture& picture, const Language& language)
{
    features::Recognition result = *picture.result;
    result.notes = picture.notes;  // those of the file as well
    report::Document document = recognitionReport(result, picture.steps, picture.inputs, language);
    document.synthetic = picture.synthetic;
    Json json = features::toJson(result);
    if (picture.result->paper_steps.empty()) {
        json["steps"] = Json::array();
        for (const ShaftStep& step : picture.steps) json["steps"].push_back(nestedJson(describedValues(step)));
    }
    document.results = {report::toText(
        report::wholeResult("recognize", picture.inputs, toValues(result.parameters), json, result.notes))};
    return document;
}

void requireComplete(const RecognisePicture& picture)
{
    const features::Recognition& result = *picture.result;
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
    facts.workspaces = {{"copy", LT_TEXT("Engine", "Copy a part"), "copy_part", 50}};
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
    setViews(views_, views_->heroes());
    connect(views_->rows(), &RowsView::sizesAccepted, this, &RecognisePanel::toggle);
    connect(views_->rows(), &RowsView::allAccepted, this, &RecognisePanel::acceptAll);
    connect(views_, &RecogniseViews::shaftWanted, this, &RecognisePanel::keepShaft);
    connect(views_, &RecogniseViews::changeWanted, this, &RecognisePanel::change);
    connect(views_, &RecogniseViews::foundWanted, this, [this] {
        editState(tr("Take back all changes of the rows"), [](project::PanelState& state) {
            lathelier::set(state.parameters, changesKey, std::string());
            lathelier::set(state.parameters, acceptedKey, std::string());
        });
    });
    connect(views_, &RecogniseViews::notWritten, this, &RecognisePanel::sayNotWritten);
}

/// Accepts the sizes of a suggestion, or takes that back.
void RecognisePanel::toggle(const std::vector<features::AcceptedSize>& sizes)
{
    const auto picture = result();
    if (!picture || sizes.empty()) return;
    std::vector<features::AcceptedSize> accepted = picture->accepted;
    std::size_t taken_back = 0;
    for (const features::AcceptedSize& size : sizes) taken_back += std::erase(accepted, size);
    if (taken_back == 0) accepted.insert(accepted.end(), sizes.begin(), sizes.end());
    const std::int64_t row = sizes.front().row;
    editState(
        taken_back > 0 ? tr("Take back the size of row %1").arg(row) : tr("Accept the size of row %1").arg(row),
        [&](project::PanelState& state) { lathelier::set(state.parameters, acceptedKey, features::textOf(accepted)); });
}

/// The joint fit is run again with the changed rows; one that cannot be fitted is no step.
void RecognisePanel::change(const QString& step, const features::RowChange& asked)
{
    const auto picture = result();
    if (!picture) return;
    std::vector<features::RowChange> changes = picture->changes;
    changes.push_back(asked);
    try {
        refit(*picture->found, changes);
        editState(step, [&](project::PanelState& state) {
            lathelier::set(state.parameters, changesKey, features::textOf(changes));
            lathelier::set(state.parameters, changesOfKey, state.inputs.at(scanRole).path);
            lathelier::set(state.parameters, acceptedKey,
                           features::textOf(features::afterChange(picture->accepted, asked)));
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
    const auto picture = result();
    if (!picture) return;
    try {
        requireComplete(*picture);
        keepItem(picture->shaft.name, shaftItem, itemValues(measuredRows(*picture), recoveredFrom(*picture)));
    } catch (const Error& error) {
        emit messageRaised({error, facts().title});
    }
}

RecognisePanel::Compute RecognisePanel::compute(const project::PanelState& state) const
{
    fromValues<features::RecognitionParameters>(state.parameters);  // refuses now what is out of range
    return [state, last = last_, scans = session().stores().of<ScanStore>()](const Progress& progress) {
        return last->find(state, *scans, progress);
    };
}

void RecognisePanel::showResult(const std::shared_ptr<const RecognisePicture>& picture)
{
    views_->setPicture(picture);
}

report::Answer RecognisePanel::answer(const RecognisePicture& picture) const
{
    return features::answer(*picture.result);
}

void RecognisePanel::showPlace(const report::Place& place)
{
    if (place.z_mm) views_->markStretch(place.z_mm->from, place.z_mm->to);
}

Notes RecognisePanel::notes(const RecognisePicture& picture) const
{
    return picture.notes;
}

report::Document RecognisePanel::document(const RecognisePicture& picture) const
{
    return reportOf(picture, screenLanguage());
}

std::vector<PanelExport> RecognisePanel::exports() const
{
    const auto picture = result();
    if (!picture) return {};
    const auto write = [](const QString& path, const std::string& text) { io::writeFile(path.toStdString(), text); };
    const double chucked_mm = picture->result->parameters.length_of_chucked_mm.value_or(0);
    part_common::PartToWrite part;
    part.shaft = picture->shaft;
    part.stock = picture->result->complete ? features::outOfChuck(picture->shaft, chucked_mm) : picture->shaft;
    part.drawing = [picture](const Language& language) { return drawingOf(*picture, language); };
    part.requireComplete = [picture] { requireComplete(*picture); };
    part.csv = [picture] { return features::rowsCsv(*picture->result); };
    std::vector<PanelExport> all =
        part_common::exportsOf(std::make_shared<const part_common::PartToWrite>(std::move(part)));
    all.push_back({tr("Meridian and residuals (CSV)…"), tr("Table (*.csv)"), "csv",
                   [picture, write](const QString& path) { write(path, features::meridianCsv(*picture->result)); }});
    all.push_back(
        {tr("Meridian (SVG)…"), tr("Picture (*.svg)"), "svg", [picture, write](const QString& path) {
             write(path, report::toSvg(features::meridianPlot(*picture->result, screenLanguage()), screenLanguage()));
         }});
    all.push_back({tr("Residuals (SVG)…"), tr("Picture (*.svg)"), "svg", [picture, write](const QString& path) {
                       write(path, report::toSvg(features::residualPlot(*picture->result), screenLanguage()));
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
