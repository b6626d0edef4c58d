// NC programs: any bytes are refused with a code of rejected input, or give a toolpath whose diagnostics have a place;
// the program written again is the program.
#include <cmath>
#include <cstdint>
#include <cstdlib>

#include "engine/core/error.h"
#include "engine/gcode/gcode_codes.h"
#include "engine/gcode/rewriter.h"
#include "engine/gcode/toolpath.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    using namespace lathelier;
    if (size == 0) return 0;
    const auto& choices = gcode::controlChoices();
    const gcode::ControlPtr control = gcode::controlNamed(choices[data[0] % choices.size()].key);
    const std::string text(reinterpret_cast<const char*>(data) + 1, size - 1);
    try {
        gcode::Program program = gcode::readProgram(text, control);
        gcode::ToolpathParameters parameters;
        parameters.most_blocks_run = 100000;  // programs that do not end are frequent here
        if (data[0] >= 128) parameters.nose_radius_mm = 0.8;
        const gcode::Toolpath path = gcode::findToolpath(program, parameters);
        if (path.blocks.size() != program.blocks.size() || path.words_understood > path.words) std::abort();
        for (const gcode::Move& move : path.moves)
            if (move.line < 1 || move.line > static_cast<std::int64_t>(program.blocks.size()) || std::isinf(move.x_mm))
                std::abort();
        for (const gcode::Diagnostic& diagnostic : path.diagnostics)
            if (diagnostic.line < 1 || diagnostic.column < 1 || gcode::sentence(diagnostic).empty()) std::abort();
        gcode::Rewriter rewriter(program, path);
        if (rewriter.write().text != text) std::abort();
        for (std::size_t block = 0; block < program.blocks.size() && block < 20; ++block)
            if (!rewriter.refusal(block)) rewriter.split(block, {{{1, 2}, {}}, {{3, 4}, {}}});
        rewriter.write();
    } catch (const Error& error) {
        if (error.code().kind != ErrorKind::InputRejected && !(error.code() == errors::ncBlockNotRewritable))
            std::abort();
    }
    return 0;
}
