#include "engine/features/stretches/prism_fit.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "engine/core/statistics.h"
#include "engine/core/units.h"
#include "engine/features/stretches/stretch_limits.h"

namespace lathelier::features {
namespace {

using Eigen::Matrix4d;
using Eigen::Vector4d;

/// Medians of the radius by sectors; NaN where nothing is seen.
std::vector<double> sectorMedians(const StretchPoints& points)
{
    const std::size_t count = stretchProof.profile_sectors;
    std::vector<std::vector<double>> radii(count);
    for (std::size_t i = 0; i < points.size(); ++i)
        radii[std::min(count - 1, static_cast<std::size_t>(points.turn[i] * static_cast<double>(count)))].push_back(
            points.r_mm[i]);
    std::vector<double> medians(count, std::numeric_limits<double>::quiet_NaN());
    for (std::size_t s = 0; s < count; ++s)
        if (!radii[s].empty()) medians[s] = upperMedianInPlace(radii[s]);
    return medians;
}

double sectorTurn(std::size_t s)
{
    return (static_cast<double>(s) + 0.5) / static_cast<double>(stretchProof.profile_sectors);
}

/// The polygon of so many faces that most sectors near the middle of a face agree with.
SectionShape startingPrism(const std::vector<double>& medians, std::size_t faces, double limit_mm)
{
    SectionShape best, shape;
    shape.count = best.count = faces;
    const double half = std::numbers::pi / static_cast<double>(faces);
    double least = std::numeric_limits<double>::infinity();
    for (double deg = 0; deg < 360.0 / static_cast<double>(faces); deg += stretchProof.phase_step_deg) {
        shape.phase_turn = deg / 360;
        std::vector<double> heights;
        for (std::size_t s = 0; s < medians.size(); ++s) {
            const double angle = shape.faceAngle(sectorTurn(s));
            if (std::isnan(medians[s]) || std::abs(angle) > stretchProof.flat_share * half) continue;
            heights.push_back(medians[s] * std::cos(angle));
        }
        if (heights.empty()) continue;
        std::vector<double> sorted = heights;
        shape.face_mm = upperMedianInPlace(sorted);
        double cost = 0;
        for (const double h : heights) cost += std::min(3 * limit_mm, std::abs(h - shape.face_mm));
        cost /= static_cast<double>(heights.size());
        if (cost < least) {
            least = cost;
            best = shape;
        }
    }
    return best;
}

/// Direction, distance of the faces and centre from the points on faces; false where the centre is off the axis.
bool refinePrism(const StretchPoints& points, SectionShape& shape)
{
    const double half = std::numbers::pi / static_cast<double>(shape.count), limit = 2 * points.onShape_mm();
    Eigen::Vector2d centre{0, 0};
    for (int round = 0; round < stretchProof.rounds; ++round) {
        Matrix4d normal = Matrix4d::Identity() * 1e-9;
        Vector4d right = Vector4d::Zero();
        for (std::size_t i = 0; i < points.size(); ++i) {
            const double angle = shape.faceAngle(points.turn[i]);
            if (std::abs(angle) > stretchProof.flat_share * half) continue;
            const double normal_rad = turn_rad * points.turn[i] - angle;
            const Eigen::Vector2d out(std::cos(normal_rad), std::sin(normal_rad));
            const double off = points.r_mm[i] * std::cos(angle) - shape.face_mm - centre.dot(out);
            const double weight = tukeyWeight(off / (2 * limit));
            const Vector4d row(1, -points.r_mm[i] * std::sin(angle), out.x(), out.y());
            normal += weight * row * row.transpose();
            right += weight * off * row;
        }
        const Vector4d step = normal.ldlt().solve(right);
        if (!step.allFinite()) return false;
        shape.face_mm += step[0];
        shape.phase_turn += step[1] / turn_rad;
        centre += step.tail<2>();
        if (step.norm() < stretchProof.settled_mm) break;
    }
    shape.centre_mm = centre;
    return centre.norm() < stretchProof.most_centre_mm && shape.face_mm > 0;
}

/// Sum of the distances of the sectors from faces that a circle of this radius cuts.
double misfitOfCorners(const std::vector<double>& medians, const SectionShape& shape, double level_mm)
{
    double sum = 0;
    for (std::size_t s = 0; s < medians.size(); ++s)
        if (!std::isnan(medians[s]))
            sum += std::abs(medians[s] - std::min(level_mm, shape.face_mm / std::cos(shape.faceAngle(sectorTurn(s)))));
    return sum;
}

/// Radius of the circle over the corners: that which cuts them, or through them.
void placeCorners(const std::vector<double>& medians, SectionShape& shape)
{
    const double sharp = shape.face_mm / std::cos(std::numbers::pi / static_cast<double>(shape.count)),
                 step = (sharp - shape.face_mm) / stretchProof.corner_steps;
    double least = std::numeric_limits<double>::infinity();
    for (int k = 0; k < stretchProof.corner_steps; ++k) {
        const double level = sharp - step * k, misfit = misfitOfCorners(medians, shape, level);
        if (misfit >= least) continue;
        least = misfit;
        shape.level_mm = level;
    }
    std::vector<double> cut;
    for (std::size_t s = 0; s < medians.size(); ++s)
        if (!std::isnan(medians[s]) &&
            shape.face_mm / std::cos(shape.faceAngle(sectorTurn(s))) > shape.level_mm + 2 * step)
            cut.push_back(medians[s]);
    if (cut.size() >= stretchProof.least_corner_sectors)
        shape.level_mm = upperMedianInPlace(cut);
    else if (shape.level_mm > sharp - stretchProof.sharp_mm)
        shape.level_mm = sharp;
}

/// Distances of the single faces; none where one is not seen, is off, or too little of the section is a face.
std::optional<std::vector<double>> prismFaces(const StretchPoints& points, const SectionShape& shape)
{
    std::vector<std::vector<double>> heights(shape.count);
    const double edge = std::acos(std::min(1.0, shape.face_mm / shape.level_mm));
    double n = 0, on = 0, squares = 0, flat = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const double angle = shape.faceAngle(points.turn[i]), normal_rad = turn_rad * points.turn[i] - angle;
        const Eigen::Vector2d out(std::cos(normal_rad), std::sin(normal_rad));
        const bool is_flat = std::abs(angle) < edge;
        const double height = points.r_mm[i] * std::cos(angle) - shape.centre_mm.dot(out);
        const double off = is_flat ? height - shape.face_mm : points.r_mm[i] - shape.level_mm;
        n += 1;
        if (std::abs(off) > points.onShape_mm()) continue;
        on += 1;
        squares += off * off;
        if (!is_flat) continue;
        flat += 1;
        const double face = normal_rad / turn_rad - shape.phase_turn;
        const auto index =
            static_cast<std::size_t>(std::lround((face - std::floor(face)) * static_cast<double>(shape.count)));
        heights[index % shape.count].push_back(height);
    }
    if (on < stretchProof.least_on_share * n || flat < stretchProof.least_flat_share * n ||
        std::sqrt(squares / std::max(1.0, on)) > points.largestRms_mm())
        return std::nullopt;
    std::vector<double> faces;
    for (std::vector<double>& own : heights) {
        if (own.size() < stretchProof.least_face_points) return std::nullopt;
        const double u = points.sigma_mm / std::sqrt(static_cast<double>(own.size()));
        faces.push_back(upperMedianInPlace(own));
        if (std::abs(faces.back() - shape.face_mm) > stretchProof.face_mm + stretchProof.face_sigmas * u)
            return std::nullopt;
    }
    return faces;
}

/// Are the faces as far from the axis in each part along z?
bool isStraightAlong(const StretchPoints& points, const SectionShape& shape)
{
    const auto [low, high] = std::minmax_element(points.z_mm.begin(), points.z_mm.end());
    const double first = *low, length = std::max(1e-9, *high - *low);
    const auto parts = static_cast<double>(stretchProof.z_parts);
    std::vector<std::vector<double>> heights(stretchProof.z_parts), turns(stretchProof.z_parts);
    const double half = stretchProof.flat_share * std::numbers::pi / static_cast<double>(shape.count);
    for (std::size_t i = 0; i < points.size(); ++i) {
        const double angle = shape.faceAngle(points.turn[i]);
        const double off = points.r_mm[i] * std::cos(angle) - shape.face_mm;
        if (std::abs(angle) > half) continue;
        const auto part =
            std::min(stretchProof.z_parts - 1, static_cast<std::size_t>(parts * (points.z_mm[i] - first) / length));
        heights[part].push_back(off);
        if (std::abs(angle) > half / 2) turns[part].push_back(off * (angle > 0 ? 1 : -1));
    }
    for (std::size_t part = 0; part < stretchProof.z_parts; ++part)
        for (std::vector<double>* offs : {&heights[part], &turns[part]}) {
            if (offs->empty()) return false;
            const double u = 2 * points.sigma_mm / std::sqrt(static_cast<double>(offs->size()));
            if (std::abs(upperMedianInPlace(*offs)) > stretchProof.drift_sigmas * u + stretchProof.drift_mm)
                return false;
        }
    return true;
}

double standardDeviation(const std::vector<double>& values)
{
    double sum = 0, squares = 0;
    for (const double v : values) sum += v / static_cast<double>(values.size());
    for (const double v : values) squares += (v - sum) * (v - sum);
    return std::sqrt(squares / static_cast<double>(values.size() - 1));
}

}  // namespace

