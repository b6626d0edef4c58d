#include "engine/project/project_json.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "engine/io/json/json_document.h"
#include "engine/project/migration.h"
#include "engine/project/parts.h"
#include "engine/project/project_codes.h"

namespace lathelier::project {
namespace {

namespace fs = std::filesystem;

constexpr const char* formatName = "lathelier-project";

// Files of former versions hold one part, whose members stand at the top. They are read there, so that errors name
// their place.
constexpr int firstWithParts = 7;

// Ten times more than any known project: beyond, the file is damaged or malicious.
constexpr std::size_t mostPanels = 1000;
constexpr std::size_t mostInputs = 1000;
constexpr std::size_t mostParameters = 1000;

Value oneOf(const char* names)
{
    return std::string(names);
}

/// An empty path means that no file is chosen, and is kept.
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

Source parseSource(const io::JsonCursor& cursor, const fs::path& folder)
{
    Source source;
    cursor.members(mostParameters, [&](const std::string& key, const io::JsonCursor& member) {
        if (key == "path")
            source.path = absolutePath(member.string(), folder);
        else if (key == "item")
            source.item = member.string();
        else if (key == "import")
            source.import = member.values();
        else if (key == "sha256")
            source.sha256 = member.string();
        else if (key == "synthetic")
            source.synthetic = member.flag();
        else
            member.reject(oneOf("path | item | import | sha256 | synthetic"));
    });
    return source;
}

PanelState parsePanel(const io::JsonCursor& cursor, const fs::path& folder)
{
    PanelState panel;
    cursor.members(mostParameters, [&](const std::string& key, const io::JsonCursor& member) {
        if (key == "inputs")
            member.members(mostInputs, [&](const std::string& role, const io::JsonCursor& source) {
                panel.inputs[role] = parseSource(source, folder);
            });
        else if (key == "parameters")
            panel.parameters = member.values();
        else
            member.reject(oneOf("inputs | parameters"));
    });
    return panel;
}

Origin parseOrigin(const io::JsonCursor& cursor)
{
    Origin origin;
    cursor.members(mostParameters, [&](const std::string& key, const io::JsonCursor& member) {
        if (key == "panel")
            origin.panel = member.string();
        else if (key == "version")
            origin.version = member.string();
        else if (key == "state_sha256")
            origin.state_sha256 = member.string();
        else if (key == "inputs")
            member.items(mostInputs, [&](const io::JsonCursor& input) { origin.inputs.push_back(input.string()); });
        else
            member.reject(oneOf("panel | version | state_sha256 | inputs"));
    });
    return origin;
}

Item parseItem(const io::JsonCursor& cursor)
{
    Item item;
    cursor.members(mostParameters, [&](const std::string& key, const io::JsonCursor& member) {
        if (key == "kind")
            item.kind = member.string();
        else if (key == "values")
            item.values = member.values();
        else if (key == "origin")
            item.origin = parseOrigin(member);
        else
            member.reject(oneOf("kind | values | origin"));
    });
    return item;
}

/// Reads a member of a part; false: it has no such member.
bool takeMember(Part& part, const std::string& key, const io::JsonCursor& member, const fs::path& folder)
{
    if (key == "panels")
        member.members(mostPanels, [&](const std::string& id, const io::JsonCursor& panel) {
            part.panels[id] = parsePanel(panel, folder);
        });
    else if (key == "items")
        member.members(mostPanels, [&](const std::string& name, const io::JsonCursor& item) {
            part.items[name] = parseItem(item);
        });
    else if (key == "views")
        member.members(mostPanels,
                       [&](const std::string& id, const io::JsonCursor& view) { part.views[id] = view.values(); });
    else if (key == "title_block")
        part.title_block = member.values();
    else if (key == "report")
        member.items(mostPanels, [&](const io::JsonCursor& id) { part.report.push_back(id.string()); });
    else
        return false;
    return true;
}

Part parsePart(const io::JsonCursor& cursor, const fs::path& folder)
{
    Part part;
    cursor.members(mostParameters, [&](const std::string& key, const io::JsonCursor& member) {
        if (key == "name")
            part.name = member.string();
        else if (!takeMember(part, key, member, folder))
            member.reject(oneOf("name | panels | items | views | title_block | report"));
    });
    return part;
}

std::size_t parseShown(const io::JsonCursor& cursor, std::size_t count)
{
    const std::int64_t shown = cursor.integer();
    if (shown < 0 || static_cast<std::size_t>(shown) >= std::max<std::size_t>(count, 1))
        cursor.reject(LT_TEXT("Engine", "the number of a part, counted from 0"));
    return static_cast<std::size_t>(shown);
}

Project parseBody(const io::JsonCursor& cursor, const fs::path& folder, bool is_one_part)
{
    Project project;
    std::vector<Part> parts;
    cursor.members(mostParameters, [&](const std::string& key, const io::JsonCursor& member) {
        if (key == "title")
            project.title = member.string();
        else if (key == "workspace")
            project.workspace = member.string();
        else if (key == "recipe")
            project.recipe = member.flag();
        else if (is_one_part && takeMember(project, key, member, folder))
            return;
        else if (!is_one_part && key == "parts")
            member.items(mostParts, [&](const io::JsonCursor& part) { parts.push_back(parsePart(part, folder)); });
        else if (!is_one_part && key == "shop")
            project.shop = member.values();
        else if (key != "format" && key != "version" && (is_one_part || key != "shown"))
            member.reject(oneOf(
                is_one_part ? "format | version | title | workspace | panels | items | views | title_block | recipe | "
                              "report"
                            : "format | version | title | workspace | parts | shown | shop | recipe"));
    });
    if (is_one_part) return project;
    const auto shown = cursor.member("shown");
    project.place = shown ? parseShown(*shown, parts.size()) : 0;
    if (parts.empty()) return project;
    static_cast<Part&>(project) = std::move(parts[project.place]);
    parts.erase(parts.begin() + static_cast<std::ptrdiff_t>(project.place));
    project.others = std::move(parts);
    return project;
}

int readVersion(const io::JsonCursor& root)
{
    const Value wanted = LT_TEXT("Engine", "a Lathelier project");
    if (!root.isObject()) root.reject(wanted);
    const auto format = root.member("format");
    if (!format) root.reject(wanted);
    if (format->value() != Value(std::string(formatName))) format->reject(wanted);
    const auto version = root.member("version");
    const Value versions = LT_TEXT("Engine", "a format version from 1");
    if (!version) root.reject(versions);
    const Value number = version->value();
    const auto* whole = std::get_if<std::int64_t>(&number);
    if (!whole || *whole < 1) version->reject(versions);
    if (*whole > projectVersion)
        throw Error(errors::versionTooNew,
                    {{"found", std::to_string(*whole)}, {"maximum", std::int64_t{projectVersion}}});
    return static_cast<int>(*whole);
}

Json sourceJson(const Source& source, const fs::path& folder)
{
    Json result = Json::object();
    if (source.item.empty())
        result["path"] = relativePath(source.path, folder);
    else
        result["item"] = source.item;
    if (!source.import.empty()) result["import"] = toJson(source.import);
    if (!source.sha256.empty()) result["sha256"] = source.sha256;
    if (source.synthetic) result["synthetic"] = true;
    return result;
}

Json itemJson(const Item& item)
{
    return {{"kind", item.kind},
            {"values", toJson(item.values)},
            {"origin",
             {{"panel", item.origin.panel},
              {"version", item.origin.version},
              {"state_sha256", item.origin.state_sha256},
              {"inputs", item.origin.inputs}}}};
}

Json partJson(const Part& part, const fs::path& folder)
{
    Json json{{"name", part.name}};
    json["panels"] = Json::object();
    for (const auto& [id, panel] : part.panels) {
        Json& state = json["panels"][id] = Json::object();
        state["inputs"] = Json::object();
        for (const auto& [role, source] : panel.inputs) state["inputs"][role] = sourceJson(source, folder);
        state["parameters"] = toJson(panel.parameters);
    }
    json["items"] = Json::object();
    for (const auto& [name, item] : part.items) json["items"][name] = itemJson(item);
    json["views"] = Json::object();
    for (const auto& [id, view] : part.views) json["views"][id] = toJson(view);
    json["title_block"] = toJson(part.title_block);
    json["report"] = part.report;
    return json;
}

}  // namespace

Project parseProject(std::string_view text, const fs::path& folder)
{
    io::JsonDocument document{std::string(text)};
    const int version = readVersion(document.root());
    migrate(document.json(), version, migrationSteps());
    return parseBody(document.root(), folder, version < firstWithParts);
}

std::string toJsonText(const Project& project, const fs::path& folder)
{
    Json json{{"format", formatName},           {"version", projectVersion}, {"title", project.title},
              {"workspace", project.workspace}, {"shown", project.place},    {"shop", toJson(project.shop)},
              {"parts", Json::array()}};
    for (const Part* part : partsOf(project)) json["parts"].push_back(partJson(*part, folder));
    if (project.recipe) json["recipe"] = true;
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace lathelier::project
