#include "engine/features/model/model_fit.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>

namespace lathelier::features {
namespace {

constexpr double huberLimit = 4;

double huber(double residual)
{
    const double a = std::abs(residual);
    return a <= huberLimit ? a * a : huberLimit * (2 * a - huberLimit);
}

double weightOf(double residual)
{
    const double a = std::abs(residual);
    return a <= huberLimit ? 1 : huberLimit / a;
}

double stepOf(const Slot& slot)
{
    switch (slot.of) {
        case Slot::Of::Plane:
        case Slot::Of::Level:
        case Slot::Of::CentreZ:
        case Slot::Of::CentreR: return 1e-5;
        case Slot::Of::Slope: return 1e-6;
        case Slot::Of::LogRadius: return 1e-5;
    }
    return 1e-6;
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

double sumOf(const Model& model, const Run& run, const std::vector<FitRow>& rows)
{
    double sum = run.violation;
    for (const FitRow& row : rows) {
        const Wall& wall = run.walls[row.wall];
        sum += huber((wall.r_mm - predicted_mm(model, run, wall)) / row.sigma);
    }
    return sum;
}

/// Rows that a change of element `element` moves: between the nodes two before and two after it.
std::pair<std::size_t, std::size_t> rowsMoved(const Run& run, const std::vector<FitRow>& rows, std::size_t element,
                                              double reach_mm)
{
    const std::size_t first = element >= 2 ? element - 2 : 0, last = std::min(element + 3, run.elements.size());
    const double from = run.nodes_mm[first] - reach_mm, to = run.nodes_mm[last] + reach_mm;
    const auto low = std::lower_bound(rows.begin(), rows.end(), from,
                                      [&](const FitRow& row, double z) { return run.walls[row.wall].z_mm < z; });
    const auto high = std::upper_bound(rows.begin(), rows.end(), to,
                                       [&](double z, const FitRow& row) { return z < run.walls[row.wall].z_mm; });
    return {static_cast<std::size_t>(low - rows.begin()), static_cast<std::size_t>(high - rows.begin())};
}

/// Normal equations of the rows of one run over some slots.
void addNormals(Model& model, std::size_t run_index, const std::vector<FitRow>& rows, const std::vector<Slot>& slots,
                const std::vector<std::size_t>& places, Eigen::MatrixXd& normal, Eigen::VectorXd& gradient)
{
    Run& run = model.runs[run_index];
    std::vector<double> residuals(rows.size());
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const Wall& wall = run.walls[rows[i].wall];
        residuals[i] = (wall.r_mm - predicted_mm(model, run, wall)) / rows[i].sigma;
    }
    struct Column {
        std::size_t first = 0;
        std::vector<double> values;
    };
    std::vector<Column> columns(slots.size());
    const double violation = std::sqrt(run.violation);
    std::vector<double> violated(slots.size(), 0);
    for (std::size_t s = 0; s < slots.size(); ++s) {
        const Slot& slot = slots[s];
        std::pair<std::size_t, std::size_t> range{0, rows.size()};
        if (slot.of != Slot::Of::Plane) {
            range = rowsMoved(run, rows, slot.element, 1);
        } else {
            const std::size_t end = run.left == slot.run ? 0 : run.elements.size() - 1;
            range = rowsMoved(run, rows, end, 1);
        }
        Column& column = columns[s];
        column.first = range.first;
        double& value = valueOf(model, slot);
        const double before = value, step = stepOf(slot);
        const std::vector<double> nodes = run.nodes_mm;
        value = before + step;
        resolve(model, run);
        violated[s] = (std::sqrt(run.violation) - violation) / step;
        for (std::size_t i = range.first; i < range.second; ++i) {
            const Wall& wall = run.walls[rows[i].wall];
            const double residual = (wall.r_mm - predicted_mm(model, run, wall)) / rows[i].sigma;
            column.values.push_back((residual - residuals[i]) / step);
        }
        value = before;
        run.nodes_mm = nodes;
        resolve(model, run);
    }
    for (std::size_t s = 0; s < slots.size(); ++s) {
        const auto a = static_cast<Eigen::Index>(places[s]);
        const Column& one = columns[s];
        for (std::size_t k = 0; k < one.values.size(); ++k)
            gradient[a] += weightOf(residuals[one.first + k]) * one.values[k] * residuals[one.first + k];
        gradient[a] += violated[s] * violation;
        for (std::size_t t = s; t < slots.size(); ++t) {
            const auto b = static_cast<Eigen::Index>(places[t]);
            const Column& two = columns[t];
            const std::size_t from = std::max(one.first, two.first);
            const std::size_t to = std::min(one.first + one.values.size(), two.first + two.values.size());
            double sum = violated[s] * violated[t];
            for (std::size_t i = from; i < to; ++i)
                sum += weightOf(residuals[i]) * one.values[i - one.first] * two.values[i - two.first];
            normal(a, b) += sum;
            if (t != s) normal(b, a) += sum;
        }
    }
}

double planesMisfit(const Model& model)
{
    double sum = 0;
    for (const Plane& plane : model.planes)
        if (!plane.data_end) sum += std::pow((plane.z_mm - plane.seen_mm) / plane.sigma_mm, 2);
    return sum;
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
        const bool touches = e.start == Tie::Plane || e.end == Tie::Plane;
        slots.push_back({Slot::Of::LogRadius, run, k});
        if (tangents < 2 && !touches) slots.push_back({Slot::Of::CentreZ, run, k});
        if (tangents == 0) slots.push_back({Slot::Of::CentreR, run, k});
    }
    return slots;
}

std::vector<Slot> allSlots(const Model& model)
{
    std::vector<Slot> slots;
    for (std::size_t p = 0; p < model.planes.size(); ++p)
        if (!model.planes[p].data_end) slots.push_back({Slot::Of::Plane, p, 0});
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
    for (std::size_t s = 0; s < slots.size(); ++s) places[s] = s;
    const std::vector<FitRow> rows = fitRowsOf(model, run, from_mm, to_mm);
    double best = sumOf(model, run, rows), damping = 1e-3;
    const auto count = static_cast<Eigen::Index>(slots.size());
    for (int i = 0; i < iterations; ++i) {
        Eigen::MatrixXd normal = Eigen::MatrixXd::Zero(count, count);
        Eigen::VectorXd gradient = Eigen::VectorXd::Zero(count);
        addNormals(model, window.run, rows, slots, places, normal, gradient);
        bool better = false;
        double gain = 0;
        for (int tries = 0; tries < 6 && !better; ++tries, damping *= 8) {
            Eigen::MatrixXd damped = normal;
            damped.diagonal() += damping * normal.diagonal() + Eigen::VectorXd::Constant(count, 1e-12);
            const Eigen::VectorXd step = damped.ldlt().solve(-gradient);
            if (!step.allFinite()) continue;
            const std::vector<Element> elements = run.elements;
            const std::vector<double> nodes = run.nodes_mm;
            for (std::size_t s = 0; s < slots.size(); ++s)
                valueOf(model, slots[s]) += step[static_cast<Eigen::Index>(s)];
            resolve(model, run);
            const double now = sumOf(model, run, rows);
            if (now < best) {
                gain = best - now;
                best = now;
                better = true;
                damping = std::max(1e-9, damping / 64);
            } else {
                run.elements = elements;
                run.nodes_mm = nodes;
                resolve(model, run);
            }
        }
        if (!better || gain < 1e-3) break;
    }
    return misfit(model, window.run, from_mm, to_mm);
}

JointFit fitAll(Model& model, int iterations, const Progress& progress)
{
    JointFit fit;
    fit.slots = allSlots(model);
    const auto count = static_cast<Eigen::Index>(fit.slots.size());
    double damping = 1e-4;
    for (int i = 0; i < iterations; ++i) {
        progress.check();
        for (Run& run : model.runs) resolve(model, run);
        std::vector<std::vector<FitRow>> rows;
        const double all = std::numeric_limits<double>::infinity();
        for (const Run& run : model.runs) rows.push_back(fitRowsOf(model, run, -all, all));
        const auto total = [&] {
            double sum = planesMisfit(model);
            for (std::size_t r = 0; r < model.runs.size(); ++r) sum += sumOf(model, model.runs[r], rows[r]);
            return sum;
        };
        Eigen::MatrixXd normal = Eigen::MatrixXd::Zero(count, count);
        Eigen::VectorXd gradient = Eigen::VectorXd::Zero(count);
        fit.rows = 0;
        for (std::size_t r = 0; r < model.runs.size(); ++r) {
            std::vector<Slot> slots;
            std::vector<std::size_t> places;
            for (std::size_t s = 0; s < fit.slots.size(); ++s) {
                const Slot& slot = fit.slots[s];
                const bool own = slot.of == Slot::Of::Plane
                                     ? slot.run == model.runs[r].left || slot.run == model.runs[r].right
                                     : slot.run == r;
                if (!own) continue;
                slots.push_back(slot);
                places.push_back(s);
            }
            addNormals(model, r, rows[r], slots, places, normal, gradient);
            fit.rows += rows[r].size();
        }
        for (Eigen::Index s = 0; s < count; ++s) {
            const Slot& slot = fit.slots[static_cast<std::size_t>(s)];
            if (slot.of != Slot::Of::Plane) continue;
            const Plane& plane = model.planes[slot.run];
            normal(s, s) += 1 / (plane.sigma_mm * plane.sigma_mm);
            gradient[s] += (plane.z_mm - plane.seen_mm) / (plane.sigma_mm * plane.sigma_mm);
        }
        Eigen::MatrixXd sure = normal;
        sure.diagonal() += Eigen::VectorXd::Constant(count, 1e-9);
        fit.covariance = sure.ldlt().solve(Eigen::MatrixXd::Identity(count, count));
        double best = total();
        bool better = false;
        double gain = 0;
        for (int tries = 0; tries < 8 && !better; ++tries, damping *= 8) {
            Eigen::MatrixXd damped = normal;
            damped.diagonal() += damping * normal.diagonal() + Eigen::VectorXd::Constant(count, 1e-12);
            const Eigen::VectorXd step = damped.ldlt().solve(-gradient);
            if (!step.allFinite()) continue;
            const Model before = model;
            for (std::size_t s = 0; s < fit.slots.size(); ++s)
                valueOf(model, fit.slots[s]) += step[static_cast<Eigen::Index>(s)];
            for (Run& run : model.runs) resolve(model, run);
            const double now = total();
            if (now < best) {
                gain = best - now;
                best = now;
                better = true;
                damping = std::max(1e-9, damping / 64);
            } else {
                model = before;
            }
        }
        fit.chi2 = best;
        if (!better || gain < 1e-4) {
            fit.converged = true;
            break;
        }
    }
    return fit;
}

}  // namespace lathelier::features
