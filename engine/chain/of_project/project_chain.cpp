#include "engine/chain/of_project/project_chain.h"

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "engine/cam/job_file.h"
#include "engine/cam/job_item.h"
#include "engine/core/field_within.h"
#include "engine/core/units.h"
#include "engine/deflection/setup_file.h"
#include "engine/io/file.h"
#include "engine/io/shaft/shaft_file.h"
#include "engine/receptance/spindle/spindle_file.h"
#include "engine/receptance/spindle/spindle_item.h"
#include "engine/shaft/shaft_item.h"
#include "engine/shop/shop_file.h"
#include "engine/task/edited_segments.h"

namespace lathelier::chain {
namespace fs = std::filesystem;
namespace {

constexpr std::size_t fileDigits = 12;

/// Source of a panel's input; null: none.
const project::Source* sourceAt(const project::Project& project, const char* panel, const char* role)
{
    const auto state = project.panels.find(panel);
    if (state == project.panels.end()) return nullptr;
    const auto source = state->second.inputs.find(role);
    return source == state->second.inputs.end() ? nullptr : &source->second;
}

/// Made by the chain: an item, or a file of its folder but for those that were written for it ("given").
bool isOfTheChain(const project::Project& project, const project::Source& source)
{
    if (source.item.empty()) {
        const auto own = project.panels.find(chainKey);
        const Value* const value = own == project.panels.end() ? nullptr : find(own->second.parameters, folderKey);
        const auto* const folder = value ? std::get_if<std::string>(value) : nullptr;
        return folder && !folder->empty() && fs::path(source.path).parent_path() == fs::path(*folder);
    }
    const auto item = project.items.find(source.item);
    return item == project.items.end() || item->second.origin.panel == chainKey;
}

using Places = std::vector<std::pair<const char*, const char*>>;  // panel and role

/// The first of these inputs that is given.
const project::Source* firstOf(const project::Project& project, const Places& places)
{
    for (const auto& [panel, role] : places)
        if (const project::Source* const source = sourceAt(project, panel, role))
            if (panel == std::string(chainKey) || !isOfTheChain(project, *source)) return source;
    return nullptr;
}

/// Writes items and forms as files of the chain.
class Inputs {
public:
    Inputs(const project::Project& project, std::string folder, AskedChain& asked)
        : project_(project), folder_(std::move(folder)), asked_(asked)
    {
    }

    std::string made(const char* name, std::string text)
    {
        asked_.made.push_back(madeInput(folder_, name, std::move(text)));
        return asked_.made.back().path;
    }

    /// The path of a source; an item is written to a file `name`.
    std::string pathOf(const project::Source* source, const char* name)
    {
        if (!source) return {};
        if (source->item.empty()) return source->path;
        const auto item = project_.items.find(source->item);
        if (item == project_.items.end()) return {};
        if (item->second.kind == shaftItem)
            if (const auto shaft = shaftOf(item->second.values)) return made(name, io::shaftText(*shaft));
        if (item->second.kind == receptance::spindleItem)
            if (const auto spindle = receptance::spindleOf(item->second.values))
                return made(name, receptance::spindleText(*spindle));
        if (item->second.kind == cam::jobItem)
            if (const auto job = cam::jobOf(item->second.values)) return made(name, cam::jobText(*job));
        if (item->second.kind == deflection::setupItem)
            if (auto held = deflection::setupOf(item->second.values)) return madeSetup(name, *std::move(held));
        return {};
    }

private:
    /// Its stock stands beside it.
    std::string madeSetup(const char* name, deflection::HeldSetup held)
    {
        if (held.stock) held.setup.stock = fs::path(made("stock", io::shaftText(*held.stock))).filename().string();
        return made(name, deflection::setupText(held.setup));
    }

