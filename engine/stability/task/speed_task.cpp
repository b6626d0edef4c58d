#include "engine/stability/task/speed_task.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "engine/core/field_within.h"
#include "engine/core/json.h"
#include "engine/core/units.h"
#include "engine/stability/depth_digits.h"
#include "engine/stability/refusal.h"
#include "engine/stability/stability_codes.h"
#include "engine/stability/stability_quantities.h"
#include "engine/stability/stability_report.h"

namespace lathelier::stability {
namespace {

/// Selected speed; none: not stated, see chooseSpeed().
std::optional<double> selectedOf(const SpeedParameters& speed)
{
    if (speed.speed_rpm) return speed.speed_rpm;
    if (speed.cutting_speed_m_min && speed.diameter_mm)
        return spindleSpeed(*speed.cutting_speed_m_min, *speed.diameter_mm);
    return std::nullopt;
}

/// The bar D × L in place of a shaft; none: not stated.
std::optional<Shaft> barOf(const SpeedQuestion& question)
{
    if (!question.length_mm || !question.speed.diameter_mm) return std::nullopt;
    const double diameter = *question.speed.diameter_mm;
    Shaft bar;
    bar.segments = {{*question.length_mm, diameter, diameter, 0, {}, {}}};
    bar.material = question.material;
    return bar;
}

Error needed(const char* key, Text expected)
{
    return Error(errors::valueNotUnderstood, {{"parameter", key}, {"found", Value()}, {"expected", expected}});
}

/// Depth and coefficient judge the speed together.
std::optional<Error> missingOfDepth(const SpeedQuestion& question)
{
    if (question.depth_mm.has_value() == question.cutting_coefficient_N_mm2.has_value()) return std::nullopt;
    if (question.depth_mm)
        return needed("cutting_coefficient_N_mm2", LT_TEXT("Engine", "the cutting coefficient for the depth"));
    return needed("depth_mm", LT_TEXT("Engine", "the depth of cut for the coefficient"));
}

SafeSpeedQuestion safeQuestion(const SpeedQuestion& question, double selected_rpm)
{
    const SpeedParameters& speed = question.speed;
    SafeSpeedQuestion asked{selected_rpm, *question.depth_mm, usualRange(selected_rpm)};
    if (!speed.range_m_min.empty() && speed.diameter_mm)
        asked.range_rpm = {spindleSpeed(speed.range_m_min.front().from, *speed.diameter_mm),
                           spindleSpeed(speed.range_m_min.front().to, *speed.diameter_mm)};
    return asked;
}

/// About the selected and the recommended speeds.
LobeParameters shownLobes(const SpeedOutcome& outcome, double selected_rpm)
{
    Interval shown{selected_rpm, selected_rpm};
    const auto include = [&shown](double speed_rpm) {
        shown = {std::fmin(shown.from, speed_rpm), std::fmax(shown.to, speed_rpm)};
    };
    if (outcome.published) include(outcome.published->recommended_rpm);
    if (outcome.safe) include(outcome.safe->best.speed_rpm);
    LobeParameters lobes;
    lobes.cutting_coefficient_N_mm2 = outcome.question.cutting_coefficient_N_mm2;
    lobes.relation = outcome.safe ? SpeedRelation::Exact : outcome.question.speed.relation;
    lobes.direction_factor = outcome.question.speed.direction_factor;
    lobes.speed_rpm = {{0.6 * shown.from, 1.5 * shown.to}};
    return lobes;
}

/// The value that is missing first where there is no response without a bar; nothing: none is missing.
std::optional<Error> missingOfBar(const SpeedQuestion& question)
{
    if (!question.speed.diameter_mm) return needed("diameter_mm", LT_TEXT("Engine", "the diameter of the bar"));
    if (!question.length_mm) return needed(barLengthKey, LT_TEXT("Engine", "the overhang of the bar"));
    return std::nullopt;
}

bool isMissing(const Error& error)
{
    const Value* const found = find(error.values(), "found");
    return error.code() == errors::valueNotUnderstood && found && std::holds_alternative<std::monostate>(*found);
}

Json jsonOf(const SpeedOutcome& outcome)
{
    Json json = Json::object();
    if (outcome.published) json = nestedJson(describedValues(*outcome.published));
    if (outcome.safe) json.update(toJson(*outcome.safe, false));
    addUsedLines(outcome.response, json);
    return json;
}

report::Document reportOf(const SpeedOutcome& outcome, const Language& language)
{
    report::Document document;
    if (outcome.published) {
        SpeedResult published = *outcome.published;
        published.notes = outcome.notes;
        document = speedReport(published, *outcome.near, *outcome.response.frf, marksOf(outcome), outcome.response.used,
                               language);
    } else {
        document = lobesReport(*outcome.near, *outcome.response.frf, marksOf(outcome), outcome.response.used, language);
        if (!outcome.notes.empty()) document.sections.front().blocks.emplace_back(outcome.notes);
    }
    report::Answer first = answer(outcome, language);
    first.used = outcome.response.used;
    document.sections.front().blocks.front() = std::move(first);
    return document;
}

report::Section summaryOf(const SpeedOutcome& outcome, const Language& language)
{
    report::Section section{LT_TEXT("Engine", "Result"), {answer(outcome, language)}};
    if (outcome.published) {
        section = speedSummary(*outcome.published, language);
        section.blocks.front() = answer(outcome, language);
    }
    return section;
}

}  // namespace

const std::vector<Field<SpeedQuestion>>& fieldsOf(const SpeedQuestion*)
{
    using Q = SpeedQuestion;
    static const auto all = [] {
        std::vector<Field<Q>> made;
        for (const FieldInfo& info : infos<SpeedParameters>()) made.push_back(within(&Q::speed, info.key));
        made.push_back(
            field("depth_mm", &Q::depth_mm, Range{1e-6, 1e4},
                  Label{LT_TEXT("Engine", "Depth of cut"),
                        LT_TEXT("Engine", "On the radius: the speed is judged by it, with the cutting coefficient."),
                        unit::mm}));
        made.push_back(field(
            "cutting_coefficient_N_mm2", &Q::cutting_coefficient_N_mm2, Range{1e-3, 1e6},
            Label{LT_TEXT("Engine", "Cutting coefficient K_r"),
                  LT_TEXT("Engine", "Force along the chip thickness over its area; with the depth."), unit::N_mm2}));
        made.push_back(
            field(barLengthKey, &Q::length_mm, Range{1e-3, 1e5},
                  Label{LT_TEXT("Engine", "Overhang L"),
                        LT_TEXT("Engine",
                                "Of a plain bar of the diameter, from the chuck to its free end; in place of a shaft."),
                        unit::mm}));
        for (Field<Q>& one : described<Q>(group(
                 "bar_material", &Q::material,
                 Label{LT_TEXT("Engine", "Material of the bar"), LT_TEXT("Engine", "Without it steel is assumed.")}))) {
            one.info.advanced = true;
            made.push_back(std::move(one));
        }
        for (const FieldInfo& info : infos<ResponseQuestion>()) made.push_back(within(&Q::response, info.key));
        return made;
    }();
    return all;
}

std::optional<double> SpeedOutcome::recommendedRpm() const
{
    if (safe) return safe->recommendedRpm();
    return published ? std::optional(published->recommended_rpm) : std::nullopt;
}

SpeedOutcome answerSpeed(const project::PanelState& state, Stores& stores, task::Sources& sources,
                         const Progress& progress)
{
    SpeedOutcome outcome;
    outcome.question = fromValues<SpeedQuestion>(state.parameters);
    const SpeedQuestion& question = outcome.question;
    const std::vector<std::string> given = givenOf(speedTask(), state);
    if (given.empty() || given.front() == barLengthKey) outcome.problem = missingOfBar(question);
    if (outcome.problem) {
        outcome.record(state, sources, {});
        return outcome;
    }
    const std::optional<double> selected = selectedOf(question.speed);
    const double highest = std::max(usualHighestSpeed_rpm, question.speed.speed_rpm.value_or(0));
    outcome.response = takeResponse(state, question.response, highest, barOf(question), stores, sources,
                                    progress.part(0, 0.8, LT_TEXT("Engine", "Reading")));
    Notes found;
    try {
        outcome.published = chooseSpeed(*outcome.response.frf, question.speed);
        found = outcome.published->notes;
    } catch (const Error& error) {
        if (error.code().kind != ErrorKind::NoAnswer && !isMissing(error)) throw;
        outcome.problem = error;
    }
    noteUnusual(question, {usualCoefficient}, found);
    if (const auto missing = missingOfDepth(question)) outcome.problem = missing;
    if (selected) {
        if (question.depth_mm && question.cutting_coefficient_N_mm2) {
            LobeParameters lobes;
            lobes.cutting_coefficient_N_mm2 = question.cutting_coefficient_N_mm2;
            lobes.direction_factor = question.speed.direction_factor;
            outcome.safe = safeSpeed(*outcome.response.frf, lobes, safeQuestion(question, *selected),
                                     progress.part(0.8, 0.9, LT_TEXT("Engine", "Finding lobes")));
        }
        outcome.near = std::make_shared<const LobeResult>(findLobes(
            *outcome.response.frf, shownLobes(outcome, *selected), progress.part(0.9, 1), outcome.response.model));
        for (const Note& note : outcome.near->notes)  // what is said of the response, not of lobes
            if (note.code == notes::minimumInNoise || note.code == notes::minimumNotResolved) found.push_back(note);
    }
    outcome.record(state, sources, found);
    progress.report(1);
    return outcome;
}

LobesMarks marksOf(const SpeedOutcome& outcome)
{
    LobesMarks marks;
    if (outcome.safe) {
        marks.safe = &*outcome.safe;
        marks.point = OperatingPoint{outcome.safe->best.speed_rpm, outcome.safe->question.depth};
    }
    if (outcome.published) marks.rule = &*outcome.published;
    return marks;
}

report::Answer answer(const SpeedOutcome& outcome, const Language& language)
{
    if (!outcome.safe) {
        report::Answer told = outcome.published ? answer(*outcome.published, language) : report::Answer{};
        told.findings.push_back(
            {LT_TEXT("Engine", "Whether it is stable depends on the depth of cut, which is not given"), {}, {}, {}});
        return told;
    }
    const SafeSpeed& safe = *outcome.safe;
    report::Answer told;
    told.quantity = LT_TEXT("Engine", "Recommended spindle speed");
    told.value = safe.best.speed_rpm;
    told.unit = unit::rpm;
    told.decimals = 0;
    told.verdict = safe.best.is_stable ? Verdict::Pass : Verdict::Fail;
    told.verdict_words = safe.best.is_stable ? LT_TEXT("Engine", "✓ stable") : LT_TEXT("Engine", "✗ chatter");
    if (!safe.best.is_stable) told.quantity = LT_TEXT("Engine", "Speed that bears the most");
    const auto shown = [&](double depth_mm) { return fixed(depth_mm, depthDecimals(depth_mm), language); };
    told.values = {{"selected", fixed(safe.question.selected_rpm, 0, language)},
                   {"depth", shown(safe.question.depth)},
                   {"limit", shown(safe.best.limit.value_or(notANumber))},
                   {"margin", shown(safe.best.margin.value_or(notANumber))},
                   {"largest", shown(safe.selected.limit.value_or(notANumber))}};
    if (!safe.best.limit)
        told.sentence = LT_TEXT("Engine", "No lobe limits the depth here · instead of {selected}");
    else if (!safe.best.is_stable)
        told.sentence = LT_TEXT("Engine", "No speed of the range bears {depth} mm: at most {limit} mm");
    else if (!safe.selected.limit)
        told.sentence = LT_TEXT("Engine", "At {depth} mm with a margin of {margin} mm · {selected} is stable too");
    else
        told.sentence =
            LT_TEXT("Engine", "At {depth} mm with a margin of {margin} mm · at {selected} no deeper than {largest} mm");
    if (outcome.published)
        told.findings.push_back({LT_TEXT("Engine", "By the rule of the papers, which knows no depth: {speed:0} 1/min"),
                                 {{"speed", outcome.published->recommended_rpm}},
                                 {},
                                 {}});
    return told;
}

task::Outcome outcomeOf(const std::shared_ptr<const SpeedOutcome>& outcome)
{
    task::Outcome all;
    all.result = outcome;
    all.notes = outcome->notes;
    const std::optional<Error>& problem = outcome->problem;
    const bool is_answered = outcome->safe && problem && problem->code().kind == ErrorKind::NoAnswer;
    if (problem && !is_answered) all.errors.push_back(*problem);
    if (outcome->safe) all.verdict = outcome->safe->best.is_stable ? Verdict::Pass : Verdict::Fail;
    all.json = [outcome] { return jsonOf(*outcome); };
    all.answer = [outcome](const Language& language) { return answer(*outcome, language); };
    if (all.errors.empty()) {
        all.summary = [outcome](const Language& language) { return summaryOf(*outcome, language); };
        all.report = [outcome](const Language& language) { return reportOf(*outcome, language); };
    }
    return settled(speedTask(), std::move(all), outcome->understanding);
}

const task::Task& speedTask()
{
    static const task::Task task = [] {
        task::Task made;
        made.key = "speed";
        made.title = LT_TEXT("Engine", "Speed");
        made.summary = "Recommend a spindle speed without chatter in place of the selected one.";
        made.question = "speed";
        made.inputs = responseInputs();
        made.one_of = responseSources();
        made.one_of.keys.emplace_back(barLengthKey);
        made.only_with = responseRules({barLengthKey});
        task::askFor<SpeedQuestion>(made);
        made.run = [](const project::PanelState& state, const task::Wanted&, Stores& stores, task::Sources& sources,
                      const Progress& progress) {
            return outcomeOf(std::make_shared<const SpeedOutcome>(answerSpeed(state, stores, sources, progress)));
        };
        return made;
    }();
    return task;
}

}  // namespace lathelier::stability
