// Evaluation of cycle words.
#include <algorithm>
#include <cmath>

#include "engine/core/units.h"
#include "engine/gcode/gcode_codes.h"
#include "engine/gcode/interpreter.h"

namespace lathelier::gcode {

/// Does the block begin a cycle or belong to a modal one?
bool Interpreter::isCycle(const BlockWords& words) const
{
    for (const G which : {G::Finish, G::RoughTurn, G::RoughFace, G::Pattern, G::SubroutineFinish, G::SubroutineTurn,
                          G::SubroutineFace, G::FacePeck, G::TurnPeck, G::ThreadMulti, G::DriveThread})
        if (words.hasG(which)) return true;
    return modal_.motion == G::TurnCycle || modal_.motion == G::FaceCycle || modal_.motion == G::ThreadCycle ||
           modal_.motion == G::Drill;
}

/// True if the block is a cycle or belongs to a modal one.
bool Interpreter::cycle(BlockWords& words)
{
    for (const G which : {G::Finish, G::RoughTurn, G::RoughFace, G::Pattern})
        if (words.hasG(which)) {
            contourCycle(words, which);
            return true;
        }
    for (const G which : {G::SubroutineFinish, G::SubroutineTurn, G::SubroutineFace})
        if (words.hasG(which)) {
            subroutineCycle(words, which);
            return true;
        }
    if (words.hasG(G::FacePeck) || words.hasG(G::TurnPeck)) {
        peck(words, words.hasG(G::TurnPeck));
        return true;
    }
    if (words.hasG(G::ThreadMulti) || words.hasG(G::DriveThread)) {
        if (words.hasG(G::ThreadMulti))
            threadMulti(words);
        else
            driveThread(words);
        return true;
    }
    if (modal_.motion == G::TurnCycle || modal_.motion == G::FaceCycle || modal_.motion == G::ThreadCycle) {
        singleCycle(words);
        return true;
    }
    if (modal_.motion == G::Drill) {
        drill(words);
        return true;
    }
    return false;
}

void Interpreter::singleCycle(BlockWords& words)
{
    const bool isNew = words.hasG(modal_.motion);
    if (!hasAxes(words) && !words.has('R') && !words.has('I') && !words.has('K')) return;
    if (!cycleStart_ || isNew) {
        cycleStart_ = modal_.at;
        if (isNew) cycleX_ = cycleZ_ = notANumber;
        cycleR_ = 0;
    }
    const Point to = target(words);
    if (words.has('X') || words.has('U')) cycleX_ = to.x_mm;
    if (words.has('Z') || words.has('W')) cycleZ_ = to.z_mm;
    for (const char letter : {'R', 'I', 'K'})
        if (words.has(letter) && !(modal_.motion == G::ThreadCycle && letter == 'K'))
            cycleR_ = length_mm(words, letter);
    if (words.has('Q')) plain(words, 'Q');
    const double lead = modal_.motion == G::ThreadCycle ? threadLead_mm(words) : modal_.feed;
    const Point end{isKnown(cycleX_) ? cycleX_ : cycleStart_->x_mm, isKnown(cycleZ_) ? cycleZ_ : cycleStart_->z_mm};
    if (!isKnown(*cycleStart_)) warn(notes::ncPositionUnknown);
    if (modal_.motion == G::ThreadCycle) {
        if (!(lead > 0)) error(errors::ncFeedMissing);
        emitCycle(threadCycle(*cycleStart_, end, cycleR_), lead);
    } else {
        emitCycle(modal_.motion == G::TurnCycle ? turningCycle(*cycleStart_, end, cycleR_)
                                                : facingCycle(*cycleStart_, end, cycleR_));
    }
}

void Interpreter::drill(BlockWords& words)
{
    const bool isNew = words.isDrilled();
    const bool hasC = words.has('C') || words.has('H');
    if (!isNew && !hasAxes(words) && !hasC) return;
    if (isNew) {
        if (const Word* const across = words.wordOfG(G::DrillAcross)) {
            warn(notes::ncBlockNotModelled, across, {{"found", shownWord(*across)}}, GapEffect::Moves);
            notUnderstood(across);
            modal_.motion = G::Unknown;
            modal_.at = {};
            return;
        }
        drilling_ = {};
        drilling_.level_z_mm = modal_.at.z_mm;
        drilling_.bottom_z_mm = modal_.at.z_mm;
        drilling_.chip_break = words.hasG(G::DrillChipBreak);
        drilling_.is_tap = words.hasG(G::Tap);
        drilling_.feeds_out = words.hasG(G::DrillFeedOut);
    }
    Point to = modal_.at;
    const bool hasZ = words.has('Z') || words.has('W');
    const Point given = target(words);
    to.x_mm = given.x_mm;
    if (to.x_mm != modal_.at.x_mm && (words.has('X') || words.has('U')))
        emit(MoveKind::Rapid, {to.x_mm, modal_.at.z_mm});
    if (words.has('R')) {
        const double r = length_mm(words, 'R');
        const double absolute = modal_.is_shifted ? ofWork({0, r}).z_mm : r;
        double level = modal_.is_incremental ? modal_.at.z_mm + r : absolute;
        if (control_.drill_level_is_increment) {  // incremental from the start; absolute if that would lead away from
                                                  // the hole
            const double from = modal_.at.z_mm + r;
            const bool isAway = hasZ && (from - modal_.at.z_mm) * (given.z_mm - modal_.at.z_mm) < 0;
            level = isAway ? absolute : from;
        }
        drilling_.level_z_mm = level;
    }
    if (hasZ) drilling_.bottom_z_mm = words.has('W') ? drilling_.level_z_mm + length_mm(words, 'W') : given.z_mm;
    if (words.has('Q')) drilling_.peck_mm = std::abs(micro_mm(words, 'Q'));
    if (words.has('P')) {
        const Word* const word = words.word['P' - 'A'];
        drilling_.dwell_s = plain(words, 'P') * (control_.integers_count_increments && !word->has_point ? 1e-3 : 1);
    }
    long repeats = 1;
    for (const char letter : {'K', 'L'})
        if (words.has(letter)) repeats = std::clamp(std::lround(plain(words, letter)), 0L, 10000L);
    if (words.hasG(G::ReturnToLevel)) drilling_.to_level = true;
    for (long k = 0; k < repeats && result_.moves.size() <= mostMoves; ++k)
        emitCycle(drilling(modal_.at, drilling_), modal_.feed);
}

void Interpreter::threadMulti(BlockWords& words)
{
    if (!hasAxes(words)) {  // first block: P mmrraa, Q least step, R finish
        if (words.has('P')) {
            const long code = std::lround(std::clamp(plain(words, 'P'), 0.0, 999999.0));
            threadLast_ = static_cast<int>(std::max(code / 10000, 1L));
            threadRun_ = static_cast<double>(code / 100 % 100) / 10;
        }
        if (words.has('Q')) threadLeast_mm_ = std::abs(micro_mm(words, 'Q'));
        if (words.has('R')) threadFinish_mm_ = std::abs(micro_mm(words, 'R'));
        if (!words.has('P') && !words.has('Q') && !words.has('R'))
            error(errors::ncCycle, nullptr, {{"cycle", "G76"}, {"reason", LT_TEXT("Engine", "it has no words")}});
        return;
    }
    // A form with letters that this cycle has on no control of its kind: X Z Q P H I R K L C B T J is that of Mach3.
    constexpr std::string_view others = "HJLBTC";
    const auto isOther = [&](char letter) { return (words.given >> BlockWords::slot(letter) & 1U) != 0; };
    if (std::count_if(others.begin(), others.end(), isOther) > 1)
        return error(
            errors::ncCycle, nullptr,
            {{"cycle", "G76"}, {"reason", LT_TEXT("Engine", "its words are those of another control (Mach3)")}});
    const Point start = modal_.at;
    MultiThread cut;
    cut.end = target(words);
    if (!(words.has('X') || words.has('U'))) cut.end.x_mm = start.x_mm;
    const bool isOneBlock = words.has('K') && words.has('D');
    if (isOneBlock) {
        cut.height_mm = std::abs(length_mm(words, 'K'));
        cut.first_mm = std::abs(micro_mm(words, 'D'));
        cut.has_finish = false;
        if (words.has('I')) cut.taper_mm = length_mm(words, 'I');
        for (const char letter : {'A', 'P', 'Q'})
            if (words.has(letter)) plain(words, letter);
    } else {
        cut.height_mm = std::abs(micro_mm(words, 'P'));
        cut.first_mm = std::abs(micro_mm(words, 'Q'));
        cut.least_mm = threadLeast_mm_;
        cut.finish_mm = threadFinish_mm_;
        cut.last_passes = threadLast_;
        if (words.has('R')) cut.taper_mm = length_mm(words, 'R');
    }
    const double lead = threadLead_mm(words);
    cut.run_out_mm = isOneBlock ? 0 : threadRun_ * lead;
    if (!(lead > 0)) return error(errors::ncFeedMissing);
    if (!(cut.height_mm > 0) || !(cut.first_mm > 0)) {
        return error(
            errors::ncCycle, nullptr,
            {{"cycle", "G76"}, {"reason", LT_TEXT("Engine", "the height of the thread or its first cut is missing")}});
    }
    if (!isKnown(start)) warn(notes::ncPositionUnknown);
    if (const std::int64_t passes = roughPasses(cut, mostPasses); passes > mostPasses)
        return error(errors::ncPasses, nullptr, {{"found", passes}, {"most", mostPasses}});
    emitCycle(multiThread(start, cut), lead);
}

void Interpreter::driveThread(BlockWords& words)
{
    const double half = modal_.is_diameter ? 0.5 : 1;
    DriveThread cut;
    const Point start = modal_.at;
    cut.end_z_mm = target(words).z_mm;
    for (const char letter : {'P', 'I', 'J', 'K'})
        if (!words.has(letter)) {
            return error(errors::ncCycle, nullptr,
                         {{"cycle", "G76"}, {"reason", LT_TEXT("Engine", "one of the words P, I, J, K is missing")}});
        }
    const double lead = length_mm(words, 'P');
    cut.peak_mm = length_mm(words, 'I') * half;
    cut.first_mm = length_mm(words, 'J') * half;
    cut.height_mm = length_mm(words, 'K') * half;
    cut.degression = plain(words, 'R', 1);
    cut.compound_rad = plain(words, 'Q') * std::acos(-1.0) / 180;
    cut.springs = static_cast<int>(std::clamp(plain(words, 'H'), 0.0, 1000.0));
    cut.taper_length_mm = words.has('E') ? length_mm(words, 'E') : 0;
    cut.tapers = static_cast<int>(std::clamp(plain(words, 'L'), 0.0, 3.0));
    if (const Word* h = words.word['H' - 'A'])
        program_.words[static_cast<std::size_t>(h - program_.words.data())].is_understood = true;
    if (!(cut.first_mm > 0) || !(cut.height_mm > cut.first_mm - 1e-12) || !(lead > 0)) {
        return error(
            errors::ncCycle, nullptr,
            {{"cycle", "G76"}, {"reason", LT_TEXT("Engine", "P, J and K must be positive, and K not below J")}});
    }
    emitCycle(gcode::driveThread(start, cut), lead);
}

void Interpreter::peck(BlockWords& words, bool alongX)
{
    if (!hasAxes(words)) {
        if (words.has('R')) peckRetreat_mm_ = std::abs(length_mm(words, 'R'));
        return;
    }
    const Point start = modal_.at;
    Pecking groove;
    groove.along_x = alongX;
    groove.end = target(words);
    const bool isOneBlock = words.has('D') || (words.has('K') || words.has('I'));
    double deltaX = words.has('P') ? micro_mm(words, 'P') : 0, deltaZ = words.has('Q') ? micro_mm(words, 'Q') : 0;
    if (isOneBlock) {
        if (words.has('I')) deltaX = length_mm(words, 'I') / (control_.groove_step_is_diameter ? 2 : 1);
        if (words.has('K')) deltaZ = length_mm(words, 'K');
        if (words.has('D')) groove.relief_mm = length_mm(words, 'D');
    }
    if (words.has('R')) groove.relief_mm = length_mm(words, 'R');
    groove.peck_mm = std::abs(alongX ? deltaX : deltaZ);
    groove.step_mm = std::abs(alongX ? deltaZ : deltaX);
    groove.retreat_mm = peckRetreat_mm_;
    if (!isKnown(start)) warn(notes::ncPositionUnknown);
    emitCycle(pecking(start, groove));
}

}  // namespace lathelier::gcode
