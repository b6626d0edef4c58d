#include "engine/deflection/identification.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "engine/core/core_codes.h"
#include "engine/core/small_solve.h"
#include "engine/core/units.h"
#include "engine/deflection/deflection_codes.h"
#include "engine/deflection/measured_places.h"

namespace lathelier::deflection {
namespace {

constexpr double difference = 1e-4;  ///< step of the logarithms for numerical derivatives
constexpr double largestLog = 4.6;   ///< limits the factors to 0.01 … 100
constexpr int mostIterations = 100;
constexpr double convergedLog = 1e-9;
constexpr double poor_percent = 50;

std::vector<Influence> soughtOf(const IdentificationParameters& p, const TurningSetup& setup)
{
    std::vector<Influence> sought;
    const auto add = [&](bool asked, Influence influence) {
        if (asked && hasInfluence(setup, influence)) sought.push_back(influence);
    };
    add(p.tailstock, Influence::Tailstock);
    add(p.chuck_radial, Influence::ChuckRadial);
    add(p.chuck_tilt, Influence::ChuckTilt);
    add(p.forces, Influence::Forces);
    return sought;
}

TurningSetup withFactors(TurningSetup setup, const std::vector<Influence>& sought, const Eigen::VectorXd& logs)
{
    for (std::size_t i = 0; i < sought.size(); ++i)
        setup = scaled(std::move(setup), sought[i], std::exp(logs(static_cast<Eigen::Index>(i))));
    return setup;
}

double valueOf(const TurningSetup& setup, Influence influence, double factor)
{
    switch (influence) {
        case Influence::Tailstock: return setup.tailstock->radial_N_mm;
        case Influence::ChuckRadial: return setup.chuck.radial_N_mm;
        case Influence::ChuckTilt: return setup.chuck.tilt_N_mm_rad;
        default: return factor;
    }
}

double rms(const Eigen::VectorXd& v)
{
    return std::sqrt(v.squaredNorm() / static_cast<double>(v.size()));
}

}  // namespace

const std::vector<Field<MeasuredDiameter>>& fieldsOf(const MeasuredDiameter*)
{
    using M = MeasuredDiameter;
    const auto label = [](Text name, Text help, Text unit, bool required) {
        Label result{name, help, unit};
        result.required = required;
        return result;
    };
    static const auto all = described<M>(
        field("z_mm", &M::z_mm, {0, 1e5},
              label(LT_TEXT("Engine", "z"), LT_TEXT("Engine", "From the free end toward the chuck."), unit::mm, true)),
        field("diameter_mm", &M::diameter_mm, {0, 1e5},
              label(LT_TEXT("Engine", "Diameter"), LT_TEXT("Engine", "As measured."), unit::mm, true)),
        field(
            "uncertainty_um", &M::uncertainty_um, {1e-3, 1e4},
            label(LT_TEXT("Engine", "Standard uncertainty"), LT_TEXT("Engine", "Of this diameter."), unit::um, false)));
    return all;
}

const std::vector<Field<IdentificationParameters>>& fieldsOf(const IdentificationParameters*)
{
    using P = IdentificationParameters;
    static const auto all = described<P>(
        field("seek_tailstock", &P::tailstock,
              Label{LT_TEXT("Engine", "Tailstock"), LT_TEXT("Engine", "Find its radial stiffness.")}),
        field("seek_chuck_radial", &P::chuck_radial,
              Label{LT_TEXT("Engine", "Chuck, radial"), LT_TEXT("Engine", "Find its radial stiffness.")}),
        field("seek_chuck_tilt", &P::chuck_tilt,
              Label{LT_TEXT("Engine", "Chuck, tilting"), LT_TEXT("Engine", "Find its tilting stiffness.")}),
        field("seek_forces", &P::forces,
              Label{LT_TEXT("Engine", "Forces"), LT_TEXT("Engine", "Find one factor on all cutting forces.")}));
    return all;
}

IdentificationResult identify(const Shaft& stock, std::span<const ToolRun> runs, const TurningSetup& setup,
                              std::span<const MeasuredDiameter> measured, const IdentificationParameters& parameters,
                              const Progress& progress)
{
    IdentificationResult result;
    result.parameters = parameters;
    const std::vector<Influence> sought = soughtOf(parameters, setup);
    const auto unknowns = static_cast<Eigen::Index>(sought.size());
    const auto count = static_cast<Eigen::Index>(measured.size());
    if (unknowns == 0 || count < unknowns)
        throw Error(errors::tooFewMeasured,
                    {{"found", static_cast<std::int64_t>(count)}, {"parameters", static_cast<std::int64_t>(unknowns)}});
    const WorkPlan plan = workPlan(stock, runs, setup);
    const FinalContour start = finalContour(plan, setup);
    if (start.z_mm.empty()) throw Error(errors::noCut, {});
    const MeasuredPlaces places(start, measured);
    const Eigen::VectorXd targets_mm = places.of(start.target_radius_mm);
    Eigen::VectorXd errors_um(count), weight(count);
    for (Eigen::Index i = 0; i < count; ++i) {
        const MeasuredDiameter& one = measured[static_cast<std::size_t>(i)];
        errors_um(i) = um_per_mm * (one.diameter_mm - 2 * targets_mm(i));
        weight(i) = 1 / one.uncertainty_um;
    }
    const auto predicted = [&](const Eigen::VectorXd& logs) {
        progress.check();
        return places.of(finalContour(plan, withFactors(setup, sought, logs)).diameter_error_um);
    };
    Eigen::VectorXd logs = Eigen::VectorXd::Zero(unknowns);
    const Eigen::VectorXd before = predicted(logs);
    Eigen::VectorXd now = before;
    Eigen::MatrixXd jacobian(count, unknowns);
    const auto differentiate = [&] {
        for (Eigen::Index k = 0; k < unknowns; ++k) {
            Eigen::VectorXd up = logs, down = logs;
            up(k) += difference;
            down(k) -= difference;
            jacobian.col(k) = weight.cwiseProduct(predicted(up) - predicted(down)) / (2 * difference);
        }
    };
    double damping = 1e-3;
    bool converged = false;
    differentiate();
    while (!converged && result.iterations < mostIterations) {
        progress.report(static_cast<double>(++result.iterations) / mostIterations);
        const Eigen::VectorXd off = weight.cwiseProduct(errors_um - now);
        Eigen::MatrixXd normal = jacobian.transpose() * jacobian;
        normal.diagonal() += damping * (normal.diagonal().array() + 1e-12).matrix();
        Eigen::VectorXd step = normal.ldlt().solve(jacobian.transpose() * off);
        const Eigen::VectorXd next = (logs + step).cwiseMax(-largestLog).cwiseMin(largestLog);
        const Eigen::VectorXd there = predicted(next);
        if (weight.cwiseProduct(errors_um - there).squaredNorm() <= off.squaredNorm()) {
            converged = (next - logs).cwiseAbs().maxCoeff() < convergedLog;
            logs = next;
            now = there;
            damping = std::max(1e-12, damping / 10);
            if (!converged) differentiate();
        } else {
            converged = step.cwiseAbs().maxCoeff() < convergedLog;
            damping *= 10;
            if (damping > 1e12) converged = true;
        }
    }
    if (!converged) throw Error(errors::notConverged, {{"iterations", static_cast<std::int64_t>(result.iterations)}});

    differentiate();
    const Eigen::MatrixXd covariance = pseudoInverse(jacobian.transpose() * jacobian);
    const bool is_singular = rankOf(jacobian, 1e-7) < unknowns;
    result.setup = withFactors(setup, sought, logs);
    for (Eigen::Index k = 0; k < unknowns; ++k) {
        const Influence influence = sought[static_cast<std::size_t>(k)];
        const double factor = std::exp(logs(k));
        const double deviation = is_singular ? HUGE_VAL : std::sqrt(covariance(k, k));
        result.factors.push_back({influence, factor, valueOf(result.setup, influence, factor), 100 * deviation});
        if (!(100 * deviation <= poor_percent))
            result.notes.push_back({notes::poorlyDetermined,
                                    {{"parameter", nameOf(influence).name}, {"uncertainty_percent", 100 * deviation}}});
        if (std::abs(logs(k)) >= largestLog * (1 - 1e-9))
            result.notes.push_back({notes::atItsLimit, {{"parameter", nameOf(influence).name}, {"value", factor}}});
        for (Eigen::Index m = 0; m < unknowns; ++m)
            result.correlation.push_back(covariance(k, m) / std::sqrt(covariance(k, k) * covariance(m, m)));
    }
    for (Eigen::Index i = 0; i < count; ++i) {
        const MeasuredDiameter& one = measured[static_cast<std::size_t>(i)];
        const Eigen::RowVectorXd row = jacobian.row(i) / weight(i);
        const double u_um = std::sqrt(std::max(0.0, (row * covariance * row.transpose())(0, 0)));
        result.diameters.push_back({one.z_mm, errors_um(i), before(i), now(i), u_um,
                                    std::abs(now(i) - errors_um(i)) / (2 * std::hypot(u_um, one.uncertainty_um))});
    }
    result.rms_before_um = rms(before - errors_um);
    result.rms_after_um = rms(now - errors_um);
    return result;
}

}  // namespace lathelier::deflection
