#include "widgets/frf/frf_panel.h"

#include <algorithm>
#include <cmath>

#include "engine/core/frf_item.h"
#include "engine/io/file.h"
#include "engine/io/frf/frf_writer.h"
#include "engine/io/shaft/shaft_kind.h"
#include "engine/receptance/modal/modal_quantities.h"
#include "engine/receptance/modal/modal_report.h"
#include "engine/receptance/spindle_item.h"
#include "engine/receptance/spindle_kind.h"
#include "engine/report/quantity_table.h"
#include "engine/shaft/shaft_item.h"
#include "widgets/chatter_common/model_inputs.h"
#include "widgets/core/form/input_box.h"
#include "widgets/core/form/input_column.h"
#include "widgets/core/language.h"
#include "widgets/core/session.h"
#include "widgets/frf/frf_views.h"

namespace lathelier::frf_panel {
namespace {

PanelInputs panelInputs()
{
    PanelInputs inputs;
    inputs.roles = {
        chatter_common::inputRole(frfRole, LT_TEXT("Engine", "Frequency response"),
                                  LT_TEXT("Engine", "Measured by a hammer or shaker: UFF, CSV or MAT."), io::frfFiles(),
                                  frfItem),
        chatter_common::inputRole(
            shaftRole, LT_TEXT("Engine", "Shaft"),
            LT_TEXT("Engine", "Whose computed response is drawn under the measured one: SHAFT.json or a stock file."),
            io::shaftFiles(), shaftItem),
        chatter_common::inputRole(
            spindleRole, LT_TEXT("Engine", "Spindle"),
            LT_TEXT("Engine", "That holds the shaft: SPINDLE.json. Without it the shaft is free."),
            receptance::spindleFiles(), receptance::spindleItem)};
    for (InputRole& role : inputs.roles) role.required = false;
    inputs.roles.front().takes_next = true;
    inputs.fields = infos<FrfQuestion>();
    inputs.defaults = toValues(FrfQuestion{});
    inputs.invitation = LT_TEXT("Engine", "Drop a measured frequency response here, or a shaft and its spindle.");
    return inputs;
}

bool hasResponse(const project::PanelState& state)
{
    return state.inputs.count(frfRole) > 0 || state.inputs.count(shaftRole) > 0;
}

std::string modesCsv(const receptance::ResponseStudy& study)
{
    return report::csvOf<receptance::ShownMode>(
        receptance::shownModes(study),
        {"rank", "frequency_hz", "frequency_uncertainty_hz", "damping_ratio", "damping_uncertainty", "stiffness_N_mm",
         "stiffness_uncertainty_N_mm", "phase_deg", "flexibility_nm_N"});
}

}  // namespace

PanelFacts frfPanelFacts()
{
    PanelFacts facts;
    facts.id = "frf";
    facts.title = LT_TEXT("Engine", "FRF");
    facts.icon = "frf";
    facts.workspaces = {workspaceOf("chatter")};
    facts.kinds = {&io::frfFiles()};
    facts.roles = panelInputs().roles;
    facts.part_inputs = {frfRole};
    facts.make = [](Session& session) -> PanelBase* { return new FrfPanel(session); };
    facts.missing = [](const project::PanelState& state) {
        std::vector<Text> labels;
        if (!hasResponse(state)) labels.push_back(LT_TEXT("Engine", "Frequency response or shaft"));
        return labels;
    };
    facts.has_work = hasResponse;
    facts.report = [](const project::PanelState& state, Stores& stores, const Language& language,
                      const Progress& progress) { return reportOf(frfOutcome(state, stores, progress), language); };
    return facts;
}

FrfPanel::FrfPanel(Session& owner, QWidget* parent)
    : Panel(owner, frfPanelFacts(), panelInputs(), parent), views_(new FrfViews)
{
    setViews(views_, views_->primaryViews());
    connect(views_, &FrfViews::modeDragged, this, &FrfPanel::dragMode);
    connect(views_, &FrfViews::fitRequested, this, &FrfPanel::goBackToTheFit);
    connect(views_, &FrfViews::responseRequested, this, &FrfPanel::offerResponse);
    connect(views_, &FrfViews::notWritten, this, &FrfPanel::reportWriteFailure);
}

/// The dragged peak changes the mode of the model, not the fit.
void FrfPanel::dragMode(int index, double frequency_hz, double magnitude_mm_N, bool dropped)
{
    const auto outcome = result();
    const auto at = static_cast<std::size_t>(index);
    if (!outcome || at >= outcome->study.model.modes.size()) return;
    FrfQuestion question;
    question.modes = outcome->study.model.modes;
    question.modes[at] = receptance::draggedMode(outcome->study.model, at, frequency_hz, magnitude_mm_N);
    editState(
        tr("Drag a peak"),
        [&](project::PanelState& state) {
            lathelier::set(state.parameters, "modes", *lathelier::find(toValues(question), "modes"));
        },
        QString("frf/modes/%1").arg(gesture_));
    gesture_ += dropped;
}

void FrfPanel::goBackToTheFit()
{
    editState(tr("Back to the fit"),
              [](project::PanelState& state) { lathelier::set(state.parameters, "modes", Rows{}); });
}

void FrfPanel::offerResponse()
{
    const auto outcome = result();
    const FrfPtr frf = outcome ? outcome->handedOn() : nullptr;
    if (!frf) return;
    try {
        Frf item = *frf;
        item.name = outcome->question.handed_on == HandedOn::Model
                        ? tr("%1, modal model").arg(QString::fromStdString(outcome->name)).toStdString()
                        : outcome->name;
        offerItem(item.name, frfItem, toValues(item), outcome->synthetic);
    } catch (const Error& error) {
        emit messageRaised({error, facts().title});
    }
}

FrfPanel::Compute FrfPanel::compute(const project::PanelState& state) const
{
    fromValues<FrfQuestion>(state.parameters);  // validates ranges before the computation
    return [state, stores = session().sharedStores()](const Progress& progress) {
        return frfOutcome(state, *stores, progress);
    };
}

void FrfPanel::assignFiles(project::PanelState& state, const std::vector<FoundFile>& files) const
{
    for (const FoundFile& file : files) {
        const char* role = file.kind == &io::shaftFiles()             ? shaftRole
                           : file.kind == &receptance::spindleFiles() ? spindleRole
                                                                      : frfRole;
        state.inputs[role] = newSource(QString::fromStdString(file.path));
    }
}

Worker::Job FrfPanel::makeReadingJob(const project::PanelState& state) const
{
    return [state, stores = session().sharedStores()](const Progress& progress) -> std::shared_ptr<const void> {
        chatter_common::takeSpindle(state, *stores, progress);  // the only input to read in an incomplete state
        return nullptr;
    };
}

QString FrfPanel::understood(const InputRole& role, const project::Source& source) const
{
    if (role.role != frfRole) return chatter_common::understoodModel(role.role, source, session().stores());
    return chatter_common::understoodResponse(source, session().stores());
}

void FrfPanel::showResult(const std::shared_ptr<const FrfOutcome>& outcome)
{
    views_->setOutcome(outcome);
}

report::Answer FrfPanel::answer(const FrfOutcome& outcome) const
{
    return receptance::answer(outcome.study, screenLanguage());
}

Notes FrfPanel::notes(const FrfOutcome& outcome) const
{
    return outcome.notes;
}

report::Document FrfPanel::document(const FrfOutcome& outcome) const
{
    return reportOf(outcome, screenLanguage());
}

std::vector<PanelExport> FrfPanel::exports() const
{
    const auto outcome = result();
    if (!outcome) return {};
    std::vector<PanelExport> all;
    if (const FrfPtr frf = outcome->handedOn()) {
        all.push_back({tr("Response (CSV)…"), tr("Table (*.csv)"), "csv",
                       [frf](const QString& path) { io::writeFrfCsv(path.toStdString(), *frf); }});
        all.push_back({tr("Response (UFF 58)…"), tr("Universal file (*.uff)"), "uff",
                       [frf, places = outcome->places](const QString& path) {
                           io::MeasuredFrf response = places;
                           response.frf = *frf;
                           io::writeUff(path.toStdString(), {&response, 1});
                       }});
    }
    if (!outcome->study.model.modes.empty())
        all.push_back({tr("Modes (CSV)…"), tr("Table (*.csv)"), "csv", [outcome](const QString& path) {
                           io::writeFile(path.toStdString(), modesCsv(outcome->study));
                       }});
    return all;
}

void FrfPanel::retranslate()
{
    views_->retranslate();
}

}  // namespace lathelier::frf_panel
