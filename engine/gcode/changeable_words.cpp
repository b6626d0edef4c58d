#include "engine/gcode/changeable_words.h"

#include <algorithm>
#include <cmath>

namespace lathelier::gcode {
namespace {

/// Words that select a motion, a unit, a feed or a speed, or have no effect on the path.
bool leavesThePath(G meaning)
{
    switch (meaning) {
        case G::Rapid:
        case G::Line:
        case G::ArcCw:
        case G::ArcCcw:
        case G::Inch:
        case G::InchAll:
        case G::Metric:
        case G::PlaneZX:
        case G::NoseOff:
        case G::CssOn:
        case G::CssOff:
        case G::PerMinute:
        case G::PerRevolution:
        case G::Absolute:
        case G::Incremental:
        case G::Diameter:
        case G::Radius:
        case G::ArcAbsolute:
        case G::ArcIncremental:
        case G::CycleOff:
        case G::NoEffect: return true;
        default: return false;
    }
}

bool leavesThePath(Name meaning)
{
    switch (meaning) {
        case Name::NoEffect:
        case Name::Uncomputed:
        case Name::DiameterOn:
        case Name::DiameterOff:
        case Name::DiameterAbsolute:
        case Name::SpeedLimit:
        case Name::Speed: return true;
        default: return false;
    }
}

}  // namespace

bool shapesItsEnd(const Program& program, const Word& word)
{
    if (word.letter == 'c' || word.letter == 'r' || word.letter == 'a') return true;
    return word.letter == 0 && word.kind != WordKind::Comment &&
           shapesCorner(meaningOfName(*program.control, program.textOf(word)));
}

bool isRadius(const Program& program, const Word& word)
{
    return word.letter == 'R' || (word.letter == 0 && word.kind != WordKind::Comment &&
                                  meaningOfName(*program.control, program.textOf(word)) == Name::ArcRadius);
}

const Word* radiusWord(const Program& program, const Block& block)
{
    for (std::uint32_t i = 0; i < block.word_count; ++i)
        if (const Word& word = program.words[block.first_word + i]; isRadius(program, word)) return &word;
    return nullptr;
}

bool isHarmless(const Program& program, const Word& word, const BlockState& state)
{
    if (word.kind == WordKind::Comment || word.kind == WordKind::Assignment) return true;
    if (word.kind == WordKind::Bad || word.kind == WordKind::Flow) return false;
    const Control& control = *program.control;
    const auto number = static_cast<int>(std::lround(std::clamp(word.value, -1.0, 1e6)));
    switch (word.letter) {
        case 'N':
        case 'F':
        case 'S':
        case 'T':
        case 'X':
        case 'Z': return true;
        case 'U':
        case 'W': return control.increments_are_letters;
        case 'I':
        case 'K':
        case 'R': return state.kind == MoveKind::Arc && word.is_understood;
        case 'M': {
            const M meaning = meaningOfM(control, number);
            return word.kind == WordKind::Number &&
                   (meaning == M::NoEffect || meaning == M::Spindle || meaning == M::Unknown);
        }
        case 'G': {
            const auto code10 = static_cast<int>(std::lround(std::clamp(word.value, -1.0, 1e6) * 10));
            return word.kind == WordKind::Number && leavesThePath(meaningOfG(control, code10));
        }
        case 0: {
            const std::string_view name = program.textOf(word);
            if (word.kind == WordKind::Name && name.ends_with(':')) return true;  // a label
            return leavesThePath(meaningOfName(control, name)) ||
                   (state.kind == MoveKind::Arc && isRadius(program, word));
        }
        default: return false;
    }
}

bool stops(const Control& control, const Word& word)
{
    if (word.letter != 'M') return false;
    constexpr double stop = 0, optionalStop = 1, spindleStop = 5;
    const M meaning = meaningOfM(control, static_cast<int>(word.value));
    return (meaning != M::NoEffect && meaning != M::Spindle && meaning != M::Unknown) || word.value == stop ||
           word.value == optionalStop || word.value == spindleStop;
}

}  // namespace lathelier::gcode
