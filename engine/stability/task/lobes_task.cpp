#include "engine/stability/task/lobes_task.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "engine/core/field_within.h"
#include "engine/core/json.h"
#include "engine/core/units.h"
#include "engine/io/file.h"
#include "engine/report/chart_csv.h"
#include "engine/stability/depth_digits.h"
#include "engine/stability/refusal.h"
#include "engine/stability/stability_codes.h"
#include "engine/stability/stability_quantities.h"
#include "engine/stability/stability_report.h"
#include "engine/task/memo.h"

namespace lathelier::stability {
namespace {

constexpr double usualDepth = 1.5;  ///< depth that is not stated, by the least limit

/// Chatter marks of a photograph as an input; an item only.
struct MarksInput {
    struct File {
        Notes notes;
    };
    using Value = SurfaceMarks;
    static constexpr const char* item = marksItem;

    static File read(const io::FileToRead&) { return {}; }
    static Value valueOf(const File&) { return {}; }
    static io::FileKinds kinds() { return {}; }
    static std::optional<Value> ofItem(const Values& values) { return marksOf(values); }
};

/// Lobes and passes by their inputs: dragging the operating point does not compute them again.
struct ComputedLobes : Memo<LobeResult> {};
struct ComputedPasses : Memo<PassResult> {};

std::string keyOf(const Values& values)
{
    return toJson(values).dump();
}

OperatingPoint pointOf(const LobesQuestion& question, const LobeResult& lobes)
{
    return {question.point.operating_speed_rpm.value_or((lobes.speed_rpm.from + lobes.speed_rpm.to) / 2),
            question.point.operating_depth.value_or(usualDepth * lobes.minimum_depth_mm.value_or(1))};
}

/// What of a point that is judged was not stated.
void assumePoint(const LobesOutcome& outcome, Understanding& understanding)
{
    const PointParameters& stated = outcome.question.point;
    const auto number = [](double value) { return std::get<std::string>(Value(fixed(value, 4))); };
    if (!outcome.is_judged) return;
    if (!stated.operating_speed_rpm)
        understanding.assumed.push_back({operatingSpeedKey, number(outcome.point.speed_rpm), {}, 0});
    if (!stated.operating_depth)
        understanding.assumed.push_back({operatingDepthKey, number(outcome.point.depth_mm), {}, 0});
}

/// Speeds that may be recommended: those of the tool, else those shown.
Interval rangeOf(const LobesQuestion& question, const Interval& shown)
{
    const SpeedParameters& speed = question.speed;
    if (speed.range_m_min.empty() || !question.lobes.diameter_mm) return shown;
    if (speed.range_m_min.size() > 1 || !(speed.range_m_min.front().from <= speed.range_m_min.front().to))
        refuse("range_m_min", Value(speed.range_m_min), LT_TEXT("Engine", "a range such as 200:350"));
    return {spindleSpeed(speed.range_m_min.front().from, *question.lobes.diameter_mm),
            spindleSpeed(speed.range_m_min.front().to, *question.lobes.diameter_mm)};
}

/// Candidates of the rule of the papers, for the chart; none where the rule has no speed.
std::optional<SpeedResult> candidatesOf(const LobesOutcome& outcome)
{
    SpeedParameters asked = outcome.question.speed;
    asked.speed_rpm = outcome.point.speed_rpm;
    asked.diameter_mm = outcome.question.lobes.diameter_mm;
    if (!asked.diameter_mm) asked.range_m_min.clear();
    asked.relation = outcome.question.lobes.relation;
    asked.direction_factor = outcome.question.lobes.direction_factor;
    try {
        return chooseSpeed(*outcome.response.frf, asked);
    } catch (const Error& error) {
        if (error.code() == errors::noStableSpeed) return std::nullopt;
        throw;
    }
}

std::optional<receptance::ForcedShape> swingOf(const LobesOutcome& outcome)
{
    if (!outcome.response.shaft) return std::nullopt;
    const PointStability work = pointStabilityAt(*outcome.lobes, outcome.point.speed_rpm, outcome.point.depth_mm);
    const std::optional<double> frequency_hz =
        std::isfinite(work.frequency_hz) ? work.frequency_hz : outcome.lobes->frequency_of_minimum_hz;
    if (!frequency_hz) return std::nullopt;
    return receptance::forcedShape(*outcome.response.shaft, outcome.question.response.computing,
                                   outcome.response.holding, *frequency_hz);
}

void answerPass(LobesOutcome& outcome, Stores& stores, const Progress& progress)
{
    const LobesQuestion& question = outcome.question;
    if (!outcome.response.shaft) refuse(shaftRole, Value(), LT_TEXT("Engine", "the shaft of a pass"));
    LobeParameters lobes = question.lobes;
    if (lobes.speed_rpm.empty()) lobes.speed_rpm = {outcome.lobes->speed_rpm};
    outcome.pass = stores.of<ComputedPasses>()->find(
        outcome.response.basis + keyOf(lathelier::toValues(lobes)) + keyOf(lathelier::toValues(question.pass)),
        progress, [&](const Progress& part) {
            return lobesOverPass(*outcome.response.shaft, question.pass, question.response.computing,
                                 outcome.response.holding, lobes, part);
        });
    const PassResult& pass = *outcome.pass;
    const Interval range = rangeOf(question, {pass.speed_rpm.front(), pass.speed_rpm.back()});
    outcome.safe = safeOverPass(pass, question.point.operating_speed_rpm, range);
    outcome.point = {outcome.safe.question.selected_rpm, *question.pass.pass_depth_mm};
}

Json jsonOf(const LobesOutcome& outcome)
{
    Json json = toJson(*outcome.lobes);
    addUsedLines(outcome.response, json);
    if (outcome.is_judged) json["operating_point"] = pointJson(*outcome.lobes, outcome.point);
    if (outcome.pass) json["pass"] = passJson(*outcome.pass);
    if (outcome.is_judged || outcome.pass)
        json["safe_speed"] = toJson(outcome.safe, !outcome.pass && outcome.lobes->isRelative());
    return json;
}

report::Document reportOf(const LobesOutcome& outcome, const Language& language)
{
    if (outcome.pass) {
        PassResult pass = *outcome.pass;
        pass.notes = outcome.notes;
        report::Document document = passReport(pass, outcome.safe, outcome.question.lobes, language);
        report::Document whole =
            lobesReport(*outcome.lobes, *outcome.response.frf, {}, outcome.response.used, language);
        document.sections.insert(document.sections.end() - 1, whole.sections.begin() + 1, whole.sections.end() - 1);
        std::get<report::Answer>(document.sections.front().blocks.front()).used = outcome.response.used;
        return document;
    }
    LobeResult lobes = *outcome.lobes;
    lobes.notes = outcome.notes;
    report::Document document =
        lobesReport(lobes, *outcome.response.frf, outcome.is_judged ? marksOf(outcome) : LobesMarks{},
                    outcome.response.used, language);
    report::Answer first = answer(outcome, language);
    first.used = outcome.response.used;
    document.sections.front().blocks.front() = std::move(first);
    return document;
}

report::Section summaryOf(const LobesOutcome& outcome, const Language& language)
{
    report::Section section = lobesSummary(*outcome.lobes, language);
    section.blocks.front() = answer(outcome, language);
    if (outcome.is_judged) section.blocks.push_back(pointTable(*outcome.lobes, outcome.point));
    return section;
}

/// What is stable at the operating point's speed against its depth; without a limit there the depth.
report::Answer pointAnswer(const LobesOutcome& outcome, const Language& language)
{
    const LobeResult& lobes = *outcome.lobes;
    const PointStability work = pointStabilityAt(lobes, outcome.point.speed_rpm, outcome.point.depth_mm);
    report::Answer told;
    const bool is_limited = std::isfinite(work.limit_mm);
    told.quantity = is_limited ? LT_TEXT("Engine", "Depth that is stable here") : LT_TEXT("Engine", "Depth of cut");
    told.value = is_limited ? roundedDepth(work.limit_mm) : outcome.point.depth_mm;
    if (!lobes.isRelative()) told.unit = unit::mm;
    told.decimals = depthDecimals(std::min(outcome.point.depth_mm, std::fmin(work.limit_mm, 1)));
    if (is_limited) told.lower_limit = outcome.point.depth_mm;
    told.verdict = work.stable ? Verdict::Pass : Verdict::Fail;
    told.verdict_words = work.stable ? LT_TEXT("Engine", "✓ stable") : LT_TEXT("Engine", "✗ chatter");
    told.values = {{"speed", fixed(outcome.point.speed_rpm, 0, language)},
                   {"frequency", fixed(work.frequency_hz, 1, language)},
                   {"k", std::int64_t{work.k}},
                   {"probability", fixed(100 * work.probability_stable, 0, language)}};
    told.sentence = !is_limited  ? LT_TEXT("Engine", "{speed} 1/min · no lobe limits here")
                    : lobes.band ? LT_TEXT("Engine",
                                           "{speed} 1/min · stable with a probability of {probability} % · "
                                           "lobe {k}, chatter at {frequency} Hz")
                                 : LT_TEXT("Engine", "{speed} 1/min · lobe {k}, chatter at {frequency} Hz");
    told.findings = findingsOf(outcome.safe, lobes.isRelative(), operatingSpeedKey);
    return told;
}

}  // namespace

const std::vector<Field<LobesQuestion>>& fieldsOf(const LobesQuestion*)
{
    using Q = LobesQuestion;
    static const std::vector<Field<Q>> all = [] {
        std::vector<Field<Q>> made;
        for (const FieldInfo& info : infos<LobeParameters>()) made.push_back(within(&Q::lobes, info.key));
        for (const FieldInfo& info : infos<PointParameters>()) made.push_back(within(&Q::point, info.key));
        for (const char* key : {"range_m_min", "rule"}) made.push_back(within(&Q::speed, key));
        for (const FieldInfo& info : infos<PassParameters>()) made.push_back(within(&Q::pass, info.key));
        for (const FieldInfo& info : infos<ResponseQuestion>()) made.push_back(within(&Q::response, info.key));
        return made;
    }();
    return all;
}

LobesOutcome answerLobes(const project::PanelState& state, Stores& stores, task::Sources& sources,
                         const Progress& progress)
{
    LobesOutcome outcome;
    outcome.question = fromValues<LobesQuestion>(state.parameters);
    const LobesQuestion& question = outcome.question;
    outcome.is_judged = question.point.operating_speed_rpm || question.point.operating_depth;
    const double highest =
        question.lobes.speed_rpm.empty() ? usualHighestSpeed_rpm : question.lobes.speed_rpm.front().to;
    outcome.response =
        takeResponse(state, question.response, highest, std::nullopt, stores, sources, progress.part(0, 0.4));
    outcome.marks = task::take<MarksInput>(state, marksRole, stores, progress, sources);
    outcome.lobes = stores.of<ComputedLobes>()->find(
        outcome.response.basis + keyOf(lathelier::toValues(question.lobes)),
        progress.part(0.4, 0.6, LT_TEXT("Engine", "Finding lobes")), [&](const Progress& part) {
            return findLobes(*outcome.response.frf, question.lobes, part, outcome.response.model);
        });
    Notes found = outcome.lobes->notes;
    outcome.point = pointOf(question, *outcome.lobes);
    if (question.pass.isAsked()) {
        answerPass(outcome, stores, progress.part(0.6, 1, LT_TEXT("Engine", "Finding lobes")));
        for (const Note& note : outcome.pass->notes)
            if (!contains(sources.notes, note.code)) found.push_back(note);
    } else {
        const SafeSpeedQuestion asked{outcome.point.speed_rpm, outcome.point.depth_mm,
                                      rangeOf(question, outcome.lobes->speed_rpm)};
        outcome.safe = safeSpeed(*outcome.response.frf, question.lobes, asked, progress.part(0.6, 1));
        outcome.candidates = candidatesOf(outcome);
        outcome.swing = swingOf(outcome);
    }
    Understanding assumed;
    assumePoint(outcome, assumed);
    outcome.record(state, sources, found, assumed);
    progress.report(1);
    return outcome;
}

LobesMarks marksOf(const LobesOutcome& outcome)
{
    const bool is_exact = outcome.question.lobes.relation == SpeedRelation::Exact;  // as the safe speed is
    return {is_exact ? &outcome.safe : nullptr, outcome.candidates ? &*outcome.candidates : nullptr, outcome.point};
}

report::Answer answer(const LobesOutcome& outcome, const Language& language)
{
    if (outcome.pass) return passAnswer(*outcome.pass, outcome.safe, language);
    const LobeResult& lobes = *outcome.lobes;
    report::Answer told = outcome.is_judged ? pointAnswer(outcome, language) : answer(lobes, language);
    if (!outcome.is_judged && outcome.safe.best.limit && lobes.isRelative()) {
        told.quantity = LT_TEXT("Engine", "Speed of the deepest stable cut");
        told.value = outcome.safe.best.speed_rpm;
        told.unit = unit::rpm;
        told.decimals = 0;
    }
    if (!outcome.is_judged && outcome.safe.best.limit)
        told.findings.push_back({lobes.isRelative()
                                     ? LT_TEXT("Engine", "The most is {limit:3} × at {speed:0} 1/min")
                                     : LT_TEXT("Engine", "The most is {limit_mm:3+} mm at {speed:0} 1/min"),
                                 {{"speed", outcome.safe.best.speed_rpm},
                                  {"limit", *outcome.safe.best.limit},
                                  {"limit_mm", *outcome.safe.best.limit}},
                                 {},
                                 {},
                                 {{operatingSpeedKey, std::round(outcome.safe.best.speed_rpm)}}});
    if (outcome.marks)
        if (const auto check = checkModel(*outcome.marks, lobes))
            told.findings.push_back(modelFinding(*outcome.marks, *check, language));
    if (outcome.is_judged && lobes.minimum_depth_mm && !lobes.isRelative())
        told.findings.push_back({LT_TEXT("Engine", "Stable at every speed up to {depth_mm:3+} mm"),
                                 {{"depth_mm", *lobes.minimum_depth_mm}},
                                 {},
                                 {}});
    return told;
}

task::Outcome outcomeOf(const std::shared_ptr<const LobesOutcome>& outcome)
{
    task::Outcome all;
    all.result = outcome;
    all.notes = outcome->notes;
    if (outcome->pass)
        all.verdict = outcome->safe.selected.is_stable ? Verdict::Pass : Verdict::Fail;
    else if (outcome->is_judged)
        all.verdict = answer(*outcome).verdict;
    all.json = [outcome] { return jsonOf(*outcome); };
    all.answer = [outcome](const Language& language) { return answer(*outcome, language); };
    all.summary = [outcome](const Language& language) { return summaryOf(*outcome, language); };
    all.report = [outcome](const Language& language) { return reportOf(*outcome, language); };
    all.writers[limitExport] = [outcome](const std::string& path, const Language&, const Progress&) {
        io::writeFile(
            path, report::toCsv(outcome->pass ? passPlot(*outcome->pass, outcome->safe) : lobesPlot(*outcome->lobes)));
    };
    return settled(lobesTask(), std::move(all), outcome->understanding);
}

const task::Task& lobesTask()
{
    static const task::Task task = [] {
        task::Task made;
        made.key = "lobes";
        made.title = LT_TEXT("Engine", "Lobes");
        made.summary = "Stability lobes: the limiting depth of cut over the spindle speed.";
        made.question = "speed";
        made.inputs = responseInputs();
        made.inputs.push_back(task::optionalInput<MarksInput>(
            marksRole, "", LT_TEXT("Engine", "Chatter marks"),
            LT_TEXT("Engine", "Read off a photograph by the panel Surface. They may be missing.")));
        made.inputs.back().takes_files = false;
        made.inputs.back().is_of_part = true;
        made.one_of = responseSources();
        made.only_with = responseRules();
        task::askFor<LobesQuestion>(made);
        made.exports = {{limitExport, "Write limit and lobes as FILE.csv.", LT_TEXT("Engine", "Limit and lobes (CSV)…"),
                         LT_TEXT("Engine", "Table (*.csv)"), "csv"}};
        made.run = [](const project::PanelState& state, const task::Wanted&, Stores& stores, task::Sources& sources,
                      const Progress& progress) {
            return outcomeOf(std::make_shared<const LobesOutcome>(answerLobes(state, stores, sources, progress)));
        };
        return made;
    }();
    return task;
}

}  // namespace lathelier::stability
