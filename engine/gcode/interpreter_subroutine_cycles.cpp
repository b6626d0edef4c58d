// G70 to G72 over the contour of a subroutine: its words are read, its blocks are not run.
#include <algorithm>
#include <cmath>
#include <iterator>

#include "engine/core/units.h"
#include "engine/gcode/gcode_codes.h"
#include "engine/gcode/interpreter.h"
#include "engine/gcode/roughing_linuxcnc.h"

namespace lathelier::gcode {
namespace {

/// Does it read the position, which the interpreter counts in another way while it reads a contour?
bool readsPosition(std::string_view text)
{
    constexpr std::string_view signs[] = {"_x", "_z", "_X", "_Z", "#54", "#["};
    return std::any_of(std::begin(signs), std::end(signs),
                       [text](std::string_view sign) { return text.find(sign) != std::string_view::npos; });
}

/// Centre of the arc of a radius, the shorter one; none where it does not reach.
std::optional<Point> centreOfContourArc(const Point& from, const Point& to, double radius, bool clockwise)
{
    const double half = distance_mm(from, to) / 2;
    if (!(radius >= half) || !(half > 0)) return std::nullopt;
    return centreOfRadius(from, to, radius, clockwise);
}

}  // namespace

/// Its blocks as pieces in the unit of the program; none: what it holds is not modelled, which is noted.
std::optional<std::vector<Piece>> Interpreter::subroutineContour(std::size_t first, std::size_t last, Point from)
{
    const std::size_t here = pc_;
    std::vector<Piece> contour;
    G motion = G::Unknown;
    bool isStated = false, isModelled = true;
    for (std::size_t b = first; b <= last && isModelled; ++b) {
        const Block& block = program_.blocks[b];
        result_.blocks[b].is_contour = true;
        pc_ = b;
        const auto leave = [&] {
            isModelled = false;
            const Word& place = program_.words[block.first_word];
            warn(notes::ncBlockNotModelled, &place, {{"found", shownWord(place)}}, GapEffect::Moves);
        };
        const Word* const begin = program_.words.data() + block.first_word;
        BlockWords words;
        if (std::any_of(begin, begin + block.word_count,
                        [this](const Word& word) {
                            return word.kind == WordKind::Flow || word.kind == WordKind::Name ||
                                   (word.kind == WordKind::Expression && readsPosition(program_.textOf(word)));
                        }) ||
            block.has_skip || !gather(words) || words.blocker) {
            leave();
            continue;
        }
        isStated = false;
        for (std::size_t i = 0; i < static_cast<std::size_t>(words.g_count); ++i) {
            isModelled = isModelled && words.g[i] >= G::Rapid && words.g[i] <= G::ArcCcw;
            motion = words.g[i];
            isStated = true;
        }
        const bool isArc = motion == G::ArcCw || motion == G::ArcCcw;
        const bool hasAxis = words.has('X') || words.has('Z');
        constexpr std::string_view others = "ABCUVWYHD";
        if (std::any_of(others.begin(), others.end(), [&](char letter) { return words.has(letter); }) ||
            (hasAxis && motion == G::Unknown) || (isArc && hasAxis && !isStated))  // a modal G3 turns as a G2 there
            isModelled = false;
        Piece piece{from, from, {}, motion == G::ArcCw};
        if (words.has('X')) piece.to.x_mm = plain(words, 'X') / (modal_.is_diameter ? 2 : 1);
        if (words.has('Z')) piece.to.z_mm = plain(words, 'Z');
        if (isModelled && piece.to.x_mm == from.x_mm && piece.to.z_mm == from.z_mm) continue;
        if (isArc && words.has('R')) {
            const auto centre = centreOfContourArc(from, piece.to, plain(words, 'R'), piece.clockwise);
            isModelled = isModelled && centre;
            piece.centre = centre.value_or(Point{});
        } else if (isArc) {
            const Point origin = modal_.arc_is_absolute ? Point{0, 0} : from;
            piece.centre = {origin.x_mm + plain(words, 'I'), origin.z_mm + plain(words, 'K')};
            isModelled = isModelled && (words.has('I') || words.has('K')) &&
                         !(modal_.arc_is_absolute && (!words.has('I') || !words.has('K')));
        }
        if (!isModelled) leave();
        contour.push_back(piece);
        from = piece.to;
    }
    pc_ = here;
    return isModelled ? std::optional(contour) : std::nullopt;
}

/// The block of a cycle whose Q names a subroutine.
void Interpreter::subroutineCycle(BlockWords& words, G which)
{
    const auto at = static_cast<std::size_t>(std::find(words.g.begin(), words.g.end(), which) - words.g.begin());
    const Word* const word = words.g_word[at];
    const auto unusable = [&](Text reason) {
        error(errors::ncCycle, word, {{"cycle", shownWord(*word)}, {"reason", reason}});
    };
    const std::string label = named('O', std::lround(std::clamp(plain(words, 'Q', -1), -1.0, 1e9)));
    const auto sub = std::find_if(statements_.begin(), statements_.end(), [&](const FlowStatement& one) {
        return one.keyword == "SUB" && one.label == label && one.block < pc_;
    });
    const auto end =
        std::find_if(sub, statements_.end(), [](const FlowStatement& one) { return one.keyword == "ENDSUB"; });
    SubroutineCycle cycle;
    const double unit_mm = modal_.is_inch ? mm_per_inch : 1;
    const Point now = ofProgram(modal_.at);
    cycle.start = {now.x_mm / unit_mm, now.z_mm / unit_mm};
    if (words.has('X')) cycle.start.x_mm = plain(words, 'X') / (modal_.is_diameter ? 2 : 1);
    if (words.has('Z')) cycle.start.z_mm = plain(words, 'Z');
    cycle.kind = which == G::SubroutineFinish ? SubroutineCycle::Kind::Finish
                 : which == G::SubroutineTurn ? SubroutineCycle::Kind::Turn
                                              : SubroutineCycle::Kind::Face;
    const int of = words.g10[at] % 10;
    cycle.pockets = of == 0   ? SubroutineCycle::Pockets::Cut
                    : of == 1 ? SubroutineCycle::Pockets::LeftOut
                              : SubroutineCycle::Pockets::OnlyThey;
    cycle.distance = plain(words, 'D', cycle.distance);
    cycle.last = plain(words, 'E', cycle.last);
    cycle.depth = plain(words, 'I', cycle.depth);
    cycle.retreat = plain(words, 'R', cycle.retreat);
    if (const double passes = plain(words, 'P', 1); cycle.kind == SubroutineCycle::Kind::Finish)
        cycle.passes = passesOf(passes);
    if (sub == statements_.end() || end == statements_.end())
        return unusable(LT_TEXT("Engine", "the subroutine that Q names is not in the program before it"));
    if (modal_.is_incremental) return unusable(LT_TEXT("Engine", "it needs absolute coordinates (G90)"));
    if (modal_.side != NoseSide::Off && cycle.kind != SubroutineCycle::Kind::Finish)
        return unusable(LT_TEXT("Engine", "nose radius compensation is on"));
    if (!isKnown(cycle.start)) return unusable(LT_TEXT("Engine", "the position where it starts is not known"));
    std::unordered_map<long, double> locals;  // those of the caller hold in the contour
    for (long n = 1; n <= control_.arithmetic.last_local; ++n)
        if (variables_.isSet(n) && variables_.get(n)) locals[n] = *variables_.get(n);
    variables_.enter(std::move(locals));
    const auto contour = subroutineContour(sub->block + 1, end->block - 1, cycle.start);
    variables_.leave();
    const auto leave = [&] {
        warn(notes::ncBlockNotModelled, word, {{"found", shownWord(*word)}}, GapEffect::Moves);
        notUnderstood(word);
        modal_.at = {};
    };
    if (!contour) return leave();
    SubroutineCycleMoves made = gcode::subroutineCycle(cycle, *contour);
    if (made.refused) return unusable(*made.refused);
    if (!made.is_modelled) return leave();
    for (CycleMove& move : made.moves)
        for (Point* point : {&move.to, &move.centre}) *point = ofWork({point->x_mm * unit_mm, point->z_mm * unit_mm});
    emitCycle(made.moves);
    if (made.moves.empty()) return;
    const CycleMove& last = made.moves.back();  // it leaves its last motion in force
    modal_.motion = last.kind == MoveKind::Rapid  ? G::Rapid
                    : last.kind == MoveKind::Feed ? G::Line
                    : last.clockwise              ? G::ArcCw
                                                  : G::ArcCcw;
}

}  // namespace lathelier::gcode
