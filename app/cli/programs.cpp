#include "app/cli/programs.h"

#include "app/cli/shafts.h"
#include "engine/gcode/tool_table.h"

namespace lathelier::cli {
namespace {

/// Files that options name.
struct ToolFiles {
    std::string tools;  ///< path; empty: none
};

const std::vector<Field<ToolFiles>>& fieldsOf(const ToolFiles*)
{
    static const std::vector<Field<ToolFiles>> all{field(
        "tools", &ToolFiles::tools,
        Label{LT_TEXT("Engine", "Tools"), LT_TEXT("Engine", "Nose radii from FILE, a tool table of LinuxCNC in mm.")})};
    return all;
}

gcode::ToolTable toolsOf(const Request& request, io::InputFiles& inputs, const Progress& progress)
{
    const std::string path = wordOf(request, "tools");
    if (path.empty()) return {};
    try {
        return gcode::readToolTable(inputs.open(path, progress));
    } catch (Error& error) {
        throw error.with("path", path);
    }
}

}  // namespace

std::vector<Option> programOptions()
{
    std::vector<Option> options = optionsOf<gcode::ToolpathParameters>();
    for (Option& option : optionsOf<ToolFiles>()) options.push_back(std::move(option));
    return options;
}

ProgramRead readProgram(const std::string& path, const Request& request, io::InputFiles& inputs,
                        const Progress& progress)
{
    const auto parameters = fromValues<gcode::ToolpathParameters>(request.parameters);
    ProgramRead read;
    read.tools = toolsOf(request, inputs, progress);
    try {
        read.program = gcode::readProgram(std::string(inputs.open(path, progress)), parameters.dialect,
                                          progress.part(0.1, 0.5, LT_TEXT("Engine", "Reading")));
    } catch (Error& error) {
        throw error.with("path", path);
    }
    read.path = findToolpath(read.program, parameters, read.tools,
                             progress.part(0.5, 1, LT_TEXT("Engine", "Following the program")));
    return read;
}

std::optional<Error> firstError(const gcode::Toolpath& toolpath, const std::string& path)
{
    for (const gcode::Diagnostic& diagnostic : toolpath.diagnostics) {
        if (!diagnostic.error) continue;
        Error error = *diagnostic.error;
        return error.with("path", path);
    }
    return std::nullopt;
}

}  // namespace lathelier::cli
