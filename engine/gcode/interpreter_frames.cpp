// Shifts and frames of coordinates, and moves that are not those of turning.
#include <algorithm>
#include <cmath>

#include "engine/core/units.h"
#include "engine/gcode/gcode_codes.h"
#include "engine/gcode/interpreter.h"

namespace lathelier::gcode {
namespace {

/// Ten times the number of work offset 1, 2…: G54 to G59, G59.1 to G59.3.
int offsetOf(long number)
{
    constexpr long whole = 6, most = 9;
    const long one = std::clamp(number, 1L, most);
    return static_cast<int>(one <= whole ? 530 + 10 * one : 590 + one - whole);
}

}  // namespace

/// What shifts and frames come to, for the blocks that follow: kept, for every coordinate asks for it.
void Interpreter::updateFrame()
{
    const Frame by = Frame::translation(modal_.coarse.x_mm + modal_.fine.x_mm, modal_.coarse.z_mm + modal_.fine.z_mm);
    modal_.whole = by.with(modal_.frame);
    modal_.shift = plus(modal_.zero, plus(modal_.stated, modal_.local));
    const Frame& all = modal_.whole;
    modal_.is_shifted =
        !all.isStraight() || all.x_mm != 0 || all.z_mm != 0 || modal_.shift.x_mm != 0 || modal_.shift.z_mm != 0;
}

Point Interpreter::ofProgram(const Point& work) const
{
    return modal_.whole.inverse({work.x_mm - modal_.shift.x_mm, work.z_mm - modal_.shift.z_mm});
}

/// X and Z of the block as a shift, each only where it is given.
Point Interpreter::statedShift(BlockWords& words, const Point& otherwise)
{
    Point by = otherwise;
    if (words.has('X')) by.x_mm = length_mm(words, 'X') / (modal_.is_diameter ? 2 : 1);
    if (words.has('Z')) by.z_mm = length_mm(words, 'Z');
    if (control_.increments_are_letters && words.has('U'))
        by.x_mm += length_mm(words, 'U') / (modal_.is_diameter ? 2 : 1);
    if (control_.increments_are_letters && words.has('W')) by.z_mm += length_mm(words, 'W');
    return by;
}

/// TRANS, ROT, SCALE, MIRROR and those in addition.
void Interpreter::takeFrame(BlockWords& words)
{
    Frame by;
    const Point none{0, 0};
    switch (words.frame) {
        case Name::Translate:
        case Name::TranslateMore: {
            const Point to = statedShift(words, none);
            by = Frame::translation(to.x_mm, to.z_mm);
            break;
        }
        case Name::Rotate:
        case Name::RotateMore:
            if (hasAxes(words)) return leaveOut(words, nullptr);  // about an axis instead of within the plane
            if (isKnown(words.valueOf(Name::RotateAngle))) by = Frame::rotation(words.valueOf(Name::RotateAngle));
            break;
        case Name::Scale:
        case Name::ScaleMore: by = Frame::scaled(plain(words, 'X', 1), plain(words, 'Z', 1)); break;
        case Name::Mirror:
        case Name::MirrorMore: by = Frame::scaled(words.has('X') ? -1 : 1, words.has('Z') ? -1 : 1); break;
        default: break;
    }
    for (const char letter : {'X', 'Z'}) words.used |= 1U << BlockWords::slot(letter);
    const bool isMore = words.frame == Name::TranslateMore || words.frame == Name::RotateMore ||
                        words.frame == Name::ScaleMore || words.frame == Name::MirrorMore;
    if (!isMore) modal_.coarse = modal_.fine = none;
    modal_.frame = isMore ? modal_.frame.with(by) : by;
    updateFrame();
}

void Interpreter::takeShift(BlockWords& words, G which)
{
    const Point none{0, 0};
    switch (which) {
        case G::LocalShift:
            if (control_.local_shift_is_position)
                modal_.stated_kept = modal_.stated = statedShift(words, modal_.stated);
            else
                modal_.local = statedShift(words, modal_.local);
            break;
        case G::Translate: {
            const Point to = statedShift(words, none);
            modal_.coarse = modal_.fine = none;
            modal_.frame = Frame::translation(to.x_mm, to.z_mm);
            break;
        }
        case G::TranslateCoarse: modal_.coarse = statedShift(words, modal_.coarse); break;
        case G::TranslateFine: modal_.fine = statedShift(words, modal_.fine); break;
        case G::SetPositionOff:
        case G::SetPositionClear:
            modal_.stated_kept = which == G::SetPositionClear ? none : modal_.stated;
            modal_.stated = none;
            break;
        case G::SetPositionBack: modal_.stated = modal_.stated_kept; break;
        default: {  // SetPosition, SpeedLimit with coordinates
            if (!hasAxes(words)) return;
            const bool isIncremental = modal_.is_incremental;
            if (control_.set_position_is_absolute) modal_.is_incremental = false;
            const Point stated = statedTarget(words, ofProgram(modal_.at));
            modal_.is_incremental = isIncremental;
            // Before the first move it says where the tool stands; later the tool stays and the zero moves. Where the
            // control states coordinates of each tool by it, it describes the tool.
            if (!control_.set_position_shifts || result_.moves.empty()) {
                modal_.at = ofWork(stated);
                return;
            }
            const Point now = ofProgram(modal_.at);
            if (!isKnown(now)) {
                warn(notes::ncOffsetUnknown, words.g_word[0], {{"found", shownWord(*words.g_word[0])}},
                     GapEffect::Shifts);
                modal_.at = {};
                return;
            }
            modal_.stated = plus(modal_.stated, modal_.frame.turned({now.x_mm - stated.x_mm, now.z_mm - stated.z_mm}));
            modal_.stated_kept = modal_.stated;
        }
    }
    updateFrame();
}

/// G10: a work offset; what it states of tools is not modelled.
void Interpreter::setData(BlockWords& words)
{
    const Word* const word = words.wordOfG(G::SetData);
    const long kind = std::lround(plain(words, 'L', 0));
    const bool isOffset = kind == 2 || kind == 20;
    if (!isOffset || !(words.has('P'))) {
        for (const char letter : {'X', 'Z', 'U', 'W', 'P', 'R', 'Q', 'I', 'K', 'J', 'C', 'Y', 'L', 'D'})
            words.used |= 1U << BlockWords::slot(letter);
        notUnderstood(word);
        warn(notes::ncWordNotModelled, word, {{"found", shownWord(*word)}}, GapEffect::Measures);
        return;
    }
    const long number = std::lround(plain(words, 'P'));
    const int of = number == 0 ? modal_.work_offset : offsetOf(number);
    const Point before = offsets_.contains(of) ? offsets_[of] : Point{0, 0};
    if (kind == 2) {
        if (!offsets_.contains(of)) assume("work_offset_before", LT_TEXT("Engine", "0"));
        offsets_[of] = statedShift(words, before);
    } else {
        const Point now = ofProgram(modal_.at), stated = statedShift(words, now);
        if (!isKnown(now)) {
            warn(notes::ncOffsetUnknown, word, {{"found", shownWord(*word)}}, GapEffect::Shifts);
            modal_.at = {};
            return;
        }
        Point& offset = offsets_[of] = before;
        if (words.has('X') || words.has('U')) offset.x_mm = modal_.zero.x_mm + now.x_mm - stated.x_mm;
        if (words.has('Z') || words.has('W')) offset.z_mm = modal_.zero.z_mm + now.z_mm - stated.z_mm;
    }
    if (of != modal_.work_offset) return;
    modal_.zero = offsets_[of];
    updateFrame();
}

/// Another work offset: by how much it shifts is known where the program has set both.
void Interpreter::changeOffset(int number10, const Word* word)
{
    if (number10 == modal_.work_offset) return;
    const bool isNamed = meaningOfG(control_, number10) == G::WorkOffsetNamed;
    const bool isStated = offsets_.contains(number10);
    modal_.work_offset = number10;
    if (isStated) {
        modal_.zero = offsets_[number10];
        return updateFrame();
    }
    if (isNamed && offsets_.empty()) {  // the program is taken to state its coordinates in it
        if (!result_.moves.empty()) assume("work_offset", LT_TEXT("Engine", "as before"));
        return;
    }
    if (!isKnown(modal_.at.x_mm) && !isKnown(modal_.at.z_mm)) return;
    warn(notes::ncOffsetUnknown, word, {{"found", shownWord(*word)}}, GapEffect::Shifts);
    modal_.at = {};
}

/// The block makes no move; where it leads to is not known.
void Interpreter::leaveOut(BlockWords& words, const Word* because)
{
    const bool mayMove =
        hasAxes(words) || words.has('P') || (because && because->letter == 0) || words.hasG(G::ArcThrough);
    for (const char letter : {'X', 'Z', 'U', 'W'}) words.used |= 1U << BlockWords::slot(letter);
    // An axis of its own turns or swivels the work; X and Z stay.
    const bool isAxis =
        because && !hasAxes(words) && std::string_view("ABCHVYUW").find(because->letter) != std::string_view::npos;
    if (!mayMove && !isAxis) return;
    const Word& place = because ? *because : program_.words[program_.blocks[pc_].first_word];
    warn(notes::ncBlockNotModelled, &place, {{"found", shownWord(place)}}, GapEffect::Moves);
    if (!isAxis) modal_.at = {};
}

/// What makes the moves of this block those of a driven tool or of an axis that turning does not have.
const Word* Interpreter::milledBy(const BlockWords& words)
{
    const bool feeds = modal_.motion != G::Rapid && modal_.motion != G::Unknown;
    const bool moves = hasAxes(words);
    if (modal_.milled_by && moves) return modal_.milled_by;
    const Word* held = nullptr;
    for (const char letter : {'A', 'B', 'C', 'H', 'V', 'Y', 'U', 'W'}) {
        const auto slot = static_cast<std::size_t>(BlockWords::slot(letter));
        if ((words.given >> slot & 1U) == 0 || meaningOfLetter(control_, letter) != Letter::NotModelled) continue;
        if (letter == 'C' && isChamferC(words)) continue;
        if (letter == 'C' && control_.has_drawing_words) {
            warn(notes::ncWordNotModelled, words.word[slot], {{"found", shownWord(*words.word[slot])}},
                 GapEffect::None);
            notUnderstood(words.word[slot]);
        }
        if (letter == 'H' && !control_.increments_are_letters) continue;  // a function of the machine
        const bool turnsWork = letter == 'C' || letter == 'H';
        if (feeds || (!turnsWork && words.value[slot] != 0)) return words.word[slot];
        if (turnsWork) held = words.word[slot];
    }
    if (held) modal_.held_by = held;
    if (!feeds || !moves) return nullptr;
    return modal_.held_by ? modal_.held_by : modal_.plane_by;
}

}  // namespace lathelier::gcode
