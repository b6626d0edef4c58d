#include "engine/stability/task/point_response.h"

#include <nlohmann/json.hpp>

#include "engine/core/field_within.h"
#include "engine/core/json.h"
#include "engine/core/units.h"
#include "engine/io/frf/frf_input.h"
#include "engine/io/shaft/material_input.h"
#include "engine/io/shaft/shaft_input.h"
#include "engine/receptance/frf_checks.h"
#include "engine/receptance/shaft/shaft_place.h"
#include "engine/receptance/spindle/spindle_input.h"
#include "engine/stability/stability_codes.h"
#include "engine/stability/task/response_fit.h"
#include "engine/task/memo.h"
#include "engine/task/read_key.h"
#include "engine/task/task_codes.h"

namespace lathelier::stability {
namespace {

/// Responses by their inputs: another speed or depth does not compute them again.
struct ComputedResponses : Memo<receptance::ShaftReceptanceResult> {};

void append(Notes& notes, const Notes& more)
{
    notes.insert(notes.end(), more.begin(), more.end());
}

/// In place of the lines the modes fitted to them, on lines that are dense enough. Without modes the lines stay.
void useModel(PointResponse& found, Stores& stores, Notes& notes, const Progress& progress)
{
    const auto fit = fitOf(*found.frf, found.basis, stores, progress);
    append(notes, fit->notes);
    if (fit->modes.empty()) throw Error(errors::modesNeeded, {});
    found.model = receptance::uncertainModelOf(*fit);
    std::vector<Mode> modes;
    for (const receptance::ModalMode& mode : fit->model.modes)
        modes.push_back({mode.frequency_hz, mode.damping_ratio, mode.stiffness_N_mm});
    Frf frf = receptance::synthesised(fit->model, linesAround(modes, fit->range_hz));
    frf.name = found.frf->name;
    found.frf = std::make_shared<const Frf>(std::move(frf));
    found.basis += "#model";
}

/// Of a file with its notes on the choice and on its plausibility, or of an item.
PointResponse measured(const project::PanelState& state, const ResponseQuestion& question, Stores& stores,
                       task::Sources& sources, const Progress& progress)
{
    PointResponse found;
    const std::size_t read = sources.inputs.size();
    const std::string path = task::nameOf(state.inputs.at(frfRole));
    const Progress reading = progress.part(0, question.use == ResponseUse::Model ? 0.3 : 1);
    Frf frf;
    if (const auto loaded = task::takeFile<io::FrfInput>(state, frfRole, stores, reading, sources)) {
        const io::MeasuredFrf& used = loaded->file.response();
        append(sources.notes, loaded->file.notes_of_choice);
        append(sources.notes, receptance::checkResponse(used, path));
        frf = io::toReceptance(used.frf);
    } else {
        frf = *task::take<io::FrfInput>(state, frfRole, stores, reading, sources);
        const Values& item = task::itemValues(state, frfRole, frfItem);
        if (auto model = receptance::modelIn(item)) found.model = std::move(*model);
    }
    found.lines = receptance::takeUsableLines(frf, question.range_hz, path, sources.notes);
    found.frf = std::make_shared<const Frf>(std::move(frf));
    found.basis = task::readKey(state, {frfRole}, sources, read);
    for (const Interval& range : question.range_hz)
        found.basis += "#" + std::to_string(range.from) + ":" + std::to_string(range.to);
    if (question.use == ResponseUse::Model && !found.model.isKnown())
        useModel(found, stores, sources.notes, progress.part(0.3, 1, LT_TEXT("Engine", "Fitting modes")));
    return found;
}

/// Of the shaft, or of the bar in its place.
PointResponse computed(const project::PanelState& state, const ResponseQuestion& question,
                       const std::optional<Shaft>& bar, Stores& stores, task::Sources& sources,
                       const Progress& progress)
{
    PointResponse found;
    const std::size_t read = sources.inputs.size();
    const Progress reading = progress.part(0, 0.1, LT_TEXT("Engine", "Reading"));
    found.shaft = task::take<io::ShaftInput>(state, shaftRole, stores, reading.part(0, 0.4), sources);
    if (!found.shaft) found.shaft = bar;
    if (const auto material =
            task::take<io::MaterialInput>(state, materialRole, stores, reading.part(0.4, 0.6), sources))
        found.shaft->material = *material;
    found.holding = {task::take<receptance::SpindleInput>(state, spindleRole, stores, reading.part(0.6, 1), sources),
                     receptance::supportsOf(question.supports)};
    found.basis = toJson(lathelier::toValues(question.computing)).dump() +
                  toJson(lathelier::toValues(question.supports)).dump() +
                  task::readKey(state, {shaftRole, materialRole, spindleRole}, sources, read);
    if (bar && !task::sourceOf(state, shaftRole)) found.basis += toJson(lathelier::toValues(*bar)).dump();
    const auto response = stores.of<ComputedResponses>()->find(
        found.basis, progress.part(0.1, 1, LT_TEXT("Engine", "Computing")), [&](const Progress& part) {
            const project::Source* const source = task::sourceOf(state, shaftRole);
            return receptance::namingShaft(source ? source->path : std::string(), *found.shaft, [&] {
                return receptance::heldShaftReceptance(*found.shaft, question.computing, found.holding, part,
                                                       receptance::LinesOf::Refined);
            });
        });
    append(sources.notes, response->notes);
    found.used = response->used;
    found.natural_frequencies_hz = response->natural_frequencies_hz.value_or(std::vector<double>());
    Frf frf = response->frf;
    io::dropUnusableLines(frf);  // a free shaft has no receptance at 0 Hz
    found.frf = std::make_shared<const Frf>(std::move(frf));
    return found;
}

}  // namespace

const std::vector<Field<ResponseQuestion>>& fieldsOf(const ResponseQuestion*)
{
    using Q = ResponseQuestion;
    static const std::vector<Field<Q>> all = [] {
        std::vector<Field<Q>> made{
            rows(modeKey, &Q::mode, Range{0, 50},
                 Label{LT_TEXT("Engine", "Modes"),
                       LT_TEXT("Engine", "In place of FRF: f_hz,zeta,stiffness_N_mm; several are summed.")})};
        Field<Q> range = field("range_hz", &Q::range_hz, Range{0, 1e7},
                               Label{LT_TEXT("Engine", "Frequencies used"),
                                     LT_TEXT("Engine",
                                             "Of a measured response, 100:700. Default: the lines that stand out of "
                                             "their noise."),
                                     unit::hz, true});
        made.push_back(std::move(range));
        Field<Q> use = field(
            "use", &Q::use,
            {{"measured", LT_TEXT("Engine", "The lines")}, {"model", LT_TEXT("Engine", "The fitted modes")}},
            Label{LT_TEXT("Engine", "Used of a measurement"),
                  LT_TEXT("Engine", "The lines as measured, or the modes fitted to them, with their uncertainties.")});
        use.info.advanced = true;
        made.push_back(std::move(use));
        for (const FieldInfo& info : infos<receptance::ShaftSupports>())
            made.push_back(foldedWithin(&Q::supports, info.key));
        for (const FieldInfo& info : infos<receptance::ReceptanceParameters>())
            made.push_back(foldedWithin(&Q::computing, info.key));
        return made;
    }();
    return all;
}

std::vector<task::Input> responseInputs()
{
    task::Input response = task::optionalInput<io::FrfInput>(
        frfRole, "", LT_TEXT("Engine", "Frequency response"),
        LT_TEXT("Engine", "Of the point that is cut, in the direction of the chip thickness: UFF, CSV or MAT."));
    response.operand = "FRF";
    return {task::ofPart(std::move(response)),
            task::ofPart(task::optionalInput<io::ShaftInput>(
                shaftRole, shaftRole, LT_TEXT("Engine", "Shaft"),
                LT_TEXT("Engine",
                        "Its receptance is computed, on its machine where a spindle is given: SHAFT.json or a "
                        "stock file."))),
            task::optionalInput<receptance::SpindleInput>(
                spindleRole, spindleRole, LT_TEXT("Engine", "Spindle"),
                LT_TEXT("Engine", "The machine at the chuck face, from FILE.json; without it the shaft is free.")),
            task::optionalInput<io::MaterialInput>(materialRole, materialRole, LT_TEXT("Engine", "Material"),
                                                   LT_TEXT("Engine", "Of the shaft, from FILE.json."))};
}

task::OneOf responseSources()
{
    return {{frfRole, shaftRole, modeKey}, LT_TEXT("Engine", "Frequency response, shaft or modes")};
}

std::vector<task::OnlyWith> responseRules(const std::vector<std::string>& bar)
{
    std::vector<std::string> of_shaft{spindleRole, materialRole}, shafts{shaftRole};
    for (const FieldInfo& info : infos<receptance::ShaftSupports>()) of_shaft.push_back(info.key);
    for (const FieldInfo& info : infos<receptance::ReceptanceParameters>()) of_shaft.push_back(info.key);
    shafts.insert(shafts.end(), bar.begin(), bar.end());
    return {{std::move(of_shaft), std::move(shafts)}, {{"range_hz", "use"}, {frfRole}}};
}

void addUsedLines(const PointResponse& response, Json& json)
{
    json["range_used_hz"] = response.lines ? Json{response.lines->range_hz.from, response.lines->range_hz.to} : Json();
    json["lines_left_out"] = response.lines ? Json(response.lines->left_out) : Json();
}

PointResponse takeResponse(const project::PanelState& state, const ResponseQuestion& question, double highest_rpm,
                           const std::optional<Shaft>& bar, Stores& stores, task::Sources& sources,
                           const Progress& progress)
{
    if (task::sourceOf(state, frfRole)) return measured(state, question, stores, sources, progress);
    if (task::sourceOf(state, shaftRole)) return computed(state, question, bar, stores, sources, progress);
    if (!question.mode.empty()) {
        PointResponse found;
        found.frf = std::make_shared<const Frf>(frfOf(question.mode, highest_rpm));
        found.modes = question.mode;
        noteUnusualModes(question.mode, sources.notes);
        for (const Mode& mode : question.mode)
            found.model.model.modes.push_back({mode.frequency_hz, mode.damping_ratio, mode.stiffness_N_mm, 0});
        for (const Mode& mode : question.mode) found.basis += toJson(lathelier::toValues(mode)).dump();
        found.basis += std::to_string(highest_rpm);
        return found;
    }
    if (bar) return computed(state, question, bar, stores, sources, progress);
    throw Error(errors::oneNeeded, {{"names", responseSources().label}});
}

}  // namespace lathelier::stability
