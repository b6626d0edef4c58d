#include "engine/features/model/selection_criterion.h"

#include <algorithm>
#include <cmath>

#include "engine/features/model/model_limits.h"

namespace lathelier::features {

double price(const Model& model, std::size_t parameters)
{
    std::size_t rows = 1;
    for (const Run& run : model.runs) rows += run.walls.size();
    return selectionLimits.parameter_price * static_cast<double>(parameters) * std::log(static_cast<double>(rows));
}

Scope scopeOf(const Run& run, std::size_t r, std::size_t first, std::size_t last)
{
    const auto isFree = [&](std::size_t k) {
        return run.nodes_mm[k + 1] - run.nodes_mm[k] < selectionLimits.short_neighbour_mm;
    };
    const auto reach_mm = [](bool free) {
        return free ? selectionLimits.short_neighbour_mm : selectionLimits.neighbour_margin_mm;
    };
    Scope scope;
    scope.window = {r, first, last};
    scope.from_mm = run.nodes_mm[first];
    scope.to_mm = run.nodes_mm[last + 1];
    if (first > 0) {
        const bool free = isFree(first - 1);
        scope.from_mm = std::max(run.nodes_mm[first - 1], run.nodes_mm[first] - reach_mm(free));
        if (free) scope.window.first = first - 1;
    }
    if (last + 1 < run.elements.size()) {
        const bool free = isFree(last + 1);
        scope.to_mm = std::min(run.nodes_mm[last + 2], run.nodes_mm[last + 1] + reach_mm(free));
        if (free) scope.window.last = last + 1;
    }
    return scope;
}

double criterion(Model& model, const Scope& scope, int iterations)
{
    const double chi2 = fitWindow(model, scope.window, scope.from_mm, scope.to_mm, iterations);
    double ties = 0;
    for (std::size_t k = scope.window.first; k <= scope.window.last; ++k) {
        const Element& e = model.runs[scope.window.run].elements[k];
        ties += (e.arc && e.start == Tie::Plane) + (e.arc && e.end == Tie::Plane);
    }
    return chi2 + price(model, slotsOf(model, scope.window.run, scope.window.first, scope.window.last).size()) +
           ties * std::max(0.0, price(model, 1) - selectionLimits.plane_tie_discount);
}

bool isFoot(const Model& model, std::size_t r, bool start)
{
    const std::size_t plane = start ? model.runs[r].left : model.runs[r].right;
    const double own = start ? startRadius_mm(model.runs[r]) : endRadius_mm(model.runs[r]);
    for (std::size_t other = 0; other < model.runs.size(); ++other) {
        if (other == r) continue;
        if (start && model.runs[other].right == plane) return endRadius_mm(model.runs[other]) > own;
        if (!start && model.runs[other].left == plane) return startRadius_mm(model.runs[other]) > own;
    }
    return false;
}

}  // namespace lathelier::features
