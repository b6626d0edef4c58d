#include "engine/link/link_kind.h"

#include <filesystem>

#include "engine/io/json/json_head.h"
#include "engine/link/transports.h"

namespace lathelier::link {
namespace {

io::Likeness likeConfig(const std::string&, std::string_view head, const Values&)
{
    const std::vector<std::string> keys = io::keysOfHead(head);
    return io::hasKey(keys, "schema") && head.find(assistSchema) != std::string_view::npos ? io::Likeness::Certain
                                                                                           : io::Likeness::No;
}

Rows controlRows(const LinkConfig& config)
{
    Rows rows;
    for (const TransportKind& kind : transportKinds())
        if (kind.is_configured(config))
            rows.rows.push_back({{{"link", std::string(kind.key)}, {"is_verified", kind.is_verified}}});
    return rows;
}

Rows fileRows(const LinkConfig& config)
{
    Rows rows;
    for (const auto& [role, source] : config.question.inputs)
        if (!source.path.empty()) rows.rows.push_back({{{"role", role}, {"path", source.path}}});
    return rows;
}

io::FileFacts configFacts(const io::FileToRead& file, Notes&)
{
    LinkConfig config;
    try {
        config =
            readConfig(std::string(file.bytes), std::filesystem::absolute(file.path).lexically_normal().parent_path());
    } catch (Error& error) {
        throw error.with("path", file.path);
    }
    io::FileFacts facts;
    facts.path = file.path;
    facts.format = "assist";
    facts.encoding = "utf-8";
    facts.details = {{"schema_version", std::int64_t{assistVersion}},
                     {"controls", controlRows(config)},
                     {"files", fileRows(config)},
                     {"highest_rpm", config.limits.highest_rpm},
                     {"takes_program", config.program.has_value()}};
    return facts;
}

}  // namespace

const io::FileKind& assistFiles()
{
    static const io::FileKind kind{"assist",   LT_TEXT("Engine", "Links to controls"), "*.json", {}, {}, likeConfig,
                                   configFacts};
    return kind;
}

}  // namespace lathelier::link
