#include "engine/shaft/shaft_contour.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/core/units.h"
#include "engine/shaft/shaft_bores.h"

namespace lathelier {
namespace {

using Eigen::Vector2d;
using std::numbers::pi;

constexpr double emptyPiece_mm = 1e-12;  // shorter pieces are left out
constexpr int taperSteps = 20;

Vector2d unitLeft(const Vector2d& direction)
{
    return Vector2d(-direction.y(), direction.x()) / direction.norm();
}

/// Adds a piece unless it has no length.
void add(Contour& contour, const ContourPiece& piece)
{
    if ((piece.to_mm - piece.from_mm).norm() > emptyPiece_mm) contour.push_back(piece);
}

/// Adds a straight piece of no row.
void addFace(Contour& contour, const Vector2d& from, const Vector2d& to, std::ptrdiff_t bore = ContourPiece::none)
{
    add(contour, {from, to, 0, ContourPiece::none, bore});
}

/// Rows along z from `z_mm`, in the sense of `sense`; faces where diameters jump.
template <class Segment>
Contour along(const std::vector<Segment>& rows, double z_mm, double sense, std::ptrdiff_t bore)
{
    Contour contour;
    Vector2d last(0, 0);
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const Segment& row = rows[i];
        const Vector2d from(z_mm, row.start_diameter_mm / 2);
        const Vector2d to(z_mm + sense * row.length_mm, row.end_diameter_mm / 2);
        if (i > 0) addFace(contour, last, from, bore);
        // A row's arc bulges toward larger radii when positive, whichever way the contour runs.
        add(contour, {from, to, sense * row.arc_radius_mm.value_or(0), static_cast<std::ptrdiff_t>(i), bore});
        last = to;
        z_mm = to.x();
    }
    return contour;
}

double lengthOf(const ShaftBore& bore)
{
    double sum = 0;
    for (const BoreSegment& row : bore.segments) sum += row.length_mm;
    return sum;
}

Contour contourOf(const ShaftBore& bore, double length_mm, std::ptrdiff_t number)
{
    const bool free = bore.from == ShaftEnd::Free;
    return along(bore.segments, free ? 0 : length_mm, free ? 1 : -1, number);
}

Shaft withoutRowsThatRunBack(Shaft shaft)
{
    std::vector<ShaftSegment> rows;
    for (const ShaftSegment& row : shaft.segments) {
        if (!(row.length_mm < 0) || rows.empty()) {
            rows.push_back(row);
            continue;
        }
        ShaftSegment& before =
            rows.back();  // shortened to the face; an arc of that radius may not span it, hence a cone
        before.length_mm = std::max(0.0, before.length_mm + row.length_mm);
        before.arc_radius_mm.reset();
    }
    shaft.segments = std::move(rows);
    return shaft;
}

bool isOnArc(const ContourPiece& arc, const Vector2d& point)
{
    const Vector2d from_centre = point - arc.centre_mm();
    const auto [start, end] = arc.arcAngles();
    const double middle = (start + end) / 2, half = std::abs(end - start) / 2;
    double off = std::atan2(from_centre.y(), from_centre.x()) - middle;
    off = std::remainder(off, turn_rad);
    return std::abs(off) <= half + meet_mm / std::abs(arc.arc_radius_mm);
}

bool isOnLine(const ContourPiece& line, const Vector2d& point)
{
    const Vector2d direction = line.to_mm - line.from_mm;
    const double at = (point - line.from_mm).dot(direction) / direction.norm();
    return at >= -meet_mm && at <= direction.norm() + meet_mm;
}

void meetLines(const ContourPiece& a, const ContourPiece& b, std::vector<Vector2d>& found)
{
    const Vector2d u = a.to_mm - a.from_mm, v = b.to_mm - b.from_mm, w = b.from_mm - a.from_mm;
    const double cross = u.x() * v.y() - u.y() * v.x();
    if (std::abs(cross) > 1e-14 * u.norm() * v.norm()) {
        const Vector2d point = a.from_mm + (w.x() * v.y() - w.y() * v.x()) / cross * u;
        if (isOnLine(a, point) && isOnLine(b, point)) found.push_back(point);
        return;
    }
    if (std::abs(w.x() * u.y() - w.y() * u.x()) > meet_mm * u.norm()) return;
    for (const Vector2d& point : {b.from_mm, b.to_mm})
        if (isOnLine(a, point)) found.push_back(point);
    for (const Vector2d& point : {a.from_mm, a.to_mm})
        if (isOnLine(b, point)) found.push_back(point);
}

void meetLineAndArc(const ContourPiece& line, const ContourPiece& arc, std::vector<Vector2d>& found)
{
    const Vector2d u = (line.to_mm - line.from_mm).normalized(), c = arc.centre_mm();
    const Vector2d foot = line.from_mm + u * u.dot(c - line.from_mm);
    const double radius = std::abs(arc.arc_radius_mm), square = radius * radius - (foot - c).squaredNorm();
    if (square < -2 * radius * meet_mm) return;
    const double half = std::sqrt(std::max(0.0, square));
    for (const double side : {-1.0, 1.0}) {
        const Vector2d point = foot + side * half * u;
        if (isOnLine(line, point) && isOnArc(arc, point)) found.push_back(point);
    }
}

void meetArcs(const ContourPiece& a, const ContourPiece& b, std::vector<Vector2d>& found)
{
    const Vector2d ca = a.centre_mm(), cb = b.centre_mm(), between = cb - ca;
    const double ra = std::abs(a.arc_radius_mm), rb = std::abs(b.arc_radius_mm), d = between.norm();
    if (d < meet_mm) {
        if (std::abs(ra - rb) > meet_mm) return;
        for (const Vector2d& point : {b.from_mm, b.to_mm})
            if (isOnArc(a, point)) found.push_back(point);
        return;
    }
    const double at = (d * d + ra * ra - rb * rb) / (2 * d), square = ra * ra - at * at;
    if (square < -2 * ra * meet_mm) return;
    const Vector2d u = between / d, foot = ca + at * u;
    const double half = std::sqrt(std::max(0.0, square));
    for (const double side : {-1.0, 1.0}) {
        const Vector2d point = foot + side * half * Vector2d(-u.y(), u.x());
        if (isOnArc(a, point) && isOnArc(b, point)) found.push_back(point);
    }
}

/// x - sin x, to the last digit for small angles too.
double angleLessSine(double x)
{
    if (x > 0.3) return x - std::sin(x);
    const double q = x * x;
    return x * q / 6 * (1 - q / 20 * (1 - q / 42 * (1 - q / 72 * (1 - q / 110))));
}

}  // namespace

