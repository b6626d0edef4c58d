#include "engine/receptance/eirc/spindle_line.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "engine/core/small_solve.h"

namespace lathelier::receptance {
namespace {

constexpr double scale_mm = 100;
constexpr int mostHalvings = 20;
constexpr double convergedShare = 1e-10;  // relative change of the unknowns at convergence

/// u = -Hs r as two rows in the scaled unknowns: the factors of H, L and P.
Eigen::Matrix<Complex, 2, 3> rowsOf(const Eigen::Vector2cd& reaction)
{
    Eigen::Matrix<Complex, 2, 3> rows;
    const Complex tilt = reaction[1] / scale_mm;
    rows << reaction[0], tilt, 0, 0, reaction[0], tilt;  // the second row times 100 mm
    return rows;
}

/// Per change of H, L and P, from (Hb_jj + Hs)⁻¹ Hb_j of both points.
Eigen::RowVector3cd gradientOf(const Eigen::Vector2cd& a, const Eigen::Vector2cd& b)
{
    return {a[0] * b[0], (a[0] * b[1] + a[1] * b[0]) / scale_mm, a[1] * b[1] / (scale_mm * scale_mm)};
}

struct System {
    ThreeColumns jacobian;
    Eigen::VectorXcd residual;
};

System linearised(const SpindleLine& line, const ScaledSpindle& spindle)
{
    const ReceptanceMatrix hs = matrixOf(spindle);
    std::vector<ReceptanceMatrix> inverse;
    for (const ReceptanceMatrix& jj : line.free_jj) inverse.push_back((jj + hs).inverse());
    const auto n = static_cast<Eigen::Index>(line.responses.size());
    System system{ThreeColumns(n, 3), Eigen::VectorXcd(n)};
    for (Eigen::Index i = 0; i < n; ++i) {
        const LineResponse& one = line.responses[static_cast<std::size_t>(i)];
        const Eigen::Vector2cd a = inverse[one.loaded] * one.joint_a;
        const Eigen::Vector2cd b = inverse[one.loaded] * one.joint_b;
        const Complex value = one.free - one.joint_a.cwiseProduct(b).sum();  // bilinear product, without conjugation
        system.residual[i] = one.weight * (value - one.measured);
        system.jacobian.row(i) = one.weight * gradientOf(a, b);
    }
    return system;
}

double costOf(const SpindleLine& line, const ScaledSpindle& spindle)
{
    double cost = 0;
    for (const LineResponse& one : line.responses)
        if (one.weight > 0) cost += std::norm(one.weight * (responseOn(line, one, spindle) - one.measured));
    return std::isfinite(cost) ? cost : HUGE_VAL;
}

}  // namespace

ReceptanceMatrix matrixOf(const ScaledSpindle& spindle)
{
    const Complex cross = spindle[1] / scale_mm;
    ReceptanceMatrix result;
    result << spindle[0], cross, cross, spindle[2] / (scale_mm * scale_mm);
    return result;
}

ScaledSpindle scaledOf(const ReceptanceMatrix& spindle)
{
    return {spindle(0, 0), scale_mm * (spindle(0, 1) + spindle(1, 0)) / 2.0, scale_mm * scale_mm * spindle(1, 1)};
}

Complex responseOn(const SpindleLine& line, const LineResponse& response, const ScaledSpindle& spindle)
{
    const ReceptanceMatrix joint = line.free_jj[response.loaded] + matrixOf(spindle);
    const Eigen::Vector2cd reaction = joint.inverse() * response.joint_b;
    return response.free - response.joint_a.cwiseProduct(reaction).sum();
}

Eigen::RowVector3cd gradientOn(const SpindleLine& line, const LineResponse& response, const ScaledSpindle& spindle)
{
    const ReceptanceMatrix inverse = (line.free_jj[response.loaded] + matrixOf(spindle)).inverse();
    return gradientOf(inverse * response.joint_a, inverse * response.joint_b);
}

std::optional<ScaledSpindle> linearStart(const SpindleLine& line)
{
    Eigen::Matrix3cd normal = Eigen::Matrix3cd::Zero();
    Eigen::Vector3cd right = Eigen::Vector3cd::Zero();
    const auto addForce = [&](std::size_t rod, std::size_t point) {
        Eigen::Matrix2cd motion = Eigen::Matrix2cd::Zero();
        Eigen::Vector2cd known = Eigen::Vector2cd::Zero();
        Eigen::Vector2cd joint = Eigen::Vector2cd::Zero();
        int count = 0;
        for (const LineResponse& one : line.responses) {
            const bool at_a = one.point_a == point;
            if (one.loaded != rod || !(one.weight > 0) || (!at_a && one.point_b != point)) continue;
            joint = at_a ? one.joint_a : one.joint_b;
            Eigen::Vector2cd row = at_a ? one.joint_b : one.joint_a;
            row[1] /= scale_mm;  // reaction moment in units of 100 mm times a force
            motion += one.weight * one.weight * row.conjugate() * row.transpose();
            known += one.weight * one.weight * row.conjugate() * (one.measured - one.free);
            ++count;
        }
        if (count < 2) return;
        Eigen::Vector2cd reaction = solveFullPivoting(motion, known);
        reaction[1] /= scale_mm;
        // Motion of the joint, its rotation times 100 mm; and the reaction moment divided by it.
        Eigen::Vector2cd moved = joint + line.free_jj[rod] * Eigen::Vector2cd(reaction[0], reaction[1]);
        moved[1] *= scale_mm;
        const Eigen::Matrix<Complex, 2, 3> rows = rowsOf(reaction);
        normal += rows.adjoint() * rows;
        right -= rows.adjoint() * moved;
    };
    std::vector<std::pair<std::size_t, std::size_t>> forces;
    for (const LineResponse& one : line.responses)
        for (const std::size_t point : {one.point_a, one.point_b})
            if (std::find(forces.begin(), forces.end(), std::pair{one.loaded, point}) == forces.end())
                forces.emplace_back(one.loaded, point);
    for (const auto& [rod, point] : forces) addForce(rod, point);
    if (normal.isZero(0)) return std::nullopt;
    const ScaledSpindle result = solveFullPivoting(normal, right);
    return result.allFinite() ? std::optional(result) : std::nullopt;
}

LineFit refine(const SpindleLine& line, const ScaledSpindle& start, int most_steps)
{
    LineFit fit;
    fit.spindle = start;
    fit.cost = costOf(line, start);
    fit.responses = static_cast<std::size_t>(std::count_if(line.responses.begin(), line.responses.end(),
                                                           [](const LineResponse& one) { return one.weight > 0; }));
    for (int i = 0; i < most_steps && !fit.converged; ++i) {
        const System system = linearised(line, fit.spindle);
        if (!system.jacobian.allFinite()) break;
        const ScaledSpindle step = -leastSquares(system.jacobian, system.residual);
        double share = 1;
        ScaledSpindle next = fit.spindle + step;
        double cost = costOf(line, next);
        for (int k = 0; k < mostHalvings && !(cost <= fit.cost); ++k) {
            share /= 2;
            next = fit.spindle + share * step;
            cost = costOf(line, next);
        }
        fit.converged = step.norm() <= convergedShare * fit.spindle.norm() ||
                        (share < 1e-5 && step.norm() < 1e-4 * fit.spindle.norm());
        if (!(cost <= fit.cost)) break;
        fit.spindle = next;
        fit.cost = cost;
    }
    const System system = linearised(line, fit.spindle);
    fit.information = system.jacobian.adjoint() * system.jacobian;
    if (system.jacobian.allFinite()) {
        const Eigen::Vector3d values = singularValues(system.jacobian);
        fit.condition = values[2] > 0 ? values[0] / values[2] : HUGE_VAL;
    }
    return fit;
}

}  // namespace lathelier::receptance
