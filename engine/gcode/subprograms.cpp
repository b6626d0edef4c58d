#include "engine/gcode/subprograms.h"

#include <algorithm>
#include <cctype>
#include <filesystem>

#include "engine/core/core_codes.h"
#include "engine/gcode/flow_text.h"
#include "engine/gcode/gcode_codes.h"
#include "engine/io/file.h"

namespace lathelier::gcode {
namespace {

namespace fs = std::filesystem;

/// A file of the folder, read when a program is looked for.
struct FolderFile {
    std::string path;
    std::string text;
    std::vector<std::string> names;  ///< of the programs that it holds
    bool is_taken = false;
};

/// "O1234" for O1234, o01234 and 1234; other names in capitals; of "o<name>" the name without its marks.
std::string plainName(std::string_view name)
{
    std::string plain = capitals(name);
    std::erase_if(plain, [](char c) { return c == '<' || c == '>' || c == ' ' || c == '\t'; });
    const std::size_t from = !plain.empty() && plain[0] == 'O' ? 1 : 0;
    const std::size_t digit = plain.find_first_not_of("0123456789", from);
    if (plain.size() == from || digit != std::string::npos) return plain;
    const std::size_t zeros = std::min(plain.find_first_not_of('0', from), plain.size() - 1);
    std::string numbered = "O";
    return numbered.append(plain.substr(zeros));
}

/// What `line` declares; empty: nothing.
std::string declaredBy(std::string_view line, const Control& control)
{
    line = trimmedFront(line);
    if (line.starts_with("\xEF\xBB\xBF")) line.remove_prefix(3);
    if (!control.program_head.empty() &&
        capitals(line.substr(0, control.program_head.size())) == control.program_head) {
        const std::string name = nameOf(line.substr(control.program_head.size()));
        return name.substr(0, name.rfind('_'));
    }
    if (control.grammar.flow == FlowStyle::Structured)
        return keywordOf(line) == "PROC" ? nameOf(trimmedFront(line.substr(4))) : std::string();
    if (line.empty() || (line[0] != 'O' && line[0] != 'o' && line[0] != ':')) return {};
    if (control.grammar.flow == FlowStyle::Labelled) {
        const std::size_t end = line.size() > 1 && line[1] == '<' ? line.find('>') : line.find_first_of(" \t");
        if (end == std::string_view::npos) return {};
        const std::size_t behind = end + (line[end] == '>' ? 1 : 0);
        return keywordOf(trimmedFront(line.substr(behind))) == "SUB" ? plainName(line.substr(0, behind))
                                                                     : std::string();
    }
    std::size_t to = 1;
    while (to < line.size() && std::isdigit(static_cast<unsigned char>(line[to]))) ++to;
    return to > 1 ? plainName(std::string("O").append(line.substr(1, to - 1))) : std::string();
}

[[noreturn]] void throwTooLarge(const std::string& folder, std::uintmax_t found, std::uintmax_t most, Text unit)
{
    throw Error(errors::subprogramsTooLarge, {{"path", folder},
                                              {"found", static_cast<std::int64_t>(found)},
                                              {"most", static_cast<std::int64_t>(most)},
                                              {"unit", unit}});
}

/// The files of the folder by name, not read yet.
std::vector<FolderFile> filesOf(const std::string& folder)
{
    std::error_code problem;
    if (!fs::is_directory(folder, problem))
        throw Error(
            errors::valueNotUnderstood,
            {{"parameter", "subprograms"}, {"found", folder}, {"expected", LT_TEXT("Engine", "a folder that exists")}});
    std::vector<FolderFile> files;
    std::uintmax_t bytes = 0;
    for (fs::directory_iterator entry(folder, problem), end; !problem && entry != end; entry.increment(problem)) {
        std::error_code ignored;
        if (!entry->is_regular_file(ignored)) continue;
        const std::uintmax_t size = entry->file_size(ignored);
        if (ignored || size == 0 || size > largestSubprogram_bytes) continue;
        files.push_back({entry->path().string(), {}, {}, false});
        bytes += size;
        if (files.size() > mostSubprogramFiles)
            throwTooLarge(folder, files.size(), mostSubprogramFiles, LT_TEXT("Engine", "files"));
    }
    if (bytes > largestSubprograms_bytes)
        throwTooLarge(folder, bytes, largestSubprograms_bytes, LT_TEXT("Engine", "bytes"));
    std::sort(files.begin(), files.end(), [](const FolderFile& a, const FolderFile& b) { return a.path < b.path; });
    return files;
}

void readAll(std::vector<FolderFile>& files, const Control& control, const Progress& progress)
{
    for (FolderFile& file : files) {
        progress.check();
        file.text = std::string(io::FileBytes(file.path).view());
        if (file.text.find('\0') != std::string::npos) continue;  // no program
        file.names = programsIn(file.text, control);
        if (file.names.empty()) file.names = {plainName(fs::path(file.path).stem().string())};
    }
}

/// Calls that found no program; where a name alone is a call, also the names that are not known: one is known as a
/// program only once it is there.
std::vector<std::string> missingIn(const Program& program, const Toolpath& path)
{
    std::vector<std::string> missing = path.missing;
    if (program.control->grammar.flow != FlowStyle::Structured) return missing;
    for (const Word& word : program.words) {
        if (word.is_understood || (word.kind != WordKind::Name && word.kind != WordKind::Call)) continue;
        std::string name = nameOf(program.textOf(word));
        if (missing.size() < mostMissing && std::find(missing.begin(), missing.end(), name) == missing.end())
            missing.push_back(std::move(name));
    }
    return missing;
}

Notes notesOf(const Program& program)
{
    Notes notes;
    for (std::size_t i = 0; i < program.parts.size(); ++i) {
        const std::size_t first = program.parts[i].first_block;
        const std::size_t end = i + 1 < program.parts.size() ? program.parts[i + 1].first_block : program.blocks.size();
        notes.push_back({notes::ncSubprogramRead,
                         {{"path", program.parts[i].path},
                          {"first_line", static_cast<std::int64_t>(first) + 1},
                          {"last_line", static_cast<std::int64_t>(end)},
                          {"lines", static_cast<std::int64_t>(end - first)}}});
    }
    return notes;
}

/// The only file that holds the program; nullptr: none, or several that differ.
FolderFile* fileFor(const std::string& name, std::vector<FolderFile>& files)
{
    FolderFile* found = nullptr;
    for (FolderFile& file : files) {
        if (std::find(file.names.begin(), file.names.end(), name) == file.names.end()) continue;
        if (found && found->text != file.text) return nullptr;
        if (!found) found = &file;
    }
    return found;
}

}  // namespace

std::vector<std::string> programsIn(std::string_view text, const Control& control)
{
    std::vector<std::string> names;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t end = std::min(text.find_first_of("\r\n", at), text.size());
        std::string name = declaredBy(text.substr(at, end - at), control);
        if (!name.empty()) names.push_back(std::move(name));
        at = end + 1;
    }
    return names;
}

FoundSubprograms findSubprograms(const std::string& text, const ToolpathParameters& parameters, const ToolTable& tools,
                                 const Progress& progress)
{
    std::vector<FolderFile> files = filesOf(parameters.subprograms);
    FoundSubprograms found;
    const Progress quiet = progress.quiet();
    for (bool is_first = true;; is_first = false) {
        Program program;
        try {
            program = readProgram(text, controlOf(parameters), quiet, parameters.file_name, found.parts);
        } catch (Error& error) {
            throw error.with("path", parameters.file_name);
        }
        if (is_first) readAll(files, *program.control, progress);
        const Toolpath path = findToolpath(program, parameters, tools, quiet);
        const std::size_t before = found.parts.size();
        for (const std::string& missing : missingIn(program, path)) {
            FolderFile* const file = fileFor(plainName(missing), files);
            if (!file || file->is_taken) continue;
            file->is_taken = true;
            found.parts.push_back({plainName(missing), file->path, file->text});
            found.files.push_back({file->path, static_cast<std::int64_t>(file->text.size()), io::sha256(file->text)});
        }
        if (found.parts.size() > before) continue;
        found.notes = notesOf(program);
        return found;
    }
}

}  // namespace lathelier::gcode
