#include "engine/receptance/task/shaft_task.h"

#include <fmt/format.h>

#include <limits>
#include <nlohmann/json.hpp>

#include "engine/core/field_within.h"
#include "engine/core/frf_item.h"
#include "engine/core/json.h"
#include "engine/core/units.h"
#include "engine/io/file.h"
#include "engine/io/frf/frf_lines.h"
#include "engine/io/frf/frf_writer.h"
#include "engine/io/shaft/material_input.h"
#include "engine/io/shaft/shaft_file.h"
#include "engine/io/shaft/shaft_input.h"
#include "engine/receptance/receptance_quantities.h"
#include "engine/receptance/receptance_report.h"
#include "engine/receptance/shaft/shaft_place.h"
#include "engine/receptance/shaft/shaft_report.h"
#include "engine/receptance/spindle/spindle_input.h"
#include "engine/shaft/shaft_item.h"

namespace lathelier::receptance {
namespace {

void takeSegments(ShaftOutcome& outcome, const project::PanelState& state, Stores& stores, task::Sources& sources,
                  const Progress& progress)
{
    const ShaftQuestion& question = outcome.question;
    outcome.table_rules = task::chooseSegments(question.segments, question.segments_of, state, shaftRole, outcome.shaft,
                                               sources.notes, [&](const project::Source&) {
                                                   outcome.shaft = *task::take<io::ShaftInput>(state, shaftRole, stores,
                                                                                               progress, sources);
                                               });
}

/// The material by precedence, and where it comes from.
ValueOrigin takeMaterial(ShaftOutcome& outcome, const project::PanelState& state, Stores& stores,
                         task::Sources& sources, const Progress& progress)
{
    const auto file = task::take<io::MaterialInput>(state, materialRole, stores, progress, sources);
    if (file) outcome.shaft.material = *file;
    if (outcome.question.own_material) {
        outcome.shaft.material = outcome.question.own_material;
        return ValueOrigin::Given;
    }
    if (chooseMaterial(outcome.question.material, outcome.shaft, sources.notes)) return ValueOrigin::Assumed;
    return outcome.shaft.material ? ValueOrigin::File : ValueOrigin::Assumed;
}

void takeHolding(ShaftOutcome& outcome, const project::PanelState& state, Stores& stores, task::Sources& sources,
                 const Progress& progress)
{
    const ShaftQuestion& question = outcome.question;
    ShaftHolding& holding = outcome.holding;
    holding.supports = supportsOf(question.supports);
    constexpr double rigid = std::numeric_limits<double>::infinity();
    switch (question.hold) {
        case Hold::Free: return;
        case Hold::Clamped: holding.supports.push_back({outcome.shaft.length_mm(), rigid, rigid, 0}); return;
        case Hold::Springs: holding.spindle = SpindleReceptance{question.springs}; return;
        case Hold::Given: break;
    }
    holding.spindle = task::take<SpindleInput>(state, spindleRole, stores, progress, sources);
}

io::MeasuredFrf measuredOf(const ShaftOutcome& outcome)
{
    io::MeasuredFrf response;
    response.frf = outcome.usableResponse();
    return response;
}

/// What is seldom changed is folded away in the form, groups as a whole.
std::vector<Field<ShaftQuestion>> folded(std::vector<Field<ShaftQuestion>> all)
{
    for (Field<ShaftQuestion>& field : all) {
        for (const char* start : {"own_material", "springs", "tailstock", "rest"})
            if (field.info.key.starts_with(start)) field.info.advanced = true;
        field.info.is_kept = field.info.key == task::segmentsKey || field.info.key == task::segmentsOfKey;
    }
    return all;
}

std::string nameOf(const ShaftOutcome& outcome, const Language& language)
{
    if (!outcome.shaft.name.empty()) return outcome.shaft.name;
    return fill(text(LT_TEXT("Engine", "shaft, {length} mm"), language),
                {{"length", fixed(outcome.shaft.length_mm(), 1, language)}});
}

}  // namespace

const std::vector<Field<ShaftQuestion>>& fieldsOf(const ShaftQuestion*)
{
    using Q = ShaftQuestion;
    static const auto all = folded(described<Q>(
        rows(task::segmentsKey, &Q::segments, Range{0, 10000}, task::segmentsLabel()),
        field(task::segmentsOfKey, &Q::segments_of, task::segmentsOfLabel()),
        choice("library_material", &Q::material, materialChoices(LT_TEXT("Engine", "as the file states")),
               Label{LT_TEXT("Engine", "Material"),
                     LT_TEXT("Engine", "Handbook values of the library are marked as assumed.")}),
        group("own_material", &Q::own_material,
              Label{LT_TEXT("Engine", "Own material"),
                    LT_TEXT("Engine", "Stated in place of the file and the library.")}),
        field("hold", &Q::hold,
              {{"given", LT_TEXT("Engine", "the spindle given, else free")},
               {"springs", LT_TEXT("Engine", "springs")},
               {"clamped", LT_TEXT("Engine", "clamped rigidly")},
               {"free", LT_TEXT("Engine", "free")}},
              Label{LT_TEXT("Engine", "Held at the chuck"), LT_TEXT("Engine", "At the last segment's end.")}),
        group("springs", &Q::springs,
              Label{LT_TEXT("Engine", "Springs at the chuck"), LT_TEXT("Engine", "Where it is held by springs.")}),
        within(&Q::supports, "tailstock"), within(&Q::supports, "rest"), within(&Q::response, "respond_z_mm"),
        within(&Q::response, "excite_z_mm"), within(&Q::response, "from_hz"), within(&Q::response, "to_hz"),
        within(&Q::response, "step_hz"), within(&Q::response, "shear"), within(&Q::response, "method"),
        within(&Q::response, "step_correction")));
    return all;
}

Frf ShaftOutcome::usableResponse() const
{
    Frf frf = study.response.frf;
    io::dropUnusableLines(frf);
    return frf;
}

ShaftOutcome answerShaft(const project::PanelState& state, Stores& stores, task::Sources& sources,
                         const Progress& progress)
{
    ShaftOutcome outcome;
    outcome.question = fromValues<ShaftQuestion>(state.parameters);
    takeSegments(outcome, state, stores, sources, progress.part(0, 0.1, LT_TEXT("Engine", "Reading")));
    const ValueOrigin origin = takeMaterial(outcome, state, stores, sources, progress.part(0.1, 0.12));
    takeHolding(outcome, state, stores, sources, progress.part(0.12, 0.2));
    const project::Source* const source = task::sourceOf(state, shaftRole);
    outcome.study = namingShaft(source && !outcome.table_rules ? source->path : std::string(), outcome.shaft, [&] {
        return studyShaft(outcome.shaft, outcome.question.response, outcome.holding,
                          progress.part(0.2, 1, LT_TEXT("Engine", "Computing")));
    });
    for (UsedValue& used : outcome.study.response.used) used.origin = origin;
    outcome.record(state, sources, outcome.study.response.notes);
    return outcome;
}

task::Outcome outcomeOf(const std::shared_ptr<const ShaftOutcome>& outcome)
{
    task::Outcome all;
    all.result = outcome;
    all.notes = outcome->notes;
    all.json = [outcome] { return nestedJson(describedValues(outcome->study.response)); };
    all.answer = [outcome](const Language& language) { return answer(outcome->study, language); };
    all.summary = [outcome](const Language& language) { return frfSummary(outcome->study.response, language); };
    all.report = [outcome](const Language& language) {
        ShaftStudy study = outcome->study;
        study.response.notes = outcome->notes;
        return shaftReport(study, outcome->shaft, outcome->holding, language);
    };
    all.writers[responseExport] = [outcome](const std::string& path, const Language&, const Progress&) {
        io::writeFrfCsv(path, outcome->usableResponse());
    };
    all.writers[universalExport] = [outcome](const std::string& path, const Language&, const Progress&) {
        const io::MeasuredFrf response = measuredOf(*outcome);
        io::writeUff(path, {&response, 1});
    };
    all.writers[shaftExport] = [outcome](const std::string& path, const Language&, const Progress&) {
        io::writeFile(path, io::shaftText(outcome->shaft));
    };
    all.writers[stockExport] = [outcome](const std::string& path, const Language&, const Progress&) {
        io::writeFile(path, io::stockText(outcome->shaft));
    };
    all.products = [outcome](const Language& language) {
        const std::string name = nameOf(*outcome, language);
        const std::string of = fill(text(LT_TEXT("Engine", "response of {shaft}"), language), {{"shaft", name}});
        return std::vector<task::Product>{{shaftItem, {}, name, [outcome] { return toValues(outcome->shaft); }},
                                          {frfItem, {}, of, [outcome, of] {
                                               Frf frf = outcome->usableResponse();
                                               frf.name = of;
                                               return toValues(frf);
                                           }}};
    };
    return settled(shaftTask(), std::move(all), outcome->understanding);
}

const task::Task& shaftTask()
{
    static const task::Task task = [] {
        task::Task made;
        made.key = "frf";
        made.title = LT_TEXT("Engine", "Shaft");
        made.summary = "Frequency response and natural frequencies of a shaft, free or on its spindle.";
        made.question = "machine";
        made.products = {shaftItem, frfItem};
        made.inputs = {
            task::optionalInput<io::ShaftInput>(
                shaftRole, "", LT_TEXT("Engine", "Shaft"),
                LT_TEXT("Engine", "SHAFT.json or a stock file; fills the table of segments")),
            task::optionalInput<SpindleInput>(
                spindleRole, spindleRole, LT_TEXT("Engine", "Spindle"),
                LT_TEXT("Engine", "SPINDLE.json, or what the panel Spindle made; without it the shaft is free")),
            task::optionalInput<io::MaterialInput>(materialRole, materialRole, LT_TEXT("Engine", "Material"),
                                                   LT_TEXT("Engine", "Of the shaft, from FILE.json."))};
        made.inputs.front().is_of_part = true;
        made.one_of = {{shaftRole, task::segmentsKey}, LT_TEXT("Engine", "Shaft or segments")};
        task::askFor<ShaftQuestion>(made);
        made.exports = {{shaftExport, "Write the shaft as SHAFT.json.", LT_TEXT("Engine", "Shaft (SHAFT.json)…"),
                         LT_TEXT("Engine", "JSON (*.json)"), "json"},
                        {stockExport, "Write the contour as a stock file.", LT_TEXT("Engine", "Stock text…"),
                         LT_TEXT("Engine", "Text (*.txt)"), "txt"},
                        {responseExport, "Write the receptance as FILE.csv.", LT_TEXT("Engine", "Receptance (CSV)…"),
                         LT_TEXT("Engine", "Table (*.csv)"), "csv"},
                        {universalExport, "Write the receptance as a universal file (58).",
                         LT_TEXT("Engine", "Receptance (UFF)…"), LT_TEXT("Engine", "Universal file (*.uff)"), "uff"}};
        made.run = [](const project::PanelState& state, const task::Wanted&, Stores& stores, task::Sources& sources,
                      const Progress& progress) {
            return outcomeOf(std::make_shared<const ShaftOutcome>(answerShaft(state, stores, sources, progress)));
        };
        return made;
    }();
    return task;
}

}  // namespace lathelier::receptance
