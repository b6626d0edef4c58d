#include "engine/task/task_fields.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "engine/io/import.h"
#include "engine/io/json/json_fields.h"

namespace lathelier::task {

std::vector<FieldInfo> questionFields(const Task& task)
{
    std::vector<FieldInfo> fields = task.fields;
    std::erase_if(fields, [](const FieldInfo& info) { return info.is_kept; });
    return fields;
}

std::vector<FieldInfo> readingFields(const Task& task)
{
    std::vector<FieldInfo> all = infos<io::ImportOptions>();
    for (const Input& input : task.inputs)
        for (const io::FileKind* kind : input.kinds)
            for (const FieldInfo& info : kind->reading)
                if (std::none_of(all.begin(), all.end(), [&](const FieldInfo& one) { return one.key == info.key; }))
                    all.push_back(info);
    return all;
}

Values readingDefaults(const Task& task)
{
    Values all = toValues(io::ImportOptions{});
    for (const Input& input : task.inputs)
        for (const io::FileKind* kind : input.kinds)
            for (const auto& [key, value] : kind->reading_defaults) set(all, key, value);
    return all;
}

Values asRead(const std::vector<FieldInfo>& fields, const Values& values)
{
    const io::JsonDocument document(io::objectOf(fields, values).dump());
    Notes unused;
    return io::valuesOf(document.root(), fields, unused);
}

}  // namespace lathelier::task
