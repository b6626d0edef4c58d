#include "widgets/cylindricity/cylindricity_panel.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "engine/core/profile_item.h"
#include "engine/form/cylinder/cylindricity_plots.h"
#include "engine/form/cylinder/cylindricity_quantities.h"
#include "engine/form/cylinder/cylindricity_report.h"
#include "engine/form/roundness/section_of_points.h"
#include "engine/io/file.h"
#include "engine/report/chart_csv.h"
#include "engine/report/result_json.h"
#include "widgets/core/language.h"
#include "widgets/cylindricity/cylindricity_views.h"

namespace lathelier::cylindricity_panel {
namespace {

PanelInputs panelInputs()
{
    InputRole points;
    points.role = "points";
    points.label = LT_TEXT("Engine", "Points");
    points.hint =
        LT_TEXT("Engine", "Points of one cylindrical surface: a scan, or sections measured one above the other.");
    points.kinds = {&io::scanFiles()};
    points.takes_next = true;
    PanelInputs inputs;
    inputs.roles = {points};
    inputs.fields = infos<form::CylindricityParameters>();
    inputs.defaults = toValues(form::CylindricityParameters{});
    inputs.invitation = LT_TEXT("Engine", "Drop the points of a cylindrical surface here.");
    return inputs;
}

report::Document reportOf(const CylindricityOutcome& outcome, const Language& language)
{
    form::CylindricityResult result = *outcome.result;
    result.notes = outcome.notes;  // those of the file as well
    report::Document document = cylindricityReport(result, outcome.surface.get(), outcome.inputs, language);
    document.synthetic = outcome.synthetic;
    document.results = {report::toText(report::wholeResult("cylindricity", outcome.inputs, toValues(result.parameters),
                                                           nestedJson(describedValues(result)), result.notes))};
    return document;
}

}  // namespace

PanelFacts cylindricityPanelFacts()
{
    PanelFacts facts;
    facts.id = "cylindricity";
    facts.title = LT_TEXT("Engine", "Cylindricity");
    facts.icon = "cylindricity";
    facts.workspaces = {workspaceOf("roundness")};
    facts.kinds = {&io::scanFiles()};
    facts.part_inputs = {"points"};
    facts.make = [](Session& session) -> PanelBase* { return new CylindricityPanel(session); };
    facts.roles = panelInputs().roles;
    facts.report = [](const project::PanelState& state, Stores& stores, const Language& language,
                      const Progress& progress) {
        return reportOf(LastCylinder().find(state, *stores.of<ScanStore>(), progress), language);
    };
    return facts;
}

CylindricityPanel::CylindricityPanel(Session& session, QWidget* parent)
    : Panel(session, cylindricityPanelFacts(), panelInputs(), parent),
      views_(new CylindricityViews),
      last_(std::make_shared<LastCylinder>())
{
    setViews(views_, views_->primaryViews());
    connect(views_, &CylindricityViews::sectionRequested, this, &CylindricityPanel::offerSection);
    connect(views_, &CylindricityViews::notWritten, this, &CylindricityPanel::reportWriteFailure);
}

/// The marked measured section alone; for a scan a thin slice.
void CylindricityPanel::offerSection(double z_mm)
{
    const CylindricityOutcome& outcome = *result();
    const form::CylinderSurface& surface = *outcome.surface;
    const bool in_sections = outcome.result->sections > 1;
    form::SectionCut cut{z_mm, std::max(1.0, outcome.result->length_mm / 200)};
    if (in_sections) {
        const auto nearest = std::min_element(surface.z_mm.begin(), surface.z_mm.end(), [z_mm](double a, double b) {
            return std::abs(a - z_mm) < std::abs(b - z_mm);
        });
        cut = {*nearest, surface.z_step_mm / 2};
    }
    try {
        Profile profile = sectionOfPoints(outcome.scan().points_mm, surface.axis_T_points, cut);
        profile.name =
            tr("%1, z %2 mm")
                .arg(screenFileName(QString::fromStdString(outcome.inputs.front().path)), screenNumber(cut.z_mm, 2))
                .toStdString();
        offerItem(profile.name, profileItem, toValues(profile), outcome.synthetic);
    } catch (const Error& error) {
        emit messageRaised({error, facts().title});
    }
}

CylindricityPanel::Compute CylindricityPanel::compute(const project::PanelState& state) const
{
    fromValues<form::CylindricityParameters>(state.parameters);  // validates ranges before the computation
    return [state, last = last_, scans = session().stores().of<ScanStore>()](const Progress& progress) {
        return last->find(state, *scans, progress);
    };
}

void CylindricityPanel::showResult(const std::shared_ptr<const CylindricityOutcome>& outcome)
{
    views_->setOutcome(outcome);
}

report::Answer CylindricityPanel::answer(const CylindricityOutcome& outcome) const
{
    return form::answer(*outcome.result);
}

Notes CylindricityPanel::notes(const CylindricityOutcome& outcome) const
{
    return outcome.notes;
}

report::Document CylindricityPanel::document(const CylindricityOutcome& outcome) const
{
    return reportOf(outcome, screenLanguage());
}

std::vector<PanelExport> CylindricityPanel::exports() const
{
    const auto outcome = result();
    if (!outcome) return {};
    return {{tr("Local radius and axis along the length (CSV)…"), tr("Table (*.csv)"), "csv",
             [outcome](const QString& path) {
                 report::Plot plot = radiusAlongAxis(*outcome->surface, outcome->result->parameters);
                 for (report::Curve& curve : centresAlongAxis(*outcome->surface).curves)
                     plot.curves.push_back(std::move(curve));
                 io::writeFile(path.toStdString(), report::toCsv(plot));
             }}};
}

Values CylindricityPanel::view() const
{
    return views_->view();
}

void CylindricityPanel::restoreView(const Values& kept)
{
    views_->restoreView(kept);
}

void CylindricityPanel::retranslate()
{
    views_->retranslate();
}

}  // namespace lathelier::cylindricity_panel
