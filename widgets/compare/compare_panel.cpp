#include "widgets/compare/compare_panel.h"

#include <QToolButton>
#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "engine/core/profile_item.h"
#include "engine/form/roundness/section_of_points.h"
#include "engine/registration/compare_quantities.h"
#include "engine/registration/compare_report.h"
#include "engine/registration/deviation_file.h"
#include "engine/report/result_json.h"
#include "widgets/compare/compare_views.h"
#include "widgets/core/form/input_column.h"
#include "widgets/core/language.h"

namespace lathelier::compare_panel {
namespace {

PanelInputs panelInputs()
{
    PanelInputs inputs;
    inputs.roles = {{"reference", LT_TEXT("Engine", "Reference"), LT_TEXT("Engine", "Scan or mesh of the original")},
                    {"copy", LT_TEXT("Engine", "Copy"), LT_TEXT("Engine", "Scan of the part to be judged")}};
    for (InputRole& role : inputs.roles) role.kinds = {&io::scanFiles()};
    inputs.roles.back().takes_next = true;  // the master stays, the next copy comes
    inputs.fields = infos<registration::CompareParameters>();
    inputs.defaults = toValues(registration::CompareParameters{});
    inputs.invitation = LT_TEXT("Engine", "Drop two scans here, first the original, then the copy.");
    return inputs;
}

report::Document reportOf(const ComparePicture& picture, const Language& language,
                          std::vector<report::Picture> pictures)
{
    registration::CompareResult result = *picture.result;
    result.notes = picture.notes;  // those of the files as well
    report::Document document = compareReport(result, picture.inputs, language, std::move(pictures));
    document.synthetic = picture.synthetic;
    document.results = {report::toText(
        report::wholeResult("compare", picture.inputs, toValues(result.parameters), toJson(result), result.notes))};
    return document;
}

}  // namespace

PanelFacts comparePanelFacts()
{
    PanelFacts facts;
    facts.id = "compare";
    facts.title = LT_TEXT("Engine", "Compare");
    facts.icon = "compare";
    facts.workspaces = {{"inspection", LT_TEXT("Engine", "Inspection"), "inspection", 10}};
    facts.kinds = {&io::scanFiles()};
    facts.part_inputs = {"copy"};
    facts.make = [](Session& session) -> PanelBase* { return new ComparePanel(session); };
    facts.missing = missingOf(panelInputs().roles);
    facts.report = [](const project::PanelState& state, Stores& stores, const Language& language,
                      const Progress& progress) {
        return reportOf(LastComparison().find(state, *stores.of<ScanStore>(), progress), language, {});
    };
    return facts;
}

ComparePanel::ComparePanel(Session& session, QWidget* parent)
    : Panel(session, comparePanelFacts(), panelInputs(), parent),
      views_(new CompareViews),
      last_(std::make_shared<LastComparison>())
{
    setViews(views_, views_->heroes());
    addSwapButton();
    connect(views_, &CompareViews::toleranceDragged, this, [this](double tolerance_mm, bool dropped) {
        const double rounded_mm = std::round(tolerance_mm * 1e4) / 1e4;
        Panel::session().edit(
            tr("Change the tolerance"),
            [&](project::Project& project) {
                lathelier::set(project.panels["compare"].parameters, "tolerance_mm", rounded_mm);
            },
            QString("compare/tolerance/drag%1").arg(drags_));
        drags_ += dropped;
    });
    connect(views_, &CompareViews::sectionWanted, this, &ComparePanel::offerSection);
    connect(views_, &CompareViews::notWritten, this, &ComparePanel::sayNotWritten);
}

/// A slice of the copy two bins of the meridian thick, a millimetre at least.
void ComparePanel::offerSection(double z_mm)
{
    const ComparePicture& picture = *result();
    const registration::CompareResult& compared = *picture.result;
    const std::vector<double>& bins_mm = compared.meridian->z_mm;
    const double step_mm = bins_mm.size() > 1 ? bins_mm[1] - bins_mm[0] : 0;
    try {
        Profile profile = form::sectionOfPoints(picture.copyScan().points_mm,
                                                *compared.axis_T_reference * compared.alignment.reference_T_copy,
                                                {z_mm, std::max(1.0, 2 * step_mm)});
        profile.name =
            tr("%1, z %2 mm")
                .arg(screenFileName(QString::fromStdString(picture.inputs.back().path)), screenNumber(z_mm, 2))
                .toStdString();
        offerItem(profile.name, profileItem, toValues(profile), picture.synthetic);
    } catch (const Error& error) {
        emit messageRaised({error, facts().title});
    }
}

void ComparePanel::addSwapButton()
{
    swap_ = new QToolButton;
    swap_->setObjectName("swap");
    swap_->setAutoRaise(true);
    inputColumn().insertBefore("copy", swap_);
    connect(swap_, &QToolButton::clicked, this, &ComparePanel::swapInputs);
    ComparePanel::retranslate();
}

void ComparePanel::swapInputs()
{
    session().edit(tr("Swap reference and copy"), [](project::Project& project) {
        auto& inputs = project.panels["compare"].inputs;
        std::map<std::string, project::Source> swapped;
        for (auto& [role, source] : inputs) swapped[role == "reference" ? "copy" : "reference"] = source;
        inputs = swapped;
    });
}

ComparePanel::Compute ComparePanel::compute(const project::PanelState& state) const
{
    fromValues<registration::CompareParameters>(
        state.parameters);  // refuses now, not in the worker, what is out of range
    return [state, last = last_, scans = session().stores().of<ScanStore>()](const Progress& progress) {
        return last->find(state, *scans, progress);
    };
}

void ComparePanel::showResult(const std::shared_ptr<const ComparePicture>& picture)
{
    views_->setPicture(picture);
}

report::Answer ComparePanel::answer(const ComparePicture& picture) const
{
    return registration::answer(*picture.result, screenLanguage());
}

void ComparePanel::showPlace(const report::Place& place)
{
    if (place.z_mm) views_->markAlong((place.z_mm->from + place.z_mm->to) / 2, place.angle_deg);
}

Notes ComparePanel::notes(const ComparePicture& picture) const
{
    return picture.notes;
}

report::Document ComparePanel::document(const ComparePicture& picture) const
{
    return reportOf(picture, screenLanguage(), views_->pictures());
}

std::vector<PanelExport> ComparePanel::exports() const
{
    const auto picture = result();
    if (!picture) return {};
    const auto write = [picture](const QString& path) {
        writeDeviations(path.toStdString(), picture->copyScan(), *picture->result);
    };
    return {{tr("Deviations of all points (PLY)…"), tr("Point cloud (*.ply)"), "ply", write},
            {tr("Deviations of all points (CSV)…"), tr("Table (*.csv)"), "csv", write}};
}

Values ComparePanel::view() const
{
    return views_->view();
}

void ComparePanel::restoreView(const Values& kept)
{
    views_->restoreView(kept);
}

void ComparePanel::retranslate()
{
    swap_->setText(tr("⇅ Swap"));
    swap_->setToolTip(tr("Reference and copy change places"));
    swap_->setAccessibleName(swap_->toolTip());
    views_->retranslate();
}

}  // namespace lathelier::compare_panel
