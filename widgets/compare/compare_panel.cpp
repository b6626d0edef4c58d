#include "widgets/compare/compare_panel.h"

#include <QToolButton>
#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "engine/cad/step_kind.h"
#include "engine/core/profile_item.h"
#include "engine/form/roundness/section_of_points.h"
#include "engine/io/shaft/shaft_kind.h"
#include "engine/registration/compare_quantities.h"
#include "engine/registration/compare_report.h"
#include "engine/registration/deviation_file.h"
#include "engine/report/result_json.h"
#include "engine/shaft/shaft_item.h"
#include "widgets/compare/compare_views.h"
#include "widgets/compare/zone_dialog.h"
#include "widgets/core/form/input_box.h"
#include "widgets/core/form/input_column.h"
#include "widgets/core/language.h"
#include "widgets/part_common/part_store.h"

namespace lathelier::compare_panel {
namespace {

PanelInputs panelInputs()
{
    PanelInputs inputs;
    inputs.roles = {{referenceRole, LT_TEXT("Engine", "Reference"),
                     LT_TEXT("Engine", "Scan or mesh of the original; or its drawing: STEP, SHAFT.json, a shaft")},
                    {"copy", LT_TEXT("Engine", "Copy"), LT_TEXT("Engine", "Scan of the part to be judged")}};
    inputs.roles.back().takes_next = true;  // a further file replaces the copy
    InputRole copies{copiesRole, LT_TEXT("Engine", "Further copies"),
                     LT_TEXT("Engine", "Scans of more parts, judged by the same limits: table and trend")};
    copies.required = false;
    copies.several = true;
    inputs.roles.push_back(copies);
    for (InputRole& role : inputs.roles) role.kinds = {&io::scanFiles()};
    inputs.roles.front().kinds = {&io::scanFiles(), &cad::stepFiles(), &io::shaftFiles()};
    inputs.roles.front().item_kind = shaftItem;
    inputs.fields = infos<registration::CompareParameters>();
    inputs.defaults = toValues(registration::CompareParameters{});
    inputs.invitation = LT_TEXT("Engine", "Drop two files here, first the original (scan or drawing), then the copy.");
    return inputs;
}

report::Document reportOf(const CompareOutcome& outcome, const Language& language,
                          std::vector<report::Picture> pictures, const std::vector<registration::CopySummary>& copies)
{
    registration::CompareResult result = *outcome.result;
    result.notes = outcome.notes;  // including those of the files
    report::Document document;
    Json json;
    if (outcome.sizes) {
        features::ShaftComparison all = *outcome.sizes;
        all.surface.notes = outcome.notes;
        document = shaftReport(all, outcome.inputs, language, std::move(pictures));
        json = toJson(all);
    } else {
        document = compareReport(result, outcome.inputs, language, std::move(pictures));
        json = toJson(result);
    }
    document.synthetic = outcome.synthetic;
    for (const registration::CopySummary& copy : copies)
        if (copy.file) document.inputs.push_back(*copy.file);
    if (copies.size() > 1)
        document.sections.insert(
            document.sections.begin() + 1,
            report::Section{LT_TEXT("Engine", "Copies of the same original"),
                            {copiesTrend(copies, result.parameters, language), copiesTable(copies, language)}});
    document.results = {report::toText(
        report::wholeResult("compare", outcome.inputs, toValues(result.parameters), json, result.notes))};
    return document;
}

}  // namespace

PanelFacts comparePanelFacts()
{
    PanelFacts facts;
    facts.id = "compare";
    facts.title = LT_TEXT("Engine", "Compare");
    facts.icon = "compare";
    facts.workspaces = {workspaceOf("inspection")};
    facts.kinds = {&io::scanFiles()};
    facts.part_inputs = {"copy", copiesRole};
    facts.make = [](Session& session) -> PanelBase* { return new ComparePanel(session); };
    facts.roles = panelInputs().roles;
    facts.report = [](const project::PanelState& state, Stores& stores, const Language& language,
                      const Progress& progress) {
        const bool alone = furtherCopies(state).empty();
        const CompareOutcome outcome = LastComparison().find(state, stores, progress.part(0, alone ? 1 : 0.4));
        std::vector<registration::CopySummary> copies;
        if (!alone) copies = KnownCopies().find(state, outcome, progress.part(0.4, 1));
        return reportOf(outcome, language, {}, copies);
    };
    return facts;
}

ComparePanel::ComparePanel(Session& session, QWidget* parent)
    : Panel(session, comparePanelFacts(), panelInputs(), parent),
      views_(new CompareViews),
      last_(std::make_shared<LastComparison>()),
      known_(std::make_shared<KnownCopies>())
{
    setViews(views_, views_->primaryViews());
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
    connect(views_, &CompareViews::copyRequested, this, &ComparePanel::showCopy);
    connect(views_, &CompareViews::zoneDrawn, this, &ComparePanel::askZone);
    connect(views_, &CompareViews::sectionRequested, this, &ComparePanel::offerSection);
    connect(views_, &CompareViews::notWritten, this, &ComparePanel::reportWriteFailure);
}

/// A slice of the copy two bins of the meridian thick, a millimetre at least.
void ComparePanel::offerSection(double z_mm)
{
    const CompareOutcome& outcome = *result();
    const registration::CompareResult& compared = *outcome.result;
    const std::vector<double>& bins_mm = compared.meridian->z_mm;
    const double step_mm = bins_mm.size() > 1 ? bins_mm[1] - bins_mm[0] : 0;
    try {
        Profile profile = form::sectionOfPoints(outcome.copyScan().points_mm,
                                                *compared.axis_T_reference * compared.alignment.reference_T_copy,
                                                {z_mm, std::max(1.0, 2 * step_mm)});
        profile.name =
            tr("%1, z %2 mm")
                .arg(screenFileName(QString::fromStdString(outcome.inputs.back().path)), screenNumber(z_mm, 2))
                .toStdString();
        offerItem(profile.name, profileItem, toValues(profile), outcome.synthetic);
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
                       Values& parameters = project.panels["compare"].parameters;
                       parameters = wanted(fromValues<registration::CompareParameters>(parameters));
                   });
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
    if (const auto shown = result(); shown && shown->drawn) return;  // a drawing cannot be the copy
    session().edit(tr("Swap reference and copy"), [](project::Project& project) {
        auto& inputs = project.panels["compare"].inputs;
        const auto reference = inputs.find("reference");
        const auto copy = inputs.find("copy");
        if (reference != inputs.end() && copy != inputs.end()) return std::swap(reference->second, copy->second);
        const auto only = reference != inputs.end() ? reference : copy;
        if (only == inputs.end()) return;
        const char* other = only == reference ? "copy" : "reference";
        const project::Source source = only->second;
        inputs.erase(only);
        inputs[other] = source;
    });
}

