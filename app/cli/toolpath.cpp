// toolpath PROGRAM: an NC program as canonical moves.
#include <nlohmann/json.hpp>

#include "app/cli/programs.h"
#include "app/cli/verbs.h"
#include "engine/gcode/program_kind.h"
#include "engine/gcode/toolpath_files.h"
#include "engine/io/file.h"
#include "engine/report/plain_text.h"

namespace lathelier::cli {
namespace {

constexpr const char* rewriteOption = "--rewrite";

void runToolpath(const Request& request, io::InputFiles& inputs, const Progress& progress, Answer& answer)
{
    const std::string& path = request.operands.front();
    ProgramRead read = readProgram(path, request, inputs, progress);
    const auto result = std::make_shared<gcode::Toolpath>(std::move(read.path));
    answer.json = [result] { return gcode::toJson(*result); };
    answer.report = [result] { return gcode::toolpathReport(*result); };
    answer.summary = report::toPlainText(gcode::toolpathSummary(*result));
    if (const auto copy = request.outputs.find(rewriteOption); copy != request.outputs.end())
        io::writeFile(copy->second, read.program.text);
    if (auto error = firstError(*result, path)) {
        answer.errors.push_back(*error);
        return;
    }
    if (const auto table = request.outputs.find(tableOption); table != request.outputs.end())
        io::writeFile(table->second, [&](const io::Append& append) {
            writeMoves(*result, [&](std::string_view step) {
                progress.check();
                append(step);
            });
        });
}

}  // namespace

Verb toolpathVerb()
{
    return {"toolpath",
            "Read an NC program and give its moves.",
            {{"PROGRAM", "An NC program (Fanuc, Haas, Sinumerik, LinuxCNC)."}},
            programOptions(),
            {&gcode::programFiles()},
            {{tableOption, "Write the moves as FILE.csv."},
             {rewriteOption, "Write the program again as FILE, byte for byte."}},
            true,
            runToolpath};
}

}  // namespace lathelier::cli
