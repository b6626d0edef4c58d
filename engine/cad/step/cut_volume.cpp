#include "engine/cad/step/cut_volume.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "engine/shaft/shaft_contour.h"

namespace lathelier::cad {
namespace {

using Eigen::Vector3d;
using Interval = std::pair<double, double>;

constexpr int linesAcross = 256;       ///< in a section
constexpr int sectionsOfStretch = 24;  ///< of a stretch between two edges of the meridian or the cuts
constexpr double oblique_rad = 0.3;    ///< of the lines to the frame; no multiple of an angle in use
constexpr double infinite = std::numeric_limits<double>::infinity();

void cutTo(Interval& at, double low, double high)
{
    at = {std::max(at.first, low), std::min(at.second, high)};
}

void cutBy(Interval& at, const HalfSpace& half, const Vector3d& point, const Vector3d& along)
{
    const double slope = half.normal.dot(along), left = half.distance_mm - half.normal.dot(point);
    if (std::abs(slope) < 1e-12) {
        if (left < 0) at = {0, -1};
    } else if (slope > 0) {
        cutTo(at, -infinite, left / slope);
    } else {
        cutTo(at, left / slope, infinite);
    }
}

void cutBy(Interval& at, const RoundSpace& round, const Vector3d& point, const Vector3d& along)
{
    const Vector3d from = point - round.point_mm;
    const double t0 = from.dot(round.axis), dt = along.dot(round.axis);
    const Vector3d across0 = from - t0 * round.axis, across = along - dt * round.axis;
    const double r0 = round.radius_mm + round.slope * t0, dr = round.slope * dt;
    // |across0 + s across|² <= (r0 + s dr)², and r0 + s dr >= 0
    const double a = across.squaredNorm() - dr * dr, b = across0.dot(across) - r0 * dr,
                 c = across0.squaredNorm() - r0 * r0;
    if (std::abs(dr) > 1e-12)
        dr > 0 ? cutTo(at, -r0 / dr, infinite) : cutTo(at, -infinite, -r0 / dr);
    else if (r0 < 0)
        at = {0, -1};
    if (std::abs(a) < 1e-12) {
        if (std::abs(b) < 1e-12) {
            if (c > 0) at = {0, -1};
        } else {
            b > 0 ? cutTo(at, -infinite, -c / (2 * b)) : cutTo(at, -c / (2 * b), infinite);
        }
        return;
    }
    const double square = b * b - a * c;
    if (square < 0) {
        if (a > 0) at = {0, -1};
        return;
    }
    const double root = std::sqrt(square), low = (-b - root) / a, high = (-b + root) / a;
    if (a > 0)
        cutTo(at, low, high);
    else
        dr > 0 ? cutTo(at, std::max(low, high), infinite) : cutTo(at, -infinite, std::min(low, high));
}

/// Length of the union of intervals within the ring on a line at `off` from the axis.
double lengthWithin(std::vector<Interval> found, const Ring& ring, double off)
{
    const double outer = ring.outer * ring.outer - off * off, inner = ring.inner * ring.inner - off * off;
    if (outer <= 0) return 0;
    const double reach = std::sqrt(outer), hole = inner > 0 ? std::sqrt(inner) : 0;
    std::sort(found.begin(), found.end());
    double sum = 0, done = -infinite;
    for (const Interval& one : found) {
        const double low = std::max(one.first, done), high = one.second;
        if (high <= low) continue;
        done = high;
        for (const Interval& side : {Interval{-reach, -hole}, Interval{hole, reach}})
            sum += std::max(0.0, std::min(high, side.second) - std::max(low, side.first));
    }
    return sum;
}

double sectionArea_mm2(const std::vector<ConvexCut>& cuts, const Ring& ring, double z_mm)
{
    const Vector3d along(std::cos(oblique_rad), std::sin(oblique_rad), 0), side(-along.y(), along.x(), 0);
    double area = 0;
    std::vector<Interval> found;
    for (int i = 0; i < linesAcross; ++i) {
        // Equal steps of the angle: dense where the lines are short.
        const double angle = std::acos(-1.0) * (i + 0.5) / linesAcross, off = -ring.outer * std::cos(angle);
        const Vector3d point = off * side + z_mm * Vector3d::UnitZ();
        found.clear();
        for (const ConvexCut& cut : cuts) {
            Interval at{-infinite, infinite};
            for (const HalfSpace& half : cut.half_spaces) cutBy(at, half, point, along);
            for (const RoundSpace& round : cut.round_spaces) cutBy(at, round, point, along);
            if (at.first < at.second) found.push_back(at);
        }
        if (!found.empty())
            area += lengthWithin(found, ring, off) * ring.outer * std::sin(angle) * std::acos(-1.0) / linesAcross;
    }
    return area;
}

/// Where sections may change their kind: edges of the meridian, and planes across the axis.
std::vector<double> stations(const std::vector<ConvexCut>& cuts, const Contour& contour)
{
    std::vector<double> z;
    for (const ContourPiece& piece : contour) z.insert(z.end(), {piece.from_mm.x(), piece.to_mm.x()});
    const auto [low, high] = std::minmax_element(z.begin(), z.end());
    const double first = *low, last = *high;
    for (const ConvexCut& cut : cuts) {
        for (const HalfSpace& half : cut.half_spaces)
            if (std::abs(std::abs(half.normal.z()) - 1) < 1e-9) z.push_back(half.distance_mm * half.normal.z());
        for (const RoundSpace& round : cut.round_spaces)
            if (std::abs(round.axis.z()) < 1e-9)
                z.insert(z.end(), {round.point_mm.z() - round.radius_mm, round.point_mm.z() + round.radius_mm});
    }
    std::erase_if(z, [&](double at) { return !(at >= first && at <= last); });
    std::sort(z.begin(), z.end());
    return z;
}

}  // namespace

Ring ringAt(const Contour& contour, double z_mm)
{
    Ring ring;
    bool bored = false;
    for (const ContourPiece& piece : contour) {
        if (piece.row == ContourPiece::none) continue;
        const auto [low, high] = std::minmax(piece.from_mm.x(), piece.to_mm.x());
        if (z_mm < low || z_mm > high || high - low <= 0) continue;
        const double radius = piece.radiusAt_mm(z_mm);
        if (piece.bore == ContourPiece::none) {
            ring.outer = std::max(ring.outer, radius);
        } else {
            ring.inner = bored ? std::min(ring.inner, radius) : radius;
            bored = true;
        }
    }
    return ring;
}

double cutVolume_mm3(const std::vector<ConvexCut>& cuts, const Shaft& turned, const Progress& progress)
{
    if (cuts.empty()) return 0;
    const Contour contour = closedContour(turned);
    const std::vector<double> z = stations(cuts, contour);
    double volume = 0;
    for (std::size_t i = 0; i + 1 < z.size(); ++i) {
        const double length = z[i + 1] - z[i];
        if (!(length > 1e-9)) continue;
        for (int k = 0; k < sectionsOfStretch; ++k) {
            progress.check();
            // Equal steps of the angle here too: sections of round cuts begin and end like roots.
            const double angle = std::acos(-1.0) * (k + 0.5) / sectionsOfStretch;
            const double at = z[i] + length * (1 - std::cos(angle)) / 2;
            volume += sectionArea_mm2(cuts, ringAt(contour, at), at) * length / 2 * std::sin(angle) * std::acos(-1.0) /
                      sectionsOfStretch;
        }
    }
    return volume;
}

}  // namespace lathelier::cad
