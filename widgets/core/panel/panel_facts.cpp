#include "widgets/core/panel/panel_facts.h"

#include <algorithm>

#include "engine/project/input_key.h"
#include "engine/walk/part_places.h"

namespace lathelier {

const Question& questionOf(const std::string& id)
{
    static const std::vector<Question> all = {{"scan", LT_TEXT("Engine", "Scan"), "scan", 10},
                                              {"drawing", LT_TEXT("Engine", "Drawing"), "drawing", 20},
                                              {"machine", LT_TEXT("Engine", "Machine"), "spindle", 30},
                                              {"speed", LT_TEXT("Engine", "Speed"), "speed", 40},
                                              {"program", LT_TEXT("Engine", "Program"), "program", 50},
                                              {"deflection", LT_TEXT("Engine", "Deflection"), "deflection", 60},
                                              {"copy", LT_TEXT("Engine", "Copy"), "compare", 70},
                                              {"proof", LT_TEXT("Engine", "Proof"), "chain", 80},
                                              {"roundness", LT_TEXT("Engine", "Roundness"), "roundness", 90, true},
                                              {"photographs", LT_TEXT("Engine", "Photographs"), "surface", 100, true},
                                              {"training", LT_TEXT("Engine", "Training"), "training", 110, true},
                                              {"series", LT_TEXT("Engine", "Series"), "series", 120, true}};
    return *std::find_if(all.begin(), all.end(), [&](const Question& one) { return one.id == id; });
}

std::vector<walk::Place> placesOf(const std::vector<PanelFacts>& table)
{
    std::vector<walk::Place> places = walk::partPlaces();
    std::erase_if(places, [&](const walk::Place& place) {
        return std::none_of(table.begin(), table.end(), [&](const PanelFacts& facts) { return facts.id == place.id; });
    });
    for (const PanelFacts& facts : table) {
        if (!facts.answer) continue;
        auto place = std::find_if(places.begin(), places.end(), [&](const auto& one) { return one.id == facts.id; });
        if (place == places.end()) place = places.emplace(places.end());
        place->id = facts.id;
        place->state = facts.stateKey();
        place->title = facts.title;
        place->task = facts.task;
        place->begins_with = facts.begins_with;
        place->missing = facts.missing ? facts.missing : missingOf(facts.roles);
        place->answer = facts.answer;
    }
    return places;
}

bool hasWork(const PanelFacts& facts, const project::PanelState& state)
{
    return facts.has_work ? facts.has_work(state) : !state.inputs.empty();
}

io::FileKinds kindsOf(const std::vector<InputRole>& roles)
{
    io::FileKinds kinds;
    for (const InputRole& role : roles) io::unite(kinds, role.kinds);
    return kinds;
}

std::function<std::vector<Text>(const project::PanelState&)> missingOf(const std::vector<InputRole>& roles)
{
    return [roles](const project::PanelState& state) {
        std::vector<Text> labels;
        for (const InputRole& role : roles)
            if (role.required && state.inputs.count(role.role) == 0) labels.push_back(role.label);
        return labels;
    };
}

std::vector<project::Source> sourcesOf(const project::PanelState& state, const InputRole& role)
{
    std::vector<project::Source> sources;
    for (const std::string& key : project::keysOf(state, role.role)) {
        sources.push_back(state.inputs.at(key));
        if (!role.several) break;
    }
    return sources;
}

void setSources(project::PanelState& state, const InputRole& role, const std::vector<project::Source>& sources)
{
    std::erase_if(state.inputs, [&](const auto& input) { return project::belongsTo(input.first, role.role); });
    for (std::size_t i = 0; i < sources.size() && (i == 0 || role.several); ++i)
        state.inputs[project::keyOf(role.role, i + 1)] = sources[i];
}

}  // namespace lathelier
