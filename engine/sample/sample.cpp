#include "engine/sample/sample.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "engine/core/parallel.h"
#include "engine/core/random.h"

namespace lathelier::sample {
namespace {

using std::numbers::pi;

/// Streams of random numbers, so that the effects are independent of each other.
enum ScanStream : std::uint64_t { Phase, Noise, Spot, Dropout, Patch, Spurious };

double pieceRadius_mm(const ShaftPiece& piece, double z_mm)
{
    const double t = (z_mm - piece.z_start_mm) / (piece.z_end_mm - piece.z_start_mm);
    double from = piece.barrel_start_mm;
    double to = piece.barrel_end_mm;
    if (from == to) {
        from = piece.z_start_mm;
        to = piece.z_end_mm;
    }
    const double b = (z_mm - from) / (to - from);
    return piece.radius_start_mm + t * (piece.radius_end_mm - piece.radius_start_mm) +
           1e-3 * (piece.oversize_um + piece.taper_start_um + t * (piece.taper_end_um - piece.taper_start_um) +
                   piece.barrel_um * 4 * b * (1 - b));
}

/// The meridian as a polyline (z, r) from the axis over all pieces back to the axis. Curved pieces are cut so finely
/// (0.5 mm) that the barrel of the copy is off by less than 1 nm.
std::vector<Eigen::Vector2d> meridianOf(const ShaftModel& shaft)
{
    std::vector<Eigen::Vector2d> line;
    if (shaft.empty()) return line;
    line.emplace_back(shaft.front().z_start_mm, 0.0);
    for (const ShaftPiece& piece : shaft) {
        const double length = piece.z_end_mm - piece.z_start_mm;
        const int cuts = piece.barrel_um == 0 ? 1 : std::max(1, static_cast<int>(std::ceil(length / 0.5)));
        for (int i = 0; i <= cuts; ++i) {
            const double z = i == cuts ? piece.z_end_mm : piece.z_start_mm + length * i / cuts;
            const Eigen::Vector2d point(z, pieceRadius_mm(piece, z));
            if (point != line.back()) line.push_back(point);
        }
    }
    line.emplace_back(shaft.back().z_end_mm, 0.0);
    return line;
}

/// First hit of a ray with the surface of revolution of one meridian segment, beyond `nearest`; else `nearest`.
double hit(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector3d& o, const Eigen::Vector3d& d,
           double nearest)
{
    if (a.x() == b.x()) {  // a shoulder or end face: a plane
        if (d.z() == 0) return nearest;
        const double t = (a.x() - o.z()) / d.z();
        if (t <= 0 || t >= nearest) return nearest;
        const double r = std::hypot(o.x() + t * d.x(), o.y() + t * d.y());
        return r >= std::min(a.y(), b.y()) && r <= std::max(a.y(), b.y()) ? t : nearest;
    }
    const double slope = (b.y() - a.y()) / (b.x() - a.x());
    const double r0 = a.y() + slope * (o.z() - a.x());  // the cone's radius at the ray's origin
    const double dr = slope * d.z();
    const double qa = d.x() * d.x() + d.y() * d.y() - dr * dr;
    const double qb = o.x() * d.x() + o.y() * d.y() - r0 * dr;
    const double qc = o.x() * o.x() + o.y() * o.y() - r0 * r0;
    const double discriminant = qb * qb - qa * qc;
    if (discriminant < 0) return nearest;
    const double root = std::sqrt(discriminant);
    for (const double t : {(-qb - root) / qa, (-qb + root) / qa}) {
        const double z = o.z() + t * d.z();
        if (t > 0 && t < nearest && z >= std::min(a.x(), b.x()) && z <= std::max(a.x(), b.x()) && r0 + t * dr >= 0)
            nearest = t;
    }
    return nearest;
}

/// The shaft under rays that run nearly across its axis.
class RayCaster {
public:
    explicit RayCaster(const ShaftModel& shaft) : line_(meridianOf(shaft))
    {
        for (const Eigen::Vector2d& p : line_) largest_ = std::max(largest_, p.y());
    }

    /// Distance from the origin along the unit direction, infinite when the ray misses.
    double range_mm(const Eigen::Vector3d& o, const Eigen::Vector3d& d) const
    {
        // Only segments between the heights at which the ray enters the largest cylinder and leaves it can be hit.
        double nearest = std::numeric_limits<double>::infinity();
        const double qa = d.x() * d.x() + d.y() * d.y();
        const double qb = o.x() * d.x() + o.y() * d.y();
        const double discriminant = qb * qb - qa * (o.x() * o.x() + o.y() * o.y() - largest_ * largest_);
        if (discriminant < 0) return nearest;
        const double z1 = o.z() + d.z() * (-qb - std::sqrt(discriminant)) / qa;
        const double z2 = o.z() + d.z() * (-qb + std::sqrt(discriminant)) / qa;
        const double low = std::min(z1, z2);
        const double high = std::max(z1, z2);
        const auto first = std::lower_bound(line_.begin(), line_.end(), low,
                                            [](const Eigen::Vector2d& p, double z) { return p.x() < z; });
        for (auto i = static_cast<std::size_t>(std::max<std::ptrdiff_t>(1, first - line_.begin())); i < line_.size();
             ++i) {
            if (line_[i - 1].x() > high) break;
            nearest = hit(line_[i - 1], line_[i], o, d, nearest);
        }
        return nearest;
    }

