#include "engine/training/task/training_question.h"

#include <algorithm>

#include "engine/core/units.h"
#include "engine/training/lesson_state.h"

namespace lathelier::training {
namespace {

constexpr double usualCoefficient_N_mm2 = 2000;  ///< of a machine of which nothing else is known
constexpr double usualFeed_mm_rev = 0.1;
constexpr double usualDiameter_mm = 40;

}  // namespace

const std::vector<Field<TrainingQuestion>>& fieldsOf(const TrainingQuestion*)
{
    using Q = TrainingQuestion;
    static const std::vector<Field<Q>> all = [] {
        std::vector<FieldChoice> parts;
        for (const Scenario& scenario : scenarios()) parts.push_back({scenario.key, scenario.name});
        return std::vector<Field<Q>>{
            field("scenario", &Q::part, parts,
                  Label{LT_TEXT("Engine", "Part and machine"),
                        LT_TEXT("Engine",
                                "A machine with known modes; a response or modes of your own take its "
                                "place.")}),
            field("operating_speed_rpm", &Q::speed_rpm, Range{30, 1e6},
                  Label{LT_TEXT("Engine", "Spindle speed"),
                        LT_TEXT("Engine", "Of the operating point; drag it in the chart."), unit::rpm}),
            field("operating_depth", &Q::depth_mm, Range{1e-4, 1e3},
                  Label{LT_TEXT("Engine", "Depth of cut"),
                        LT_TEXT("Engine", "Of the operating point; drag it in the chart."), unit::mm}),
            field("relation", &Q::relation, relationChoices(),
                  Label{LT_TEXT("Engine", "Speed relation"),
                        LT_TEXT("Engine", "Exact keeps the phase of the regeneration; the papers set it to zero.")}),
            field(
                "hide_chart", &Q::hide_chart,
                Label{LT_TEXT("Engine", "Teacher mode: hide the chart"),
                      LT_TEXT("Engine", "The class hears the cut and sees its wave, but neither limit nor verdict.")}),
            field("cutting_coefficient_N_mm2", &Q::cutting_coefficient_N_mm2, Range{1e-3, 1e6},
                  Label{LT_TEXT("Engine", "Cutting coefficient K_r"),
                        LT_TEXT("Engine", "Force along the chip thickness over its area."), unit::N_mm2, true}),
            field("feed_mm_rev", &Q::feed_mm_rev, Range{1e-4, 10},
                  Label{LT_TEXT("Engine", "Feed"), LT_TEXT("Engine", "Chip thickness without vibration."), unit::mm_rev,
                        true}),
            field("speed_rpm", &Q::range_rpm, Range{30, 1e5},
                  Label{LT_TEXT("Engine", "Speeds"), LT_TEXT("Engine", "Range that is shown, 1000:4000."), unit::rpm,
                        true}),
            rows("modes", &Q::modes, Range{0, 6},
                 Label{LT_TEXT("Engine", "Modes"),
                       LT_TEXT("Engine", "Of a machine of your own, where there is no measured frequency response."),
                       {},
                       true})};
    }();
    return all;
}

Scenario scenarioOf(const TrainingQuestion& question, const std::vector<stability::Mode>& own)
{
    Scenario scenario = scenarios()[static_cast<std::size_t>(question.part)];
    if (!own.empty()) {
        scenario.key = ownScenario;
        scenario.name = LT_TEXT("Engine", "own machine");
        scenario.description = LT_TEXT("Engine", "The machine and part of the shop.");
        scenario.modes = own;
        scenario.cutting_coefficient_N_mm2 = usualCoefficient_N_mm2;
        scenario.feed_mm_rev = usualFeed_mm_rev;
        scenario.diameter_mm = usualDiameter_mm;
    }
    if (question.cutting_coefficient_N_mm2) scenario.cutting_coefficient_N_mm2 = *question.cutting_coefficient_N_mm2;
    if (question.feed_mm_rev) scenario.feed_mm_rev = *question.feed_mm_rev;
    if (!question.range_rpm.empty()) {
        scenario.speed_rpm = question.range_rpm.front();
        scenario.start_speed_rpm = std::clamp(scenario.start_speed_rpm, scenario.speed_rpm.from, scenario.speed_rpm.to);
    }
    return scenario;
}

}  // namespace lathelier::training
