#include "widgets/chain/chain_panel.h"

#include <QVBoxLayout>
#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "engine/cad/step_kind.h"
#include "engine/cam/job_file.h"
#include "engine/chain/dossier_kind.h"
#include "engine/deflection/setup_file.h"
#include "engine/io/file.h"
#include "engine/io/image/image_kind.h"
#include "engine/io/shaft/shaft_kind.h"
#include "engine/receptance/spindle/spindle_item.h"
#include "engine/receptance/spindle/spindle_kind.h"
#include "engine/report/result_json.h"
#include "engine/shaft/shaft_item.h"
#include "widgets/chain/chain_landing.h"
#include "widgets/chain/chain_roles.h"
#include "widgets/chain/chain_run_row.h"
#include "widgets/chain/chain_views.h"
#include "widgets/core/form/input_box.h"
#include "widgets/core/form/input_column.h"
#include "widgets/core/language.h"

namespace lathelier::chain_panel {
namespace {

PanelInputs panelInputs()
{
    PanelInputs inputs;
    inputs.roles = chainRoles();
    for (FieldInfo& info : infos<chain::ChainSettings>())
        if (info.key != chain::runKey) inputs.fields.push_back(std::move(info));
    inputs.defaults = toValues(chain::ChainSettings{});
    inputs.invitation =
        LT_TEXT("Engine",
                "The button above runs the chain from the scan of a worn part to the proof of its copy; "
                "drop its files here, or a dossier that was made before.");
    return inputs;
}

bool wasRun(const project::PanelState& state)
{
    const Value* const folder = find(state.parameters, chain::folderKey);
    const Value* const run = find(state.parameters, chain::runKey);
    return folder && run && *folder != Value(std::string()) && *run != Value(std::string());
}

/// The role that a file fills: the first free one of its kind.
const char* roleFor(const project::PanelState& state, const io::FileKind* kind)
{
    const auto is_free = [&](const char* role) { return state.inputs.count(role) == 0; };
    if (kind == &io::scanFiles()) return is_free(chain::scanRole) ? chain::scanRole : chain::copyRole;
    if (kind == &io::imageFiles()) return is_free(chain::beforeRole) ? chain::beforeRole : chain::afterRole;
    if (kind == &cam::jobFiles()) return chain::jobRole;
    if (kind == &receptance::spindleFiles()) return chain::machineRole;
    if (kind == &deflection::setupFiles()) return chain::setupRole;
    return kind == &io::shaftFiles() || kind == &cad::stepFiles() ? chain::drawingRole : nullptr;
}

}  // namespace

PanelFacts chainPanelFacts()
{
    PanelFacts facts;
    facts.id = chain::chainKey;
    facts.title = LT_TEXT("Engine", "Proof of the copy");
    facts.icon = "chain";
    facts.question = questionOf("proof");
    facts.roles = panelInputs().roles;
    facts.kinds = kindsOf(facts.roles);
    facts.kinds.push_back(&chain::dossierFiles());
    facts.part_inputs = {chain::scanRole, chain::drawingRole, chain::copyRole, chain::beforeRole, chain::afterRole};
    facts.item_inputs = {{shaftItem, chain::drawingRole}, {receptance::spindleItem, chain::machineRole}};
    facts.missing = [](const project::PanelState& state) {
        return wasRun(state) ? std::vector<Text>{} : std::vector<Text>{LT_TEXT("Engine", "a run of the chain")};
    };
    facts.has_work = wasRun;
    facts.report = [](const project::PanelState& state, Stores& stores, task::Sources&, const Language& language,
                      const Progress& progress) {
        return chain::reportOf(chain::chainOutcome(state, stores, progress), language);
    };
    facts.answer = [](const project::PanelState& state, Stores& stores, task::Sources&, const Progress& progress) {
        const auto outcome = std::make_shared<const chain::ChainOutcome>(chain::chainOutcome(state, stores, progress));
        walk::PlaceAnswer made;
        made.value = outcome;
        made.outcome.notes = outcome->notes;
        made.outcome.answer = [outcome](const Language&) { return chain::answerOf(*outcome); };
        made.is_synthetic = outcome->synthetic;
        return made;
    };
    facts.make = [](Session& session) -> PanelBase* { return new ChainPanel(session); };
    return facts;
}

ChainPanel::ChainPanel(Session& owner, QWidget* parent)
    : Panel(owner, chainPanelFacts(), panelInputs(), parent), views_(new ChainViews), run_(new ChainRunRow(owner))
{
    setViews(views_, views_->primaryViews());
    static_cast<QVBoxLayout*>(layout())->insertWidget(0, run_);  // without a result too
    connect(run_, &ChainRunRow::lookedAgain, views_, &ChainViews::setLooked);
    connect(run_, &ChainRunRow::panelRequested, this, &ChainPanel::panelRequested);
    connect(run_, &ChainRunRow::messageRaised, this, &ChainPanel::messageRaised);
    connect(views_, &ChainViews::stepRequested, run_, &ChainRunRow::openStep);
    connect(views_, &ChainViews::fitRequested, this, &ChainPanel::takeFit);
    connect(views_, &ChainViews::notWritten, this, &ChainPanel::reportWriteFailure);
}

void ChainPanel::takeFit()
{
    const auto outcome = result();
    if (!outcome || !outcome->fit) return;
    try {
        landFit(session(), *outcome->fit, outcome->settings.folder);
    } catch (const Error& error) {
        emit messageRaised({error, facts().title});
    }
}

ChainPanel::Compute ChainPanel::compute(const project::PanelState& state) const
{
    fromValues<chain::ChainSettings>(state.parameters);  // validates ranges before the computation
    return [state, stores = session().sharedStores()](const Progress& progress) {
        return std::make_shared<const chain::ChainOutcome>(chain::chainOutcome(state, *stores, progress));
    };
}

/// The row above refers to the inputs.
Worker::Job ChainPanel::makeReadingJob(const project::PanelState&) const
{
    return [](const Progress&) -> std::shared_ptr<const void> { return nullptr; };
}

void ChainPanel::showResult(const std::shared_ptr<const chain::ChainOutcome>& outcome)
{
    views_->setOutcome(outcome);
    if (run_->looked()) views_->setLooked(run_->looked());
}

void ChainPanel::assignFiles(project::PanelState& state, const std::vector<FoundFile>& files) const
{
    for (const FoundFile& file : files) {
        const std::string name = std::filesystem::path(file.path).filename().string();
        if (file.kind == &chain::dossierFiles() || name == chain::dossierFile) {
            const std::string folder = std::filesystem::path(file.path).parent_path().string();
            lathelier::set(state.parameters, chain::folderKey, folder);
            lathelier::set(state.parameters, chain::runKey, chain::dossierDigest(folder));
        } else if (const char* const role = roleFor(state, file.kind)) {
            state.inputs[role] = newSource(QString::fromStdString(file.path));
        }
    }
}

report::Document ChainPanel::document(const chain::ChainOutcome& outcome) const
{
    return chain::reportOf(outcome, screenLanguage());
}

std::vector<PanelExport> ChainPanel::exports() const
{
    const auto outcome = result();
    if (!outcome) return {};
    std::vector<PanelExport> all{{tr("Dossier…"), tr("JSON (*.json)"), "json", [outcome](const QString& path) {
                                      const io::FileBytes bytes(outcome->file.path);
                                      io::writeFile(path.toStdString(), bytes.view());
                                  }}};
    if (outcome->fit)
        all.push_back({tr("Set-up as fitted…"), tr("JSON (*.json)"), "json", [outcome](const QString& path) {
                           io::writeFile(path.toStdString(), outcome->fit->setup_text);
                       }});
    return all;
}

void ChainPanel::showPlace(const report::Place& place)
{
    if (place.z_mm) views_->showStretch(*place.z_mm);
}

void ChainPanel::setPresenting(bool presenting)
{
    Panel::setPresenting(presenting);
    views_->setPresenting(presenting);
    run_->setVisible(!presenting);
}

void ChainPanel::retranslate()
{
    views_->retranslate();
}

}  // namespace lathelier::chain_panel
