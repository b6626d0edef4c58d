#include "engine/features/model/undercut_search.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

#include "engine/features/model/model_limits.h"
#include "engine/features/model/selection.h"
#include "engine/features/model/selection_criterion.h"

namespace lathelier::features {
namespace {

const double runOutSlope = std::tan(undercutLimits.run_out_deg * std::numbers::pi / 180);

/// Least mean of three neighbouring walls between two places; the level where there are none.
double deepest(const Run& run, double from_mm, double to_mm, double level_mm)
{
    double least = level_mm;
    for (std::size_t i = 0; i + 2 < run.walls.size(); ++i)
        if (run.walls[i].z_mm > from_mm && run.walls[i + 2].z_mm < to_mm)
            least = std::min(least, (run.walls[i].r_mm + run.walls[i + 1].r_mm + run.walls[i + 2].r_mm) / 3);
    return least;
}

Element line(double z_mm, double level_mm, double slope)
{
    Element e;
    e.cylinder = slope == 0;
    e.at_mm = z_mm;
    e.level_mm = level_mm;
    e.slope = slope;
    return e;
}

/// Three elements and the places where they begin, away from the plane (at `plane_mm`) first; `sense` +1: the plane is
/// at the end of the run.
struct FoundUndercut {
    std::array<Element, 3> elements;
    std::array<double, 3> from_mm{};
};

std::optional<FoundUndercut> fittedUndercut(double from_mm, double plane_mm, double level_mm, double depth_mm,
                                            double radius_mm)
{
    const double sense = plane_mm > from_mm ? 1 : -1, length = std::abs(plane_mm - from_mm);
    const double run_out = depth_mm / runOutSlope;
    if (!(run_out + radius_mm < undercutLimits.length_share * length)) return std::nullopt;
    const double bottom = level_mm - depth_mm, tangent = plane_mm - sense * radius_mm;
    FoundUndercut made;
    made.from_mm = {from_mm, from_mm + sense * run_out, tangent};
    made.elements[0] = line(from_mm, level_mm, -sense * runOutSlope);
    made.elements[1] = line((made.from_mm[1] + tangent) / 2, bottom, 0);
    made.elements[2] =
        arcOverChord(std::min(tangent, plane_mm), sense > 0 ? bottom : bottom + radius_mm, std::max(tangent, plane_mm),
                     sense > 0 ? bottom + radius_mm : bottom, radius_mm, false);
    (sense > 0 ? made.elements[2].start : made.elements[2].end) = Tie::Tangent;
    (sense > 0 ? made.elements[2].end : made.elements[2].start) = Tie::Plane;
    return made;
}

/// The run with its last `rows` elements (its first ones at the start) replaced.
Run replaced(const Run& run, bool start, std::size_t rows, FoundUndercut undercut)
{
    Run result = run;
    if (start) {
        std::reverse(undercut.elements.begin(), undercut.elements.end());
        result.elements.erase(result.elements.begin(), result.elements.begin() + static_cast<std::ptrdiff_t>(rows));
        result.elements.insert(result.elements.begin(), undercut.elements.begin(), undercut.elements.end());
        result.nodes_mm.erase(result.nodes_mm.begin() + 1,
                              result.nodes_mm.begin() + static_cast<std::ptrdiff_t>(rows) + 1);
        result.nodes_mm.insert(result.nodes_mm.begin() + 1,
                               {undercut.from_mm[2], undercut.from_mm[1], undercut.from_mm[0]});
    } else {
        result.elements.resize(result.elements.size() - rows);
        result.elements.insert(result.elements.end(), undercut.elements.begin(), undercut.elements.end());
        const double plane = result.nodes_mm.back();
        result.nodes_mm.resize(result.nodes_mm.size() - rows - 1);
        result.nodes_mm.insert(result.nodes_mm.end(),
                               {undercut.from_mm[0], undercut.from_mm[1], undercut.from_mm[2], plane});
    }
    return result;
}

/// Is it there already: a line, a line and an arc into the plane?
bool isUndercut(const Run& run, bool start)
{
    const std::size_t n = run.elements.size();
    const auto& last = run.elements[start ? 0 : n - 1];
    const auto& middle = run.elements[start ? 1 : n - 2];
    const auto& first = run.elements[start ? 2 : n - 3];
    return last.arc && !last.convex && !middle.arc && !first.arc && middle.cylinder && !first.cylinder;
}

bool tryUndercut(Model& model, std::size_t r, bool start)
{
    const Run before = model.runs[r];
    const std::size_t n = before.elements.size();
    if (n < 2 || model.planes[start ? before.left : before.right].data_end || !isFoot(model, r, start)) return false;
    if (n >= 4 && isUndercut(before, start)) return false;
    const double plane = start ? before.nodes_mm.front() : before.nodes_mm.back();
    Run chosen = before;
    bool found = false;
    for (std::size_t rows = 1; rows <= std::min(undercutLimits.most_replaced_rows, n - 1); ++rows) {
        const std::size_t first = start ? 0 : n - rows, last = start ? rows - 1 : n - 1;
        const Element& base = before.elements[start ? rows : n - rows - 1];
        const double from = start ? before.nodes_mm[rows] : before.nodes_mm[n - rows];
        if (base.arc || base.rough || !(std::abs(base.slope) < undercutLimits.largest_shaft_slope) ||
            !(std::abs(plane - from) < undercutLimits.longest_mm) ||
            std::any_of(before.elements.begin() + static_cast<std::ptrdiff_t>(first),
                        before.elements.begin() + static_cast<std::ptrdiff_t>(last) + 1,
                        [](const Element& e) { return e.rough; }))
            continue;
        const double level = base.radiusAt_mm(from);
        const double depth = level - deepest(before, std::min(from, plane), std::max(from, plane), level);
        if (depth < std::max(undercutLimits.shallowest_mm, model.sigma_mm)) continue;
        const Scope scope = scopeOf(before, r, first, last);
        model.runs[r] = before;
        double best = criterion(model, scope, undercutLimits.before_iterations) - selectionLimits.least_gain;
        if (found) {  // an undercut found with fewer rows is compared over the same stretch
            model.runs[r] = chosen;
            Scope wider = scope;
            wider.window.last = std::min(chosen.elements.size() - 1, scope.window.last + chosen.elements.size() - n);
            best = std::min(best, criterion(model, wider, undercutLimits.before_iterations));
        }
        for (const double radius : undercutLimits.radii_mm) {
            const auto undercut = fittedUndercut(from, plane, level, depth, radius);
            if (!undercut) continue;
            model.runs[r] = replaced(before, start, rows, *undercut);
            resolve(model, model.runs[r]);
            Scope own = scope;
            own.window.last = scope.window.last + 3 - rows;
            const double value = criterion(model, own, undercutLimits.iterations);
            if (!(value < best) || model.runs[r].violation > selectionLimits.largest_violation) continue;
            best = value;
            chosen = model.runs[r];
            found = true;
        }
    }
    model.runs[r] = chosen;
    resolve(model, model.runs[r]);
    return found;
}

}  // namespace

int tryUndercuts(Model& model, const Progress& progress)
{
    int inserted = 0;
    for (std::size_t r = 0; r < model.runs.size(); ++r)
        for (const bool start : {true, false}) {
            progress.check();
            inserted += tryUndercut(model, r, start) ? 1 : 0;
        }
    return inserted;
}

}  // namespace lathelier::features
