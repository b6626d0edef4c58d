#include "widgets/compare/compare_panel.h"

#include <QToolButton>
#include <cmath>

#include "engine/cad/step_kind.h"
#include "engine/cad/task/compare_copies.h"
#include "engine/core/profile_item.h"
#include "engine/form/roundness/section_of_points.h"
#include "engine/io/shaft/shaft_kind.h"
#include "widgets/compare/compare_views.h"
#include "widgets/compare/zone_dialog.h"
#include "widgets/core/form/input_box.h"
#include "widgets/core/form/input_column.h"
#include "widgets/core/language.h"

namespace lathelier::compare_panel {
namespace {

const std::vector<std::string> roles{cad::referenceRole, cad::copyRole, cad::copiesRole};

/// With what the views show, in the worker. The further copies follow when this is shown.
cad::CompareOutcome compareForViews(const project::PanelState& state, Stores& stores, task::Sources& sources,
                                    const Progress& progress)
{
    cad::CompareOutcome outcome =
        cad::answerCompare(state, registration::CompareDetail::Full, stores, sources, progress.part(0, 0.9));
    addViews(outcome, stores, progress.part(0.9, 1));
    return outcome;
}

/// The unit of each file is one of its reading options.
PanelInputs panelInputs()
{
    PanelInputs inputs =
        inputsOf(cad::compareTask(), roles, {}, false,
                 LT_TEXT("Engine", "Drop two files here, first the original (scan or drawing), then the copy."));
    for (const FieldInfo& info : cad::compareTask().fields)
        if (info.key != cad::referenceUnitKey && info.key != cad::copyUnitKey) inputs.fields.push_back(info);
    for (InputRole& role : inputs.roles) role.takes_next = role.role == cad::copyRole;
    return inputs;
}

InputRole copiesInput()
{
    return rolesOf(cad::compareTask(), {cad::copiesRole}).front();
}

project::PanelState& stateIn(project::Project& project)
{
    return project.panels["compare"];
}

}  // namespace

PanelFacts comparePanelFacts()
{
    PanelFacts facts = factsOf(cad::compareTask(), "compare", "compare", roles, {});
    facts.kinds = {&io::scanFiles()};  // a drawing opens the panels of shafts
    facts.item_inputs.clear();         // likewise
    facts.answer = answeredBy(compareForViews);
    facts.make = [](Session& session) -> PanelBase* { return new ComparePanel(session); };
    return facts;
}

ComparePanel::ComparePanel(Session& owner, QWidget* parent)
    : TaskPanel(owner, comparePanelFacts(), panelInputs(), parent), views_(new CompareViews)
{
    setViews(views_, views_->primaryViews());
    addSwapButton();
    connect(views_, &CompareViews::toleranceDragged, this, &ComparePanel::dragTolerance);
    connect(views_, &CompareViews::copyRequested, this, &ComparePanel::showCopy);
    connect(views_, &CompareViews::zoneDrawn, this, &ComparePanel::askZone);
    connect(views_, &CompareViews::sectionRequested, this, &ComparePanel::offerSection);
    connect(views_, &CompareViews::notWritten, this, &ComparePanel::reportWriteFailure);
}

void ComparePanel::dragTolerance(double tolerance_mm, bool dropped)
{
    const double rounded_mm = std::round(tolerance_mm * 1e4) / 1e4;
    session().edit(
        tr("Change the tolerance"),
        [&](project::Project& project) { lathelier::set(stateIn(project).parameters, "tolerance_mm", rounded_mm); },
        QString("compare/tolerance/drag%1").arg(drags_));
    drags_ += dropped;
}

/// A slice of the copy two bins of the meridian thick, a millimetre at least.
void ComparePanel::offerSection(double z_mm)
{
    const cad::CompareOutcome& outcome = *result();
    const registration::CompareResult& compared = *outcome.result;
    const std::vector<double>& bins_mm = compared.meridian->z_mm;
    const double step_mm = bins_mm.size() > 1 ? bins_mm[1] - bins_mm[0] : 0;
    try {
        Profile profile = form::sectionOfPoints(outcome.copyScan().points_mm,
                                                *compared.axis_T_reference * compared.alignment.reference_T_copy,
                                                {z_mm, std::max(1.0, 2 * step_mm)});
        profile.name = tr("%1, z %2 mm")
                           .arg(screenFileName(QString::fromStdString(outcome.asked.inputs.at(cad::copyRole).path)),
                                screenNumber(z_mm, 2))
                           .toStdString();
        offerItem(profile.name, profileItem, toValues(profile), outcome.sources.synthetic);
    } catch (const Error& error) {
        emit messageRaised({error, facts().title});
    }
}

void ComparePanel::askZone(double from_mm, double to_mm)
{
    const auto known =
        fromValues<registration::CompareParameters>(state().parameters);  // the shown result may be older
    auto drawn = zoneAt(known.zones, from_mm, to_mm);
    if (!drawn) return;
    if (!drawn->existing) {
        drawn->zone.name = tr("Zone %1").arg(known.zones.size() + 1).toStdString();
        if (known.tolerance_mm) {
            drawn->zone.lower_mm = -*known.tolerance_mm;
            drawn->zone.upper_mm = *known.tolerance_mm;
        }
    }
    ZoneDialog dialog(drawn->zone, drawn->existing.has_value(), this);
    if (dialog.exec() != QDialog::Accepted) return;
    const ZoneDialog::Answer answer = dialog.answer();
    const registration::ZoneLimits zone = dialog.zone();
    const auto wanted = [&](registration::CompareParameters parameters) {
        if (answer == ZoneDialog::Answer::LeaveOut)
            parameters.exclude_z_mm.push_back({zone.z_start_mm, zone.z_end_mm});
        else if (answer == ZoneDialog::Answer::Remove)
            parameters.zones.erase(parameters.zones.begin() + static_cast<std::ptrdiff_t>(*drawn->existing));
        else if (drawn->existing)
            parameters.zones[*drawn->existing] = zone;
        else
            parameters.zones.push_back(zone);
        return toValues(parameters);
    };
    session().edit(answer == ZoneDialog::Answer::LeaveOut ? tr("Leave a zone out")
                   : answer == ZoneDialog::Answer::Remove ? tr("Remove a zone")
                   : drawn->existing                      ? tr("Edit a zone")
                                                          : tr("Add a zone"),
                   [&](project::Project& project) {
                       Values& parameters = stateIn(project).parameters;
                       parameters = wanted(fromValues<registration::CompareParameters>(parameters));
                   });
}

void ComparePanel::addSwapButton()
{
    swap_ = new QToolButton;
    swap_->setObjectName("swap");
    swap_->setAutoRaise(true);
    inputColumn().insertBefore(cad::copyRole, swap_);
    connect(swap_, &QToolButton::clicked, this, &ComparePanel::swapInputs);
    ComparePanel::retranslate();
}

void ComparePanel::swapInputs()
{
    if (const auto shown = result(); shown && shown->reference.drawn) return;  // a drawing cannot be the copy
    session().edit(tr("Swap reference and copy"), [](project::Project& project) {
        auto& inputs = stateIn(project).inputs;
        const auto reference = inputs.find(cad::referenceRole);
        const auto copy = inputs.find(cad::copyRole);
        if (reference != inputs.end() && copy != inputs.end()) return std::swap(reference->second, copy->second);
        const auto only = reference != inputs.end() ? reference : copy;
        if (only == inputs.end()) return;
        const char* other = only == reference ? cad::copyRole : cad::referenceRole;
        const project::Source source = only->second;
        inputs.erase(only);
        inputs[other] = source;
    });
}

void ComparePanel::showResult(const std::shared_ptr<const cad::CompareOutcome>& outcome)
{
    views_->setOutcome(outcome);
    copies_.clear();
    if (cad::furtherCopies(outcome->asked).empty()) {
        series_.cancel();
        return views_->setCopies({});
    }
    series_.compute<std::vector<registration::CopySummary>>(
        [outcome, stores = session().sharedStores()](const Progress& progress) {
            return cad::compareCopies(*outcome, *stores, progress);
        },
        [this](const std::vector<registration::CopySummary>& copies) {
            copies_ = copies;
            views_->setCopies(copies_);
        },
        [this](const Error& error) {
            emit messageRaised({error, facts().title});
        });
}

/// Exchanges the further copy with the one on screen.
void ComparePanel::showCopy(int number)
{
    session().edit(tr("Show another copy"), [number](project::Project& project) {
        project::PanelState& panel = stateIn(project);
        const std::vector<project::Source> others = cad::furtherCopies(panel);
        if (number < 0 || number >= static_cast<int>(others.size())) return;
        std::vector<project::Source> after = others;
        std::swap(after[static_cast<std::size_t>(number)], panel.inputs[cad::copyRole]);
        setSources(panel, copiesInput(), after);
    });
}

/// Number of rows of a drawing, or of points of a scan.
QString ComparePanel::understood(const InputRole& role, const project::Source& source) const
{
    if (const auto part = session().stores().of<task::CacheOf<cad::PartInput>>()->known(source)) {
        const Shaft& shaft = part->file.shaft;
        return understoodText(
            part->file.facts,
            tr("%L1 segments · %2").arg(shaft.segments.size()).arg(screenQuantity(shaft.length_mm(), millimetre, 1)));
    }
    return Panel::understood(role, source);
}

/// Only the reference may be a drawing.
void ComparePanel::assignFiles(project::PanelState& state, const std::vector<FoundFile>& files) const
{
    std::vector<FoundFile> scans;
    for (const FoundFile& file : files) {
        if (file.kind == &cad::stepFiles() || file.kind == &io::shaftFiles())
            state.inputs[cad::referenceRole] = newSource(QString::fromStdString(file.path));
        else
            scans.push_back(file);
    }
    assignInOrder(state, scans);
}

void ComparePanel::showPlace(const report::Place& place)
{
    if (place.z_mm) views_->markAlong((place.z_mm->from + place.z_mm->to) / 2, place.angle_deg);
}

/// With the pictures of the views, and with the further copies where they were compared.
report::Document ComparePanel::document(const cad::CompareOutcome& outcome) const
{
    const auto whole = std::make_shared<cad::CompareOutcome>(outcome);
    whole->pictures = views_->pictures();
    addCopies(*whole, copies_);
    return task::documentOf(cad::compareTask(), whole->asked, whole->sources, outcomeOf(whole), screenLanguage());
}

std::vector<PanelExport> ComparePanel::exports() const
{
    std::vector<PanelExport> all = TaskPanel::exports();
    for (const PanelExport& as_cloud : TaskPanel::exports())
        all.push_back({tr("Deviations of all points (CSV)…"), tr("Table (*.csv)"), "csv", as_cloud.write});
    return all;
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
