#include "engine/stability/task/point_response.h"

#include <nlohmann/json.hpp>

#include "engine/core/field_within.h"
#include "engine/core/json.h"
#include "engine/io/frf/frf_input.h"
#include "engine/io/shaft/material_input.h"
#include "engine/io/shaft/shaft_input.h"
#include "engine/receptance/frf_checks.h"
#include "engine/receptance/shaft_place.h"
#include "engine/receptance/spindle_input.h"
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

/// Of a file with its notes on the choice and on its plausibility.
PointResponse measured(const project::PanelState& state, Stores& stores, task::Sources& sources,
                       const Progress& progress)
{
    PointResponse found;
    const std::size_t read = sources.inputs.size();
    const std::string path = task::nameOf(state.inputs.at(frfRole));
    if (const auto loaded = task::takeFile<io::FrfInput>(state, frfRole, stores, progress, sources)) {
        const io::MeasuredFrf& used = io::preferredResponse(loaded->file.frfs);
        append(sources.notes, io::notesOfChoice(loaded->file.frfs, used, path));
        append(sources.notes, receptance::checkResponse(used, path));
        found.frf = std::make_shared<const Frf>(io::toReceptance(used.frf));
    } else {
        found.frf = std::make_shared<const Frf>(*task::take<io::FrfInput>(state, frfRole, stores, progress, sources));
    }
    found.basis = task::readKey(state, {frfRole}, sources, read);
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
    found.spindle = task::take<receptance::SpindleInput>(state, spindleRole, stores, reading.part(0.6, 1), sources);
    found.basis = toJson(lathelier::toValues(question.computing)).dump() +
                  task::readKey(state, {shaftRole, materialRole, spindleRole}, sources, read);
    if (bar && !task::sourceOf(state, shaftRole)) found.basis += toJson(lathelier::toValues(*bar)).dump();
    const auto response = stores.of<ComputedResponses>()->find(
        found.basis, progress.part(0.1, 1, LT_TEXT("Engine", "Computing")), [&](const Progress& part) {
            const project::Source* const source = task::sourceOf(state, shaftRole);
            return receptance::namingShaft(source ? source->path : std::string(), *found.shaft, [&] {
                return receptance::shaftReceptance(*found.shaft, question.computing, found.spindle, part,
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
    return {std::move(response),
            task::optionalInput<io::ShaftInput>(
                shaftRole, shaftRole, LT_TEXT("Engine", "Shaft"),
                LT_TEXT("Engine",
                        "Its receptance is computed, on its machine where a spindle is given: SHAFT.json or a "
                        "stock file.")),
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

PointResponse takeResponse(const project::PanelState& state, const ResponseQuestion& question, double highest_rpm,
                           const std::optional<Shaft>& bar, Stores& stores, task::Sources& sources,
                           const Progress& progress)
{
    if (task::sourceOf(state, frfRole)) return measured(state, stores, sources, progress);
    if (task::sourceOf(state, shaftRole)) return computed(state, question, bar, stores, sources, progress);
    if (!question.mode.empty()) {
        PointResponse found;
        found.frf = std::make_shared<const Frf>(frfOf(question.mode, highest_rpm));
        found.modes = question.mode;
        for (const Mode& mode : question.mode) found.basis += toJson(lathelier::toValues(mode)).dump();
        found.basis += std::to_string(highest_rpm);
        return found;
    }
    if (bar) return computed(state, question, bar, stores, sources, progress);
    throw Error(errors::oneNeeded, {{"names", responseSources().label}});
}

}  // namespace lathelier::stability
