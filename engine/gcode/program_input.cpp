#include "engine/gcode/program_input.h"

#include "engine/gcode/program_item_codes.h"
#include "engine/gcode/subprograms.h"
#include "engine/gcode/tool_table.h"
#include "engine/io/file.h"

namespace lathelier::gcode {
namespace {

constexpr std::size_t shownDigestDigits = 12;

}  // namespace

ProgramFile ProgramInput::read(const io::FileToRead& file)
{
    return {std::string(file.bytes), {}};
}

std::optional<ProgramText> ProgramInput::ofItem(const Values& values)
{
    std::optional<ProgramItem> program = programOf(values);
    if (!program) return std::nullopt;
    std::string text = program->text;
    return ProgramText{std::move(text), std::move(program)};
}

std::string ProgramInput::contentOf(const Values& values)
{
    const std::optional<ProgramItem> program = programOf(values);
    return program ? program->text : std::string();
}

ProgramFacts::File ProgramFacts::read(const io::FileToRead& file)
{
    File read;
    read.facts = programFiles().facts(file, read.notes);
    return read;
}

ToolTableFile ToolTableInput::read(const io::FileToRead& file)
{
    ToolTableFile read;
    read.tools = readToolTable(file.bytes);
    return read;
}

task::Input programAsInput()
{
    return task::ofPart(task::input<ProgramInput>(programRole, "", LT_TEXT("Engine", "Program"),
                                                  LT_TEXT("Engine", "The NC program that turns the work.")));
}

task::Input toolTableAsInput()
{
    return task::optionalInput<ToolTableInput>(
        toolsRole, toolsRole, LT_TEXT("Engine", "Tools"),
        LT_TEXT("Engine", "Nose radii from FILE, a tool table of LinuxCNC in mm."));
}

ProgramTaken takeProgram(const project::PanelState& state, std::vector<ProgramDraft>& drafts, Stores& stores,
                         const Progress& progress, task::Sources& sources)
{
    ProgramText read = *task::take<ProgramInput>(state, programRole, stores, progress, sources);
    const project::Source& source = state.inputs.at(programRole);
    ProgramTaken taken;
    taken.item = std::move(read.item);
    taken.original = std::move(read.text);
    taken.sha256 = io::sha256(taken.original);
    taken.name = taken.item ? source.item + " · " + taken.sha256.substr(0, shownDigestDigits) : source.path;
    std::erase_if(drafts, [&](const ProgramDraft& draft) { return !isOf(draft, taken.name, taken.sha256); });
    taken.text = drafts.empty() ? taken.original : bytesOf(drafts.front().text, taken.original);
    if (!drafts.empty()) sources.notes.push_back({notes::programEdited, {}});
    return taken;
}

void takeSubprograms(const std::string& text, ToolpathParameters& parameters, const ToolTable& tools,
                     const Progress& progress, task::Sources& sources)
{
    if (parameters.subprograms.empty()) return;
    FoundSubprograms found = findSubprograms(text, parameters, tools, progress);
    parameters.parts = std::make_shared<const std::vector<ProgramPart>>(std::move(found.parts));
    sources.inputs.insert(sources.inputs.end(), found.files.begin(), found.files.end());
    sources.notes.insert(sources.notes.end(), found.notes.begin(), found.notes.end());
}

ProgramRun runProgram(std::string text, const std::string& name, const ToolpathParameters& parameters,
                      const ToolTable& tools, const Progress& progress)
{
    try {
        ProgramRun run;
        run.program =
            readProgram(std::move(text), controlOf(parameters), progress.part(0, 0.5), name, partsOf(parameters));
        run.path = findToolpath(run.program, parameters, tools,
                                progress.part(0.5, 1, LT_TEXT("Engine", "Following the program")));
        if (const std::optional<Error> error = firstError(run.path)) throw Error(*error);
        return run;
    } catch (Error& error) {
        throw error.with("path", name);
    }
}

std::optional<Error> firstError(const Toolpath& toolpath)
{
    for (const Diagnostic& diagnostic : toolpath.diagnostics)
        if (diagnostic.error) return *diagnostic.error;
    return std::nullopt;
}

}  // namespace lathelier::gcode
