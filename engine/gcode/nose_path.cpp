#include "engine/gcode/nose_path.h"

namespace lathelier::gcode {

std::optional<std::vector<ContourPiece>> nosePath(const std::vector<ContourPiece>& contour, NoseSide side,
                                                  double radius_mm, int tip)
{
    if (!(radius_mm > 0)) return contour;
    std::vector<Move> moves;
    PathBuilder path(moves);
    path.setNose(side, radius_mm, tip);
    const Piece& first = contour[1].piece;
    const Direction d = directionAtStart(first);
    Point from{first.from.x_mm - d.x, first.from.z_mm - d.z};
    const auto add = [&](const Point& to, const Piece* arc, std::int64_t line) {
        Move move;
        move.line = line;
        move.kind = arc ? MoveKind::Arc : MoveKind::Feed;
        move.x_mm = to.x_mm;
        move.z_mm = to.z_mm;
        if (arc) {
            move.centre_x_mm = arc->centre.x_mm;
            move.centre_z_mm = arc->centre.z_mm;
            move.clockwise = arc->clockwise;
        }
        path.add(move, from);
        from = to;
    };
    add(first.from, nullptr, contour.front().line);
    for (std::size_t i = 1; i < contour.size(); ++i)
        add(contour[i].piece.to, contour[i].piece.isArc() ? &contour[i].piece : nullptr, contour[i].line);
    path.finish();
    if (!path.problems.empty() || moves.size() < 2) return std::nullopt;
    std::vector<ContourPiece> result;
    Point at{moves.front().x_mm, moves.front().z_mm};
    for (std::size_t i = 0; i < moves.size(); ++i) {
        const Move& move = moves[i];
        const Point to{move.x_mm, move.z_mm};
        result.push_back({{at, to, {move.centre_x_mm, move.centre_z_mm}, move.clockwise}, i == 0, move.line});
        at = to;
    }
    return result;
}

}  // namespace lathelier::gcode
