#include "widgets/cylindricity/cylindricity_panel.h"

#include <algorithm>
#include <cmath>

#include "engine/core/profile_item.h"
#include "engine/form/roundness/section_of_points.h"
#include "widgets/core/language.h"
#include "widgets/cylindricity/cylindricity_views.h"

namespace lathelier::cylindricity_panel {
namespace {

const std::vector<std::string> roles{form::pointsRole};

PanelInputs panelInputs()
{
    PanelInputs inputs = inputsOf(form::cylindricityTask(), roles, {}, false,
                                  LT_TEXT("Engine", "Drop the points of a cylindrical surface here."));
    inputs.fields = form::cylindricityTask().fields;
    inputs.roles.front().takes_next = true;
    return inputs;
}

}  // namespace

PanelFacts cylindricityPanelFacts()
{
    PanelFacts facts = factsOf(form::cylindricityTask(), "cylindricity", "cylindricity", roles, {});
    facts.answer = answeredBy(form::answerCylindricity);
    facts.make = [](Session& session) -> PanelBase* { return new CylindricityPanel(session); };
    return facts;
}

CylindricityPanel::CylindricityPanel(Session& session, QWidget* parent)
    : TaskPanel(session, cylindricityPanelFacts(), panelInputs(), parent), views_(new CylindricityViews)
{
    setViews(views_, views_->primaryViews());
    connect(views_, &CylindricityViews::sectionRequested, this, &CylindricityPanel::offerSection);
    connect(views_, &CylindricityViews::notWritten, this, &CylindricityPanel::reportWriteFailure);
}

/// The marked measured section alone; for a scan a thin slice.
void CylindricityPanel::offerSection(double z_mm)
{
    const form::CylindricityOutcome& outcome = *result();
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
        profile.name = tr("%1, z %2 mm")
                           .arg(screenFileName(QString::fromStdString(outcome.sources.inputs.front().path)),
                                screenNumber(cut.z_mm, 2))
                           .toStdString();
        offerItem(profile.name, profileItem, toValues(profile), outcome.sources.synthetic);
    } catch (const Error& error) {
        emit messageRaised({error, facts().title});
    }
}

void CylindricityPanel::showResult(const std::shared_ptr<const form::CylindricityOutcome>& outcome)
{
    views_->setOutcome(outcome);
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
