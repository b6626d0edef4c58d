#include "engine/registration/copies.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "engine/core/units.h"
#include "engine/core/verdict_json.h"
#include "engine/registration/compare_quantities.h"

namespace lathelier::registration {

CopySummary summaryOf(std::string name, const CompareResult& result)
{
    CopySummary copy;
    copy.name = std::move(name);
    copy.verdict = result.verdict;
    copy.worst = result.worst;
    if (result.has_sign) copy.mean_mm = result.statistics.mean_mm;
    copy.rmse_mm = result.statistics.rmse_mm;
    copy.scatter_mm = result.scatter_mm;
    return copy;
}

Json toJson(const std::vector<CopySummary>& copies)
{
    Json all = Json::array();
    for (const CopySummary& copy : copies) {
        Json one{{"name", copy.name}};
        if (copy.error) {
            one["error"] = lathelier::toJson(*copy.error);
        } else {
            one["verdict"] = verdictJson(copy.verdict);
            one["worst"] = copy.worst ? nestedJson(describedValues(*copy.worst)) : Json(nullptr);
            one["mean_mm"] = number(copy.mean_mm);
            one["rmse_mm"] = number(copy.rmse_mm);
            one["scatter_mm"] = number(copy.scatter_mm);
        }
        all.push_back(std::move(one));
    }
    return all;
}

report::Table copiesTable(const std::vector<CopySummary>& copies, const Language& language)
{
    report::Table table{
        LT_TEXT("Engine", "Copies of the same original"),
        {LT_TEXT("Engine", "copy"), LT_TEXT("Engine", "verdict"),
         report::Labelled{LT_TEXT("Engine", "worst"), unit::mm}, report::Labelled{LT_TEXT("Engine", "U"), unit::mm},
         report::Labelled{LT_TEXT("Engine", "z"), unit::mm}, report::Labelled{LT_TEXT("Engine", "mean"), unit::mm},
         report::Labelled{LT_TEXT("Engine", "RMS"), unit::mm}, report::Labelled{LT_TEXT("Engine", "noise"), unit::mm}},
        {},
        {0, 0, 4, 4, 1, 4, 4, 4}};
    const auto number = [](double value) { return std::isfinite(value) ? Value(value) : Value(); };
    for (const CopySummary& copy : copies) {
        if (copy.error) {
            table.rows.push_back(
                {copy.name, text(*copy.error, language), Value(), Value(), Value(), Value(), Value(), Value()});
            continue;
        }
        const Value z = copy.worst && copy.worst->z_mm ? Value(*copy.worst->z_mm) : Value();
        table.rows.push_back({copy.name, copy.verdict ? Value(lathelier::name(*copy.verdict)) : Value(),
                              copy.worst ? Value(copy.worst->deviation_mm) : Value(),
                              copy.worst ? Value(copy.worst->uncertainty_mm) : Value(), z, number(copy.mean_mm),
                              number(copy.rmse_mm), number(copy.scatter_mm)});
    }
    return table;
}

report::Plot copiesTrend(const std::vector<CopySummary>& copies, const CompareParameters& parameters,
                         const Language& language)
{
    report::Plot plot;
    plot.title = LT_TEXT("Engine", "Trend of the copies");
    plot.x = {LT_TEXT("Engine", "Number of the copy"), Text{}};
    plot.x.scale = report::Axis::Scale::Whole;
    plot.x.range = Interval{0.5, static_cast<double>(copies.size()) + 0.5};
    plot.y = {LT_TEXT("Engine", "Deviation"), unit::mm};
    report::Curve worst{LT_TEXT("Engine", "worst local deviation"), {}, {}, report::Curve::Style::Points};
    report::Curve mean{LT_TEXT("Engine", "mean"), {}, {}};
    report::Curve reach{LT_TEXT("Engine", "± U (k = 2)"), {}, {}};
    worst.colour = reach.colour = report::ColourRole::Copy;
    mean.colour = report::ColourRole::Original;
    reach.has_readout = false;
    for (std::size_t i = 0; i < copies.size(); ++i) {
        const auto number = static_cast<double>(i + 1);
        const CopySummary& copy = copies[i];
        mean.x.push_back(number);
        mean.y.push_back(copy.mean_mm);
        worst.x.push_back(number);
        worst.y.push_back(copy.worst ? copy.worst->deviation_mm : notANumber);
        if (!copy.worst) continue;
        for (const double end : {-1.0, 1.0, notANumber}) {
            reach.x.push_back(number);
            reach.y.push_back(copy.worst->deviation_mm + end * copy.worst->uncertainty_mm);
        }
    }
    plot.curves = {std::move(reach), std::move(mean), std::move(worst)};
    if (parameters.tolerance_mm)
        for (const double sign : {-1.0, 1.0}) {
            std::string words = sign < 0 ? "−" : "+";
            words += text(shownValue(*parameters.tolerance_mm, millimetre, language), language);
            plot.limits.push_back(
                {report::Limit::Direction::Horizontal, sign * *parameters.tolerance_mm, std::move(words)});
        }
    return plot;
}

}  // namespace lathelier::registration
