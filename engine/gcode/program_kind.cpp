#include "engine/gcode/program_kind.h"

#include <filesystem>

#include "engine/gcode/toolpath.h"
#include "engine/gcode/toolpath_files.h"
#include "engine/io/text/encoding.h"
#include "engine/io/text/units.h"

namespace lathelier::gcode {
namespace {

bool hasProgramName(const std::string& path)
{
    const std::string extension = io::lowerCase(std::filesystem::path(path).extension().string());
    for (const char* known : {".nc", ".ngc", ".tap", ".mpf", ".spf", ".cnc", ".min", ".eia", ".h"})
        if (extension == known) return true;
    return false;
}

io::Likeness likeProgram(const std::string& path, std::string_view head, const Values&)
{
    if (head.empty() || head.substr(0, 4096).find('\0') != std::string_view::npos) return io::Likeness::No;
    const DialectFound found = detectDialect(head);
    const bool isNamed = hasProgramName(path);
    if (!found.not_read.empty() && (isNamed || found.nc_lines > 0))
        return isNamed ? io::Likeness::Certain : io::Likeness::Likely;
    const bool isMostly = found.has_codes && found.nc_lines >= 4 * found.other_lines && found.nc_lines > 0;
    if (isNamed && (found.has_codes || found.has_head)) return io::Likeness::Certain;
    if (isMostly && found.has_head) return io::Likeness::Certain;
    return isMostly ? io::Likeness::Likely : io::Likeness::No;
}

io::FileFacts factsOf(const io::FileToRead& file, Notes&)
{
    Program program = readProgram(std::string(file.bytes), Dialect::Auto, file.progress.part(0, 0.5));
    const Toolpath path = findToolpath(program, {}, {}, file.progress.part(0.5, 1));
    io::FileFacts facts;
    facts.path = file.path;
    facts.format = "nc_program";
    facts.encoding = program.is_utf8 ? "utf-8" : "latin-1";
    facts.rows = static_cast<std::int64_t>(program.blocks.size());
    set(facts.details, "dialect", std::string(key(program.dialect)));
    set(facts.details, "blocks", static_cast<std::int64_t>(program.blocks.size()));
    set(facts.details, "words", path.words);
    set(facts.details, "words_understood", path.words_understood);
    set(facts.details, "diagnostics", diagnosticRows(path.diagnostics));
    return facts;
}

}  // namespace

const io::FileKind& programFiles()
{
    static const io::FileKind kind{
        "nc_program", LT_TEXT("Engine", "NC programs"), "*.nc *.ngc *.tap *.mpf *.spf *.cnc *.txt", {}, {}, likeProgram,
        factsOf};
    return kind;
}

}  // namespace lathelier::gcode
