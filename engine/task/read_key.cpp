#include "engine/task/read_key.h"

#include <nlohmann/json.hpp>

#include "engine/core/json.h"

namespace lathelier::task {

std::string readKey(const project::PanelState& state, std::initializer_list<std::string> roles, const Sources& sources,
                    std::size_t first)
{
    std::string key;
    for (std::size_t i = first; i < sources.inputs.size(); ++i) key += sources.inputs[i].sha256 + '\n';
    for (const std::string& role : roles)
        if (const project::Source* const source = sourceOf(state, role)) key += toJson(source->import).dump() + '\n';
    return key;
}

}  // namespace lathelier::task
