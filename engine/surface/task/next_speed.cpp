#include "engine/surface/task/next_speed.h"

#include <algorithm>
#include <cmath>

#include "engine/core/texts.h"
#include "engine/surface/surface_words.h"
#include "engine/surface/task/surface_task.h"

namespace lathelier::surface {

std::optional<stability::SpeedResult> nextSpeed(Frf response, const stability::SurfaceMarks& marks,
                                                const stability::ModelCheck& check)
{
    const double by = marks.frequency_hz / check.model_hz;
    for (double& line : response.frequency_hz) line *= by;
    stability::SpeedParameters parameters;
    parameters.speed_rpm = marks.speed_rpm;
    parameters.relation = stability::SpeedRelation::Exact;
    try {
        return chooseSpeed(response, parameters);
    } catch (const Error&) {
        return std::nullopt;  // nothing chatters, or the speed lies above the last lobe
    }
}

report::Table nextSpeedTable(const SurfaceOutcome& outcome)
{
    report::Table table = speedTable(outcome.first());
    if (!outcome.next || table.rows.empty()) return table;
    table.title = LT_TEXT("Engine", "Speeds by the marks, and by the model moved to the marks");
    table.columns = {LT_TEXT("Engine", "Waves, k"),
                     report::Labelled{LT_TEXT("Engine", "Whole waves, 60 f_c / k"), LT_TEXT("Engine", "rpm")},
                     report::Labelled{LT_TEXT("Engine", "Best of the pocket, model"), LT_TEXT("Engine", "rpm")}};
    table.decimals = {0, 0, 0};
    for (std::vector<Value>& row : table.rows) {
        const auto k = std::get<std::int64_t>(row.front());
        const auto& all = outcome.next->candidates;
        const auto best = std::find_if(all.begin(), all.end(), [&](const auto& each) { return each.k == k; });
        Value& cell = row.emplace_back();
        if (best != all.end()) cell = best->speed_rpm;
    }
    return table;
}

std::optional<report::Finding> nextSpeedFinding(const SurfaceOutcome& outcome, const Language& language)
{
    if (!outcome.next) return std::nullopt;
    report::Finding finding;
    finding.pattern = LT_TEXT("Engine",
                              "Speed next: {speed} rpm, the best of pocket {k} by the exact relation, with the model "
                              "moved to the frequency of the marks.");
    finding.values = {{"speed", fixed(outcome.next->recommended_rpm, 0, language)},
                      {"k", std::int64_t{outcome.next->k}}};
    return finding;
}

}  // namespace lathelier::surface
