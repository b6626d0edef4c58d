#include "engine/project/project_json.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "engine/project/json_text.h"
#include "engine/project/migration.h"
#include "engine/project/project_codes.h"

namespace lathelier {
namespace {

namespace fs = std::filesystem;

constexpr const char* formatName = "lathelier-project";

// More than any project of ours has by a factor of ten: beyond, the file is damaged or made to harm.
constexpr std::size_t mostPanels = 1000;
constexpr std::size_t mostInputs = 1000;
constexpr std::size_t mostParameters = 1000;
constexpr std::size_t mostRanges = 10000;

/// A value that is not what is expected at its place.
struct Misfit {
    JsonPath path;
    Value expected;
};

/// A value of the file together with the way to it.
class Cursor {
public:
    Cursor(const Json& json, JsonPath path) : json_(json), path_(std::move(path)) {}

    [[noreturn]] void reject(Value expected) const { throw Misfit{path_, std::move(expected)}; }

    std::string string() const
    {
        if (!json_.is_string()) reject(LT_TEXT("Engine", "a text"));
        return json_.get<std::string>();
    }

    bool flag() const
    {
        if (!json_.is_boolean()) reject(LT_TEXT("Engine", "true or false"));
        return json_.get<bool>();
    }

    /// Calls use(key, value) for each member.
    template <class Use>
    void members(std::size_t most, Use use) const
    {
        if (!json_.is_object()) reject(LT_TEXT("Engine", "an object"));
        if (json_.size() > most) reject(LT_TEXT("Engine", "fewer members"));
        for (const auto& [name, value] : json_.items()) use(name, Cursor(value, inside(name)));
    }

    template <class Use>
    void items(std::size_t most, Use use) const
    {
        if (!json_.is_array()) reject(LT_TEXT("Engine", "a list"));
        if (json_.size() > most) reject(LT_TEXT("Engine", "a shorter list"));
        for (std::size_t i = 0; i < json_.size(); ++i) use(Cursor(json_[i], inside(std::to_string(i))));
    }

    Value value() const
    {
        constexpr auto largest = static_cast<std::uint64_t>(INT64_MAX);
        const bool tooLarge = json_.is_number_unsigned() && json_.get<std::uint64_t>() > largest;
        if (json_.is_array() && json_.size() > mostRanges) reject(LT_TEXT("Engine", "fewer ranges"));
        Value result = tooLarge ? Value() : valueFromJson(json_);
        if (!json_.is_null() && std::holds_alternative<std::monostate>(result))
            reject(LT_TEXT("Engine", "a number, a text, true, false, null or ranges"));
        return result;
    }

    Values values() const
    {
        Values result;
        members(mostParameters,
                [&](const std::string& name, const Cursor& member) { set(result, name, member.value()); });
        return result;
    }

private:
    JsonPath inside(const std::string& step) const
    {
        JsonPath result = path_;
        result.push_back(step);
        return result;
    }

    const Json& json_;
    JsonPath path_;
};

Value oneOf(const char* names)
{
    return std::string(names);
}

/// An empty path means "no file yet" and stays empty.
std::string absolutePath(const std::string& stored, const fs::path& folder)
{
    return stored.empty() ? stored : (folder / stored).lexically_normal().string();
}

std::string relativePath(const std::string& path, const fs::path& folder)
{
    if (path.empty()) return path;
    const std::string result = fs::path(path).lexically_relative(folder).generic_string();
    return result.empty() ? path : result;
}

Source parseSource(const Cursor& cursor, const fs::path& folder)
{
    Source source;
    cursor.members(mostParameters, [&](const std::string& key, const Cursor& member) {
        if (key == "path")
            source.path = absolutePath(member.string(), folder);
        else if (key == "import")
            source.import = member.values();
        else if (key == "sha256")
            source.sha256 = member.string();
        else if (key == "synthetic")
            source.synthetic = member.flag();
        else
            member.reject(oneOf("path | import | sha256 | synthetic"));
    });
    return source;
}

PanelState parsePanel(const Cursor& cursor, const fs::path& folder)
{
    PanelState panel;
    cursor.members(mostParameters, [&](const std::string& key, const Cursor& member) {
        if (key == "inputs")
            member.members(mostInputs, [&](const std::string& role, const Cursor& source) {
                panel.inputs[role] = parseSource(source, folder);
            });
        else if (key == "parameters")
            panel.parameters = member.values();
        else
            member.reject(oneOf("inputs | parameters"));
    });
    return panel;
}

Project parseBody(const Cursor& cursor, const fs::path& folder)
{
    Project project;
    cursor.members(mostParameters, [&](const std::string& key, const Cursor& member) {
        if (key == "title")
            project.title = member.string();
        else if (key == "workspace")
            project.workspace = member.string();
        else if (key == "panels")
            member.members(mostPanels, [&](const std::string& id, const Cursor& panel) {
                project.panels[id] = parsePanel(panel, folder);
            });
        else if (key == "report")
            member.items(mostPanels, [&](const Cursor& id) { project.report.push_back(id.string()); });
        else if (key != "format" && key != "version")
            member.reject(oneOf("format | version | title | workspace | panels | report"));
    });
    return project;
}

int readVersion(const Json& json)
{
    if (!json.is_object() || json.value("format", Json()) != formatName)
        throw Misfit{json.is_object() && json.contains("format") ? JsonPath{"format"} : JsonPath{},
                     LT_TEXT("Engine", "a Lathelier project")};
    const Json version = json.value("version", Json());
    if (!version.is_number_integer() || version < 1)
        throw Misfit{{"version"}, LT_TEXT("Engine", "a format version from 1")};
    if (version > projectVersion)
        throw Error(errors::versionTooNew, {{"found", version.dump()}, {"maximum", std::int64_t{projectVersion}}});
    return version.get<int>();
}

Json toJson(const Source& source, const fs::path& folder)
{
    Json result{{"path", relativePath(source.path, folder)}};
    if (!source.import.empty()) result["import"] = toJson(source.import);
    if (!source.sha256.empty()) result["sha256"] = source.sha256;
    if (source.synthetic) result["synthetic"] = true;
    return result;
}

}  // namespace

Project parseProject(std::string_view text, const fs::path& folder)
{
    Json json = parseJson(text);
    try {
        migrate(json, readVersion(json), migrationSteps());
        return parseBody(Cursor(json, {}), folder);
    } catch (const Misfit& wrong) {
        throw misfit(text, wrong.path, wrong.expected);
    }
}

std::string toJsonText(const Project& project, const fs::path& folder)
{
    Json json{{"format", formatName},
              {"version", projectVersion},
              {"title", project.title},
              {"workspace", project.workspace}};
    json["panels"] = Json::object();
    for (const auto& [id, panel] : project.panels) {
        Json& state = json["panels"][id] = Json::object();
        state["inputs"] = Json::object();
        for (const auto& [role, source] : panel.inputs) state["inputs"][role] = toJson(source, folder);
        state["parameters"] = toJson(panel.parameters);
    }
    json["report"] = project.report;
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace lathelier
