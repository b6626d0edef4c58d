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
    const auto rename = [](Json* parameters, const std::string& from, const std::string& to) {
        if (!parameters || !parameters->contains(from)) return;
        (*parameters)[to] = (*parameters)[from];
        parameters->erase(from);
    };
    rename(parametersOf(json, "lobes"), "modes", "mode");
    for (const char* panel : {"shaft", "drawing"}) rename(parametersOf(json, panel), "material", "library_material");
    Json* const speed = parametersOf(json, "speed");
    if (!speed) return;
    const std::vector<std::string> keys = [&] {
        std::vector<std::string> all;
        for (const auto& [key, value] : speed->items())
            if (key == "material" || key.starts_with("material.")) all.push_back(key);
        return all;
    }();
    for (const std::string& key : keys) rename(speed, key, "bar_" + key);
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
                                                  [](Json&) {}, namesOfTasks,
                                                  // One part is read from the top (project_json.cpp).
                                                  [](Json&) {}};
    return steps;
}

void migrate(Json& json, int from, const std::vector<MigrationStep>& steps)
{
    const int last = static_cast<int>(steps.size()) + 1;
    for (int version = from; version < last; ++version) steps[static_cast<std::size_t>(version - 1)](json);
    json["version"] = last;
}

}  // namespace lathelier::project