Vector2d ContourPiece::centre_mm() const
{
    const Vector2d chord = to_mm - from_mm;
    const double height = std::sqrt(std::max(0.0, arc_radius_mm * arc_radius_mm - chord.squaredNorm() / 4));
    return (from_mm + to_mm) / 2 - (arc_radius_mm > 0 ? 1 : -1) * height * unitLeft(chord);
}

std::pair<double, double> ContourPiece::arcAngles() const
{
    const Vector2d a = from_mm - centre_mm(), b = to_mm - centre_mm();
    const double start = std::atan2(a.y(), a.x());
    // The angle between the two, exact for half a turn too: its sense is that of the bulge.
    const double turn = std::abs(std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b)));
    return {start, start + (arc_radius_mm > 0 ? -turn : turn)};
}

double ContourPiece::length_mm() const
{
    if (!isArc()) return (to_mm - from_mm).norm();
    const auto [start, end] = arcAngles();
    return std::abs(arc_radius_mm * (end - start));
}

double ContourPiece::radiusAt_mm(double z_mm) const
{
    const double run = to_mm.x() - from_mm.x();
    if (!isArc()) return run != 0 ? from_mm.y() + (to_mm.y() - from_mm.y()) * (z_mm - from_mm.x()) / run : from_mm.y();
    const Vector2d c = centre_mm();
    const double side = (arc_radius_mm > 0) == (run > 0) ? 1 : -1, off = z_mm - c.x();
    return c.y() + side * std::sqrt(std::max(0.0, arc_radius_mm * arc_radius_mm - off * off));
}

double ContourPiece::sweptVolume_mm3() const
{
    const double r0 = from_mm.y(), r1 = to_mm.y();
    if (!isArc()) return pi * (to_mm.x() - from_mm.x()) * (r0 * r0 + r0 * r1 + r1 * r1) / 3;
    // The frustum of the chord, and the segment between chord and arc by the theorem of Pappus. The primitive of r²
    // along the arc would lose the cube of its radius in digits: crowned rollers have radii of many metres.
    const Vector2d chord = to_mm - from_mm;
    const double rho = std::abs(arc_radius_mm);
    const double half_angle = std::asin(std::min(1.0, chord.norm() / (2 * rho)));
    const double excess = angleLessSine(2 * half_angle);
    const double frustum = pi * chord.x() * (r0 * r0 + r0 * r1 + r1 * r1) / 3;
    if (!(excess > 0)) return frustum;
    const double sine = std::sin(half_angle);
    const double area = rho * rho * excess / 2;
    const double above_chord_mm = 4 * rho * sine * sine * sine / (3 * excess) - rho * std::cos(half_angle);
    const double bulge = arc_radius_mm > 0 ? 1 : -1;
    const double centroid_mm = (r0 + r1) / 2 + bulge * above_chord_mm * chord.x() / chord.norm();
    return frustum + bulge * 2 * pi * centroid_mm * area;
}

ContourPiece ContourPiece::reversed() const
{
    return {to_mm, from_mm, -arc_radius_mm, row, bore};
}

Contour outerContour(const Shaft& shaft)
{
    return along(shaft.segments, 0, 1, ContourPiece::none);
}

Contour boreContour(const Shaft& shaft, std::size_t bore)
{
    return contourOf(shaft.bores.at(bore), shaft.length_mm(), static_cast<std::ptrdiff_t>(bore));
}

bool isThrough(const Shaft& shaft, const ShaftBore& bore)
{
    return lengthOf(bore) >= shaft.length_mm() - meet_mm;
}

