#include "widgets/chain/chain_landing.h"

#include <QCoreApplication>
#include <filesystem>

#include "engine/io/file.h"
#include "engine/receptance/spindle/spindle_item.h"
#include "widgets/core/form/input_column.h"

namespace lathelier::chain_panel {
namespace fs = std::filesystem;
namespace {

QString say(const char* english)
{
    return QCoreApplication::translate("lathelier::chain_panel::ChainLanding", english);
}

/// Where the panel has none.
void giveFile(project::Project& project, const char* panel, const char* role, const std::string& path)
{
    if (path.empty()) return;
    const auto state = project.panels.find(panel);
    if (state == project.panels.end() || state->second.inputs.count(role) == 0)
        project.panels[panel].inputs[role] = newSource(QString::fromStdString(path));
}

/// The requested name, or with a number where an item of that name is the user's.
std::string freeName(const project::Project& project, const std::string& wanted)
{
    for (int number = 1;; ++number) {
        std::string name = number == 1 ? wanted : wanted + " (" + std::to_string(number) + ")";
        const auto item = project.items.find(name);
        if (item == project.items.end() || item->second.origin.panel == chain::chainKey) return name;
    }
}

const Value* parameterOf(const chain::Dossier& dossier, const char* step, const char* key)
{
    const chain::ChainStep* const found = dossier.step(step);
    return found ? find(found->parameters, key) : nullptr;
}

project::Item itemOf(const project::Project& project, const char* kind, Values values)
{
    return {kind, std::move(values),
            originOf(project, chain::chainKey, QCoreApplication::applicationVersion().toStdString())};
}

/// Sets the photographs of the panel Surface, with the chain's parameters, where it has none.
void givePhotographs(project::Project& project, const chain::ChainQuestion& question, const chain::Dossier& dossier)
{
    project::PanelState& surface = project.panels["surface"];
    if (!surface.inputs.empty()) return;
    surface.inputs[chain::beforeRole] = newSource(QString::fromStdString(question.photograph_before));
    surface.inputs[chain::afterRole] = newSource(QString::fromStdString(question.photograph_after));
    for (const char* key :
         {"feed_mm_rev", "diameter_mm", "mm_per_px", "feed_direction_deg", "cut_direction", "expect_hz"})
        if (const Value* const value = parameterOf(dossier, "surface", key)) set(surface.parameters, key, *value);
    const Value* const speeds = parameterOf(dossier, "surface", "speed_rpm");
    const auto* const rows = speeds ? std::get_if<Rows>(speeds) : nullptr;
    if (!rows || rows->rows.size() != 2) return;
    const char* const keys[] = {"speed_before_rpm", "speed_after_rpm"};
    for (std::size_t i = 0; i < 2; ++i)
        if (const Value* const rpm = find(rows->rows[i].cells, "rpm")) set(surface.parameters, keys[i], *rpm);
}

}  // namespace

void landRun(Session& session, const chain::ChainQuestion& question, const chain::Dossier& dossier,
             const std::string& sha256)
{
    const chain::ChainStep* const photographs = dossier.step("surface");
    session.edit(say("Run the chain"), [&](project::Project& project) {
        Values& settings = project.panels[chain::chainKey].parameters;
        set(settings, chain::folderKey, question.out);
        set(settings, chain::runKey, sha256);
        giveFile(project, "recognise", "scan", question.scan);
        giveFile(project, "drawing", "shaft", question.drawing);
        giveFile(project, "turning", "job", question.job);
        for (const char* panel : {"shaft", "lobes", "turning"}) giveFile(project, panel, "spindle", question.machine);
        giveFile(project, "deflection", "setup", question.setup);
        giveFile(project, "compare", "copy", question.copy);
        if (photographs && photographs->state == chain::StepState::Done) givePhotographs(project, question, dossier);
    });
}

void landFit(Session& session, const chain::MachineFit& fit, const std::string& folder)
{
    const fs::path given = fs::path(folder) / "given";
    std::error_code ignored;
    fs::create_directories(given, ignored);
    const auto write = [&](const char* name, const std::string& text) {
        std::string path = (given / (name + io::sha256(text).substr(0, 12) + ".json")).string();
        io::writeFile(path, text);
        return path;
    };
    const std::string path = write("fittedSetup_", fit.setup_text), whole = write("fitted_", fit.whole_text);
    const deflection::TurningSetup& setup = fit.found.setup;
    receptance::SpindleSprings springs = fit.springs.value_or(receptance::SpindleSprings{});  // keeps its damping
    springs.radial_N_mm = setup.chuck.radial_N_mm;
    springs.tilt_N_mm_rad = setup.chuck.tilt_N_mm_rad;
    const std::string name = freeName(session.project(), say("Machine fitted to the copy").toStdString());
    session.edit(say("Take the fit to the machine"), [&](project::Project& project) {
        project.items[name] =
            itemOf(project, receptance::spindleItem, receptance::toValues(receptance::SpindleReceptance{springs}));
        project::PanelState& deflection = project.panels["deflection"];
        project::Source source;
        source.item = name;
        deflection.inputs["spindle"] = source;
        deflection.inputs["setup"] = newSource(QString::fromStdString(whole));
        project.panels[chain::chainKey].inputs[chain::setupRole] = newSource(QString::fromStdString(path));
        // A machine given as a table of measured receptances has no springs.
        if (fit.springs) project.panels[chain::chainKey].inputs[chain::machineRole] = source;
    });
}

}  // namespace lathelier::chain_panel
