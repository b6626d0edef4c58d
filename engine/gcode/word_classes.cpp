#include "engine/gcode/word_classes.h"

#include <cmath>

#include "engine/gcode/declared_names.h"
#include "engine/gcode/gcode_codes.h"

namespace lathelier::gcode {
namespace {

void mark(Program& program, const Block& block, Word& word, const NoteCode& code, GapEffect effect)
{
    word.is_understood = false;
    report(program, program.diagnostics, block, word.begin, code, {{"found", shown(program, program.textOf(word))}},
           effect);
}

bool hasAxis(const Program& program, const Block& block)
{
    for (std::uint32_t i = 0; i < block.word_count; ++i) {
        const Word& word = program.words[block.first_word + i];
        if (word.letter != 0 && std::string_view("XZUWYCAB").find(word.letter) != std::string_view::npos) return true;
    }
    return false;
}

/// An unknown M word alone switches something; one with coordinates or P calls or moves.
GapEffect effectOfM(const Program& program, const Block& block)
{
    return hasAxis(program, block) || program.wordOf(block, 'P') ? GapEffect::Moves : GapEffect::None;
}

void classifyName(Program& program, const Block& block, Word& word)
{
    const std::string_view text = program.textOf(word);
    if (text.ends_with(':')) return;  // a label
    const Name meaning = meaningOfName(*program.control, text);
    if (meaning == Name::Unknown && !program.names.contains(nameOf(text)))
        mark(program, block, word, notes::ncWordUnknown, GapEffect::Moves);
    if (meaning == Name::MillOn) mark(program, block, word, notes::ncWordNotModelled, GapEffect::Moves);
}

void classifyNumber(Program& program, const Block& block, Word& word)
{
    const Control& control = *program.control;
    if (word.letter == 'G') {
        const double code10 = word.value * 10;
        const G meaning = code10 >= 0 && code10 < 1e6 && std::abs(code10 - std::round(code10)) < 1e-6
                              ? meaningOfG(control, static_cast<int>(std::lround(code10)))
                              : G::Unknown;
        if (meaning == G::Unknown) mark(program, block, word, notes::ncWordUnknown, GapEffect::Moves);
        if (meaning == G::NotModelled || meaning == G::MillOn)
            mark(program, block, word, notes::ncWordNotModelled, GapEffect::Moves);
    } else if (word.letter == 'M') {
        const M meaning =
            word.value >= 0 && word.value <= 9999 ? meaningOfM(control, static_cast<int>(word.value)) : M::Unknown;
        if (meaning == M::Unknown) mark(program, block, word, notes::ncWordUnknown, effectOfM(program, block));
        if (meaning == M::NotModelled)
            mark(program, block, word,
                 program.wordOf(block, 'P') ? notes::ncBlockNotModelled : notes::ncWordNotModelled, GapEffect::Moves);
    } else {
        const Letter use = meaningOfLetter(control, word.letter);
        if (use == Letter::Unknown) mark(program, block, word, notes::ncWordUnknown, GapEffect::Moves);
        // The interpreter says where it moves what is not modelled.
        const bool mayShape = word.letter == 'C' && control.has_drawing_words;  // the interpreter tells
        if (use == Letter::NotModelled && !mayShape)
            mark(program, block, word, notes::ncWordNotModelled, GapEffect::None);
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
                    mark(program, block, word, notes::ncWordNotModelled,
                         meaningOfLetter(*program.control, word.letter) == Letter::Unknown ? GapEffect::Moves
                                                                                           : GapEffect::None);
                break;
            case WordKind::Name:
            case WordKind::Call: classifyName(program, block, word); break;
            default: break;
        }
    }
}

}  // namespace lathelier::gcode