    const std::vector<Eigen::Vector2d>& line() const { return line_; }
    double largest_mm() const { return largest_; }

private:
    std::vector<Eigen::Vector2d> line_;
    double largest_ = 0;
};

/// Patches of the scanner's grid without data: together about `share` of it.
std::vector<bool> patches(int rows, int columns, double share, std::uint64_t seed)
{
    const auto width_of = [columns](int row) {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns);
    };
    std::vector<bool> lost(width_of(rows));
    const auto wanted = static_cast<std::size_t>(share * static_cast<double>(lost.size()));
    std::size_t count = 0;
    for (std::uint64_t i = 0; count < wanted; ++i) {
        const int height = 1 + static_cast<int>(rows * 0.08 * randomUniform(seed, Patch, 4 * i));
        const int width = 1 + static_cast<int>(columns * 0.2 * randomUniform(seed, Patch, 4 * i + 1));
        const int row = static_cast<int>(rows * randomUniform(seed, Patch, 4 * i + 2));
        const int column = static_cast<int>(columns * randomUniform(seed, Patch, 4 * i + 3));
        for (int r = row; r < std::min(rows, row + height); ++r)
            for (int c = column; c < column + width; ++c) {
                const std::size_t cell = width_of(r) + static_cast<std::size_t>(c % columns);
                if (!lost[cell] && count < wanted) {
                    lost[cell] = true;
                    ++count;
                }
            }
    }
    return lost;
}

void addSpurious(std::vector<Eigen::Vector3d>& points, double share, std::uint64_t seed)
{
    if (share <= 0 || points.empty()) return;
    Eigen::Vector3d low = points.front();
    Eigen::Vector3d high = low;
    for (const Eigen::Vector3d& p : points) {
        low = low.cwiseMin(p);
        high = high.cwiseMax(p);
    }
    const Eigen::Vector3d middle = (low + high) / 2;
    const Eigen::Vector3d half = (high - low) * 0.65;  // a box 30 % larger than the part
    const auto count = static_cast<std::uint64_t>(share * static_cast<double>(points.size()));
    for (std::uint64_t i = 0; i < count; ++i) {
        Eigen::Vector3d p = middle;
        for (int k = 0; k < 3; ++k)
            p[k] += half[k] * (2 * randomUniform(seed, Spurious, 3 * i + static_cast<unsigned>(k)) - 1);
        points.push_back(p);
    }
}

}  // namespace

ShaftModel nominalShaft()
{
    return {{.z_start_mm = 0, .z_end_mm = 98, .radius_start_mm = 15, .radius_end_mm = 15},
            {.z_start_mm = 98, .z_end_mm = 108, .radius_start_mm = 18.5, .radius_end_mm = 18.5},
            {.z_start_mm = 108, .z_end_mm = 178, .radius_start_mm = 16.9, .radius_end_mm = 16.9},
            {.z_start_mm = 178, .z_end_mm = 183, .radius_start_mm = 16.9, .radius_end_mm = 11.9}};
}

ShaftModel copiedShaft()
{
    ShaftModel shaft = nominalShaft();
    shaft[0].taper_start_um = 30;
    shaft[0].taper_end_um = -30;
    shaft[1].oversize_um = 50;
    shaft[2].barrel_um = 40;
    return shaft;
}

double radius_mm(const ShaftModel& shaft, double z_mm)
{
    double largest = 0;
    for (const ShaftPiece& piece : shaft)
        if (z_mm >= piece.z_start_mm && z_mm <= piece.z_end_mm)
            largest = std::max(largest, pieceRadius_mm(piece, z_mm));
    return largest;
}