Contour closedContour(const Shaft& shaft)
{
    const Contour outside = outerContour(shaft);
    if (outside.empty()) return {};
    const double length = shaft.length_mm();
    Contour from_free, from_chuck;  // bores from their mouths to the axis, or to the other end
    bool through = false;
    const std::vector<ShaftBore> bores = boresOf(shaft);
    for (std::size_t i = 0; i < bores.size(); ++i) {
        const auto number = static_cast<std::ptrdiff_t>(i);
        Contour contour = contourOf(bores[i], length, number);
        if (contour.empty()) continue;
        if (isThrough(shaft, bores[i]))
            through = true;
        else
            addFace(contour, contour.back().to_mm, {contour.back().to_mm.x(), 0}, number);
        (bores[i].from == ShaftEnd::Free ? from_free : from_chuck) = std::move(contour);
    }
    const auto backwards = [](const Contour& contour) {
        Contour result;
        for (auto piece = contour.rbegin(); piece != contour.rend(); ++piece) result.push_back(piece->reversed());
        return result;
    };
    if (through && from_free.empty()) {
        from_free = backwards(from_chuck);
        from_chuck.clear();
    } else if (through) {
        from_chuck.clear();
    }
    const Vector2d free_inner = from_free.empty() ? Vector2d(0, 0) : from_free.front().from_mm;
    Vector2d chuck_inner = from_chuck.empty() ? Vector2d(length, 0) : from_chuck.front().from_mm;
    if (through) chuck_inner = from_free.back().to_mm;

    Contour closed;
    addFace(closed, free_inner, outside.front().from_mm);
    closed.insert(closed.end(), outside.begin(), outside.end());
    addFace(closed, outside.back().to_mm, chuck_inner);
    closed.insert(closed.end(), from_chuck.begin(), from_chuck.end());
    const Contour back = backwards(from_free);
    if (!through) addFace(closed, closed.back().to_mm, back.empty() ? Vector2d(0, 0) : back.front().from_mm);
    closed.insert(closed.end(), back.begin(), back.end());
    return closed;
}

double volume_mm3(const Shaft& shaft)
{
    double sum = 0;
    for (const ContourPiece& piece : closedContour(shaft)) sum += piece.sweptVolume_mm3();
    return sum;
}

std::vector<Vector2d> meetingPoints(const ContourPiece& a, const ContourPiece& b)
{
    std::vector<Vector2d> found;
    if (!a.isArc() && !b.isArc())
        meetLines(a, b, found);
    else if (a.isArc() && b.isArc())
        meetArcs(a, b, found);
    else if (a.isArc())
        meetLineAndArc(b, a, found);
    else
        meetLineAndArc(a, b, found);
    return found;
}

Shaft beamView(const Shaft& stated)
{
    const Shaft shaft = withoutRowsThatRunBack(stated);
    Shaft laid = shaft;
    laid.bores.clear();
    if (shaft.bores.empty()) return laid;
    struct Step {
        double from_mm, to_mm, diameter_mm;
    };
    std::vector<Step> steps;
    std::vector<double> cuts;
    for (std::size_t i = 0; i < shaft.bores.size(); ++i)
        for (const ContourPiece& piece : boreContour(shaft, i)) {
            const double run = piece.to_mm.x() - piece.from_mm.x();
            if (run == 0) continue;
            const bool plain = !piece.isArc() && piece.from_mm.y() == piece.to_mm.y();
            const int count = plain ? 1 : taperSteps;
            for (int k = 0; k < count; ++k) {
                const double a = piece.from_mm.x() + run * k / count, b = piece.from_mm.x() + run * (k + 1) / count;
                const double middle = piece.from_mm.x() + run * (k + 0.5) / count;
                steps.push_back({std::min(a, b), std::max(a, b), 2 * piece.radiusAt_mm(middle)});
                cuts.insert(cuts.end(), {a, b});
            }
        }
    std::sort(cuts.begin(), cuts.end());
    const auto boreAt = [&](double z_mm) {
        double largest = 0;
        for (const Step& step : steps)
            if (z_mm > step.from_mm && z_mm < step.to_mm) largest = std::max(largest, step.diameter_mm);
        return largest;
    };
    laid.segments.clear();
    double begin = 0;
    for (const ShaftSegment& row : shaft.segments) {
        const double end = begin + row.length_mm;
        const ContourPiece piece{
            {begin, row.start_diameter_mm / 2}, {end, row.end_diameter_mm / 2}, row.arc_radius_mm.value_or(0), 0};
        double from = begin;
        const auto append = [&](double to) {
            ShaftSegment part = row;
            part.length_mm = to - from;
            if (from > begin) part.start_diameter_mm = 2 * piece.radiusAt_mm(from);
            if (to < end) part.end_diameter_mm = 2 * piece.radiusAt_mm(to);
            part.bore_diameter_mm = boreAt((from + to) / 2);
            laid.segments.push_back(part);
            from = to;
        };
        for (const double cut : cuts)
            if (cut > from + meet_mm && cut < end - meet_mm) append(cut);
        append(end);
        begin = end;
    }
    return laid;
}

}  // namespace lathelier
