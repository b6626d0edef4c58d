#include "engine/features/model/selection.h"

#include <algorithm>
#include <cmath>

#include "engine/features/model/model_fit.h"
#include "engine/features/model/model_limits.h"
#include "engine/features/model/selection_criterion.h"

namespace lathelier::features {
namespace {

/// A trial run in place of the present one.
struct Trial {
    Run run;
    double value = 0;
};

/// Price of a slope that rises into the foot of a shoulder: it is more often a fillet than a cone.
double priorOf(const Model& model, std::size_t r, std::size_t k)
{
    const Run& run = model.runs[r];
    const Element& e = run.elements[k];
    if (e.arc || e.cylinder || std::abs(e.slope) < selectionLimits.unusual_cone_slope ||
        run.nodes_mm[k + 1] - run.nodes_mm[k] > selectionLimits.longest_unusual_cone_mm)
        return 0;
    const bool rises_into_foot = (k == 0 && e.slope < 0 && isFoot(model, r, true)) ||
                                 (k + 1 == run.elements.size() && e.slope > 0 && isFoot(model, r, false));
    return rises_into_foot ? selectionLimits.unusual_cone_price : 0;
}

bool isConsistent(const Run& run)
{
    return !(run.violation > selectionLimits.largest_violation);
}

bool selectKind(Model& model, std::size_t r, std::size_t k)
{
    const Run before = model.runs[r];
    const double z0 = before.nodes_mm[k], z1 = before.nodes_mm[k + 1], length = z1 - z0;
    const Scope scope = scopeOf(before, r, k, k);
    const double r0 = before.elements[k].radiusAt_mm(z0), r1 = before.elements[k].radiusAt_mm(z1);
    Trial best{before, 0};
    best.value = criterion(model, scope, selectionLimits.start_iterations) + priorOf(model, r, k);
    best.run = model.runs[r];
    bool changed = false;
    const auto attempt = [&](const Element& element) {
        model.runs[r] = before;
        model.runs[r].elements[k] = element;
        releaseLostTies(model.runs[r]);
        const double value = criterion(model, scope, selectionLimits.kind_iterations) + priorOf(model, r, k);
        if (!(value < best.value - selectionLimits.kind_gain) || !isConsistent(model.runs[r])) return;
        best = {model.runs[r], value};
        changed = true;
    };
    Element line;
    line.at_mm = (z0 + z1) / 2;
    line.level_mm = (r0 + r1) / 2;
    line.cylinder = true;
    if (before.elements[k].arc || !before.elements[k].cylinder) attempt(line);
    line.cylinder = false;
    line.slope = (r1 - r0) / std::max(length, 1e-6);
    if (before.elements[k].arc) attempt(line);
    if (before.elements[k].flat) {  // too long for the starts of a fillet
        model.runs[r] = best.run;
        resolve(model, model.runs[r]);
        return changed;
    }
    const double chord = std::hypot(length, r1 - r0);
    for (const bool convex : {false, true})
        for (const Tie start : possibleTies(model, before, k, true))
            for (const Tie end : possibleTies(model, before, k, false)) {
                if (start == Tie::Plane && end == Tie::Plane) continue;
                const bool both_tied = start != Tie::Free && end != Tie::Free;
                for (const double chords : {selectionLimits.small_arc_chords, selectionLimits.large_arc_chords}) {
                    if (both_tied && chords == selectionLimits.large_arc_chords) continue;
                    Element arc = arcOverChord(z0, r0, z1, r1, chords * chord, convex);
                    arc.start = start;
                    arc.end = end;
                    attempt(arc);
                }
            }
    model.runs[r] = best.run;
    resolve(model, model.runs[r]);
    return changed;
}

/// Inserts an element at `at`, the corner at z = `node`, with starting values of the nodes on both of its sides.
void insertElement(Run& run, std::size_t at, double node, const Element& element)
{
    run.elements.insert(run.elements.begin() + static_cast<std::ptrdiff_t>(at), element);
    run.nodes_mm.insert(run.nodes_mm.begin() + static_cast<std::ptrdiff_t>(at), node);
    const double half =
        selectionLimits.start_half_share * (element.arc ? element.radius_mm() : selectionLimits.start_line_mm);
    if (at > 0) run.nodes_mm[at] = node - half;
    if (at + 1 < run.nodes_mm.size() - 1) run.nodes_mm[at + 1] = node + half;
}

/// Inserts the better of the elements at `at` when its gain exceeds its price plus the margin.
bool tryInsert(Model& model, std::size_t r, std::size_t at, const std::vector<Element>& elements)
{
    constexpr double reach_mm = selectionLimits.insert_reach_mm;
    const Run before = model.runs[r];
    const double node = before.nodes_mm[at];
    const std::size_t first = at > 0 ? at - 1 : at, last = std::min(at, before.elements.size() - 1);
    const double from = std::max(before.nodes_mm.front(), node - reach_mm),
                 to = std::min(before.nodes_mm.back(), node + reach_mm);
    const double without = fitWindow(model, {r, first, last}, from, to, selectionLimits.before_iterations);
    const double price_without = price(model, slotsOf(model, r, first, last).size());
    const Run kept = model.runs[r];
    Trial best{before, without + price_without - selectionLimits.least_gain};
    bool found = false;
    for (const Element& element : elements) {
        model.runs[r] = kept;
        Run& run = model.runs[r];
        insertElement(run, at, node, element);
        const std::size_t end = std::min(last + 1, run.elements.size() - 1);
        const double value = fitWindow(model, {r, first, end}, from, to, selectionLimits.insert_iterations) +
                             price(model, slotsOf(model, r, first, end).size());
        if (!(value < best.value) || !isConsistent(run)) continue;
        best = {run, value};
        found = true;
    }
    model.runs[r] = best.run;
    resolve(model, model.runs[r]);
    return found;
}

bool isDropCheap(Model& model, std::size_t r, std::size_t k)
{
    const Run before = model.runs[r];
    if (before.elements.size() < 2) return false;
    const double length = before.nodes_mm[k + 1] - before.nodes_mm[k];
    const std::size_t first = k > 0 ? k - 1 : k, last = std::min(k + 1, before.elements.size() - 1);
    constexpr double reach_mm = selectionLimits.drop_reach_mm;
    const double from = std::max(before.nodes_mm[first], before.nodes_mm[k] - reach_mm),
                 to = std::min(before.nodes_mm[last + 1], before.nodes_mm[k + 1] + reach_mm);
    const double with = fitWindow(model, {r, first, last}, from, to, selectionLimits.before_iterations);
    const std::size_t parameters = slotsOf(model, r, first, last).size();
    Run& run = model.runs[r];
    const Run kept = run;
    run.elements.erase(run.elements.begin() + static_cast<std::ptrdiff_t>(k));
    run.nodes_mm.erase(run.nodes_mm.begin() + static_cast<std::ptrdiff_t>(k == 0 ? 1 : k));
    releaseLostTies(run);
    const std::size_t end = std::min(last > 0 ? last - 1 : 0, run.elements.size() - 1);
    const std::size_t begin = std::min(first, end);
    resolve(model, run);
    const double without = fitWindow(model, {r, begin, end}, from, to, selectionLimits.insert_iterations);
    const double saved = price(model, parameters) - price(model, slotsOf(model, r, begin, end).size());
    const double allowed =
        saved + selectionLimits.drop_gain + (length < model.spot_mm ? selectionLimits.drop_gain_below_spot : 0);
    if (without - with < allowed && run.violation < selectionLimits.largest_violation) return true;
    run = kept;
    resolve(model, run);
    return false;
}

bool isMergeCheap(Model& model, std::size_t r, std::size_t k)
{
    const Run before = model.runs[r];
    const Element& a = before.elements[k];
    const Element& b = before.elements[k + 1];
    if (a.arc || b.arc || a.rough || b.rough) return false;
    if (std::abs(std::atan(a.slope) - std::atan(b.slope)) > selectionLimits.merged_bend_rad) return false;
    const double from = before.nodes_mm[k], to = before.nodes_mm[k + 2];
    const double with = fitWindow(model, {r, k, k + 1}, from, to, selectionLimits.before_iterations);
    const std::size_t parameters = slotsOf(model, r, k, k + 1).size();
    const Run kept = model.runs[r];
    Run& run = model.runs[r];
    Element merged;
    merged.at_mm = (from + to) / 2;
    const double r0 = a.radiusAt_mm(from), r1 = b.radiusAt_mm(to);
    merged.level_mm = (r0 + r1) / 2;
    for (const bool cylinder : {true, false}) {
        merged.cylinder = cylinder;
        merged.slope = cylinder ? 0 : (r1 - r0) / (to - from);
        run = kept;
        run.elements.erase(run.elements.begin() + static_cast<std::ptrdiff_t>(k));
        run.elements[k] = merged;
        run.nodes_mm.erase(run.nodes_mm.begin() + static_cast<std::ptrdiff_t>(k + 1));
        resolve(model, run);
        const double without = fitWindow(model, {r, k, k}, from, to, selectionLimits.merge_iterations);
        const double saved = price(model, parameters) - price(model, slotsOf(model, r, k, k).size());
        if (without - with < saved + selectionLimits.drop_gain && run.violation < selectionLimits.largest_violation)
            return true;
    }
    run = kept;
    resolve(model, run);
    return false;
}

/// A cone at the start of a thread or a knurl: too little of it is seen between the grooves to distinguish it from an
/// arc.
bool isLeadIntoRough(const Model& model, std::size_t r, std::size_t k)
{
    const Run& run = model.runs[r];
    const bool before =
        k == 0 && r > 0 && model.runs[r - 1].right == run.left && model.runs[r - 1].elements.back().rough;
    const bool behind = k + 1 == run.elements.size() && r + 1 < model.runs.size() &&
                        model.runs[r + 1].left == run.right && model.runs[r + 1].elements.front().rough;
    return before || behind;
}

/// Tries fillets at the sharp corners between lines of one run.
int tryFillets(Model& model, std::size_t r, const Progress& progress)
{
    constexpr double half_mm = selectionLimits.corner_half_chord_mm;
    int inserted = 0;
    for (std::size_t k = 0; k + 1 < model.runs[r].elements.size(); ++k) {
        progress.check();
        const Run& run = model.runs[r];
        const Element &a = run.elements[k], &b = run.elements[k + 1];
        if (a.arc || b.arc) continue;
        const double bend = std::atan(b.slope) - std::atan(a.slope);
        if (std::abs(bend) < selectionLimits.least_bend_rad) continue;
        std::vector<Element> arcs;
        for (const double radius : {selectionLimits.small_fillet_mm, selectionLimits.large_fillet_mm}) {
            Element arc =
                arcOverChord(run.nodes_mm[k + 1] - half_mm, 0, run.nodes_mm[k + 1] + half_mm, 0, radius, bend < 0);
            arc.start = arc.end = Tie::Tangent;
            arcs.push_back(arc);
        }
        if (!tryInsert(model, r, k + 1, arcs)) continue;
        ++inserted;
        ++k;
    }
    return inserted;
}

/// Tries fillets, rounds and a chamfer where a run ends at a plane.
bool tryPlaneCorner(Model& model, std::size_t r, bool start)
{
    constexpr double half_mm = selectionLimits.corner_half_chord_mm;
    const Run& run = model.runs[r];
    const Plane& plane = model.planes[start ? run.left : run.right];
    const Element& own = start ? run.elements.front() : run.elements.back();
    if (plane.data_end || own.arc || own.rough || std::abs(own.slope) > selectionLimits.steepest_wall_slope)
        return false;
    const bool foot = isFoot(model, r, start);
    const double z = plane.z_mm, radius = own.radiusAt_mm(z), inward = start ? 1 : -1;
    std::vector<Element> tries;
    for (const double rho : {selectionLimits.small_round_mm, selectionLimits.large_round_mm}) {
        Element arc = arcOverChord(z - half_mm, radius, z + half_mm, radius, rho, !foot);
        (start ? arc.start : arc.end) = Tie::Plane;
        (start ? arc.end : arc.start) = Tie::Tangent;
        tries.push_back(arc);
    }
    Element chamfer;
    chamfer.at_mm = z;
    chamfer.level_mm = radius + (foot ? selectionLimits.chamfer_mm : -selectionLimits.chamfer_mm);
    chamfer.slope = (foot ? -1 : 1) * inward;
    tries.push_back(chamfer);
    return tryInsert(model, r, start ? 0 : run.elements.size(), tries);
}

}  // namespace

std::vector<Tie> possibleTies(const Model& model, const Run& run, std::size_t k, bool start)
{
    const bool at_plane = start ? k == 0 : k + 1 == run.elements.size();
    if (at_plane) {
        const Plane& plane = model.planes[start ? run.left : run.right];
        if (plane.data_end) return {Tie::Free};
        return {Tie::Free, Tie::Plane};
    }
    if (run.elements[start ? k - 1 : k + 1].arc) return {Tie::Free};
    return {Tie::Free, Tie::Tangent};
}

Element arcOverChord(double z0, double r0, double z1, double r1, double radius_mm, bool convex)
{
    const double chord = std::hypot(z1 - z0, r1 - r0),
                 rho = std::max(radius_mm, selectionLimits.least_chord_ratio * chord);
    const double height = (convex ? 1 : -1) * std::sqrt(std::max(0.0, rho * rho - chord * chord / 4));
    Element arc;
    arc.arc = true;
    arc.convex = convex;
    arc.log_radius = std::log(std::max(rho, selectionLimits.least_radius_mm));
    arc.centre_z_mm = (z0 + z1) / 2 + height * (r1 - r0) / std::max(chord, 1e-9);
    arc.centre_r_mm = (r0 + r1) / 2 - height * (z1 - z0) / std::max(chord, 1e-9);
    return arc;
}

bool isSignificantSlope(const Piece& piece)
{
    return !(std::abs(piece.slope) < selectionLimits.significant_errors * piece.slope_error);
}

std::vector<Element> elementsOf(const std::vector<Piece>& pieces, std::span<const Wall> walls, double form_mm)
{
    std::vector<Element> elements;
    for (const Piece& piece : pieces) {
        const double z0 = walls[piece.begin].z_mm, z1 = walls[piece.end - 1].z_mm;
        Element element;
        element.level_mm = piece.level_mm;
        element.at_mm = piece.at_mm;
        element.slope = piece.slope;
        const double fall = std::abs(piece.slope) * (z1 - z0);
        element.cylinder = fall < form_mm || !isSignificantSlope(piece);
        if (element.cylinder) element.slope = 0;
        const double chord = z1 - z0, sagitta = piece.arc ? chord * chord / (8 * piece.radius_mm) : 0;
        if (piece.arc && sagitta >= form_mm / 2) {
            element.arc = true;
            element.convex = piece.convex;
            element.log_radius = std::log(std::max(piece.radius_mm, selectionLimits.least_radius_mm));
            element.centre_z_mm = piece.centre_z_mm;
            element.centre_r_mm = piece.centre_r_mm;
            element.flat = piece.flat;
            if (piece.flat) {
                element.slope = piece.slope;
                element.cylinder = false;
            }
        }
        elements.push_back(element);
    }
    return elements;
}

int selectKinds(Model& model, const Progress& progress)
{
    int changed = 0;
    for (std::size_t r = 0; r < model.runs.size(); ++r)
        for (std::size_t k = 0; k < model.runs[r].elements.size(); ++k) {
            progress.check();
            const Element& e = model.runs[r].elements[k];
            const double length = model.runs[r].nodes_mm[k + 1] - model.runs[r].nodes_mm[k];
            if (e.rough || (!e.arc && (e.cylinder || length > selectionLimits.longest_doubtful_cone_mm))) continue;
            if (!e.arc && isLeadIntoRough(model, r, k)) continue;
            changed += selectKind(model, r, k) ? 1 : 0;
        }
    return changed;
}

int tryCorners(Model& model, const Progress& progress)
{
    int inserted = 0;
    for (std::size_t r = 0; r < model.runs.size(); ++r) {
        inserted += tryFillets(model, r, progress);
        for (const bool start : {true, false}) {
            progress.check();
            inserted += tryPlaneCorner(model, r, start) ? 1 : 0;
        }
    }
    return inserted;
}

int simplify(Model& model, const Progress& progress)
{
    int removed = 0;
    for (std::size_t r = 0; r < model.runs.size(); ++r) {
        for (std::size_t k = 0; k < model.runs[r].elements.size();) {
            progress.check();
            const Run& run = model.runs[r];
            const double length = run.nodes_mm[k + 1] - run.nodes_mm[k];
            const double limit =
                model.corner_mm > 0 ? selectionLimits.short_surface_element_mm : selectionLimits.short_element_mm;
            if (!run.elements[k].rough && length < limit && isDropCheap(model, r, k)) {
                ++removed;
                k = k > 0 ? k - 1 : 0;
            } else {
                ++k;
            }
        }
        for (std::size_t k = 0; k + 1 < model.runs[r].elements.size();) {
            progress.check();
            if (isMergeCheap(model, r, k))
                ++removed;
            else
                ++k;
        }
    }
    return removed;
}

}  // namespace lathelier::features
