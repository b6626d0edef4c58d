#include "engine/trajectory/longitudinal.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "engine/core/core_codes.h"
#include "engine/core/units.h"
#include "engine/form/cylinder/cylindricity.h"
#include "engine/form/cylinder/straightness.h"
#include "engine/trajectory/trajectory_codes.h"

namespace lathelier::trajectory {
namespace {

constexpr std::size_t fewestSections = 3;

/// Largest minus smallest residual of the values about their least-squares line.
double straightnessOf(const std::vector<double>& z_mm, const std::vector<double>& values)
{
    const auto n = static_cast<Eigen::Index>(z_mm.size());
    Eigen::MatrixX2d line(n, 2);
    line.col(0).setOnes();
    line.col(1) = Eigen::Map<const Eigen::VectorXd>(z_mm.data(), n);
    line.col(1).array() -= line.col(1).mean();
    const Eigen::Map<const Eigen::VectorXd> y(values.data(), n);
    const Eigen::VectorXd centred = y.array() - y.mean();
    const Eigen::VectorXd residual = centred - line * line.colPivHouseholderQr().solve(centred);
    return residual.maxCoeff() - residual.minCoeff();
}

}  // namespace

std::array<double, 3> fitParabola(const std::vector<double>& z_mm, const std::vector<double>& values)
{
    const auto [from, to] = std::minmax_element(z_mm.begin(), z_mm.end());
    const auto n = static_cast<Eigen::Index>(z_mm.size());
    Eigen::MatrixX3d base(n, 3);
    for (Eigen::Index i = 0; i < n; ++i) {
        const double u = (2 * z_mm[static_cast<std::size_t>(i)] - *from - *to) / (*to - *from);
        base.row(i) = Eigen::RowVector3d(1, u, u * u);
    }
    const Eigen::Map<const Eigen::VectorXd> y(values.data(), n);
    const double mean = y.mean();  // subtracted first: the deviations are a millionth of the radius
    const Eigen::Vector3d c = base.colPivHouseholderQr().solve(Eigen::VectorXd(y.array() - mean));
    return {c[0] + mean, c[1], c[2]};
}

std::optional<LongitudinalSection> longitudinalSection(const std::vector<TrajectorySection>& sections, Notes& notes,
                                                       const Progress& progress)
{
    LongitudinalSection result;
    std::vector<Eigen::Vector3d> axis_mm;
    std::vector<Eigen::Vector3d> surface_mm;
    for (const TrajectorySection& section : sections) {
        if (!std::isfinite(section.z_mm)) continue;
        const form::FittedCircle& circle = section.roundness.circles.LSCI;
        result.z_mm.push_back(section.z_mm);
        result.radius_mm.push_back(circle.radius_mm);
        result.centre_um.push_back(1e3 * circle.centre_mm);
        axis_mm.emplace_back(circle.centre_mm.x(), circle.centre_mm.y(), section.z_mm);
        for (const Eigen::Vector2d& point : section.roundness.evaluated_mm)
            surface_mm.emplace_back(point.x(), point.y(), section.z_mm);
    }
    std::vector<double> places = result.z_mm;
    std::sort(places.begin(), places.end());
    places.erase(std::unique(places.begin(), places.end()), places.end());
    if (result.z_mm.size() < sections.size()) {
        notes.push_back(
            {notes::zUnknown, {{"count", static_cast<std::int64_t>(sections.size() - result.z_mm.size())}}});
        return std::nullopt;
    }
    if (places.size() < fewestSections) {
        notes.push_back({notes::tooFewSections,
                         {{"found", static_cast<std::int64_t>(places.size())},
                          {"minimum", static_cast<std::int64_t>(fewestSections)}}});
        return std::nullopt;
    }

    result.fit_mm = fitParabola(result.z_mm, result.radius_mm);
    result.taper_diameter_um = 4e3 * result.fit_mm[1];
    result.barrel_um = -1e3 * result.fit_mm[2];
    const auto [least, most] = std::minmax_element(result.radius_mm.begin(), result.radius_mm.end());
    result.diameter_range_um = 2e3 * (*most - *least);
    result.half_diameter_range_um = result.diameter_range_um / 2;
    result.profile_straightness_um = 1e3 * straightnessOf(result.z_mm, result.radius_mm);
    result.axis_straightness_um = form::straightness(axis_mm).STRt_MZLI_um;
    // A stack much shorter than its diameter is a disc: its axis is undetermined, all other quantities exist.
    result.CYLt_LSCY_um = result.CYLt_MZCY_um = notANumber;
    try {
        const form::CylindricityResult cylinder =
            form::cylindricity(surface_mm, {}, progress, form::NoiseEstimate::LeftOut);
        result.CYLt_LSCY_um = cylinder.LSCY.CYLt_um;
        result.CYLt_MZCY_um = cylinder.MZCY.CYLt_um;
    } catch (const Error& error) {
        if (error.code() != errors::notConverged && error.code() != errors::pointsDegenerate) throw;
        notes.push_back(
            {notes::noCylindricity,
             {{"length_mm", places.back() - places.front()}, {"diameter_mm", 2 * result.radius_mm.front()}}});
    }
    return result;
}

}  // namespace lathelier::trajectory
