#include "widgets/chain/chain_landing.h"

#include <QCoreApplication>
#include <algorithm>
#include <filesystem>

#include "engine/chain/of_project/chain_memory.h"
#include "engine/io/file.h"
#include "engine/io/shaft/shaft_file.h"
#include "engine/receptance/spindle/spindle_item.h"
#include "engine/shaft/shaft_item.h"
#include "widgets/core/form/input_column.h"

namespace lathelier::chain_panel {
namespace fs = std::filesystem;
namespace {

QString say(const char* english)
{
    return QCoreApplication::translate("lathelier::chain_panel::ChainLanding", english);
}

/// Sets inputs of panels that have none.
class Giver {
public:
    explicit Giver(project::Project& project) : project_(project) {}

    void file(const char* panel, const char* role, const std::string& path)
    {
        if (!path.empty() && isFree(panel, role))
            project_.panels[panel].inputs[role] = newSource(QString::fromStdString(path));
    }
    void item(const char* panel, const char* role, const std::string& name)
    {
        if (!isFree(panel, role)) return;
        project::Source source;
        source.item = name;
        project_.panels[panel].inputs[role] = source;
    }

private:
    bool isFree(const char* panel, const char* role) const
    {
        const auto state = project_.panels.find(panel);
        return state == project_.panels.end() || state->second.inputs.count(role) == 0;
    }
    project::Project& project_;
};

std::optional<Shaft> drawnShaft(const std::string& path)
{
    try {
        Notes ignoredNotes;
        const io::FileBytes bytes(path);
        return io::readShaft(std::string(bytes.view()), ignoredNotes);
    } catch (const Error&) {
        return std::nullopt;
    }
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
    const auto isDone = [&](const char* id) {
        const chain::ChainStep* const step = dossier.step(id);
        return step && step->state == chain::StepState::Done;
    };
    const auto made = [&](const std::string& name) { return (fs::path(question.out) / name).string(); };
    const std::optional<Shaft> drawing = isDone("draw") ? drawnShaft(made("drawing.json")) : std::nullopt;
    const std::string stem = fs::path(question.scan.empty() ? question.drawing : question.scan).stem().string();
    const std::string name =
        freeName(session.project(), say("Drawing of %1").arg(QString::fromStdString(stem)).toStdString());

    session.edit(say("Run the chain"), [&](project::Project& project) {
        Values& settings = project.panels[chain::chainKey].parameters;
        set(settings, chain::folderKey, question.out);
        set(settings, chain::runKey, sha256);
        Giver give(project);
        give.file("recognise", "scan", question.scan);
        if (drawing) {
            project.items[name] = itemOf(project, shaftItem, toValues(*drawing));
            for (const char* panel : {"drawing", "turning"}) give.item(panel, "shaft", name);
        }
        give.file("turning", "job", question.job);
        give.file("turning", "spindle", question.machine);
        if (isDone("machine")) {
            give.file("shaft", "shaft", made("held.json"));
            give.file("shaft", "spindle", question.machine);
            give.file("lobes", "frf", made("receptance.csv"));
        }
        if (isDone("deflection")) {
            for (const InputFile& file : dossier.step("deflection")->inputs) {
                const std::string stem_of = fs::path(file.path).stem().string();
                if (stem_of.starts_with("program")) give.file("deflection", "program", made(file.path));
                if (stem_of == "setup") give.file("deflection", "setup", made(file.path));
            }
            give.file("deflection", "setup", question.setup);
        }
        if (isDone("surface")) givePhotographs(project, question, dossier);
        if (isDone("draw") && !question.copy.empty()) {
            const auto compare = project.panels.find("compare");
            if (compare == project.panels.end() || compare->second.inputs.empty()) {
                give.file("compare", "reference", made("drawing.json"));
                give.file("compare", "copy", question.copy);
            }
        }
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
