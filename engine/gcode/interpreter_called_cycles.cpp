// Programs and cycles that are called by their names, CYCLE95("CONTOUR", 2, ...), also modally. What a cycle does is
// left out, as a gap, wherever the guide of the control leaves it open and it could change what is left on the part.
#include <algorithm>
#include <cmath>

#include "engine/core/units.h"
#include "engine/gcode/flow_text.h"
#include "engine/gcode/gcode_codes.h"
#include "engine/gcode/grooving.h"
#include "engine/gcode/interpreter.h"
#include "engine/gcode/stock_removal.h"
#include "engine/gcode/thread_turning.h"

namespace lathelier::gcode {
namespace {

/// NAME of "/_N_SPF_DIR/_N_NAME_SPF", "NAME.SPF" and "NAME", in capitals.
std::string programOf(const std::string& path)
{
    const std::string all = capitals(path);
    std::string_view name = all;
    if (const std::size_t slash = name.rfind('/'); slash != std::string_view::npos) name.remove_prefix(slash + 1);
    if (name.starts_with("_N_")) name.remove_prefix(3);
    for (const char* ending : {"_SPF", "_MPF", ".SPF", ".MPF"})
        if (name.ends_with(ending)) name.remove_suffix(4);
    return std::string(name);
}

/// A length without a value is the 1 mm that these cycles take instead.
double clearanceOf(double stated_mm)
{
    return stated_mm > 0 ? stated_mm : 1;
}

/// A rounding, or, negative, a chamfer.
GrooveEdge edgeOf(double stated, double unit, double leg)
{
    return {std::max(-stated * leg, 0.0), std::max(stated * unit, 0.0)};
}

double feedOf(double stated, double unit)
{
    return stated > 0 ? stated * unit : notANumber;
}

/// The arguments of CYCLE95. `kind`: 1-4 roughing, 5-8 finishing, 9-12 both; odd: longitudinal; the second pair of
/// four: inside.
StockRemoval stockRemovalOf(const CycleArguments& given, int kind, double unit, double feedUnit)
{
    StockRemoval cut;
    cut.roughs = kind < 5 || kind > 8;
    cut.finishes = kind > 4;
    cut.is_face = kind % 2 == 0;
    cut.is_outward = (kind - 1) % 4 >= 2;
    cut.depth_mm = given.number(1) * unit;
    const double along_mm = (given.number(2) + given.number(4)) * unit;
    const double across_mm = (given.number(3) + given.number(4)) * unit;
    cut.allowance_depth_mm = cut.is_face ? along_mm : across_mm;
    cut.allowance_feed_mm = cut.is_face ? across_mm : along_mm;
    cut.retreat_mm = clearanceOf(given.number(11) * unit);
    cut.chip_mm = given.number(10) * unit;
    cut.dwell_s = given.number(9);
    cut.feed_rough = feedOf(given.number(5), feedUnit);
    cut.feed_enter = feedOf(given.number(6), feedUnit);
    cut.feed_finish = feedOf(given.number(7), feedUnit);
    return cut;
}

}  // namespace

/// Calls of a block, and what is called behind every block that moves.
void Interpreter::takeCalls(BlockWords& words)
{
    const bool hasLetter = control_.call_letter != 0 && words.has(control_.call_letter);
    const Word* const word = words.called ? words.called
                             : hasLetter  ? words.word[static_cast<std::size_t>(BlockWords::slot(control_.call_letter))]
                                          : nullptr;
    if (word && (inContour_ || inFinish_))
        return warn(notes::ncBlockNotModelled, word, {{"found", shownWord(*word)}}, GapEffect::Moves);
    const long repeats = words.called || hasLetter ? std::clamp(std::lround(plain(words, 'P', 1)), 1L, 9999L) : 1;
    if (words.is_modal_call) {
        modalCall_.reset();
        if (word && !words.blocker) modalCall_ = ModalCall{word, repeats, calls_.size(), 0};
        return;
    }
    if (word) return runCalled(*word, repeats);
    const bool moves = hasAxes(words) && !words.blocker && words.frame == Name::Unknown && !words.hasG(G::Dwell);
    if (moves && modalCall_ && !inContour_ && !inFinish_) callModally();
}

/// Behind a block that moves. What a modal call does in programs that are called meanwhile is a gap.
void Interpreter::callModally()
{
    ModalCall& modal = *modalCall_;
    if (modal.running > 0) return;  // within what is called
    const auto isProgram = [](const CallFrame& frame) { return frame.last == std::string::npos; };
    if (calls_.size() < modal.depth ||
        std::any_of(calls_.begin() + static_cast<std::ptrdiff_t>(modal.depth), calls_.end(), isProgram))
        return warn(notes::ncBlockNotModelled, nullptr, {{"found", shownWord(*modal.word)}}, GapEffect::Moves);
    const std::size_t before = calls_.size();
    runCalled(*modal.word, modal.repeats);
    if (calls_.size() > before) modal.running = calls_.size();
}

void Interpreter::runCalled(const Word& word, long repeats)
{
    const std::string_view text = program_.textOf(word);
    const Name meaning = meaningOfName(control_, text);
    if (word.letter != 0 || !isCalledCycle(meaning) || program_.names.contains(nameOf(text)))
        return callByName(word, repeats);
    if (!modal_.whole.isStraight() || modal_.milled_by || modal_.plane_by || modal_.side != NoseSide::Off)
        return leaveCycleOut(word);
    try {
        const CycleArguments given(text, variables_);
        if (!given.unknown().empty()) {
            warn(notes::ncVariableUnset, nullptr, {{"found", given.unknown()}}, GapEffect::Moves);
            return leaveCycleOut(word);
        }
        if (meaning == Name::StockRemoval) stockRemovalCycle(word, given);
        if (meaning == Name::ThreadTurning) threadTurningCycle(word, given);
        if (meaning == Name::Grooving) groovingCycle(word, given);
    } catch (const ExpressionFailure& failure) {
        error(errors::ncExpression, nullptr, {{"found", shownWord(word)}, {"reason", failure.reason}});
    }
}

/// Its moves are missing, and where it ends is not known.
void Interpreter::leaveCycleOut(const Word& word)
{
    const Block& block = program_.blocks[pc_];
    const bool isHere = word.begin >= block.begin && word.begin < block.begin + block.length;  // else called modally
    notUnderstood(&word);
    warn(notes::ncBlockNotModelled, isHere ? &word : nullptr, {{"found", shownWord(word)}}, GapEffect::Moves);
    modal_.at = {};
}

/// The blocks of the contour "NAME", a program of the file, or "FROM:TO", between two labels. None: reported.
std::optional<std::pair<std::size_t, std::size_t>> Interpreter::contourNamed(const Word& word, const std::string& name)
{
    if (const std::size_t colon = name.find(':'); colon != std::string::npos) {
        const std::string labels[] = {name.substr(0, colon), name.substr(colon + 1)};
        const auto first = labelled(labels[0]), last = labelled(labels[1]);
        if (first && last && *first <= *last) return std::pair{*first, *last};
        error(errors::ncSequence, nullptr, {{"found", labels[first ? 1 : 0]}});
        return std::nullopt;
    }
    const std::string wanted = programOf(name);
    const std::optional<std::size_t> start = programNamed(wanted);
    if (!start) {
        callMissing(&word, wanted);
        return std::nullopt;
    }
    std::size_t first = *start;
    const std::size_t end = sectionOf(first).second;
    for (std::size_t b = first; b < end; ++b) {
        const FlowStatement* const at = statementOf(b);
        if (at && at->keyword == "PROC") first = b + 1;
        if (at && at->keyword == "RET") return std::pair{first, std::max(b, first + 1) - 1};
        const Block& block = program_.blocks[b];
        for (std::uint32_t i = 0; i < block.word_count; ++i) {
            const Word& one = program_.words[block.first_word + i];
            if (one.letter != 'M' || one.kind != WordKind::Number) continue;
            const M meaning = meaningOfM(control_, static_cast<int>(std::clamp(one.value, -1.0, 1e6)));
            if (meaning == M::End || meaning == M::EndOrReturn) return std::pair{first, b};
        }
    }
    return std::pair{first, std::max(end, first + 1) - 1};
}

/// The moves of these blocks, without those of no length. Empty: the blocks do something else too, or where the contour
/// starts is not known.
std::vector<ContourPiece> Interpreter::contourBetween(std::size_t first, std::size_t last)
{
    bool isStarted = isKnown(modal_.at);
    for (std::size_t b = first; b <= last; ++b) {
        const Block& block = program_.blocks[b];
        bool hasX = false, hasZ = false;
        for (std::uint32_t i = 0; i < block.word_count; ++i) {
            const Word& word = program_.words[block.first_word + i];
            hasX = hasX || word.letter == 'X';
            hasZ = hasZ || word.letter == 'Z';
            const G meaning =
                word.letter == 'G' && word.kind == WordKind::Number
                    ? meaningOfG(control_, static_cast<int>(std::lround(std::clamp(word.value, -1.0, 1e6) * 10)))
                    : G::Unknown;
            if (meaning == G::NoseLeft || meaning == G::NoseRight) return {};
        }
        if (!isStarted && hasX != hasZ) return {};
        isStarted = isStarted || hasX;
    }
    endsNothing_ = true;
    std::vector<ContourPiece> all = collect(first, last);
    endsNothing_ = false;
    std::vector<ContourPiece> contour;
    for (const ContourPiece& part : all)
        if (contour.empty() || part.piece.isArc() || distance_mm(part.piece.from, part.piece.to) > 1e-9)
            contour.push_back(part);
    return contour;
}

/// CYCLE95: contour, depth of a pass, allowances along Z, along X and of the contour, feeds of roughing, into pockets
/// and of finishing, kind, dwell and length between two dwells, retreat. Lengths across the axis count the radius.
void Interpreter::stockRemovalCycle(const Word& word, const CycleArguments& given)
{
    const auto unusable = [&](Text reason) {
        error(errors::ncCycle, nullptr, {{"cycle", nameOf(program_.textOf(word))}, {"reason", reason}});
    };
    const auto vari = static_cast<int>(std::lround(std::clamp(given.number(8), -1.0, 1000.0)));
    const int kind = vari > 200 ? vari - 200 : vari;
    if (kind < 1 || kind > 12)
        return unusable(LT_TEXT("Engine", "its kind of machining is none of 1 to 12 and 201 to 212"));
    StockRemoval cut =
        stockRemovalOf(given, kind, modal_.is_inch ? mm_per_inch : 1, modal_.inch_feed ? mm_per_inch : 1);
    if (cut.roughs && !(cut.depth_mm > 0)) return unusable(LT_TEXT("Engine", "the depth of its passes is missing"));
    if (given.text(0).empty()) return unusable(LT_TEXT("Engine", "the name of its contour is missing"));
    if (given.isNegative({2, 3, 4, 5, 6, 7, 9, 10, 11}) || given.hasMore(12)) return leaveCycleOut(word);
    const auto blocks = contourNamed(word, given.text(0));
    if (!blocks) return;
    // Does a move in the block of the second label belong to the contour? The guide does not say.
    const Block& end = program_.blocks[blocks->second];
    const bool isOpen =
        given.text(0).find(':') != std::string::npos && (program_.wordOf(end, 'X') || program_.wordOf(end, 'Z'));
    const std::vector<ContourPiece> contour =
        isOpen ? std::vector<ContourPiece>{} : contourBetween(blocks->first, blocks->second);
    if (contour.empty()) return leaveCycleOut(word);
    if (contour.size() < 2) return unusable(LT_TEXT("Engine", "its contour has fewer than two moves"));
    // Along the contour or in both axes: the guide says both, and on slopes they differ.
    if (cut.roughs && given.number(4) > 0 && hasSlopes(contour)) return leaveCycleOut(word);
    if ((cut.roughs && !isKnown(cut.feed_rough)) || (cut.finishes && !isKnown(cut.feed_finish)))
        assume("feed_of_cycle", LT_TEXT("Engine", "the feed in force"));
    if (cut.roughs && given.number(3) + given.number(4) > 0 && modal_.is_diameter)
        assume("allowance_across", LT_TEXT("Engine", "on radius"));
    if (const std::optional<Tool> tool = noseTool()) {
        cut.nose_radius_mm = tool->corner_radius_mm.value_or(0);
        cut.nose_tip = tool->tip;
        if (cut.nose_radius_mm > 0)
            assume("nose_compensation_in_cycle", LT_TEXT("Engine", "on, in roughing and in finishing"));
    } else {
        reportNose();
    }
    const StockRemovalMoves made = stockRemoval(contour, cut, mostPasses);
    if (made.problem == StockRemovalProblem::Passes)
        return error(errors::ncPasses, nullptr,
                     {{"found", static_cast<std::int64_t>(std::min(made.passes, 1e15))}, {"most", mostPasses}});
    if (made.problem != StockRemovalProblem::None) return leaveCycleOut(word);
    emitCycle(made.moves);
}

/// CYCLE97: pitch or size of the thread, start and end along Z, their diameters, run-in, run-out, depth, allowance,
/// angle of the infeed, angle of the start, roughing and idle passes, kind (1, 2 even passes, 3, 4 degressive; even
/// numbers: inside), number of starts, clearance.
void Interpreter::threadTurningCycle(const Word& word, const CycleArguments& given)
{
    const auto unusable = [&](Text reason) {
        error(errors::ncCycle, nullptr, {{"cycle", nameOf(program_.textOf(word))}, {"reason", reason}});
    };
    const double unit = modal_.is_inch ? mm_per_inch : 1;
    const auto kind = static_cast<int>(std::lround(std::clamp(given.number(14), -1.0, 1e6)));
    if (kind < 1 || kind > 4) return unusable(LT_TEXT("Engine", "its kind of machining is none of 1 to 4"));
    double lead_mm = given.number(0) * unit;
    const double size_mm = given.number(1);
    const double coarse_mm = coarsePitch_mm(size_mm);
    if (size_mm != 0 && coarse_mm == 0) return leaveCycleOut(word);
    if (lead_mm == 0) lead_mm = coarse_mm;
    if (!(lead_mm > 0) || (size_mm != 0 && std::abs(lead_mm - coarse_mm) > 1e-9))
        return unusable(LT_TEXT("Engine", "it states no pitch, or two that differ"));
    ThreadTurning cut;
    cut.from = ofWork({given.number(4) * unit / 2, given.number(2) * unit});
    cut.to = ofWork({given.number(5) * unit / 2, given.number(3) * unit});
    cut.is_inner = kind % 2 == 0;
    cut.is_degressive = kind > 2;
    cut.run_in_mm = given.number(6) * unit;
    cut.run_out_mm = given.number(7) * unit;
    cut.depth_mm = given.number(8) * unit;
    cut.allowance_mm = given.number(9) * unit;
    cut.angle_deg = given.number(10);
    cut.clearance_mm = clearanceOf(given.number(16) * unit);
    if (!(cut.depth_mm > 0)) return unusable(LT_TEXT("Engine", "the depth of the thread is missing"));
    const double counts[] = {given.number(12), given.number(13), std::max(given.number(15), 1.0)};
    // On a steep cone the thread is one of a face, which advances along X.
    const bool isFace = std::abs(cut.to.x_mm - cut.from.x_mm) > std::abs(cut.to.z_mm - cut.from.z_mm);
    if (!modal_.is_diameter || isFace || cut.from.z_mm == cut.to.z_mm || counts[0] < 1 || counts[1] < 0 ||
        given.isNegative({6, 7, 9, 11, 16}) || cut.allowance_mm >= cut.depth_mm || std::abs(cut.angle_deg) >= 60 ||
        given.hasMore(17))
        return leaveCycleOut(word);
    const double most = static_cast<double>(mostPasses);
    if (const double passes = (counts[0] + counts[1]) * counts[2]; passes > most)
        return error(errors::ncPasses, nullptr,
                     {{"found", static_cast<std::int64_t>(std::min(passes, 1e15))}, {"most", mostPasses}});
    cut.roughs = static_cast<int>(std::lround(counts[0]));
    cut.idles = static_cast<int>(std::lround(counts[1]));
    cut.starts = static_cast<int>(std::lround(counts[2]));
    emitCycle(threadTurning(cut), lead_mm);
}

/// CYCLE93: diameter and place of its start, width, depth, angle of the surface, of the walls, corners outside and
/// inside, allowances of bottom and walls, infeed, dwell, kind (odd: across the axis; 3, 4, 7, 8: inside; 1 to 4: from
/// the smaller Z; above 10: chamfers by their legs), retreat. Modelled: straight walls in a cylinder, sharp corners
/// inside.
void Interpreter::groovingCycle(const Word& word, const CycleArguments& given)
{
    const auto unusable = [&](Text reason) {
        error(errors::ncCycle, nullptr, {{"cycle", nameOf(program_.textOf(word))}, {"reason", reason}});
    };
    const auto vari = static_cast<int>(std::lround(std::clamp(given.number(15), -1.0, 1e6)));
    const int kind = vari > 10 ? vari - 10 : vari;
    if (kind < 1 || kind > 8)
        return unusable(LT_TEXT("Engine", "its kind of machining is none of 1 to 8 and 11 to 18"));
    const double unit = modal_.is_inch ? mm_per_inch : 1;
    const double width_mm = given.number(2) * unit;
    Grooving cut;
    cut.depth_mm = given.number(3) * unit;
    if (!(width_mm > 0) || !(cut.depth_mm > 0))
        return unusable(LT_TEXT("Engine", "the width or the depth of the groove is missing"));
    bool isPlain = kind % 2 == 1;
    for (const std::size_t at : {4U, 5U, 6U, 9U, 10U}) isPlain = isPlain && given.number(at) == 0;
    const std::optional<Tool> tool = noseTool();
    cut.is_inner = (kind - 1) % 4 >= 2;
    cut.is_far_corner = tool && tool->tip == (cut.is_inner ? 1 : 4);
    const bool isBlade = tool && tool->kind == ToolKind::Blade && tool->width_mm &&
                         (cut.is_far_corner || tool->tip == (cut.is_inner ? 2 : 3));
    if (!isPlain || !isBlade || !modal_.is_diameter || given.isNegative({0, 11, 12, 13, 14, 16}) || given.hasMore(18))
        return leaveCycleOut(word);
    const Point start = ofWork({given.number(0) * unit / 2, given.number(1) * unit});
    cut.surface_mm = start.x_mm;
    cut.is_from_far = kind > 4;
    cut.near_z_mm = cut.is_from_far ? start.z_mm - width_mm : start.z_mm;
    cut.far_z_mm = cut.near_z_mm + width_mm;
    cut.allowance_bottom_mm = given.number(11) * unit;
    cut.allowance_wall_mm = given.number(12) * unit;
    cut.infeed_mm = given.number(13) * unit;
    const double leg = vari > 10 ? unit : unit / std::sqrt(2.0);  // chamfers by their legs, or by their length
    (cut.is_from_far ? cut.far_edge : cut.near_edge) = edgeOf(given.number(7), unit, leg);
    (cut.is_from_far ? cut.near_edge : cut.far_edge) = edgeOf(given.number(8), unit, leg);
    cut.dwell_s = given.number(14);
    cut.retreat_mm = clearanceOf(given.number(16) * unit);
    cut.blade_mm = *tool->width_mm;
    cut.corner_mm = tool->corner_radius_mm.value_or(0);
    if (cut.allowance_bottom_mm >= cut.depth_mm) return leaveCycleOut(word);
    const std::int64_t cuts = cutsOf(cut);
    if (cuts == 0) return unusable(LT_TEXT("Engine", "the blade is wider than the groove"));
    const double pecks = cut.infeed_mm > 0 ? std::ceil(cut.depth_mm / cut.infeed_mm) : 1;
    if (const double passes = static_cast<double>(cuts) * pecks; passes > static_cast<double>(mostPasses))
        return error(errors::ncPasses, nullptr,
                     {{"found", static_cast<std::int64_t>(std::min(passes, 1e15))}, {"most", mostPasses}});
    const CycleMoves moves = grooving(cut);
    if (moves.empty()) return leaveCycleOut(word);
    emitCycle(moves);
}

}  // namespace lathelier::gcode
