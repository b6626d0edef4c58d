#include "engine/training/scenario.h"

#include <algorithm>
#include <cmath>

namespace lathelier::training {
namespace {

constexpr int shownPoints = 3001;      ///< points of the limit over the speeds
constexpr double beyondEnds = 0.03;    ///< extension of the shown speeds at either end, relative
constexpr double narrow = 1e-6;        ///< relative width of the range for a single speed
constexpr double stepsPerPeriod = 96;  ///< samples per period of the highest mode
constexpr double mostRevolutions = 1e5;

stability::LobeParameters lobesAt(const Scenario& scenario, stability::SpeedRelation relation,
                                  const Interval& speed_rpm, int points)
{
    stability::LobeParameters parameters;
    parameters.cutting_coefficient_N_mm2 = scenario.cutting_coefficient_N_mm2;
    parameters.relation = relation;
    parameters.speed_rpm = {speed_rpm};
    parameters.points = points;
    parameters.diameter_mm = scenario.diameter_mm;
    return parameters;
}

}  // namespace

const std::vector<Scenario>& scenarios()
{
    static const std::vector<Scenario> all{
        {"rigid",
         LT_TEXT("Engine", "Short stiff part"),
         LT_TEXT("Engine", "A short part in a good chuck: it bends little, and takes a deep cut before it chatters."),
         {{520, 0.018, 1e5}},
         2000,
         40,
         0.1,
         {1000, 4000},
         5,
         2400,
         1},
        {"slender",
         LT_TEXT("Engine", "Slender part"),
         LT_TEXT("Engine",
                 "A long thin part held at one end: one weak mode at 223 Hz, the example of the published papers."),
         {{223, 0.03, 1e4}},
         2000,
         40,
         0.1,
         {1000, 4000},
         1.2,
         2800,
         0.2},
        {"tailstock",
         LT_TEXT("Engine", "Slender part with tailstock"),
         LT_TEXT("Engine", "The same part with a centre in its end: two modes, each much stiffer than the one before."),
         {{340, 0.03, 3e4}, {615, 0.025, 6e4}},
         2000,
         40,
         0.1,
         {1000, 4000},
         3,
         2800,
         0.5},
        {"worn_bearing",
         LT_TEXT("Engine", "Worn spindle bearing"),
         LT_TEXT("Engine",
                 "The short part again, in a spindle whose worn bearing is loose and damps little: the spindle "
                 "chatters now."),
         {{185, 0.015, 2.2e4}, {520, 0.018, 1e5}},
         2000,
         40,
         0.1,
         {1000, 4000},
         2.5,
         2400,
         0.3}};
    return all;
}

const Scenario* findScenario(std::string_view key)
{
    const std::vector<Scenario>& all = scenarios();
    const auto found =
        std::find_if(all.begin(), all.end(), [key](const Scenario& scenario) { return scenario.key == key; });
    return found == all.end() ? nullptr : &*found;
}

stability::LobeParameters lobesOf(const Scenario& scenario, stability::SpeedRelation relation)
{
    const Interval& shown = scenario.speed_rpm;
    return lobesAt(scenario, relation, {shown.from * (1 - beyondEnds), shown.to * (1 + beyondEnds)}, shownPoints);
}

stability::SimulationParameters cutOf(const Scenario& scenario, double speed_rpm, double depth_mm, double seconds)
{
    stability::SimulationParameters parameters;
    parameters.speed_rpm = speed_rpm;
    parameters.depth_mm = depth_mm;
    parameters.cutting_coefficient_N_mm2 = scenario.cutting_coefficient_N_mm2;
    parameters.feed_mm_rev = scenario.feed_mm_rev;
    parameters.diameter_mm = scenario.diameter_mm;
    parameters.revolutions = static_cast<int>(std::clamp(std::ceil(seconds * speed_rpm / 60), 1.0, mostRevolutions));
    return parameters;
}

stability::Growth growthOf(const Scenario& scenario, double speed_rpm, double depth_mm)
{
    const double revolution_s = 60 / speed_rpm;
    const stability::CutForces forces{scenario.cutting_coefficient_N_mm2 * depth_mm};
    stability::GrowthEffort effort;
    effort.steps = static_cast<int>(stability::stepsOfRevolution(scenario.modes, revolution_s, stepsPerPeriod));
    return stability::growthsOf(scenario.modes, {&forces, 1}, revolution_s, effort).front();
}

double limit_mm(const Scenario& scenario, double speed_rpm, stability::SpeedRelation relation)
{
    const Interval one{speed_rpm, speed_rpm * (1 + narrow)};
    const stability::LobeLimit limit =
        stability::limitOf(stability::frfOf(scenario.modes, one.to), lobesAt(scenario, relation, one, 2));
    return std::isnan(limit.depth_mm.front()) ? HUGE_VAL : limit.depth_mm.front();
}

double leastAbout(const stability::LobeLimit& limit, double speed_rpm, double share)
{
    const std::vector<double>& speeds = limit.speed_rpm;
    const auto from = std::lower_bound(speeds.begin(), speeds.end(), speed_rpm * (1 - share));
    const auto to = std::upper_bound(from, speeds.end(), speed_rpm * (1 + share));
    double least = HUGE_VAL;
    for (auto at = from; at != to; ++at) {
        const double depth = limit.depth_mm[static_cast<std::size_t>(at - speeds.begin())];
        if (depth < least) least = depth;
    }
    return least;
}

Limits limitsOf(const Scenario& scenario, const Progress& progress)
{
    const Frf frf = stability::frfOf(scenario.modes, 2 * scenario.speed_rpm.to);
    return {stability::findLobes(frf, lobesOf(scenario, stability::SpeedRelation::Exact), progress.part(0, 0.5)),
            stability::findLobes(frf, lobesOf(scenario, stability::SpeedRelation::Published), progress.part(0.5, 1))};
}

}  // namespace lathelier::training
