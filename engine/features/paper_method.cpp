#include "engine/features/paper_method.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>

namespace lathelier::features {
namespace {

/// Limits of the published method; those of its sections are parameters (RecognitionParameters).
struct PaperLimits {
    double chamfer_drop_mm = 0.15;         ///< below the step's radius, as published
    std::size_t least_step_sections = 3;   ///< as published
    double least_chamfer_sections = 2.5;   ///< one or two sections are a chamfer or a shoulder within them
    std::size_t least_section_points = 8;  ///< of a circle
    double most_sections = 1e6;            ///< bounds the memory
    std::size_t check_sections = 64;       ///< Progress::check() after so many
    double least_row_mm = 1e-6;
};

constexpr PaperLimits paperLimits;

struct Section {
    double z_mm, x_mm, y_mm, radius_mm;
};

/// x² + y² = Ax + By + C by least squares.
std::optional<Section> sectionThrough(const std::vector<Eigen::Vector2d>& points, double z_mm)
{
    if (points.size() < paperLimits.least_section_points) return std::nullopt;
    Eigen::Vector2d mean = Eigen::Vector2d::Zero();
    for (const Eigen::Vector2d& p : points) mean += p / static_cast<double>(points.size());
    Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
    Eigen::Vector3d right = Eigen::Vector3d::Zero();
    for (const Eigen::Vector2d& p : points) {
        const Eigen::Vector3d row(p.x() - mean.x(), p.y() - mean.y(), 1);
        normal += row * row.transpose();
        right += row * (p - mean).squaredNorm();
    }
    const Eigen::Vector3d abc = normal.ldlt().solve(right);
    const double square = (abc[0] * abc[0] + abc[1] * abc[1] + 4 * abc[2]) / 4;
    if (!(square > 0)) return std::nullopt;
    return Section{z_mm, mean.x() + abc[0] / 2, mean.y() + abc[1] / 2, std::sqrt(square)};
}

/// Least-squares line through the centres.
Eigen::Vector3d centreLineThrough(const std::vector<Section>& sections)
{
    double n = 0, sz = 0, szz = 0;
    Eigen::Vector2d s = Eigen::Vector2d::Zero(), szc = Eigen::Vector2d::Zero();
    for (const Section& one : sections) {
        n += 1;
        sz += one.z_mm;
        szz += one.z_mm * one.z_mm;
        s += Eigen::Vector2d(one.x_mm, one.y_mm);
        szc += one.z_mm * Eigen::Vector2d(one.x_mm, one.y_mm);
    }
    const double spread = szz - sz * sz / std::max(1.0, n);
    if (!(spread > 0)) return Eigen::Vector3d::UnitZ();
    const Eigen::Vector2d slope = (szc - sz * s / n) / spread;
    return Eigen::Vector3d(slope.x(), slope.y(), 1).normalized();
}

/// The coordinate along which the sections lie, and the two across it.
struct SectionFrame {
    Eigen::Index along = 0, across = 1, up = 2;
    double sense = 1;  ///< of z along the coordinate

