#include "engine/project/project.h"

#include <filesystem>

#include "engine/io/file.h"
#include "engine/io/io_codes.h"
#include "engine/project/project_codes.h"
#include "engine/project/project_json.h"

namespace lathelier {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t largestProject = std::size_t{64} << 20;  ///< bytes; a project holds names, not data

fs::path folderOf(const std::string& path)
{
    return fs::absolute(path).lexically_normal().parent_path();
}

/// Says what became of the files since the project was saved. Only regular files are opened: a pipe would wait.
Notes checkSources(const Project& project)
{
    Notes notes;
    for (const auto& [id, panel] : project.panels)
        for (const auto& [role, source] : panel.inputs) {
            if (source.path.empty()) continue;
            std::error_code ignored;
            if (!fs::is_regular_file(source.path, ignored)) {
                notes.push_back({notes::sourceMissing, {{"path", source.path}}});
                continue;
            }
            if (source.sha256.empty()) continue;
            try {
                if (sha256(FileBytes(source.path).view()) != source.sha256)
                    notes.push_back({notes::sourceChanged, {{"path", source.path}}});
            } catch (const Error&) {  // gone or locked in this moment; opening it will say why
                notes.push_back({notes::sourceMissing, {{"path", source.path}}});
            }
        }
    return notes;
}

}  // namespace

ProjectFile readProject(const std::string& path)
{
    try {
        const FileBytes bytes(path);
        if (bytes.view().empty()) throw Error(errors::fileEmpty, {});
        if (bytes.view().size() > largestProject)
            throw Error(errors::malformed, {{"byte", static_cast<std::int64_t>(largestProject)},
                                            {"found", LT_TEXT("Engine", "more")},
                                            {"expected", LT_TEXT("Engine", "a project of at most 64 MB")}});
        ProjectFile result{parseProject(bytes.view(), folderOf(path)), {}};
        result.notes = checkSources(result.project);
        return result;
    } catch (Error& error) {
        throw error.with("path", path);
    }
}

void writeProject(const std::string& path, const Project& project)
{
    writeFile(path, toJsonText(project, folderOf(path)));
}

}  // namespace lathelier
