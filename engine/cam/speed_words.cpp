#include "engine/cam/speed_words.h"

#include <algorithm>
#include <cmath>

#include "engine/core/units.h"
#include "engine/stability/speed_choice.h"

namespace lathelier::cam {
namespace {

using Eigen::Vector2d;

constexpr double leastCylinderLeft_mm = 0.1;  // length of a cylinder that keeps its speed
constexpr double liftForSpeed_mm = 0.5;

/// True for a move along a cylinder toward the chuck.
bool isLongitudinal(const CutMove& move, const Vector2d& start)
{
    return move.kind == CutKind::Line && std::abs(move.to.y() - start.y()) < same_mm &&
           move.to.x() > start.x() + same_mm;
}

/// True if the drawing states limits, roughness or a thread for the row at z.
bool hasRequirements(const Shaft& part, double z_mm)
{
    double end = 0;
    for (const ShaftSegment& row : part.segments) {
        end += row.length_mm;
        if (z_mm <= end) return isToleranced(row) || row.Rz_um.has_value();
    }
    return false;
}

/// Position of a section boundary in a path: moves from `first` on lie beyond it; those up to `end` are faces, chamfers
/// and fillets before the next cylinder.
struct Crossing {
    std::size_t first = 0, end = 0;
    double length_mm = 0;  // of these moves
};

std::optional<Crossing> crossingOf(std::vector<CutMove>& moves, double z)
{
    for (std::size_t k = 1; k < moves.size(); ++k) {
        const Vector2d start = moves[k - 1].to;
        if (moves[k].kind == CutKind::Rapid) continue;
        if (!(moves[k].to.x() > z + same_mm || (moves[k].to.x() > z - same_mm && start.x() > z - same_mm))) continue;
        if (isLongitudinal(moves[k], start) && start.x() < z - same_mm) {  // the boundary lies within a cylinder
            CutMove before = moves[k];
            before.to.x() = z;
            moves.insert(moves.begin() + static_cast<std::ptrdiff_t>(k), before);
            ++k;
        }
        Crossing crossing{k, k, 0};
        while (crossing.end < moves.size() && moves[crossing.end].kind != CutKind::Rapid &&
               !isLongitudinal(moves[crossing.end], moves[crossing.end - 1].to)) {
            crossing.length_mm += (moves[crossing.end].to - moves[crossing.end - 1].to).norm();
            ++crossing.end;
        }
        return crossing;
    }
    return {};
}

/// Inserts the speed change before move `k`, early enough to be reached there, but not before the last rapid move.
void setAhead(std::vector<CutMove>& moves, std::size_t k, double ramp_mm, double to_rpm)
{
    double way = 0;
    std::size_t first = k;
    while (first > 1 && way < ramp_mm && moves[first - 1].kind != CutKind::Rapid) {
        --first;
        way += (moves[first].to - moves[first - 1].to).norm();
    }
    if (first < k && way > ramp_mm + leastCylinderLeft_mm && moves[first].kind == CutKind::Line) {
        CutMove before = moves[first];
        const Vector2d start = moves[first - 1].to;
        before.to = start + (before.to - start) * ((way - ramp_mm) / (before.to - start).norm());
        moves.insert(moves.begin() + static_cast<std::ptrdiff_t>(first), before);
        ++first;
    }
    moves[first].speed_rpm = to_rpm;
    moves[first].cutting_speed_m_min.reset();
}

/// Spindle speed of constant cutting speed at a diameter.
double rpmAt(double cutting_speed_m_min, double diameter_mm, double max_rpm)
{
    return std::min(max_rpm, std::floor(stability::spindleSpeed(cutting_speed_m_min, diameter_mm)));
}

double rampOf_mm(double feed_mm_rev, double from_rpm, double to_rpm)
{
    return feed_mm_rev * (from_rpm + to_rpm) / 120 * std::abs(to_rpm - from_rpm) / spindleRamp_rpm_s;
}

/// From constant cutting speed to that of a cylinder that begins at or behind z.
void enterCylinder(std::vector<CutMove>& moves, double z, const SectionSpeed& section)
{
    for (std::size_t k = 1; k < moves.size(); ++k) {
        const Vector2d start = moves[k - 1].to;
        if (!isLongitudinal(moves[k], start) || moves[k].to.x() < z + same_mm) continue;
        const double before = rpmAt(section.constant_m_min, section.diameter_mm, section.max_rpm);
        return setAhead(moves, k, rampOf_mm(moves[k].feed_mm_rev, before, *section.speed_rpm), *section.speed_rpm);
    }
}

/// From a cylinder to constant cutting speed at z.
void enterTaper(std::vector<CutMove>& moves, double z, const SectionSpeed& section)
{
    const std::optional<Crossing> crossing = crossingOf(moves, z);
    if (!crossing) return;
    CutMove& first = moves[crossing->first];
    first.cutting_speed_m_min = section.constant_m_min;
    first.speed_rpm = rpmAt(section.constant_m_min, section.diameter_mm, section.max_rpm);
}

void changeSpeed(std::vector<CutMove>& moves, double from_rpm, double to_rpm, double z, const Shaft& part)
{
    const std::optional<Crossing> crossing = crossingOf(moves, z);
    if (!crossing) return;
    const std::size_t k = crossing->first;
    const double ramp = rampOf_mm(moves[k].feed_mm_rev, from_rpm, to_rpm);
    const double missing = ramp - crossing->length_mm;
    const auto at = [&moves](std::size_t i) { return moves.begin() + static_cast<std::ptrdiff_t>(i); };
    if (missing <= 0 || crossing->end == moves.size()) {
        moves[k].speed_rpm = to_rpm;
        return;
    }
    CutMove& before = moves[k - 1];
    const bool is_cylinder = k >= 2 && isLongitudinal(before, moves[k - 2].to);
    if (is_cylinder && before.to.x() - moves[k - 2].to.x() > missing + leastCylinderLeft_mm &&
        !hasRequirements(part, z)) {
        CutMove first = before;
        first.to.x() -= missing;
        before.speed_rpm = to_rpm;
        moves.insert(at(k - 1), first);
        return;
    }
    // At the largest radius between both cylinders the tool can retract without collision.
    const bool is_end = crossing->end > k && moves[crossing->end - 1].to.y() > before.to.y();
    const std::size_t place = is_end ? crossing->end : k;
    CutMove down = moves[place - 1];
    down.kind = CutKind::Line;
    down.feed_mm_rev = moves[k].feed_mm_rev;
    down.speed_rpm.reset();
    down.cutting_speed_m_min.reset();
    CutMove up = down;
    up.to.y() += std::max(liftForSpeed_mm, missing / 2);
    if (is_end)
        moves[k].speed_rpm = to_rpm;
    else
        up.speed_rpm = to_rpm;
    moves.insert(at(place), {up, down});
}

}  // namespace

void setFinishSpeeds(Operation& finish, const std::vector<SectionSpeed>& sections, const Shaft& part)
{
    const auto is_fixed = [](const SectionSpeed& section) { return section.speed_rpm.has_value(); };
    if (std::none_of(sections.begin(), sections.end(), is_fixed)) return;
    // Faces, and cones before the first cylinder, keep the cutting speed; speeds that the job states hold from the
    // start.
    const bool from_dynamics = sections.front().constant_m_min > 0;
    if (!from_dynamics)
        finish.speed_rpm = sections.front().speed_rpm;
    else if (sections.front().speed_rpm)
        enterCylinder(finish.moves, sections.front().z_start_mm, sections.front());
    for (std::size_t i = 0; i + 1 < sections.size(); ++i) {
        const SectionSpeed &now = sections[i], &next = sections[i + 1];
        if (now.speed_rpm && next.speed_rpm) {
            if (*now.speed_rpm != *next.speed_rpm)
                changeSpeed(finish.moves, *now.speed_rpm, *next.speed_rpm, now.z_end_mm, part);
        } else if (next.speed_rpm) {
            enterCylinder(finish.moves, now.z_end_mm, next);
        } else if (now.speed_rpm) {
            enterTaper(finish.moves, now.z_end_mm, next);
        }
    }
}

}  // namespace lathelier::cam
