#include "engine/gcode/program_kind.h"

#include <algorithm>
#include <filesystem>

#include "engine/gcode/detection.h"
#include "engine/gcode/toolpath.h"
#include "engine/gcode/toolpath_files.h"
#include "engine/io/text/encoding.h"
#include "engine/io/text/units.h"

namespace lathelier::gcode {
namespace {

bool hasProgramName(const std::string& path)
{
    const std::string extension = io::lowerCase(std::filesystem::path(path).extension().string());
    const auto& all = allControls();
    return std::any_of(all.begin(), all.end(), [&extension](const ControlPtr& control) {
        const auto& own = control->extensions;
        return std::find(own.begin(), own.end(), extension) != own.end();
    });
}

/// For file dialogs: names of programs that can be read.
std::string namePatterns()
{
    std::string patterns;
    for (const ControlPtr& control : allControls())
        for (const std::string& extension : control->extensions)
            if (control->is_read && patterns.find("*" + extension + " ") == std::string::npos)
                patterns += "*" + extension + " ";
    return patterns + "*.txt";
}

io::Likeness likeProgram(const std::string& path, std::string_view head, const Values&)
{
    if (head.empty() || head.substr(0, 4096).find('\0') != std::string_view::npos) return io::Likeness::No;
    const ControlFound found = detectControl(head, path);
    const bool isNamed = hasProgramName(path);
    if (!found.control->is_read && (isNamed || found.nc_lines > 0))
        return isNamed ? io::Likeness::Certain : io::Likeness::Likely;
    const bool isMostly = found.has_codes && found.nc_lines >= 4 * found.other_lines && found.nc_lines > 0;
    if (isNamed && (found.has_codes || found.has_head)) return io::Likeness::Certain;
    if (isMostly && found.has_head) return io::Likeness::Certain;
    return isMostly ? io::Likeness::Likely : io::Likeness::No;
}

io::FileFacts factsOf(const io::FileToRead& file, Notes&)
{
    Program program = readProgram(std::string(file.bytes), nullptr, file.progress.part(0, 0.5), file.path);
    const Toolpath path = findToolpath(program, {}, {}, file.progress.part(0.5, 1));
    io::FileFacts facts;
    facts.path = file.path;
    facts.format = "nc_program";
    facts.encoding = program.is_utf8 ? "utf-8" : "latin-1";
    facts.rows = static_cast<std::int64_t>(program.blocks.size());
    set(facts.details, "dialect", program.control->key);
    set(facts.details, "blocks", static_cast<std::int64_t>(program.blocks.size()));
    set(facts.details, "words", path.words);
    set(facts.details, "words_understood", path.words_understood);
    set(facts.details, "diagnostics", diagnosticRows(path.diagnostics));
    facts.understanding = path.understanding;
    return facts;
}

}  // namespace

const io::FileKind& programFiles()
{
    static const io::FileKind kind{"nc_program", LT_TEXT("Engine", "NC programs"), namePatterns(), {}, {}, likeProgram,
                                   factsOf};
    return kind;
}

}  // namespace lathelier::gcode