Scan scanShaft(const ShaftModel& shaft, const ScannerModel& scanner, const Progress& progress)
{
    const RayCaster caster(shaft);
    const Eigen::Isometry3d part_T_scan = scanner.scan_T_part.inverse();
    const double from = std::max(caster.line().front().x(), scanner.part_z_from_mm);
    const double to = std::min(caster.line().back().x(), scanner.part_z_to_mm);

    // Heights in the scanner's frame that cover the selected stretch of the tilted part.
    const Eigen::Vector3d axis = scanner.scan_T_part.linear().col(2);
    const double margin = caster.largest_mm() * std::hypot(axis.x(), axis.y()) + scanner.spot_mm;
    const double end1 = (scanner.scan_T_part * Eigen::Vector3d(0, 0, from)).z();
    const double end2 = (scanner.scan_T_part * Eigen::Vector3d(0, 0, to)).z();
    const double bottom = std::min(end1, end2) - margin;
    const int rows = static_cast<int>((std::abs(end2 - end1) + 2 * margin) / scanner.row_pitch_mm) + 1;
    const int columns = static_cast<int>(std::lround(360 / scanner.angle_step_deg));
    const double row_phase = randomUniform(scanner.seed, Phase, 0);
    const double angle_phase = randomUniform(scanner.seed, Phase, 1);
    const double away = 2 * (caster.largest_mm() + scanner.scan_T_part.translation().head<2>().norm()) + 1000;
    const std::vector<bool> lost = patches(rows, columns, scanner.dropout_share / 2, scanner.seed);
    const double single_share =
        scanner.dropout_share < 1 ? scanner.dropout_share / 2 / (1 - scanner.dropout_share / 2) : 1;

    std::vector<std::vector<Eigen::Vector3d>> found(static_cast<std::size_t>(rows));
    parallelFor(found.size(), 16, progress, [&](std::size_t begin, std::size_t end) {
        for (std::size_t row = begin; row < end; ++row) {
            const double height = bottom + scanner.row_pitch_mm * (static_cast<double>(row) + row_phase);
            if (height < scanner.scan_z_from_mm || height > scanner.scan_z_to_mm) continue;
            found[row].reserve(static_cast<std::size_t>(columns));
            for (int column = 0; column < columns; ++column) {
                const std::size_t ray = row * static_cast<std::size_t>(columns) + static_cast<std::size_t>(column);
                if (lost[ray]) continue;
                if (single_share > 0 && randomUniform(scanner.seed, Dropout, ray) < single_share) continue;
                const double angle = 2 * pi * (column + angle_phase) / columns;
                const Eigen::Vector3d direction(-std::cos(angle), -std::sin(angle), 0);
                const Eigen::Vector3d origin = Eigen::Vector3d(0, 0, height) - away * direction;
                const double spot = scanner.spot_mm * (randomUniform(scanner.seed, Spot, ray) - 0.5);
                double range = caster.range_mm(part_T_scan * (origin + Eigen::Vector3d(0, 0, spot)),
                                               part_T_scan.linear() * direction);
                if (!std::isfinite(range)) continue;
                range += scanner.sigma_mm * randomNormal(scanner.seed, Noise, ray);
                const Eigen::Vector3d point = origin + range * direction;
                const double z = (part_T_scan * point).z();
                if (z < scanner.part_z_from_mm || z > scanner.part_z_to_mm) continue;
                found[row].push_back(point);
            }
        }
    });
    Scan scan;
    std::size_t total = 0;
    for (const auto& row : found) total += row.size();
    scan.points_mm.reserve(total + static_cast<std::size_t>(scanner.spurious_share * static_cast<double>(total)) + 1);
    for (const auto& row : found) scan.points_mm.insert(scan.points_mm.end(), row.begin(), row.end());
    addSpurious(scan.points_mm, scanner.spurious_share, scanner.seed);
    for (Eigen::Vector3d& p : scan.points_mm) p = scanner.frame_T_scan * p;
    return scan;
}

Scan shaftMesh(const ShaftModel& shaft, int sides)
{
    const std::vector<Eigen::Vector2d> line = meridianOf(shaft);
    Scan mesh;
    std::vector<std::uint32_t> first(line.size());  // of each ring; a ring on the axis is one vertex
    for (std::size_t i = 0; i < line.size(); ++i) {
        first[i] = static_cast<std::uint32_t>(mesh.points_mm.size());
        const int count = line[i].y() > 0 ? sides : 1;
        for (int k = 0; k < count; ++k) {
            const double angle = 2 * pi * k / sides;
            mesh.points_mm.emplace_back(line[i].y() * std::cos(angle), line[i].y() * std::sin(angle), line[i].x());
        }
    }
    for (std::size_t i = 1; i < line.size(); ++i)
        for (int k = 0; k < sides; ++k) {
            const auto now = static_cast<std::uint32_t>(k);
            const auto next = static_cast<std::uint32_t>((k + 1) % sides);
            const bool tip_before = line[i - 1].y() == 0;
            const bool tip_after = line[i].y() == 0;
            const std::uint32_t a = first[i - 1] + (tip_before ? 0 : now);
            const std::uint32_t b = first[i - 1] + (tip_before ? 0 : next);
            const std::uint32_t c = first[i] + (tip_after ? 0 : next);
            const std::uint32_t d = first[i] + (tip_after ? 0 : now);
            if (!tip_before) mesh.triangles.push_back({a, b, c});
            if (!tip_after) mesh.triangles.push_back({a, c, d});
        }
    return mesh;
}

}  // namespace lathelier::sample
