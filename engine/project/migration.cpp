#include "engine/project/migration.h"

#include <nlohmann/json.hpp>

namespace lathelier::project {

namespace {

/// The parameters of a panel; nullptr: none.
Json* parametersOf(Json& json, const char* panel)
{
    if (!json.contains("panels") || !json["panels"].contains(panel)) return nullptr;
    Json& state = json["panels"][panel];
    return state.is_object() && state.contains("parameters") && state["parameters"].is_object() ? &state["parameters"]
                                                                                                : nullptr;
}

/// Panels of cutting speeds took over the keys of the command line.
void namesOfTasks(Json& json)
{
    if (Json* const lobes = parametersOf(json, "lobes"); lobes && lobes->contains("modes")) {
        (*lobes)["mode"] = (*lobes)["modes"];
        lobes->erase("modes");
    }
    Json* const speed = parametersOf(json, "speed");
    if (!speed) return;
    const auto end = [&](const char* key, double open) {
        const Json value = speed->value(key, Json());
        speed->erase(key);
        return value.is_number() ? value.get<double>() : open;
    };
    constexpr double slowest_m_min = 1e-3, fastest_m_min = 1e5;
    const double low = end("lowest_m_min", slowest_m_min), high = end("highest_m_min", fastest_m_min);
    if (low > slowest_m_min || high < fastest_m_min) (*speed)["range_m_min"] = Json::array({Json::array({low, high})});
}

}  // namespace

const std::vector<MigrationStep>& migrationSteps()
{
    static const std::vector<MigrationStep> steps{[](Json& json) { json["items"] = Json::object(); },
                                                  [](Json& json) { json["views"] = Json::object(); },
                                                  [](Json& json) { json["title_block"] = Json::object(); },
                                                  // Former keys of tools are read by their description.
                                                  [](Json&) {}, namesOfTasks};
    return steps;
}

void migrate(Json& json, int from, const std::vector<MigrationStep>& steps)
{
    const int last = static_cast<int>(steps.size()) + 1;
    for (int version = from; version < last; ++version) steps[static_cast<std::size_t>(version - 1)](json);
    json["version"] = last;
}

}  // namespace lathelier::project
