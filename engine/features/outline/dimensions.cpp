#include "engine/features/outline/dimensions.h"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "engine/core/units.h"
#include "engine/features/outline/outline_limits.h"

namespace lathelier::features {
namespace {

constexpr std::size_t sizeCount = 7;  // z start, z end, start radius, end radius, arc radius, half angle, length

using Sizes = std::array<double, sizeCount>;

Sizes sizesOf(const Run& run, std::size_t k)
{
    const Element& e = run.elements[k];
    const double from = run.nodes_mm[k], to = run.nodes_mm[k + 1];
    // At a pole the root of the arc is ill-conditioned.
    return {from,
            to,
            e.start == Tie::Axis ? 0 : e.radiusAt_mm(from),
            e.end == Tie::Axis ? 0 : e.radiusAt_mm(to),
            e.arc ? e.radius_mm() : 0,
            e.arc ? 0 : std::atan(e.slope) * deg_per_rad,
            to - from};
}

std::vector<Sizes> allSizes(const Model& model)
{
    std::vector<Sizes> all;
    for (const Run& run : model.runs)
        for (std::size_t k = 0; k < run.elements.size(); ++k) all.push_back(sizesOf(run, k));
    return all;
}

/// Standard uncertainties of all sizes.
std::vector<Sizes> sigmas(const Outline& outline)
{
    Model model = outline.model;
    for (Run& run : model.runs) resolve(model, run);
    const std::vector<Sizes> base = allSizes(model);
    const std::size_t count = outline.fit.slots.size();
    std::vector<Eigen::MatrixXd> jacobians(base.size(),
                                           Eigen::MatrixXd::Zero(sizeCount, static_cast<Eigen::Index>(count)));
    for (std::size_t s = 0; s < count; ++s) {
        constexpr double step = dimensionLimits.derivative_step;
        const Model before = model;
        valueOf(model, outline.fit.slots[s]) += step;
        for (Run& run : model.runs) resolve(model, run);
        const std::vector<Sizes> moved = allSizes(model);
        model = before;
        for (std::size_t i = 0; i < base.size(); ++i)
            for (std::size_t q = 0; q < sizeCount; ++q)
                jacobians[i](static_cast<Eigen::Index>(q), static_cast<Eigen::Index>(s)) =
                    (moved[i][q] - base[i][q]) / step;
    }
    std::vector<Sizes> result(base.size());
    for (std::size_t i = 0; i < base.size(); ++i)
        for (std::size_t q = 0; q < sizeCount; ++q) {
            const auto row = jacobians[i].row(static_cast<Eigen::Index>(q));
            result[i][q] = std::sqrt(std::max(0.0, (row * outline.fit.covariance * row.transpose())(0, 0)));
        }
    return result;
}

std::string tiesOf(const Element& e)
{
    if (!e.arc) return {};
    const auto one = [](Tie tie) {
        switch (tie) {
            case Tie::Tangent: return "tangent";
            case Tie::Plane: return "plane";
            case Tie::Axis: return "axis";
            default: return "free";
        }
    };
    const std::string start = one(e.start), end = one(e.end);
    return start == end ? start : start + "-" + end;
}

/// Peak to valley of a polynomial of degree 4 fitted to the residuals, to suppress noise; 0 for a short row, whose form
/// cannot be separated from noise.
double formOf_um(const std::vector<std::array<double, 3>>& left)  // place from -1 to 1, deviation, weight
{
    constexpr int degree = 4;
    if (left.size() < dimensionLimits.least_form_walls) return 0;
    Eigen::Matrix<double, degree + 1, degree + 1> normal = Eigen::Matrix<double, degree + 1, degree + 1>::Zero();
    Eigen::Matrix<double, degree + 1, 1> right = Eigen::Matrix<double, degree + 1, 1>::Zero();
    const auto rowAt = [](double x) {
        Eigen::Matrix<double, degree + 1, 1> row;
        row << 1, x, (3 * x * x - 1) / 2, (5 * x * x - 3) * x / 2, (35 * x * x * x * x - 30 * x * x + 3) / 8;
        return row;
    };
    for (const auto& [x, off, weight] : left) {
        const auto row = rowAt(x);
        normal += weight * row * row.transpose();
        right += weight * off * row;
    }
    const Eigen::Matrix<double, degree + 1, 1> fit = normal.ldlt().solve(right);
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (int k = 0; k <= dimensionLimits.form_samples; ++k) {
        const double value = fit.dot(rowAt(-1 + dimensionLimits.form_step * k));
        low = std::min(low, value);
        high = std::max(high, value);
    }
    return 1e3 * (high - low);
}

/// Residuals of the walls of one element.
void addForm(const Outline& outline, const Run& run, std::size_t k, RecognizedRow& row)
{
    const double from = run.nodes_mm[k], to = run.nodes_mm[k + 1], middle = (from + to) / 2,
                 half = std::max(1e-9, (to - from) / 2);
    double n = 0, squares = 0, weights = 0, sx = 0, sxx = 0, sy = 0, sxy = 0;
    std::vector<std::array<double, 3>> left;
    for (const Wall& wall : run.walls) {
        if (wall.z_mm < from || wall.z_mm > to || !counts(outline.model, run, wall)) continue;
        const double off = wall.r_mm + wall.form_mm - predicted_mm(outline.model, run, wall),
                     x = (wall.z_mm - middle) / half, w = wall.points;
        left.push_back({x, off, w});
        n += 1;
        squares += off * off;
        row.points += static_cast<std::int64_t>(wall.points);
        weights += w;
        sx += w * x;
        sxx += w * x * x;
        sy += w * off;
        sxy += w * x * off;
    }
    if (n > 0) row.residual_um = 1e3 * std::sqrt(squares / n);
    row.form_pv_um = formOf_um(left);
    const double spread = sxx - sx * sx / std::max(1e-300, weights);
    if (n >= dimensionLimits.least_taper_walls && spread > 0) row.taper_um = 2e3 * (sxy - sx * sy / weights) / spread;
}

}  // namespace

double ovalityFactor(double coverage_deg)
{
    const auto& table = dimensionLimits.ovality;
    if (coverage_deg <= table.front().first) return table.front().second;
    for (std::size_t i = 1; i < table.size(); ++i)
        if (coverage_deg <= table[i].first) {
            const auto& [a, fa] = table[i - 1];
            const auto& [b, fb] = table[i];
            return fa + (fb - fa) * (coverage_deg - a) / (b - a);
        }
    return 0;
}

std::vector<RecognizedRow> rowsOf(const Outline& outline, double zero_mm, double coverage_deg,
                                  const AddedUncertainty& added)
{
    const std::vector<Sizes> sigma = sigmas(outline);
    std::vector<RecognizedRow> rows;
    for (const Run& run : outline.model.runs)
        for (std::size_t k = 0; k < run.elements.size(); ++k) {
            const Element& e = run.elements[k];
            const Sizes sizes = sizesOf(run, k);
            RecognizedRow row;
            row.kind = e.arc ? RowKind::Arc : e.cylinder ? RowKind::Cylinder : RowKind::Cone;
            row.z_start_mm = sizes[0] - zero_mm;
            row.z_end_mm = std::max(row.z_start_mm, sizes[1] - zero_mm);
            row.start_diameter_mm = 2 * sizes[2];
            row.end_diameter_mm = e.arc || !e.cylinder ? 2 * sizes[3] : row.start_diameter_mm;
            if (e.arc) row.arc_radius_mm = e.convex ? sizes[4] : -sizes[4];
            row.half_angle_deg = sizes[5];
            row.ties = tiesOf(e);
            row.coverage_deg = coverage_deg;
            if (!e.rough) addForm(outline, run, k, row);
            const Sizes& s = sigma[rows.size()];
            const double common = added.scanner_um, scale = std::sqrt(added.variance_ratio);
            const auto length = [&](double standard) { return std::hypot(2e3 * scale * standard, common); };
            const auto diameter = [&](double standard) {
                const double noise = std::hypot(4e3 * scale * standard, std::hypot(2 * common, added.ovality_um));
                return std::hypot(noise, 4 * added.passes_um);
            };
            row.uncertainty.z_start_um = length(s[0]);
            row.uncertainty.z_end_um = length(s[1]);
            row.uncertainty.length_um = length(s[6]);
            row.uncertainty.start_diameter_um = diameter(s[2]);
            row.uncertainty.end_diameter_um = diameter(e.cylinder ? s[2] : s[3]);
            if (e.rough) {
                row.uncertainty.start_diameter_um = row.uncertainty.end_diameter_um = diameter(e.level_sigma_mm);
                row.role = "rough";
            }
            if (e.arc) row.uncertainty.arc_radius_um = length(s[4]);
            if (!e.arc && !e.cylinder) row.uncertainty.angle_deg = 2 * s[5];
            rows.push_back(row);
        }
    return rows;
}

void addMeridian(const Outline& outline, double zero_mm, bool bore, std::int32_t first_row,
                 std::vector<MeridianPoint>& points)
{
    std::int32_t before = first_row;
    for (const Run& run : outline.model.runs) {
        for (const Wall& wall : run.walls) {
            if (wall.z_mm < run.nodes_mm.front() || wall.z_mm > run.nodes_mm.back()) continue;
            MeridianPoint point;
            point.z_mm = wall.z_mm - zero_mm;
            point.radius_mm = wall.r_mm + wall.form_mm;
            point.sigma_mm = sigmaOf(outline.model, wall);
            point.bore = bore;
            const auto node = std::upper_bound(run.nodes_mm.begin() + 1, run.nodes_mm.end() - 1, wall.z_mm);
            point.row = before + static_cast<std::int32_t>(node - run.nodes_mm.begin()) - 1;
            point.residual_mm = counts(outline.model, run, wall)
                                    ? point.radius_mm - predicted_mm(outline.model, run, wall)
                                    : notANumber;
            points.push_back(point);
        }
        before += static_cast<std::int32_t>(run.elements.size());
    }
}

}  // namespace lathelier::features
