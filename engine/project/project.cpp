#include "engine/project/project.h"

#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>

#include "engine/core/json.h"
#include "engine/io/file.h"
#include "engine/io/io_codes.h"
#include "engine/project/parts.h"
#include "engine/project/project_codes.h"
#include "engine/project/project_json.h"

namespace lathelier::project {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t largestProject = std::size_t{64} << 20;  ///< bytes; a project holds names, not data

fs::path folderOf(const std::string& path)
{
    return fs::absolute(path).lexically_normal().parent_path();
}

/// Note sourceChanged or sourceMissing; none: as it was, or not comparable.
std::optional<Note> changeOf(const Source& source, const Progress& progress)
{
    const Note missing{notes::sourceMissing, {{"path", source.path}}};
    // Only regular files are opened: a pipe would block.
    std::error_code unknown;
    if (!fs::is_regular_file(source.path, unknown)) return missing;
    if (source.sha256.empty() || fs::file_size(source.path, unknown) > io::largestFile_bytes()) return std::nullopt;
    try {
        if (io::fileSha256(source.path, progress) == source.sha256) return std::nullopt;
        return Note{notes::sourceChanged, {{"path", source.path}}};
    } catch (const Error&) {  // missing, locked or being written: reported when it is opened
        return missing;
    }
}

}  // namespace

ProjectFile readProject(const std::string& path)
{
    try {
        const io::FileBytes bytes(path);
        if (bytes.view().empty()) throw Error(errors::fileEmpty, {});
        if (bytes.view().size() > largestProject)
            throw Error(errors::malformed, {{"byte", static_cast<std::int64_t>(largestProject)},
                                            {"found", LT_TEXT("Engine", "more")},
                                            {"expected", LT_TEXT("Engine", "a project of at most 64 MB")}});
        return {parseProject(bytes.view(), folderOf(path)), io::sha256(bytes.view())};
    } catch (Error& error) {
        throw error.with("path", path);
    }
}

std::string writeProject(const std::string& path, const Project& project)
{
    const std::string text = toJsonText(project, folderOf(path));
    io::writeFile(path, text);
    return io::sha256(text);
}

PanelState resolved(const Project& project, const std::string& id)
{
    const auto panel = project.panels.find(id);
    if (panel == project.panels.end()) return {};
    PanelState state = panel->second;
    for (const auto& [role, source] : state.inputs)
        if (const auto item = project.items.find(source.item); item != project.items.end())
            state.items[role] = item->second;
    return state;
}

std::string stateDigest(const PanelState& state)
{
    Json json{{"inputs", Json::object()}, {"parameters", toJson(state.parameters)}};
    for (const auto& [role, source] : state.inputs)
        json["inputs"][role] = {{"content", source.sha256.empty() ? source.path + source.item : source.sha256},
                                {"import", toJson(source.import)}};
    return io::sha256(json.dump(-1, ' ', false, Json::error_handler_t::replace));
}

Origin originOf(const Project& project, const std::string& id, const std::string& version)
{
    Origin origin{id, version, {}, {}};
    const auto panel = project.panels.find(id);
    const PanelState state = panel == project.panels.end() ? PanelState() : panel->second;
    origin.state_sha256 = stateDigest(state);
    for (const auto& [role, source] : state.inputs)
        if (!source.sha256.empty()) origin.inputs.push_back(source.sha256);
    return origin;
}

bool isOutdated(const Project& project, const Item& item)
{
    if (item.origin.panel.empty()) return false;
    return originOf(project, item.origin.panel, {}).state_sha256 != item.origin.state_sha256;
}

Notes checkSources(const Project& project, const Progress& progress)
{
    Notes notes;
    std::set<std::string> done;
    for (const Part* part : partsOf(project))
        for (const auto& [id, panel] : part->panels)
            for (const auto& [role, source] : panel.inputs) {
                progress.check();
                if (source.path.empty() || !done.insert(source.path + "\n" + source.sha256).second) continue;
                if (const auto note = changeOf(source, progress)) notes.push_back(*note);
            }
    return notes;
}

}  // namespace lathelier::project