    explicit SectionFrame(const Eigen::Vector3d& direction)
    {
        direction.cwiseAbs().maxCoeff(&along);
        across = (along + 1) % 3;
        up = (along + 2) % 3;
        sense = direction[along] < 0 ? -1 : 1;
    }
};

/// Circles in sections of the width of a band; z from the first point. None: no points, or too many sections.
std::optional<std::vector<Section>> sectionsOf(const std::vector<Eigen::Vector3d>& points, const SectionFrame& frame,
                                               double width, double pitch, const Progress& progress)
{
    double first = std::numeric_limits<double>::infinity(), last = -first;
    for (const Eigen::Vector3d& p : points) {
        first = std::min(first, frame.sense * p[frame.along]);
        last = std::max(last, frame.sense * p[frame.along]);
    }
    if (points.empty() || (last - first) / pitch > paperLimits.most_sections) return std::nullopt;
    const auto count = static_cast<std::size_t>((last - first) / pitch) + 1;
    std::vector<std::vector<Eigen::Vector2d>> bands(count);
    for (const Eigen::Vector3d& p : points) {
        const double place = (frame.sense * p[frame.along] - first) / pitch;
        const auto band = std::min(count - 1, static_cast<std::size_t>(place));
        if ((place - static_cast<double>(band)) * pitch < width) bands[band].emplace_back(p[frame.across], p[frame.up]);
    }
    std::vector<Section> sections;
    for (std::size_t i = 0; i < count; ++i) {
        if (i % paperLimits.check_sections == 0) progress.check();
        if (const auto section = sectionThrough(bands[i], (static_cast<double>(i)) * pitch + width / 2))
            sections.push_back(*section);
    }
    return sections;
}

/// Sections of like radius as steps.
std::vector<ShaftStep> stepsOf(const std::vector<Section>& sections, double zero, double width,
                               const RecognitionParameters& parameters)
{
    std::vector<ShaftStep> steps;
    for (std::size_t i = 0; i < sections.size();) {
        std::size_t end = i + 1;
        while (end < sections.size()) {
            const double other =
                parameters.compare_with == CompareWith::Previous ? sections[end - 1].radius_mm : sections[i].radius_mm;
            if (std::abs(sections[end].radius_mm - other) > parameters.radial_tolerance_mm) break;
            ++end;
        }
        if (end - i >= paperLimits.least_step_sections) {
            ShaftStep step;
            for (std::size_t k = i; k < end; ++k) {
                const double n = static_cast<double>(end - i);
                step.x_mm += sections[k].x_mm / n;
                step.y_mm += sections[k].y_mm / n;
                step.radius_mm += sections[k].radius_mm / n;
            }
            step.sections = static_cast<std::int64_t>(end - i);
            step.z_start_mm = sections[i].z_mm - width / 2 - zero;
            step.z_end_mm = sections[end - 1].z_mm + width / 2 - zero;
            steps.push_back(step);
        }
        i = end;
    }
    return steps;
}

/// Dropped sections beside a step and below its radius form its chamfer.
void addChamfers(std::vector<ShaftStep>& steps, const std::vector<Section>& sections, double zero, double width,
                 double pitch)
{
    for (std::size_t s = 0; s < steps.size(); ++s) {
        ShaftStep& step = steps[s];
        const double before = s > 0 ? steps[s - 1].z_end_mm : -1,
                     after = s + 1 < steps.size() ? steps[s + 1].z_start_mm : std::numeric_limits<double>::infinity();
        const double start = step.z_start_mm, end = step.z_end_mm;
        for (const Section& section : sections) {
            const double z = section.z_mm - zero;
            if (step.radius_mm - section.radius_mm < paperLimits.chamfer_drop_mm) continue;
            if (z > before && z < start) step.z_start_mm = std::min(step.z_start_mm, z - width / 2);
            if (z > end && z < after) step.z_end_mm = std::max(step.z_end_mm, z + width / 2);
        }
        step.chamfer_start_mm = start - step.z_start_mm;
        step.chamfer_end_mm = step.z_end_mm - end;
        const double least = paperLimits.least_chamfer_sections * pitch;
        if (step.chamfer_start_mm < least) step.chamfer_start_mm = 0;
        if (step.chamfer_end_mm < least) step.chamfer_end_mm = 0;
    }
}

}  // namespace

PaperResult paperSteps(const std::vector<Eigen::Vector3d>& points, const Eigen::Vector3d& direction,
                       const RecognitionParameters& parameters, const Progress& progress)
{
    const double width = parameters.band_width_mm, pitch = width * 100 / parameters.coverage_percent;
    const SectionFrame frame(direction);
    const auto sections = sectionsOf(points, frame, width, pitch, progress);
    PaperResult result;
    if (!sections) return result;
    const Eigen::Vector3d axis = centreLineThrough(*sections);
    result.axis = Eigen::Vector3d::Zero();
    result.axis[frame.across] = axis.x();
    result.axis[frame.up] = axis.y();
    result.axis[frame.along] = frame.sense * axis.z();
    const double zero = sections->empty() ? 0 : sections->front().z_mm - width / 2;
    result.steps = stepsOf(*sections, zero, width, parameters);
    addChamfers(result.steps, *sections, zero, width, pitch);
    return result;
}

Shaft shaftOf(const std::vector<ShaftStep>& steps)
{
    Shaft shaft;
    double z = 0;
    for (std::size_t i = 0; i < steps.size(); ++i) {
        const ShaftStep& step = steps[i];
        const double end = i + 1 < steps.size() ? (step.z_end_mm + steps[i + 1].z_start_mm) / 2 : step.z_end_mm;
        const auto add = [&](double length, double d0, double d1, const char* role) {
            if (length > paperLimits.least_row_mm) shaft.segments.push_back({length, d0, d1, 0, {}, role});
        };
        const double d = 2 * step.radius_mm, a = std::min(step.chamfer_start_mm, end - z),
                     b = std::min(step.chamfer_end_mm, end - z - a);
        add(a, std::max(0.0, d - 2 * a), d, "chamfer");
        add(end - z - a - b, d, d, "");
        add(b, d, std::max(0.0, d - 2 * b), "chamfer");
        z = end;
    }
    return shaft;
}

}  // namespace lathelier::features