    const project::Project& project_;
    std::string folder_;
    AskedChain& asked_;
};

/// The job of the panel "Turning program", where its form was changed; empty: as in its file.
std::string changedJob(const project::Project& project)
{
    const auto turning = project.panels.find("turning");
    if (turning == project.panels.end()) return {};
    const Values& values = turning->second.parameters;
    const Value* const tools = find(values, "tools");
    const Value* const of = find(values, "job_of");
    const auto* const rows = tools ? std::get_if<Rows>(tools) : nullptr;
    const std::string present = task::identity(turning->second, jobRole);
    if (!rows || rows->rows.empty() || present.empty() || !of || *of != Value(present)) return {};
    try {
        return cam::jobText(fromValues<cam::Job>(values));
    } catch (const Error&) {
        return {};  // the error is shown by the panel
    }
}

std::optional<project::PanelState> stateOfPanel(const project::Project& project, const char* panel)
{
    const auto found = project.panels.find(panel);
    return found == project.panels.end() ? std::nullopt : std::optional(found->second);
}

/// Scale and directions as the panel "Surface" has them, where its photographs are used and the chain states none.
void takePictureFacts(const project::Project& project, ChainQuestion& question)
{
    const auto surface = stateOfPanel(project, "surface");
    if (!surface || sourceAt(project, chainKey, beforeRole)) return;
    const auto number = [&](const char* key) -> std::optional<double> {
        const Value* const value = find(surface->parameters, key);
        const auto* const found = value ? std::get_if<double>(value) : nullptr;
        return found ? std::optional(*found) : std::nullopt;
    };
    if (!question.photograph_mm_px) question.photograph_mm_px = number("mm_per_px");
    if (!question.photograph_feed_deg) question.photograph_feed_deg = number("feed_direction_deg");
    const Value* const cut = find(surface->parameters, "cut_direction");
    const auto* const word = cut ? std::get_if<std::string>(cut) : nullptr;
    const std::vector<FieldChoice>& cuts = cutsInPicture();
    for (std::size_t i = 0; word && question.photograph_cut == CutInPicture::Unknown && i < cuts.size(); ++i)
        if (cuts[i].key == *word) question.photograph_cut = static_cast<CutInPicture>(i);
}

}  // namespace

ChainSettings::ChainSettings()
{
    fit.tailstock = false;
    fit.chuck_tilt = true;
    fit.forces = true;
}

const std::vector<Field<ChainSettings>>& fieldsOf(const ChainSettings*)
{
    using S = ChainSettings;
    static const auto all = [] {
        std::vector<Field<S>> fields{
            field(folderKey, &S::folder,
                  Label{LT_TEXT("Engine", "Folder"), LT_TEXT("Engine", "Where the files of the chain are.")}),
            field("confirmed_by", &S::confirmed_by,
                  Label{LT_TEXT("Engine", "Drawing confirmed by"), LT_TEXT("Engine", "Who answers for the drawing.")}),
            field("tolerance_mm", &S::tolerance_mm, Range{0, 1e6},
                  Label{LT_TEXT("Engine", "Tolerance of the copy"), LT_TEXT("Engine", "Of its surface, to both sides."),
                        unit::mm}),
            field("tolerance_um", &S::tolerance_um, Range{0, 1e6},
                  Label{LT_TEXT("Engine", "Tolerance of the predicted diameter"), LT_TEXT("Engine", "To both sides."),
                        unit::um}),
            field("photograph_z_mm", &S::photograph_z_mm, Range{0, 1e5},
                  Label{LT_TEXT("Engine", "Place of the photographs"),
                        LT_TEXT("Engine", "z from the free end: diameter and speed there turn marks into frequencies."),
                        unit::mm, true}),
            field("photograph_mm_px", &S::photograph_mm_px, Range{1e-6, 1e3},
                  Label{LT_TEXT("Engine", "Scale of the photographs"), LT_TEXT("Engine", "Width of a pixel."), unit::mm,
                        true}),
            field("photograph_feed_deg", &S::photograph_feed_deg, Range{-360, 360},
                  Label{LT_TEXT("Engine", "Direction of feed in the photographs"),
                        LT_TEXT("Engine", "From right toward down; without it both signs of the marks stay open."),
                        unit::deg, true}),
            field("photograph_cut", &S::photograph_cut, cutsInPicture(),
                  Label{LT_TEXT("Engine", "Direction of cut in the photographs"),
                        LT_TEXT("Engine", "Of later points of a track, the feed pointing right."),
                        {},
                        true})};
        for (const Field<deflection::IdentificationParameters>& inner :
             lathelier::fields<deflection::IdentificationParameters>())
            fields.push_back(foldedWithin(&S::fit, inner.info.key));
        fields.push_back(field(runKey, &S::run, Label{LT_TEXT("Engine", "Run"), {}}));
        return fields;
    }();
    return all;
}

MadeInput madeInput(const std::string& folder, const char* name, std::string text)
{
    std::string file = name;
    file += '_';
    file += io::sha256(text).substr(0, fileDigits);
    file += ".json";
    return {(fs::path(folder) / "given" / file).string(), std::move(text)};
}

AskedChain askedChain(const project::Project& project)
{
    AskedChain asked;
    ChainQuestion& question = asked.question;
    const auto own = project.panels.find(chainKey);
    const auto settings = fromValues<ChainSettings>(own == project.panels.end() ? Values{} : own->second.parameters);
    const auto pathAt = [&](const Places& places) {
        const project::Source* const source = firstOf(project, places);
        return source ? source->path : std::string();
    };
    question.scan = pathAt({{chainKey, scanRole}, {"recognise", "scan"}});
    const Places jobs{{chainKey, jobRole}, {"turning", "job"}}, setups{{chainKey, setupRole}, {"deflection", "setup"}};
    const Value* const shop = find(project.shop, shop::shopTextKey);
    if (const auto* const text = shop ? std::get_if<std::string>(shop) : nullptr) question.shop_text = *text;
    question.job = pathAt(jobs);
    question.setup = pathAt(setups);
    question.copy = pathAt({{chainKey, copyRole}, {"compare", "copy"}});
    question.photograph_before = pathAt({{chainKey, beforeRole}, {"surface", beforeRole}});
    question.photograph_after = pathAt({{chainKey, afterRole}, {"surface", afterRole}});
    question.out = settings.folder.empty() ? proposedFolder(question) : settings.folder;
    Inputs inputs(project, question.out, asked);
    if (question.job.empty()) question.job = inputs.pathOf(firstOf(project, jobs), "job");
    if (question.setup.empty()) question.setup = inputs.pathOf(firstOf(project, setups), "setup");
    if (!sourceAt(project, chainKey, setupRole) && !question.setup.empty())
        asked.deflection = project::resolved(project, "deflection");
    question.drawing = inputs.pathOf(
        firstOf(project, {{chainKey, drawingRole}, {"turning", "shaft"}, {"drawing", "shaft"}}), "drawing");
    question.machine = inputs.pathOf(
        firstOf(project, {{chainKey, machineRole}, {"turning", "spindle"}, {"shaft", "spindle"}}), "spindle");
    if (!sourceAt(project, chainKey, jobRole))
        if (const std::string text = changedJob(project); !text.empty()) question.job = inputs.made("job", text);
    question.confirmed_by = settings.confirmed_by;
    question.tolerance_mm = settings.tolerance_mm;
    question.tolerance_um = settings.tolerance_um;
    question.photograph_z_mm = settings.photograph_z_mm;
    question.photograph_mm_px = settings.photograph_mm_px;
    question.photograph_feed_deg = settings.photograph_feed_deg;
    question.photograph_cut = settings.photograph_cut;
    takePictureFacts(project, question);
    if (const auto turning = project.panels.find("turning"); turning != project.panels.end())
        if (const Value* const post = find(turning->second.parameters, "post"))
            if (const auto* const name = std::get_if<std::string>(post)) question.post = *name;
    if (const auto recognise = project.panels.find("recognise"); recognise != project.panels.end())
        for (const std::string& key : recognitionKeys())
            if (const Value* const given = find(recognise->second.parameters, key))
                set(question.recognition, key, *given);
    return asked;
}

void pinInputs(project::Project& project, const ChainQuestion& question)
{
    project::PanelState& own = project.panels[chainKey];
    const auto pin = [&](const char* role, const std::string& path) {
        if (!path.empty() && own.inputs.count(role) == 0)
            own.inputs[role].path = fs::absolute(path).lexically_normal().string();
    };
    pin(scanRole, question.scan);
    pin(drawingRole, question.drawing);
    pin(machineRole, question.machine);
    pin(jobRole, question.job);
    pin(setupRole, question.setup);
    pin(copyRole, question.copy);
    pin(beforeRole, question.photograph_before);
    pin(afterRole, question.photograph_after);
    ChainSettings settings;
    settings.photograph_mm_px = question.photograph_mm_px;
    settings.photograph_feed_deg = question.photograph_feed_deg;
    settings.photograph_cut = question.photograph_cut;
    const Values values = toValues(settings);
    for (const char* key : {"photograph_mm_px", "photograph_feed_deg", "photograph_cut"})
        if (const Value* const value = find(values, key)) set(own.parameters, key, *value);
}

std::string proposedFolder(const ChainQuestion& question)
{
    const fs::path beside = !question.scan.empty() ? question.scan : question.job;
    if (beside.empty()) return {};
    return (beside.parent_path() / (beside.stem().string() + "_chain")).string();
}

}  // namespace lathelier::chain
