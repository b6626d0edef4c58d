#include "engine/project/migration.h"

#include <nlohmann/json.hpp>

namespace lathelier::project {

const std::vector<MigrationStep>& migrationSteps()
{
    static const std::vector<MigrationStep> steps{[](Json& json) { json["items"] = Json::object(); },
                                                  [](Json& json) { json["views"] = Json::object(); },
                                                  [](Json& json) { json["title_block"] = Json::object(); },
                                                  // Former keys of tools are read by their description.
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
