// Positions, what a block moves, threads, dwells, reference points.
#include <algorithm>
#include <cmath>

#include "engine/core/units.h"
#include "engine/gcode/gcode_codes.h"
#include "engine/gcode/interpreter.h"

namespace lathelier::gcode {
/// The number of a letter as written.
double Interpreter::plain(BlockWords& words, char letter, double otherwise)
{
    if (!words.has(letter)) return otherwise;
    const int slot = BlockWords::slot(letter);
    words.used |= 1U << slot;
    return words.value[static_cast<std::size_t>(slot)];
}

/// The number of a letter as a length; integers without decimal point follow ToolpathParameters::integer_words, with a
/// warning.
double Interpreter::length_mm(BlockWords& words, char letter)
{
    const double value = plain(words, letter);
    const Word* const word = words.word[static_cast<std::size_t>(BlockWords::slot(letter))];
    double scale = modal_.is_inch ? mm_per_inch : 1;
    if (control_.integers_count_increments && word && word->kind == WordKind::Number && !word->has_point &&
        value != 0) {
        if (parameters_.integer_words == IntegerWords::Micrometre) scale *= modal_.is_inch ? 1e-4 : 1e-3;
        warn(notes::ncIntegerWord, word, {{"found", shownWord(*word)}, {"read_as_mm", value * scale}});
    }
    return value * scale;
}

/// P and Q of cycles count micrometres (1e-4 in) where they have no decimal point.
double Interpreter::micro_mm(BlockWords& words, char letter)
{
    const double value = plain(words, letter);
    const Word* const word = words.word[static_cast<std::size_t>(BlockWords::slot(letter))];
    const bool isMicro =
        control_.integers_count_increments && word && word->kind == WordKind::Number && !word->has_point;
    return value * (modal_.is_inch ? mm_per_inch : 1) * (isMicro ? (modal_.is_inch ? 1e-4 : 1e-3) : 1);
}

bool Interpreter::hasAxes(const BlockWords& words) const
{
    return words.has('X') || words.has('Z') || (control_.increments_are_letters && (words.has('U') || words.has('W')));
}

Point Interpreter::target(BlockWords& words)
{
    if (!statedUnit_) {
        statedUnit_ = true;
        assume("unit", modal_.is_inch ? LT_TEXT("Engine", "inch") : LT_TEXT("Engine", "mm"));
    }
    if (!modal_.is_shifted) return statedTarget(words, modal_.at);
    Point to = ofWork(statedTarget(words, ofProgram(modal_.at)));
    if (modal_.frame.isStraight()) {  // an axis without a word stays where it is, to the last bit
        if (!words.has('X') && !words.has('U')) to.x_mm = modal_.at.x_mm;
        if (!words.has('Z') && !words.has('W')) to.z_mm = modal_.at.z_mm;
    }
    return to;
}

/// The end in coordinates that the program states, from `from` in the same ones.
Point Interpreter::statedTarget(BlockWords& words, const Point& from)
{
    Point to = from;
    const auto isIncremental = [&](char letter) {
        const std::uint32_t bit = 1U << BlockWords::slot(letter);
        if ((words.incremental & bit) != 0) return true;
        return modal_.is_incremental && (words.absolute & bit) == 0;
    };
    if (words.has('X')) {
        const bool adds = isIncremental('X');
        const bool isDiameter = modal_.is_diameter && !(adds && modal_.is_diameter_absolute_only);
        const double value = length_mm(words, 'X') / (isDiameter ? 2 : 1);
        if (adds && !isKnown(to.x_mm)) warn(notes::ncPositionUnknown, words.word['X' - 'A']);
        to.x_mm = adds ? to.x_mm + value : value;
        if (!statedDiameter_) {
            statedDiameter_ = true;
            if (control_.start.assumed_diameter.empty()) {
                if (control_.can_state_diameter)
                    assume("diameter_or_radius",
                           modal_.is_diameter ? LT_TEXT("Engine", "diameter") : LT_TEXT("Engine", "radius"));
            } else
                warn(notes::ncAssumed, words.word['X' - 'A'],
                     {{"what", LT_TEXT("Engine", "diameter or radius")}, {"assumed", control_.start.assumed_diameter}});
        }
    }
    if (words.has('Z')) {
        const bool adds = isIncremental('Z');
        const double value = length_mm(words, 'Z');
        if (adds && !isKnown(to.z_mm)) warn(notes::ncPositionUnknown, words.word['Z' - 'A']);
        to.z_mm = adds ? to.z_mm + value : value;
    }
    if (!control_.increments_are_letters) return to;
    for (const auto& [absolute, incremental] : {std::pair{'X', 'U'}, std::pair{'Z', 'W'}}) {
        if (!words.has(incremental)) continue;
        const Word* const word = words.word[static_cast<std::size_t>(incremental - 'A')];
        if (words.has(absolute)) error(errors::ncGroups, word, {{"found", shownWord(*word)}});
        const double value = length_mm(words, incremental);
        double& coordinate = incremental == 'U' ? to.x_mm : to.z_mm;
        const double before = incremental == 'U' ? from.x_mm : from.z_mm;
        if (!isKnown(before) && value != 0) warn(notes::ncPositionUnknown, word);
        coordinate = before + (incremental == 'U' ? value / 2 : value);
    }
    return to;
}

Move Interpreter::filled(MoveKind kind, const Point& to) const
{
    Move move;
    move.line = static_cast<std::int64_t>(pc_) + 1;
    move.kind = kind;
    move.x_mm = to.x_mm;
    move.z_mm = to.z_mm;
    move.tool = modal_.tool;
    if (kind == MoveKind::Feed || kind == MoveKind::Arc)
        (modal_.per_revolution ? move.feed_mm_rev : move.feed_mm_min) = modal_.feed;
    (modal_.is_css ? move.cutting_speed_m_min : move.speed_rpm) = modal_.speed;
    move.speed_limit_rpm = modal_.limit_rpm;
    return move;
}

void Interpreter::emit(MoveKind kind, const Point& to, const Corner& corner, const Point& centre, bool clockwise,
                       double lead)
{
    if (kind == MoveKind::Feed || kind == MoveKind::Arc) {
        if (!(modal_.feed > 0))
            error(errors::ncFeedMissing);
        else if (modal_.feed_is_stale) {
            modal_.feed_is_stale = false;
            warn(notes::ncFeedKept, nullptr, {{"found", modal_.feed}});
        }
        if (!statedFeedMode_) {
            statedFeedMode_ = true;
            if (control_.start.assumed_feed.empty())
                assume("feed", modal_.per_revolution ? LT_TEXT("Engine", "mm/rev") : LT_TEXT("Engine", "mm/min"));
            else
                warn(notes::ncAssumed, nullptr,
                     {{"what", LT_TEXT("Engine", "the kind of feed")}, {"assumed", control_.start.assumed_feed}});
        }
    }
    for (const double coordinate : {to.x_mm, to.z_mm})
        if (std::abs(coordinate) > farthest_mm) {
            const Word& first = program_.words[program_.blocks[pc_].first_word];
            error(errors::ncCoordinate, nullptr,
                  {{"found", shownWord(first)},
                   {"distance_m", std::abs(coordinate) / 1000},
                   {"most_m", farthest_mm / 1000}});
            stop();
            return;
        }
    Move move = filled(kind, to);
    if (kind == MoveKind::Thread) move.feed_mm_rev = lead;
    if (kind == MoveKind::Arc) {
        move.centre_x_mm = centre.x_mm;
        move.centre_z_mm = centre.z_mm;
        move.clockwise = clockwise;
    }
    path_.add(move, modal_.at, corner);
    modal_.at = to;
    result_.blocks[pc_].kind = kind;
    if (corner.kind != CornerKind::None) result_.blocks[pc_].is_shaped = true;
}

void Interpreter::emitCycle(const CycleMoves& moves, double lead)
{
    const std::size_t here = pc_;
    if (moves.size() >= mostCycleMoves)  // the cycle was truncated
        error(errors::ncMoves, nullptr, {{"most", static_cast<std::int64_t>(mostCycleMoves)}});
    result_.blocks[here].is_cycle = true;
    for (const CycleMove& part : moves) {
        if (part.line > 0) pc_ = static_cast<std::size_t>(part.line - 1);
        if (part.kind == MoveKind::Dwell) {
            Move move = filled(MoveKind::Dwell, modal_.at);
            move.dwell_s = part.dwell_s;
            path_.add(move, modal_.at);
        } else {
            const double kept = modal_.feed;
            if (isKnown(part.feed)) modal_.feed = part.feed;
            emit(part.kind, part.to, {}, part.centre, part.clockwise, lead);
            modal_.feed = kept;
        }
        pc_ = here;
        if (result_.moves.size() > mostMoves) return;
    }
}

/// Passes side and radius of the nose to the path builder.
void Interpreter::updateNose()
{
    if (modal_.side == NoseSide::Off || inContour_) {
        path_.setNose(NoseSide::Off, 0, 3);
        return;
    }
    if (isKnown(modal_.nose_radius_mm) && !parameters_.nose_radius_mm)
        return path_.setNose(modal_.side, modal_.nose_radius_mm, modal_.nose_tip);
    const std::optional<Tool> tool = noseTool();
    if (!tool) reportNose();
    path_.setNose(modal_.side, tool ? tool->corner_radius_mm.value_or(0) : 0, tool ? tool->tip : 3);
}

/// The tool in force, as far as its nose is known.
std::optional<Tool> Interpreter::noseTool() const
{
    if (parameters_.nose_radius_mm) return Tool{.tip = parameters_.tip, .corner_radius_mm = parameters_.nose_radius_mm};
    for (const int number : {modal_.offset, modal_.tool})
        if (const auto found = tools_.find(number); found != tools_.end()) return found->second;
    return std::nullopt;
}

void Interpreter::reportNose()
{
    if (!noseUnknown_) {
        noseUnknown_ = {pc_, pc_};
        assume("nose_radius_mm", LT_TEXT("Engine", "0"));
    }
    noseUnknown_->first = std::min(noseUnknown_->first, pc_);
    noseUnknown_->second = std::max(noseUnknown_->second, pc_);
}

/// Does the letter state the time of a dwell in this block, instead of what it states in others?
bool Interpreter::isOfDwell(const BlockWords& words, char letter) const
{
    return words.hasG(G::Dwell) && std::any_of(control_.dwell.begin(), control_.dwell.end(),
                                               [letter](const DwellWord& of) { return of.letter == letter; });
}

void Interpreter::dwell(BlockWords& words)
{
    double seconds = 0;
    for (const DwellWord& of : control_.dwell) {
        if (!words.has(of.letter) || (of.unit == DwellWord::Unit::Revolutions && modal_.is_css)) continue;
        const Word* const word = words.word[static_cast<std::size_t>(BlockWords::slot(of.letter))];
        const bool isWhole = word && word->kind == WordKind::Number && !word->has_point;
        const bool isMilli =
            of.unit == DwellWord::Unit::Milliseconds ||
            (of.unit == DwellWord::Unit::SecondsOrMilli && parameters_.integer_words == IntegerWords::Micrometre);
        seconds = plain(words, of.letter) * (isWhole && isMilli ? 1e-3 : 1);
        if (of.unit == DwellWord::Unit::Revolutions) seconds = 60 * seconds / modal_.speed;
    }
    Move move = filled(MoveKind::Dwell, modal_.at);
    move.dwell_s = seconds;
    path_.add(move, modal_.at);
    result_.blocks[pc_].kind = MoveKind::Dwell;
}

/// G28, G30: by an intermediate point; G53, G74, G75, SUPA: straight to a point of the machine.
void Interpreter::reference(BlockWords& words)
{
    const bool isHome = words.hasG(G::Home);
    const bool all = !hasAxes(words);
    if (isHome && !all) {
        const Point by = target(words);
        emit(MoveKind::Rapid, by);
    } else if (!isHome) {
        for (const char letter : {'X', 'Z', 'U', 'W'}) words.used |= 1U << BlockWords::slot(letter);
    }
    if (!isHome && all && !words.has_axis_point && words.hasG(G::MachineMove)) return;
    Point to = modal_.at;
    if (all || words.has('X') || words.has('U')) to.x_mm = notANumber;
    if (all || words.has('Z') || words.has('W')) to.z_mm = notANumber;
    MoveKind kind = MoveKind::Rapid;
    if (!isHome && words.hasG(G::MachineMove) && modal_.motion == G::Line) kind = MoveKind::Feed;
    if (!isHome && modal_.motion == G::Rapid) kind = MoveKind::Rapid;
    emit(kind, to);
}

/// The lead of threads by F, or by E, which holds until the next F: below 1 it is the lead in inches, which some
/// controls count by it, otherwise the number of turns per inch. A thread has no less than one, and no lead of an inch.
double Interpreter::threadLead_mm(BlockWords& words)
{
    if (words.has('E')) {
        const double stated = plain(words, 'E');
        assume("lead_of_E", stated < 1 ? LT_TEXT("Engine", "inches") : LT_TEXT("Engine", "turns per inch"));
        modal_.thread_lead_mm = !(stated > 0) ? notANumber : stated < 1 ? stated * mm_per_inch : mm_per_inch / stated;
    }
    return isKnown(modal_.thread_lead_mm) ? modal_.thread_lead_mm : modal_.feed;
}

void Interpreter::thread(BlockWords& words)
{
    const bool hasMove = hasAxes(words);
    double lead = modal_.feed;
    if (control_.thread_lead_is_ik) {
        const double along = words.has('K') ? length_mm(words, 'K') : notANumber;
        const double across = words.has('I') ? length_mm(words, 'I') : notANumber;
        lead = isKnown(along) ? along : across;
    } else {
        lead = threadLead_mm(words);
    }
    if (words.has('Q')) plain(words, 'Q');
    if (!hasMove) return;
    const Point to = target(words);
    if (!(lead > 0)) error(errors::ncFeedMissing);
    emit(MoveKind::Thread, to, {}, {}, false, lead);
}

/// Executes all motion of a block.
void Interpreter::move(BlockWords& words)
{
    const Word* blocker = words.blocker;
    bool hasMotion = false;
    for (int i = 0; i < words.g_count; ++i) {
        const auto at = static_cast<std::size_t>(i);
        const G motion = isDrilling(words.g[at]) ? G::Drill : words.g[at];
        switch (motion) {
            case G::Unknown:
            case G::NotModelled: blocker = words.g_word[at]; break;
            case G::MillOn: modal_.milled_by = blocker = words.g_word[at]; break;
            case G::MillOff: modal_.milled_by = nullptr; break;
            case G::Rapid:
            case G::Line:
            case G::ArcCw:
            case G::ArcCcw:
            case G::Thread:
            case G::TurnCycle:
            case G::FaceCycle:
            case G::ThreadCycle:
            case G::Drill:
                if (hasMotion && control_.refuses_conflicts && modal_.motion != motion)
                    error(errors::ncGroups, words.g_word[at], {{"found", shownWord(*words.g_word[at])}});
                hasMotion = true;
                if (modal_.motion != motion) cycleStart_.reset();
                modal_.motion = motion;
                break;
            default: break;
        }
    }
    if (blocker) return leaveOut(words, blocker);
    if (words.frame != Name::Unknown) return takeFrame(words);
    if (words.hasG(G::Dwell)) return dwell(words);
    if (words.hasG(G::MacroCall) && (inContour_ || inFinish_))
        return warn(notes::ncBlockNotModelled, nullptr, {{"found", std::string("G65")}}, GapEffect::Moves);
    if (words.hasG(G::MacroCall)) return callProgram(words, true);
    if (words.hasG(G::Home) || words.hasG(G::FixedPoint) || words.is_machine || (words.hasG(G::MachineMove)))
        return reference(words);
    for (const G which : {G::SpeedLimit, G::SetPosition, G::SetPositionOff, G::SetPositionClear, G::SetPositionBack,
                          G::LocalShift, G::Translate, G::TranslateCoarse, G::TranslateFine})
        if (words.hasG(which)) return takeShift(words, which);
    if (words.hasG(G::SetData)) return setData(words);
    if (const Word* const by = milledBy(words)) return leaveOut(words, by);
    if (!modal_.whole.isStraight() && isCycle(words)) return leaveOut(words, nullptr);
    if (cycle(words)) return;
    if (modal_.motion == G::Thread) return thread(words);
    const bool isArc = modal_.motion == G::ArcCw || modal_.motion == G::ArcCcw || modal_.motion == G::ArcThrough;
    if (modal_.motion == G::Line && !hasAxes(words) && angleOf(words)) return line(words);
    if (!hasAxes(words) && !(isArc && (words.has('I') || words.has('K')))) return;
    if (openLine_ && modal_.motion != G::Line) unclosedLine();
    if (modal_.motion == G::Line) return line(words);
    if (modal_.motion == G::Unknown) {
        if (control_.start.assumed_motion == G::Unknown) return error(errors::ncMotionMissing);
        modal_.motion = control_.start.assumed_motion;
        const bool isLine = modal_.motion == G::Line;
        warn(notes::ncAssumed, nullptr,
             {{"what", LT_TEXT("Engine", "a motion")}, {"assumed", control_.start.assumed_motion_word}});
        assume("motion", control_.start.assumed_motion_word);
        if (isLine) return line(words);
    }
    const Point to = target(words);
    if (isArc) return arc(words, to);
    emit(MoveKind::Rapid, to);
}

}  // namespace lathelier::gcode
