#include "engine/cad/task/draw_task.h"

#include <nlohmann/json.hpp>

#include "engine/cad/cad_notes.h"
#include "engine/cad/step_kind.h"
#include "engine/cad/steps_view.h"
#include "engine/core/json.h"
#include "engine/shaft/shaft_codes.h"
#include "engine/shaft/shaft_contour.h"
#include "engine/shaft/shaft_rules.h"

namespace lathelier::cad {
namespace {

void takeShaft(DrawOutcome& outcome, const project::PanelState& state, Stores& stores, task::Sources& sources,
               const Progress& progress)
{
    PartTaken taken = takePart(state, shaftRole, stores, sources, progress);
    outcome.shaft = std::move(taken.shaft);
    outcome.file = std::move(taken.file);
}

Json rowsJson(const Shaft& shaft)
{
    Json rows = Json::array();
    double z_mm = 0;
    for (const ShaftSegment& row : shaft.segments) {
        Json one = {{"kind", row.arc_radius_mm                              ? "arc"
                             : row.start_diameter_mm == row.end_diameter_mm ? "cylinder"
                                                                            : "cone"},
                    {"role", row.role},
                    {"z_start_mm", z_mm},
                    {"z_end_mm", z_mm + row.length_mm},
                    {"start_diameter_mm", row.start_diameter_mm},
                    {"end_diameter_mm", row.end_diameter_mm},
                    {"arc_radius_mm", row.arc_radius_mm ? Json(*row.arc_radius_mm) : Json(nullptr)}};
        z_mm += row.length_mm;
        rows.push_back(one);
    }
    return rows;
}

/// Of each mark what is set.
Json marksJson(const Shaft& shaft)
{
    Json marks = Json::array();
    for (const ShaftMark& mark : shaft.marks) {
        Json one = Json::object();
        for (const auto& [name, value] : toValues(mark))
            if (!std::holds_alternative<std::monostate>(value)) one[name] = toJson(value);
        marks.push_back(one);
    }
    return marks;
}

/// What a STEP file holds beside the shaft.
void addStep(Json& json, const StepPart& part)
{
    json["axis"] = {{"point_mm", {part.free_end_mm.x(), part.free_end_mm.y(), part.free_end_mm.z()}},
                    {"direction", {part.axis.x(), part.axis.y(), part.axis.z()}}};
    json["solid_volume_mm3"] = part.volume_mm3;
    json["cut_volume_mm3"] = part.cut_mm3;
    json["named_cut_volume_mm3"] = part.named_mm3;
    json["other_faces"] = Json::array();
    for (const OtherFace& face : part.other_faces)
        json["other_faces"].push_back({{"kind", face.kind.english},
                                       {"area_mm2", face.area_mm2},
                                       {"z_start_mm", face.z_start_mm},
                                       {"z_end_mm", face.z_end_mm}});
}

Json jsonOf(const DrawOutcome& outcome)
{
    const Shaft& shaft = outcome.shaft;
    Json json = Json::object();
    if (outcome.file) json["format"] = outcome.file->file.step ? std::string("STEP") : outcome.file->file.facts.format;
    if (outcome.file && outcome.file->file.step) addStep(json, *outcome.file->file.step);
    json["name"] = shaft.name;
    json["length_mm"] = shaft.length_mm();
    json["volume_mm3"] = volume_mm3(shaft);
    json["mass_kg"] = outcome.mass_kg ? Json(*outcome.mass_kg) : Json(nullptr);
    json["segments"] = rowsJson(shaft);
    json["bores"] = static_cast<std::int64_t>(shaft.bores.size());
    json["marks"] = marksJson(shaft);
    json["steps"] = stepsJson(shaft);
    return json;
}

/// With a new name, so that the item does not replace its origin.
std::string nameOfProduct(const DrawOutcome& outcome, const Language& language)
{
    std::string name = outcome.shaft.name;
    if (name.empty())
        name = fill(text(LT_TEXT("Engine", "shaft, {length} mm"), language),
                    {{"length", fixed(outcome.shaft.length_mm(), 1, language)}});
    const project::Source* const source = task::sourceOf(outcome.asked, shaftRole);
    if (source && source->item == name)
        name = fill(text(LT_TEXT("Engine", "{name}, edited"), language), {{"name", name}});
    return name;
}

std::shared_ptr<const PartToWrite> partOf(const std::shared_ptr<const DrawOutcome>& outcome)
{
    PartToWrite part;
    part.shaft = outcome->shaft;
    part.stock = outcome->shaft;
    part.drawing = [outcome](const Language& language) { return drawingOf(*outcome, language); };
    part.cad = outcome->question.cad;
    return std::make_shared<const PartToWrite>(std::move(part));
}

}  // namespace

DrawOutcome answerDraw(const project::PanelState& state, bool has_cad, Stores& stores, task::Sources& sources,
                       const Progress& progress)
{
    DrawOutcome outcome;
    outcome.question = fromValues<DrawQuestion>(state.parameters);
    const DrawQuestion& question = outcome.question;
    const bool rules = task::chooseSegments(question.segments, question.segments_of, state, shaftRole, outcome.shaft,
                                            sources.notes, [&](const project::Source&) {
                                                takeShaft(outcome, state, stores, sources,
                                                          progress.part(0, 0.8, LT_TEXT("Engine", "Reading")));
                                            });
    if (question.bores_of == boresOf(state)) outcome.shaft.bores = boresOfRows(question.bores);
    if (!question.name.empty()) outcome.shaft.name = question.name;
    addTitle(question.title, outcome.shaft, sources.notes);
    try {
        outcome.remarks = checkShaft(outcome.shaft);
    } catch (Error& error) {
        const project::Source* const source = task::sourceOf(state, shaftRole);
        if (!source || rules) throw;
        locatePart(error, *source);
        throw;
    }
    if (has_cad) {
        const Notes left_out = cadNotes(outcome.shaft);
        outcome.remarks.insert(outcome.remarks.end(), left_out.begin(), left_out.end());
    }
    dropRepeated(sources, outcome.remarks);
    outcome.mass_kg = drawing::massInKilograms(outcome.shaft);
    outcome.record(state, sources, outcome.remarks);
    progress.report(1);
    return outcome;
}

task::Outcome outcomeOf(const std::shared_ptr<const DrawOutcome>& outcome)
{
    task::Outcome all;
    all.result = outcome;
    all.notes = outcome->notes;
    all.json = [outcome] { return jsonOf(*outcome); };
    all.answer = [outcome](const Language&) { return answer(*outcome); };
    all.summary = [outcome](const Language& language) {
        return report::Section{LT_TEXT("Engine", "Result"), {answer(*outcome), rowsTable(*outcome, language)}};
    };
    all.report = [outcome](const Language& language) { return reportOf(*outcome, language); };
    if (!outcome->question.check) all.writers = partWriters(partOf(outcome));
    all.products = [outcome](const Language& language) {
        return std::vector<task::Product>{
            {shaftItem, {}, nameOfProduct(*outcome, language), [outcome] { return toValues(outcome->shaft); }}};
    };
    return settled(drawTask(), std::move(all), outcome->understanding);
}

const task::Task& drawTask()
{
    static const task::Task task = [] {
        task::Task made;
        made.key = "draw";
        made.title = LT_TEXT("Engine", "Drawing");
        made.summary = "Check a shaft and write it as CAD, drawing and tables.";
        made.question = "drawing";
        made.products = {shaftItem};
        made.inputs = {task::ofPart(task::optionalInput<PartInput>(
            shaftRole, "", LT_TEXT("Engine", "Shaft"),
            LT_TEXT("Engine", "SHAFT.json, a STEP file of a turned part, or what another panel made")))};
        made.one_of = {{shaftRole, task::segmentsKey}, LT_TEXT("Engine", "Shaft or segments")};
        task::askFor<DrawQuestion>(made);
        made.exports = partExports();
        made.run = [](const project::PanelState& state, const task::Wanted& wanted, Stores& stores,
                      task::Sources& sources, const Progress& progress) {
            return outcomeOf(std::make_shared<const DrawOutcome>(
                answerDraw(state, isSolidWanted(wanted), stores, sources, progress)));
        };
        return made;
    }();
    return task;
}

}  // namespace lathelier::cad
