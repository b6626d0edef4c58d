#include "engine/gcode/contour_sections.h"

#include <algorithm>
#include <cmath>

namespace lathelier::gcode {
namespace {

using Stretches = std::vector<Stretch>;

Stretch straight(const Place& from, const Place& to, std::int64_t line)
{
    Stretch part;
    part.from = from;
    part.to = to;
    part.line = line;
    return part;
}

Stretches reversedAll(const Stretches& parts)
{
    Stretches result;
    result.reserve(parts.size());
    for (auto part = parts.rbegin(); part != parts.rend(); ++part) result.push_back(reversed(*part));
    return result;
}

/// What rises steadily from `level` on, with the pockets that lie below it on the way.
struct Envelope {
    Stretches rising;
    std::vector<Stretches> pockets;
};

Envelope envelopeFrom(double level, const Stretches& parts)
{
    Envelope result;
    Stretches pocket;
    const auto close = [&](const Place& rim) {
        const std::int64_t line = pocket.back().line;
        result.rising.push_back(straight(pocket.front().from, rim, line));
        result.pockets.push_back(std::move(pocket));
        pocket.clear();
    };
    for (const Stretch& part : parts) {
        const bool isBelow = part.to.p < level - sameLevel_mm || (!pocket.empty() && part.to.p <= level);
        if (!pocket.empty() && std::abs(part.to.p - level) <= sameLevel_mm) {  // its rim is the end of a stretch
            pocket.push_back(part);
            close(part.to);
        } else if (isBelow) {
            pocket.push_back(part);
        } else if (!pocket.empty()) {
            Stretch lower = part, upper = part;
            lower.to = upper.from = {level, crossing(part, level)};
            pocket.push_back(lower);
            close(lower.to);
            result.rising.push_back(upper);
        } else {
            result.rising.push_back(part);
        }
        if (pocket.empty()) level = std::max(level, part.to.p);
    }
    if (pocket.empty()) return result;
    const Place last = pocket.back().to, rim{level, last.q};
    pocket.push_back(straight(last, rim, pocket.back().line));
    close(rim);
    return result;
}

/// False: nested too deep.
bool addPocket(const Stretches& pocket, int depth, std::vector<Section>& sections)
{
    if (depth > deepestPockets) return false;
    Section section;
    section.top = pocket.front().from.p;
    std::size_t lowest = 0;
    for (std::size_t i = 0; i < pocket.size(); ++i)
        if (pocket[i].to.p < pocket[lowest].to.p) lowest = i;
    section.bottom = pocket[lowest].to.p;
    const auto middle = pocket.begin() + static_cast<std::ptrdiff_t>(lowest) + 1;
    const Envelope front = envelopeFrom(section.bottom, reversedAll({pocket.begin(), middle}));
    const Envelope back = envelopeFrom(section.bottom, {middle, pocket.end()});
    section.falling = reversedAll(front.rising);
    section.rising = back.rising;
    sections.push_back(std::move(section));
    for (auto inner = front.pockets.rbegin(); inner != front.pockets.rend(); ++inner)
        if (!addPocket(reversedAll(*inner), depth + 1, sections)) return false;
    return std::all_of(back.pockets.begin(), back.pockets.end(),
                       [&](const Stretches& inner) { return addPocket(inner, depth + 1, sections); });
}

/// 1: rises along the cut; -1: falls; 0: constant.
int riseOf(const Stretch& part)
{
    const double rise = part.to.p - part.from.p;
    return std::abs(rise) <= sameLevel_mm ? 0 : rise > 0 ? 1 : -1;
}

Piece pieceOf(const Stretch& part, const LevelAxes& axes)
{
    Piece piece{axes.point(part.from), axes.point(part.to), {}, part.clockwise};
    if (part.radius > 0) piece.centre = axes.point(part.centre);
    return piece;
}

}  // namespace

Stretch reversed(const Stretch& part)
{
    Stretch result = part;
    std::swap(result.from, result.to);
    result.clockwise = !part.clockwise;
    return result;
}

std::vector<Section> sectionsOf(const Stretches& contour)
{
    std::vector<Section> sections;
    if (contour.empty()) return sections;
    const Envelope front = envelopeFrom(contour.front().from.p, contour);
    Section open;
    open.bottom = open.top = contour.front().from.p;
    for (const Stretch& part : front.rising) open.top = std::max(open.top, part.to.p);
    open.rising = front.rising;
    sections.push_back(std::move(open));
    for (const Stretches& pocket : front.pockets)
        if (!addPocket(pocket, 1, sections)) return {};
    return sections;
}

Stretches withAllowance(const Stretches& contour, double depth, double feed, const LevelAxes& axes)
{
    Stretches result = contour;
    const auto moved = [depth](const Place& at, double along) { return Place{at.p + depth, at.q + along}; };
    const auto shiftOf = [feed](const Stretch& part) { return riseOf(part) * feed; };
    for (std::size_t i = 0; i < contour.size(); ++i) {
        const Stretch& part = contour[i];
        const double own = shiftOf(part);
        const bool isFlat = riseOf(part) == 0;
        result[i].from = moved(part.from, isFlat && i > 0 ? shiftOf(contour[i - 1]) : own);
        result[i].to = moved(part.to, isFlat && i + 1 < contour.size() ? shiftOf(contour[i + 1]) : own);
        if (part.radius > 0) result[i].centre = moved(part.centre, own);
    }
    for (std::size_t i = 1; i < contour.size(); ++i) {
        if (feed == 0 || riseOf(contour[i - 1]) * riseOf(contour[i]) >= 0) continue;
        const auto corner = meeting(pieceOf(result[i - 1], axes), pieceOf(result[i], axes), axes.point(result[i].from));
        if (!corner) return {};
        result[i - 1].to = result[i].from = axes.place(*corner);
    }
    for (std::size_t i = 0; i < contour.size(); ++i) {
        const bool isTurned = (result[i].to.q - result[i].from.q) * (contour[i].to.q - contour[i].from.q) < -1e-12;
        if (isTurned || riseOf(result[i]) != riseOf(contour[i])) return {};
    }
    return result;
}

std::vector<ContourPiece> contourOf(const Stretches& stretches, const LevelAxes& axes)
{
    std::vector<ContourPiece> contour;
    if (stretches.empty()) return contour;
    const Point start = axes.point(stretches.front().from);
    contour.push_back({{start, start, {}, false}, true, stretches.front().line});
    for (const Stretch& part : stretches) contour.push_back({pieceOf(part, axes), false, part.line});
    return contour;
}

}  // namespace lathelier::gcode
