#include "engine/features/model/model_fit.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "engine/features/model/model_limits.h"

namespace lathelier::features {
namespace {

double huber(double residual)
{
    constexpr double limit = fitLimits.huber_sigmas;
    const double a = std::abs(residual);
    return a <= limit ? a * a : limit * (2 * a - limit);
}

double weightOf(double residual)
{
    constexpr double limit = fitLimits.huber_sigmas;
    const double a = std::abs(residual);
    return a <= limit ? 1 : limit / a;
}

double stepOf(const Slot& slot)
{
    return slot.of == Slot::Of::Slope ? fitLimits.slope_step : fitLimits.place_step_mm;
}

/// A wall (index into Run::walls) with its standard uncertainty in mm.
struct FitRow {
    std::size_t wall;
    double sigma;
};

/// The rows of one run within a range of z, chosen once for a fit so that its sum stays comparable.
std::vector<FitRow> fitRowsOf(const Model& model, const Run& run, double from_mm, double to_mm)
{
    std::vector<FitRow> rows;
    const auto first = std::lower_bound(run.walls.begin(), run.walls.end(), from_mm,
                                        [](const Wall& wall, double z) { return wall.z_mm < z; });
    for (auto wall = first; wall != run.walls.end() && wall->z_mm <= to_mm; ++wall)
        if (counts(model, run, *wall))
            rows.push_back({static_cast<std::size_t>(wall - run.walls.begin()), sigmaOf(model, *wall)});
    return rows;
}

/// Measured radius less that of the model, over its standard uncertainty.
double residualOf(const Model& model, const Run& run, const FitRow& row)
{
    const Wall& wall = run.walls[row.wall];
    return (wall.r_mm - predicted_mm(model, run, wall)) / row.sigma;
}

double sumOf(const Model& model, const Run& run, const std::vector<FitRow>& rows)
{
    double sum = run.violation;
    for (const FitRow& row : rows) sum += huber(residualOf(model, run, row));
    return sum;
}

/// Rows that a change of element `element` moves: between the nodes two before and two after it.
std::pair<std::size_t, std::size_t> rowsMoved(const Run& run, const std::vector<FitRow>& rows, std::size_t element)
{
    constexpr double reach_mm = fitLimits.derivative_reach_mm;
    const std::size_t first = element >= 2 ? element - 2 : 0, last = std::min(element + 3, run.elements.size());
    const double from = run.nodes_mm[first] - reach_mm, to = run.nodes_mm[last] + reach_mm;
    const auto low = std::lower_bound(rows.begin(), rows.end(), from,
                                      [&](const FitRow& row, double z) { return run.walls[row.wall].z_mm < z; });
    const auto high = std::upper_bound(rows.begin(), rows.end(), to,
                                       [&](double z, const FitRow& row) { return z < run.walls[row.wall].z_mm; });
    return {static_cast<std::size_t>(low - rows.begin()), static_cast<std::size_t>(high - rows.begin())};
}

/// Derivatives by one slot: of the residuals from row `first` on, and of the root of the penalties.
struct Column {
    std::size_t first = 0;
    std::vector<double> values;
    double violation = 0;
};

/// By a forward difference; `residuals` and the root of the penalties `violation` at the present values.
Column columnOf(Model& model, Run& run, const std::vector<FitRow>& rows, const Slot& slot,
                const std::vector<double>& residuals, double violation)
{
    const std::size_t at_plane = run.left == slot.run ? 0 : run.elements.size() - 1;
    const auto range = rowsMoved(run, rows, slot.of == Slot::Of::Plane ? at_plane : slot.element);
    Column column;
    column.first = range.first;
    double& value = valueOf(model, slot);
    const double before = value, step = stepOf(slot);
    const std::vector<double> nodes = run.nodes_mm;
    value = before + step;
    resolve(model, run);
    column.violation = (std::sqrt(run.violation) - violation) / step;
    for (std::size_t i = range.first; i < range.second; ++i)
        column.values.push_back((residualOf(model, run, rows[i]) - residuals[i]) / step);
    value = before;
    run.nodes_mm = nodes;
    resolve(model, run);
    return column;
}

/// Weighted sum over the rows that both columns have, and over the penalties.
double productOf(const Column& one, const Column& two, const std::vector<double>& residuals)
{
    const std::size_t from = std::max(one.first, two.first);
    const std::size_t to = std::min(one.first + one.values.size(), two.first + two.values.size());
    double sum = one.violation * two.violation;
    for (std::size_t i = from; i < to; ++i)
        sum += weightOf(residuals[i]) * one.values[i - one.first] * two.values[i - two.first];
    return sum;
}

/// Adds the normal equations of the rows of one run over some slots; `places`: their indices among all.
void addNormals(Model& model, std::size_t run_index, const std::vector<FitRow>& rows, const std::vector<Slot>& slots,
                const std::vector<std::size_t>& places, Eigen::MatrixXd& normal, Eigen::VectorXd& gradient)
{
    Run& run = model.runs[run_index];
    std::vector<double> residuals(rows.size());
    for (std::size_t i = 0; i < rows.size(); ++i) residuals[i] = residualOf(model, run, rows[i]);
    const double violation = std::sqrt(run.violation);
    std::vector<Column> columns;
    columns.reserve(slots.size());
    for (const Slot& slot : slots) columns.push_back(columnOf(model, run, rows, slot, residuals, violation));
    for (std::size_t s = 0; s < slots.size(); ++s) {
        const auto a = static_cast<Eigen::Index>(places[s]);
        const Column& one = columns[s];
        for (std::size_t k = 0; k < one.values.size(); ++k)
            gradient[a] += weightOf(residuals[one.first + k]) * one.values[k] * residuals[one.first + k];
        gradient[a] += one.violation * violation;
        for (std::size_t t = s; t < slots.size(); ++t) {
            const auto b = static_cast<Eigen::Index>(places[t]);
            const double sum = productOf(one, columns[t], residuals);
            normal(a, b) += sum;
            if (t != s) normal(b, a) += sum;
        }
    }
}

double planesMisfit(const Model& model)
{
    double sum = 0;
    for (const Plane& plane : model.planes)
        if (!plane.data_end && !plane.pole) sum += std::pow((plane.z_mm - plane.seen_mm) / plane.sigma_mm, 2);
    return sum;
}

/// Adds the observed places of the planes.
void addPlanes(const Model& model, const std::vector<Slot>& slots, Eigen::MatrixXd& normal, Eigen::VectorXd& gradient)
{
    for (Eigen::Index s = 0; s < gradient.size(); ++s) {
        const Slot& slot = slots[static_cast<std::size_t>(s)];
        if (slot.of != Slot::Of::Plane) continue;
        const Plane& plane = model.planes[slot.run];
        normal(s, s) += 1 / (plane.sigma_mm * plane.sigma_mm);
        gradient[s] += (plane.z_mm - plane.seen_mm) / (plane.sigma_mm * plane.sigma_mm);
    }
}

/// The slots that move a run, and their indices among all.
std::pair<std::vector<Slot>, std::vector<std::size_t>> slotsOfRun(const Model& model, std::size_t r,
                                                                  const std::vector<Slot>& all)
{
    std::vector<Slot> slots;
    std::vector<std::size_t> places;
    for (std::size_t s = 0; s < all.size(); ++s) {
        const bool own = all[s].of == Slot::Of::Plane
                             ? all[s].run == model.runs[r].left || all[s].run == model.runs[r].right
                             : all[s].run == r;
        if (!own) continue;
        slots.push_back(all[s]);
        places.push_back(s);
    }
    return {slots, places};
}

void moveBy(Model& model, const std::vector<Slot>& slots, const Eigen::VectorXd& step)
{
    for (std::size_t s = 0; s < slots.size(); ++s) valueOf(model, slots[s]) += step[static_cast<Eigen::Index>(s)];
}

/// One step of Levenberg and Marquardt: the damping grows until `sumAfter(step)` is less than `best`; `undo()` takes a
/// step back. Returns the gain, 0 when no step had any.
template <class SumAfter, class Undo>
double dampedStep(const Eigen::MatrixXd& normal, const Eigen::VectorXd& gradient, int most_tries, double& damping,
                  double& best, const SumAfter& sumAfter, const Undo& undo)
{
    for (int tries = 0; tries < most_tries; ++tries, damping *= fitLimits.damping_growth) {
        Eigen::MatrixXd damped = normal;
        damped.diagonal() +=
            damping * normal.diagonal() + Eigen::VectorXd::Constant(normal.rows(), fitLimits.regularization);
        const Eigen::VectorXd step = damped.ldlt().solve(-gradient);
        if (!step.allFinite()) continue;
        const double now = sumAfter(step);
        if (now < best) {
            const double gain = best - now;
            best = now;
            damping = fitLimits.damping_growth * std::max(fitLimits.least_damping, damping / fitLimits.damping_fall);
            return gain;
        }
        undo();
    }
    return 0;
}

}  // namespace

double& valueOf(Model& model, const Slot& slot)
{
    if (slot.of == Slot::Of::Plane) return model.planes[slot.run].z_mm;
    Element& element = model.runs[slot.run].elements[slot.element];
    switch (slot.of) {
        case Slot::Of::Slope: return element.slope;
        case Slot::Of::CentreZ: return element.centre_z_mm;
        case Slot::Of::CentreR: return element.centre_r_mm;
        case Slot::Of::LogRadius: return element.log_radius;
        default: return element.level_mm;
    }
}

std::vector<Slot> slotsOf(const Model& model, std::size_t run, std::size_t first, std::size_t last)
{
    std::vector<Slot> slots;
    for (std::size_t k = first; k <= last && k < model.runs[run].elements.size(); ++k) {
        const Element& e = model.runs[run].elements[k];
        if (!e.arc) {
            slots.push_back({Slot::Of::Level, run, k});
            if (!e.cylinder) slots.push_back({Slot::Of::Slope, run, k});
            continue;
        }
        const int tangents = (e.start == Tie::Tangent) + (e.end == Tie::Tangent);
        const bool touches = e.start == Tie::Plane || e.end == Tie::Plane, on_axis = isOnAxis(e);
        if (e.flat) {
            for (const Slot::Of of : {Slot::Of::Level, Slot::Of::Slope, Slot::Of::LogRadius})
                slots.push_back({of, run, k});
            continue;
        }
        if (!on_axis || tangents == 0) slots.push_back({Slot::Of::LogRadius, run, k});
        if (tangents < 2 && !touches) slots.push_back({Slot::Of::CentreZ, run, k});
        if (tangents == 0 && !on_axis) slots.push_back({Slot::Of::CentreR, run, k});
    }
    return slots;
}

std::vector<Slot> allSlots(const Model& model)
{
    std::vector<Slot> slots;
    for (std::size_t p = 0; p < model.planes.size(); ++p)
        if (!model.planes[p].data_end && !model.planes[p].pole) slots.push_back({Slot::Of::Plane, p, 0});
    for (std::size_t r = 0; r < model.runs.size(); ++r) {
        const std::vector<Slot> own = slotsOf(model, r, 0, model.runs[r].elements.size());
        slots.insert(slots.end(), own.begin(), own.end());
    }
    return slots;
}

double misfit(const Model& model, std::size_t run, double from_mm, double to_mm, std::size_t* rows)
{
    const std::vector<FitRow> own = fitRowsOf(model, model.runs[run], from_mm, to_mm);
    if (rows) *rows = own.size();
    return sumOf(model, model.runs[run], own);
}

double misfit(const Model& model, const Window& window, std::size_t* rows)
{
    const Run& run = model.runs[window.run];
    return misfit(model, window.run, run.nodes_mm[window.first], run.nodes_mm[window.last + 1], rows);
}

double fitWindow(Model& model, const Window& window, int iterations)
{
    const Run& run = model.runs[window.run];
    return fitWindow(model, window, run.nodes_mm[window.first], run.nodes_mm[window.last + 1], iterations);
}

double fitWindow(Model& model, const Window& window, double from_mm, double to_mm, int iterations)
{
    Run& run = model.runs[window.run];
    resolve(model, run);
    const std::vector<Slot> slots = slotsOf(model, window.run, window.first, window.last);
    std::vector<std::size_t> places(slots.size());
    std::iota(places.begin(), places.end(), std::size_t{0});
    const std::vector<FitRow> rows = fitRowsOf(model, run, from_mm, to_mm);
    double best = sumOf(model, run, rows), damping = fitLimits.window_damping;
    const auto count = static_cast<Eigen::Index>(slots.size());
    for (int i = 0; i < iterations; ++i) {
        Eigen::MatrixXd normal = Eigen::MatrixXd::Zero(count, count);
        Eigen::VectorXd gradient = Eigen::VectorXd::Zero(count);
        addNormals(model, window.run, rows, slots, places, normal, gradient);
        const std::vector<Element> elements = run.elements;
        const std::vector<double> nodes = run.nodes_mm;
        const auto sumAfter = [&](const Eigen::VectorXd& step) {
            moveBy(model, slots, step);
            resolve(model, run);
            return sumOf(model, run, rows);
        };
        const auto undo = [&] {
            run.elements = elements;
            run.nodes_mm = nodes;
            resolve(model, run);
        };
        const double gain = dampedStep(normal, gradient, fitLimits.window_tries, damping, best, sumAfter, undo);
        if (gain < fitLimits.window_gain) break;
    }
    return misfit(model, window.run, from_mm, to_mm);
}

JointFit fitAll(Model& model, int iterations, const Progress& progress)
{
    JointFit fit;
    fit.slots = allSlots(model);
    const auto count = static_cast<Eigen::Index>(fit.slots.size());
    double damping = fitLimits.joint_damping;
    for (int i = 0; i < iterations; ++i) {
        progress.check();
        for (Run& run : model.runs) resolve(model, run);
        std::vector<std::vector<FitRow>> rows;
        const double all = std::numeric_limits<double>::infinity();
        for (const Run& run : model.runs) rows.push_back(fitRowsOf(model, run, -all, all));
        Eigen::MatrixXd normal = Eigen::MatrixXd::Zero(count, count);
        Eigen::VectorXd gradient = Eigen::VectorXd::Zero(count);
        fit.rows = 0;
        for (std::size_t r = 0; r < model.runs.size(); ++r) {
            const auto [slots, places] = slotsOfRun(model, r, fit.slots);
            addNormals(model, r, rows[r], slots, places, normal, gradient);
            fit.rows += rows[r].size();
        }
        addPlanes(model, fit.slots, normal, gradient);
        Eigen::MatrixXd regular = normal;
        regular.diagonal() += Eigen::VectorXd::Constant(count, fitLimits.covariance_regularization);
        fit.covariance = regular.ldlt().solve(Eigen::MatrixXd::Identity(count, count));
        const auto total = [&] {
            double sum = planesMisfit(model);
            for (std::size_t r = 0; r < model.runs.size(); ++r) sum += sumOf(model, model.runs[r], rows[r]);
            return sum;
        };
        const Model before = model;
        const auto sumAfter = [&](const Eigen::VectorXd& step) {
            moveBy(model, fit.slots, step);
            for (Run& run : model.runs) resolve(model, run);
            return total();
        };
        fit.chi2 = total();
        const double gain =
            dampedStep(normal, gradient, fitLimits.joint_tries, damping, fit.chi2, sumAfter, [&] { model = before; });
        if (gain < fitLimits.joint_gain) {
            fit.converged = true;
            break;
        }
    }
    return fit;
}

}  // namespace lathelier::features
