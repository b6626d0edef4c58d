#include "engine/series/series_report.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "engine/archive/archive_json.h"
#include "engine/core/significant_digits.h"
#include "engine/core/units.h"
#include "engine/core/verdict_json.h"
#include "engine/report/parameters_table.h"
#include "engine/report/quantity_table.h"

namespace lathelier::series {
namespace {

constexpr std::size_t mostMarks = 5;
constexpr int leastDecimals = 3;

Value valueOf(const std::optional<double>& value)
{
    return value ? Value(*value) : Value();
}

/// A count is a whole number.
Value numberOf(const task::Characteristic& one)
{
    constexpr double largestCount = 1e15;
    const bool is_count = one.unit.empty() && std::abs(one.value) < largestCount && one.value == std::floor(one.value);
    return is_count ? Value(static_cast<std::int64_t>(one.value)) : Value(one.value);
}

Value verdictOf(const std::optional<Verdict>& verdict)
{
    return verdict ? Value(shortName(*verdict)) : Value();
}

/// By the smallest uncertainty or, without one, the scatter, with one digit more.
int decimalsOf(const SeriesOutcome& outcome)
{
    double finest = outcome.chart.standard_deviation.value_or(0);
    for (const archive::SeriesPoint& point : outcome.points)
        if (point.expanded_uncertainty && *point.expanded_uncertainty > 0) finest = *point.expanded_uncertainty;
    return std::min(decimalsOfThreeDigits(finest, leastDecimals) - (finest > 0 ? 1 : 0), 6);
}

std::vector<double> numbersOf(const SeriesOutcome& outcome)
{
    std::vector<double> numbers(outcome.points.size());
    for (std::size_t i = 0; i < numbers.size(); ++i) numbers[i] = static_cast<double>(i + 1);
    return numbers;
}

/// A line across all numbers.
report::Curve across(Text name, double value, const SeriesOutcome& outcome, report::Curve::Style style,
                     report::ChartColour colour)
{
    report::Curve curve;
    curve.name = name;
    curve.x = {0.5, static_cast<double>(outcome.points.size()) + 0.5};
    curve.y = {value, value};
    curve.style = style;
    curve.colour = colour;
    curve.has_readout = false;
    return curve;
}

void addLimits(report::Plot& plot, const SeriesOutcome& outcome, const Language& language)
{
    const auto add = [&](const std::optional<double>& limit, Text name) {
        if (limit)
            plot.limits.push_back({report::Limit::Direction::Horizontal, *limit,
                                   text(name, language) + " " + text(Value(*limit), language)});
    };
    add(outcome.chart.lower_limit, LT_TEXT("Engine", "lower limit"));
    add(outcome.chart.upper_limit, LT_TEXT("Engine", "upper limit"));
    if (outcome.chart.lower_limit || outcome.chart.upper_limit) return;
    for (const auto side : {&archive::SeriesPoint::lower_limit, &archive::SeriesPoint::upper_limit}) {
        report::Curve limits{LT_TEXT("Engine", "limits"), numbersOf(outcome), {}, report::Curve::Style::Dashed};
        limits.colour = report::ColourRole::Limit;
        for (const archive::SeriesPoint& point : outcome.points) limits.y.push_back((point.*side).value_or(notANumber));
        const bool any = std::any_of(limits.y.begin(), limits.y.end(), [](double y) { return !std::isnan(y); });
        if (any) plot.curves.push_back(std::move(limits));
    }
}

void addControl(report::Plot& plot, const SeriesOutcome& outcome)
{
    using Style = report::Curve::Style;
    const ControlChart& chart = outcome.chart;
    plot.curves.push_back(
        across(LT_TEXT("Engine", "mean"), chart.mean, outcome, Style::Line, report::ColourRole::Neutral));
    if (!chart.lower_control_limit) return;
    plot.curves.push_back(across(LT_TEXT("Engine", "control limits"), *chart.lower_control_limit, outcome,
                                 Style::Dashed, report::ColourRole::Neutral));
    plot.curves.push_back(across({}, *chart.upper_control_limit, outcome, Style::Dashed, report::ColourRole::Neutral));
}

bool isOutside(const archive::SeriesPoint& point)
{
    return point.verdict == Verdict::Fail;
}

report::Finding findingOf(const SeriesOutcome& outcome, std::size_t index, int decimals, const Language& language)
{
    const archive::SeriesPoint& point = outcome.points[index];
    report::Finding finding;
    finding.pattern = LT_TEXT("Engine", "Part {number}, {file}: {value} {unit}");
    finding.values = {{"number", static_cast<std::int64_t>(index + 1)},
                      {"file", point.file},
                      {"value", fixed(point.value, decimals, language)},
                      {"unit", outcome.chosen.unit}};
    finding.verdict = point.verdict;
    finding.place.line = static_cast<std::int64_t>(index + 1);
    return finding;
}

/// Those out of tolerance, the latest first.
std::vector<report::Finding> findingsOf(const SeriesOutcome& outcome, int decimals, const Language& language)
{
    constexpr std::size_t mostFindings = 3;
    std::vector<report::Finding> findings;
    for (std::size_t i = outcome.points.size(); i > 0 && findings.size() < mostFindings; --i)
        if (isOutside(outcome.points[i - 1])) findings.push_back(findingOf(outcome, i - 1, decimals, language));
    return findings;
}

}  // namespace

std::string shownName(const archive::ArchivedCharacteristic& characteristic, const Language& language)
{
    if (characteristic.key == "answer")
        return fill(text(LT_TEXT("Engine", "Answer of {task}"), language), {{"task", characteristic.task}}, language);
    std::string name;
    for (const char letter : task::withoutUnit(characteristic.key))
        if (letter == '.')
            name += " › ";
        else
            name += letter == '_' ? ' ' : letter;
    return name;
}

Text unitOf(const archive::ArchivedCharacteristic& characteristic)
{
    return task::unitNamed(characteristic.unit);
}

report::Plot seriesPlot(const SeriesOutcome& outcome, const Language& language)
{
    report::Plot plot;
    plot.title = shownName(outcome.chosen, language);
    plot.x = {LT_TEXT("Engine", "Number of the part in the order of time"), Text{}};
    plot.x.scale = report::Axis::Scale::Whole;
    plot.x.range = Interval{0.5, static_cast<double>(outcome.points.size()) + 0.5};
    plot.y = {LT_TEXT("Engine", "Value"), unitOf(outcome.chosen)};
    const std::vector<double> numbers = numbersOf(outcome);
    report::Curve reach{LT_TEXT("Engine", "± U"), {}, {}};
    report::Curve line{{}, numbers, {}};
    report::Curve inside{LT_TEXT("Engine", "value"), numbers, {}, report::Curve::Style::Points};
    report::Curve outside{LT_TEXT("Engine", "out of tolerance"), numbers, {}, report::Curve::Style::Points};
    reach.colour = line.colour = inside.colour = report::ColourRole::Original;
    outside.colour = report::ColourRole::Excess;
    reach.has_readout = false;
    line.has_readout = false;
    line.thin = true;
    for (std::size_t i = 0; i < outcome.points.size(); ++i) {
        const archive::SeriesPoint& point = outcome.points[i];
        const bool is_outside = isOutside(point);
        line.y.push_back(point.value);
        inside.y.push_back(is_outside ? notANumber : point.value);
        outside.y.push_back(is_outside ? point.value : notANumber);
        if (is_outside && plot.marks.size() < mostMarks) plot.marks.push_back({numbers[i], point.value, point.file});
        if (!point.expanded_uncertainty) continue;
        for (const double end : {-1.0, 1.0, notANumber}) {
            reach.x.push_back(numbers[i]);
            reach.y.push_back(point.value + end * *point.expanded_uncertainty);
        }
    }
    addControl(plot, outcome);
    if (!reach.x.empty()) plot.curves.push_back(std::move(reach));
    plot.curves.push_back(std::move(line));
    plot.curves.push_back(std::move(inside));
    if (outcome.chart.out_of_tolerance > 0) plot.curves.push_back(std::move(outside));
    addLimits(plot, outcome, language);
    return plot;
}

report::Table valuesTable(const SeriesOutcome& outcome, const Language& language)
{
    using report::Labelled;
    const Text unit = unitOf(outcome.chosen);
    const int decimals = decimalsOf(outcome);
    report::Table table{shownName(outcome.chosen, language),
                        {LT_TEXT("Engine", "part"), LT_TEXT("Engine", "time (UTC)"), LT_TEXT("Engine", "file"),
                         Labelled{LT_TEXT("Engine", "value"), unit}, Labelled{LT_TEXT("Engine", "U"), unit},
                         Labelled{LT_TEXT("Engine", "lower"), unit}, Labelled{LT_TEXT("Engine", "upper"), unit},
                         LT_TEXT("Engine", "verdict")},
                        {},
                        {0, 0, 0, decimals, decimals, decimals, decimals, 0}};
    table.rows.reserve(outcome.points.size());
    for (std::size_t i = 0; i < outcome.points.size(); ++i) {
        const archive::SeriesPoint& point = outcome.points[i];
        table.rows.push_back({static_cast<std::int64_t>(i + 1), point.recorded_at, point.file, point.value,
                              valueOf(point.expanded_uncertainty), valueOf(point.lower_limit),
                              valueOf(point.upper_limit), verdictOf(point.verdict)});
    }
    return table;
}

report::Table characteristicsTable(const SeriesOutcome& outcome, const Language& language)
{
    report::Table table{LT_TEXT("Engine", "Characteristics of the archive"),
                        {LT_TEXT("Engine", "task"), LT_TEXT("Engine", "characteristic"), LT_TEXT("Engine", "key"),
                         LT_TEXT("Engine", "unit"), LT_TEXT("Engine", "latest value (UTC)")},
                        {},
                        {}};
    table.rows.reserve(outcome.characteristics.size());
    for (const archive::ArchivedCharacteristic& one : outcome.characteristics)
        table.rows.push_back({one.task, shownName(one, language), one.key, one.unit, one.last_recorded_at});
    return table;
}

report::QuantityTable partTable(const SeriesOutcome& outcome)
{
    const archive::Entry& entry = outcome.part.entry;
    report::QuantityTable table{LT_TEXT("Engine", "Part in detail"), {}};
    const auto add = [&table](Text name, const std::string& value) {
        if (!value.empty()) table.rows.push_back({name, value, {}});
    };
    add(LT_TEXT("Engine", "File"), entry.file);
    add(LT_TEXT("Engine", "Evaluated (UTC)"), entry.recorded_at);
    add(LT_TEXT("Engine", "Person"), entry.attestation.person);
    add(LT_TEXT("Engine", "Instrument"), entry.attestation.instrument);
    add(LT_TEXT("Engine", "Calibrated on"), entry.attestation.calibrated_on);
    add(LT_TEXT("Engine", "Task"), entry.task);
    add(LT_TEXT("Engine", "Version of the program"), entry.version);
    add(LT_TEXT("Engine", "Recipe (SHA-256)"), entry.recipe_sha256);
    for (const ArchivedFile& file : outcome.as_asked.files) {
        table.rows.push_back({file.role, file.path.empty() ? file.sha256 : file.path, {}});
        table.rows.push_back({LT_TEXT("Engine", "… its content"), name(file.state), {}});
    }
    add(LT_TEXT("Engine", "Supersedes"), entry.supersedes);
    add(LT_TEXT("Engine", "Reason"), entry.reason);
    add(LT_TEXT("Engine", "Row in the archive"), entry.uuid);
    add(LT_TEXT("Engine", "Its SHA-256"), entry.hash);
    return table;
}

report::Table partCharacteristics(const SeriesOutcome& outcome, const Language& language)
{
    report::Table table{LT_TEXT("Engine", "Characteristics of the part"),
                        {LT_TEXT("Engine", "characteristic"), LT_TEXT("Engine", "value"), LT_TEXT("Engine", "U"),
                         LT_TEXT("Engine", "lower"), LT_TEXT("Engine", "upper"), LT_TEXT("Engine", "unit"),
                         LT_TEXT("Engine", "verdict")},
                        {},
                        {0, 4, 4, 4, 4, 0, 0}};
    table.rows.reserve(outcome.part.evaluation.characteristics.size());
    for (const task::Characteristic& one : outcome.part.evaluation.characteristics)
        table.rows.push_back({shownName({outcome.part.entry.task, one.key, one.unit, {}}, language), numberOf(one),
                              valueOf(one.expanded_uncertainty), valueOf(one.lower_limit), valueOf(one.upper_limit),
                              one.unit, verdictOf(one.verdict)});
    return table;
}

report::QuantityTable statisticsTable(const SeriesOutcome& outcome)
{
    report::QuantityTable table = report::quantityTable<ControlChart>(LT_TEXT("Engine", "Series"), outcome.chart,
                                                                      {"count",
                                                                       "judged",
                                                                       "out_of_tolerance",
                                                                       "undecided",
                                                                       "mean",
                                                                       "standard_deviation",
                                                                       "smallest",
                                                                       "largest",
                                                                       "lower_limit",
                                                                       "upper_limit",
                                                                       "Pp",
                                                                       "Ppk",
                                                                       "lower_control_limit",
                                                                       "upper_control_limit",
                                                                       "out_of_control",
                                                                       "longest_run",
                                                                       "longest_trend",
                                                                       "in_control",
                                                                       "drift_per_100_parts",
                                                                       "drift_expanded_uncertainty_per_100_parts"});
    const Text unit = unitOf(outcome.chosen);
    for (report::Quantity& row : table.rows)
        if (std::holds_alternative<double>(row.value) && row.decimals > 2) row.unit = unit;
    return table;
}

report::Answer answer(const SeriesOutcome& outcome, const Language& language)
{
    const archive::SeriesPoint& worst = outcome.points[outcome.worst];
    const int decimals = decimalsOf(outcome);
    report::Answer answer;
    answer.quantity = shownName(outcome.chosen, language);
    answer.subject = fill(text(LT_TEXT("Engine", "part {number} of {count}, {file}"), language),
                          {{"number", static_cast<std::int64_t>(outcome.worst + 1)},
                           {"count", outcome.chart.count},
                           {"file", worst.file}},
                          language);
    answer.value = worst.value;
    answer.expanded_uncertainty = worst.expanded_uncertainty;
    answer.unit = unitOf(outcome.chosen);
    answer.is_signed = worst.lower_limit && *worst.lower_limit < 0;
    answer.decimals = decimals;
    answer.lower_limit = worst.lower_limit;
    answer.upper_limit = worst.upper_limit;
    answer.verdict = outcome.verdict();
    answer.values = {
        {"out", outcome.chart.out_of_tolerance},
        {"count", outcome.chart.count},
        {"mean", fixed(outcome.chart.mean, decimals, language)},
        {"unit", outcome.chosen.unit},
        {"Ppk", outcome.chart.capability_ppk ? fixed(*outcome.chart.capability_ppk, 2, language) : std::string()}};
    if (outcome.chart.capability_ppk && outcome.chart.isInControl())
        answer.sentence = LT_TEXT("Engine",
                                  "{out} of {count} parts out of tolerance; mean {mean} {unit}, Ppk {Ppk}, "
                                  "in control.");
    else if (outcome.chart.capability_ppk)
        answer.sentence = LT_TEXT("Engine",
                                  "{out} of {count} parts out of tolerance; mean {mean} {unit}, Ppk {Ppk}, "
                                  "not in control.");
    else if (outcome.chart.judged > 0)
        answer.sentence = LT_TEXT("Engine", "{out} of {count} parts out of tolerance; mean {mean} {unit}.");
    else
        answer.sentence = LT_TEXT("Engine", "{count} parts without a limit; mean {mean} {unit}.");
    answer.findings = findingsOf(outcome, decimals, language);
    return answer;
}

report::Document seriesReport(const SeriesOutcome& outcome, const Language& language)
{
    report::Document document;
    document.title = LT_TEXT("Engine", "Series");
    report::Section result{LT_TEXT("Engine", "Result"), {answer(outcome, language), seriesPlot(outcome, language)}};
    if (!outcome.notes.empty()) result.blocks.emplace_back(outcome.notes);
    result.blocks.emplace_back(statisticsTable(outcome));
    document.sections.push_back(std::move(result));
    document.sections.push_back({LT_TEXT("Engine", "Values"), {valuesTable(outcome, language)}});
    document.sections.push_back(
        {LT_TEXT("Engine", "Parameters"),
         {report::parametersTable(infos<SeriesQuestion>(), lathelier::toValues(outcome.question), language)}});
    return document;
}

Json toJson(const SeriesOutcome& outcome)
{
    Json json{{"archive", outcome.location},
              {"task", outcome.chosen.task},
              {"characteristic", outcome.chosen.key},
              {"unit", outcome.chosen.unit}};
    json["verdict"] = verdictJson(outcome.verdict());
    json.update(nestedJson(describedValues(outcome.chart)));
    json["points"] = Json::array();
    for (const archive::SeriesPoint& point : outcome.points) json["points"].push_back(archive::toJson(point));
    json["characteristics"] = Json::array();
    for (const archive::ArchivedCharacteristic& one : outcome.characteristics)
        json["characteristics"].push_back(archive::toJson(one));
    return json;
}

}  // namespace lathelier::series