ComparePanel::Compute ComparePanel::compute(const project::PanelState& state) const
{
    fromValues<registration::CompareParameters>(state.parameters);  // validates ranges before the computation
    return [state, last = last_, stores = session().sharedStores()](const Progress& progress) {
        return last->find(state, *stores, progress);
    };
}

void ComparePanel::showResult(const std::shared_ptr<const CompareOutcome>& outcome)
{
    views_->setOutcome(outcome);
    copies_.clear();
    if (furtherCopies(state()).empty()) {
        series_.cancel();
        return views_->setCopies({});
    }
    series_.compute<std::vector<registration::CopySummary>>(
        [state = state(), outcome, known = known_](const Progress& progress) {
            return known->find(state, *outcome, progress);
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
        project::PanelState& panel = project.panels["compare"];
        const std::vector<project::Source> others = furtherCopies(panel);
        if (number < 0 || number >= static_cast<int>(others.size())) return;
        std::vector<project::Source> after = others;
        std::swap(after[static_cast<std::size_t>(number)], panel.inputs["copy"]);
        InputRole role;
        role.role = copiesRole;
        role.several = true;
        setSources(panel, role, after);
    });
}

report::Answer ComparePanel::answer(const CompareOutcome& outcome) const
{
    return outcome.sizes ? features::answer(*outcome.sizes, screenLanguage())
                         : registration::answer(*outcome.result, screenLanguage());
}

/// Number of rows of a drawing, or of points of a scan.
QString ComparePanel::understood(const InputRole& role, const project::Source& source) const
{
    if (const auto part = session().stores().of<part_common::PartStore>()->known(source)) {
        const Shaft& shaft = part->file.shaft;
        return understoodText(
            part->file.facts,
            tr("%L1 segments · %2").arg(shaft.segments.size()).arg(screenQuantity(shaft.length_mm(), millimetre, 1)));
    }
    return Panel::understood(role, source);
}

/// A drawing as reference has no scan.
Worker::Job ComparePanel::makeReadingJob(const project::PanelState& state) const
{
    return [stores = session().sharedStores(),
            inputs = state.inputs](const Progress& progress) -> std::shared_ptr<const void> {
        const Progress reading = progress.part(0, 1, LT_TEXT("Engine", "Reading"));
        for (const auto& [role, source] : inputs) {
            if (!source.item.empty()) continue;
            if (role == referenceRole && isDrawn(source))
                stores->of<part_common::PartStore>()->load(source, reading);
            else
                stores->of<ScanStore>()->load(source, reading);
        }
        return nullptr;
    };
}

/// Only the reference may be a drawing.
void ComparePanel::assignFiles(project::PanelState& state, const std::vector<FoundFile>& files) const
{
    std::vector<FoundFile> scans;
    for (const FoundFile& file : files) {
        if (file.kind == &cad::stepFiles() || file.kind == &io::shaftFiles())
            state.inputs[referenceRole] = newSource(QString::fromStdString(file.path));
        else
            scans.push_back(file);
    }
    Panel::assignFiles(state, scans);
}

void ComparePanel::showPlace(const report::Place& place)
{
    if (place.z_mm) views_->markAlong((place.z_mm->from + place.z_mm->to) / 2, place.angle_deg);
}

Notes ComparePanel::notes(const CompareOutcome& outcome) const
{
    return outcome.notes;
}

report::Document ComparePanel::document(const CompareOutcome& outcome) const
{
    return reportOf(outcome, screenLanguage(), views_->pictures(), copies_);
}

std::vector<PanelExport> ComparePanel::exports() const
{
    const auto outcome = result();
    if (!outcome) return {};
    const auto write = [outcome](const QString& path) {
        writeDeviations(path.toStdString(), outcome->copyScan(), *outcome->result);
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
