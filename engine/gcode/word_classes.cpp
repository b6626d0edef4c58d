#include "engine/gcode/word_classes.h"

#include <cmath>

#include "engine/gcode/gcode_codes.h"

namespace lathelier::gcode {
namespace {

void mark(Program& program, const Block& block, Word& word, const NoteCode& code)
{
    word.is_understood = false;
    report(program, program.diagnostics, block, word.begin, code, {{"found", shown(program, program.textOf(word))}});
}

void classifyName(Program& program, const Block& block, Word& word)
{
    const std::string_view text = program.textOf(word);
    if (text.ends_with(':')) return;  // a label
    const Name meaning = meaningOfName(*program.control, text);
    if (meaning == Name::Unknown) mark(program, block, word, notes::ncWordUnknown);
    if (meaning == Name::EndAngle) mark(program, block, word, notes::ncWordNotModelled);
}

void classifyNumber(Program& program, const Block& block, Word& word)
{
    const Control& control = *program.control;
    if (word.letter == 'G') {
        const double code10 = word.value * 10;
        const G meaning = code10 >= 0 && code10 < 1e6 && std::abs(code10 - std::round(code10)) < 1e-6
                              ? meaningOfG(control, static_cast<int>(std::lround(code10)))
                              : G::Unknown;
        if (meaning == G::Unknown) mark(program, block, word, notes::ncWordUnknown);
        if (meaning == G::NotModelled) mark(program, block, word, notes::ncWordNotModelled);
    } else if (word.letter == 'M') {
        const M meaning =
            word.value < 0 || word.value > 9999 ? M::Unknown : meaningOfM(control, static_cast<int>(word.value));
        if (meaning == M::Unknown) mark(program, block, word, notes::ncWordUnknown);
        if (meaning == M::NotModelled)
            mark(program, block, word,
                 program.wordOf(block, 'P') ? notes::ncBlockNotModelled : notes::ncWordNotModelled);
    } else {
        const Letter use = meaningOfLetter(control, word.letter);
        if (use == Letter::Unknown) mark(program, block, word, notes::ncWordUnknown);
        if (use == Letter::NotModelled) mark(program, block, word, notes::ncWordNotModelled);
    }
}

}  // namespace

void classifyWords(Program& program, Block& block)
{
    for (std::uint32_t i = 0; i < block.word_count; ++i) {
        Word& word = program.words[block.first_word + i];
        switch (word.kind) {
            case WordKind::Number:
                if (word.letter != 0)
                    classifyNumber(program, block, word);
                else
                    classifyName(program, block, word);
                break;
            case WordKind::Expression:
                if (word.letter == 0)
                    classifyName(program, block, word);
                else if (word.letter != 'G' && word.letter != 'M' &&
                         meaningOfLetter(*program.control, word.letter) < Letter::InBlock)
                    mark(program, block, word, notes::ncWordNotModelled);
                break;
            case WordKind::Name:
            case WordKind::Call: classifyName(program, block, word); break;
            default: break;
        }
    }
}

}  // namespace lathelier::gcode
