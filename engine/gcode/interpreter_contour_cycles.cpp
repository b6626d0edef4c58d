// G70 to G73: cycles over a contour that is programmed behind them.
#include <algorithm>
#include <cmath>

#include "engine/core/units.h"
#include "engine/gcode/gcode_codes.h"
#include "engine/gcode/interpreter.h"

namespace lathelier::gcode {

/// The first of the two blocks of a cycle without the second.
void Interpreter::unclosedCycle()
{
    const std::size_t here = pc_;
    pc_ = *openRough_;
    openRough_.reset();
    error(errors::ncCycle, nullptr,
          {{"cycle", "G71…G73"}, {"reason", LT_TEXT("Engine", "P and Q, which name its contour, follow nowhere")}});
    pc_ = here;
}

/// Passes of a cycle that the program counts; an error where there are too many.
int Interpreter::passesOf(double stated)
{
    if (stated > static_cast<double>(mostPasses))
        error(errors::ncPasses, nullptr,
              {{"found", static_cast<std::int64_t>(std::min(stated, 1e15))}, {"most", mostPasses}});
    return static_cast<int>(std::clamp(stated, 1.0, static_cast<double>(mostPasses)));
}

/// Lines with this block number in the same program.
std::vector<std::int64_t> Interpreter::linesOf(long number) const
{
    std::vector<std::int64_t> lines;
    const auto [begin, end] = sectionOf(pc_);
    if (const auto found = sequences_.find(number); found != sequences_.end())
        for (const std::size_t block : found->second)
            if (block >= begin && block < end) lines.push_back(static_cast<std::int64_t>(block) + 1);
    return lines;
}

/// G70…G73: words of the first block, or the cycle itself.
void Interpreter::contourCycle(BlockWords& words, G which)
{
    indexFlow();
    long number = 0;  // G70 to G73, but for controls that call them otherwise
    for (std::size_t i = 0; i < static_cast<std::size_t>(words.g_count); ++i)
        if (words.g[i] == which) number = words.g10[i] / 10;
    const std::string name = named('G', number);
    const auto unusable = [&](Text reason) { error(errors::ncCycle, nullptr, {{"cycle", name}, {"reason", reason}}); };
    if (inContour_ || inFinish_) return unusable(LT_TEXT("Engine", "it stands within the contour of a cycle"));
    const bool hasContour = words.has('P') && words.has('Q');
    const bool isOneBlock = hasContour && (words.has('D') || words.has('I') || words.has('K') || words.has('R'));
    const double u_mm = words.has('U') ? length_mm(words, 'U') : 0, w_mm = words.has('W') ? length_mm(words, 'W') : 0;
    if (!hasContour) {
        if (words.has('P') || words.has('Q') || which == G::Finish)
            return unusable(LT_TEXT("Engine", "P and Q name its contour"));
        if (openRough_) unclosedCycle();
        openRough_ = pc_;
        if (which == G::Pattern) {
            patternX_mm_ = u_mm;
            patternZ_mm_ = w_mm;
            patternCount_ = passesOf(plain(words, 'R', 1));
        } else {
            roughDepth_mm_ = std::abs(which == G::RoughTurn ? u_mm : w_mm);
            if (words.has('R')) roughRetreat_mm_ = std::abs(length_mm(words, 'R'));
        }
        return;
    }
    openRough_.reset();
    if (isOneBlock && which == G::Pattern) {
        patternCount_ = passesOf(plain(words, 'D', 1));
        if (words.has('I')) patternX_mm_ = length_mm(words, 'I');
        if (words.has('K')) patternZ_mm_ = length_mm(words, 'K');
    } else if (isOneBlock) {
        if (words.has('D')) roughDepth_mm_ = std::abs(micro_mm(words, 'D'));
        for (const char letter : {'I', 'K', 'R'})
            if (words.has(letter)) plain(words, letter);
    }
    const long p = std::lround(plain(words, 'P')), q = std::lround(plain(words, 'Q'));
    const auto first = findSequence(p, pc_), last = findSequence(q, pc_);
    if (!first || !last || *last < *first) {
        const long missing = !first ? p : q;
        error(errors::ncSequence, words.word[static_cast<std::size_t>((!first ? 'P' : 'Q') - 'A')],
              {{"found", named('N', missing)}});
        return;
    }
    for (const long sequence : {p, q}) {
        const std::vector<std::int64_t> lines = linesOf(sequence);
        if (lines.size() < 2) continue;
        return error(errors::ncSequenceTwice, nullptr,
                     {{"found", named('N', sequence)}, {"first", lines[0]}, {"second", lines[1]}});
    }
    const Point start = modal_.at;
    if (which == G::Finish) {
        finishContour(*first, *last);
        return;
    }
    const std::vector<ContourPiece> contour = collect(*first, *last);
    const bool follows =
        *first > pc_ &&
        std::all_of(program_.blocks.begin() + static_cast<std::ptrdiff_t>(pc_) + 1,
                    program_.blocks.begin() + static_cast<std::ptrdiff_t>(*first), [this](const Block& block) {
                        return block.word_count == 0 ||
                               (block.word_count == 1 && program_.words[block.first_word].kind == WordKind::Comment);
                    });
    if (follows) next_ = *last + 1;
    if (!isKnown(start)) return unusable(LT_TEXT("Engine", "the position where it starts is not known"));
    if (contour.size() < 2) return unusable(LT_TEXT("Engine", "its contour has fewer than two moves"));
    CycleMoves moves;
    if (which == G::Pattern) {
        moves = pattern(start, contour, {patternX_mm_, patternZ_mm_, u_mm / 2, w_mm, patternCount_});
    } else {
        Roughing rough;
        rough.is_face = which == G::RoughFace;
        if (!(roughDepth_mm_ > 0)) return unusable(LT_TEXT("Engine", "the depth of its passes is missing"));
        rough.depth_mm = roughDepth_mm_;
        rough.retreat_mm = roughRetreat_mm_;
        rough.allowance_x_mm = u_mm / 2;
        rough.allowance_z_mm = w_mm;
        if (const auto reach = reachesBeyond(start, contour, rough))
            warn(notes::ncCycleStartsInside, nullptr, {{"start_mm", start.x_mm}, {"reach_mm", *reach}});
        moves = roughing(start, contour, rough);
    }
    emitCycle(moves);
}

/// The moves of the contour as programmed; the modal state is restored.
std::vector<ContourPiece> Interpreter::collect(std::size_t first, std::size_t last)
{
    const Modal kept = modal_;
    const std::size_t here = pc_, next = next_;
    path_.finish();
    std::vector<Move> moves;
    std::vector<Move> outer = std::move(result_.moves);
    result_.moves.clear();
    path_ = PathBuilder(moves);
    inContour_ = true;
    if (!(modal_.feed > 0)) modal_.feed = 1;  // placeholder: the feed of the cycle applies
    for (std::size_t b = first; b <= last && !stopped_; ++b) {
        execute(b);
        result_.blocks[b].is_contour = true;
    }
    path_.finish();
    drainProblems();
    inContour_ = false;
    path_ = PathBuilder(result_.moves);
    result_.moves = std::move(outer);
    modal_ = kept;
    pc_ = here;
    next_ = next;
    std::vector<ContourPiece> contour;
    contour.reserve(moves.size());
    Point from = kept.at;
    for (const Move& move : moves) {
        if (move.kind == MoveKind::Dwell) continue;
        const Point to{move.x_mm, move.z_mm};
        if (!isKnown(to)) continue;
        contour.push_back({{from, to, {move.centre_x_mm, move.centre_z_mm}, move.clockwise},
                           move.kind == MoveKind::Rapid,
                           move.line});
        from = to;
    }
    return contour;
}

/// G70: the contour as it is programmed, then back to its start.
void Interpreter::finishContour(std::size_t first, std::size_t last)
{
    const Point start = modal_.at;
    const std::size_t here = pc_, next = next_;
    inFinish_ = true;
    for (std::size_t b = first; b <= last && !stopped_; ++b) {
        execute(b);
        result_.blocks[b].is_contour = true;
    }
    inFinish_ = false;
    pc_ = last;
    modal_.motion = G::Rapid;
    if (modal_.at.x_mm != start.x_mm || modal_.at.z_mm != start.z_mm) {
        const MoveKind kind = result_.blocks[last].kind;
        emit(MoveKind::Rapid, start);
        result_.blocks[last].kind = kind;
    }
    pc_ = here;
    next_ = next;
}

}  // namespace lathelier::gcode