std::optional<FoundShape> prismOf(const StretchPoints& points)
{
    const std::vector<double> medians = sectorMedians(points);
    for (const std::size_t faces : {std::size_t{6}, std::size_t{4}}) {
        SectionShape shape = startingPrism(medians, faces, points.onShape_mm());
        shape.kind = faces == 6 ? MarkKind::Hexagon : MarkKind::Square;
        if (!refinePrism(points, shape)) continue;
        placeCorners(medians, shape);
        const auto distances = prismFaces(points, shape);
        if (!distances || !isStraightAlong(points, shape)) continue;
        std::vector<double> across;
        for (std::size_t k = 0; k < faces / 2; ++k) across.push_back((*distances)[k] + (*distances)[k + faces / 2]);
        double mean = 0;
        for (const double one : across) mean += one / static_cast<double>(across.size());
        const double spread = standardDeviation(across),
                     own = points.sigma_mm *
                           std::sqrt(stretchProof.dependent_points / static_cast<double>(points.size()));
        FoundShape found{shape, {}};
        found.mark.kind = shape.kind;
        found.mark.across_flats_mm = mean;
        found.mark.angle_deg = markAngle_deg(
            shape.phase_turn - std::floor(shape.phase_turn * static_cast<double>(faces)) / static_cast<double>(faces));
        found.mark.diameter_mm = 2 * shape.level_mm;
        found.mark.uncertainty_mm = 2 * std::sqrt(spread * spread / static_cast<double>(across.size()) + 4 * own * own +
                                                  stretchProof.form_mm * stretchProof.form_mm);
        return found;
    }
    return std::nullopt;
}

}  // namespace lathelier::features
