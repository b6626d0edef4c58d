#include "engine/features/refit/model_edit.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "engine/features/model/model_limits.h"
#include "engine/features/model/selection.h"
#include "engine/features/refit/refit_codes.h"
#include "engine/features/refit/refit_limits.h"

namespace lathelier::features {
namespace {

std::ptrdiff_t at(std::size_t index)
{
    return static_cast<std::ptrdiff_t>(index);
}

[[noreturn]] void refuse(std::int64_t row, Text reason)
{
    throw Error(errors::rowNotChangeable, {{"row", row}, {"reason", reason}});
}

/// Which run, which of its elements.
struct ElementPlace {
    std::size_t run = 0, element = 0;
};

ElementPlace elementPlaceOf(const Model& model, const RowChange& change)
{
    std::size_t before = 0;
    const auto row = static_cast<std::size_t>(change.row - 1);
    for (std::size_t r = 0; change.row >= 1 && r < model.runs.size(); ++r) {
        const std::size_t count = model.runs[r].elements.size();
        if (row < before + count) return {r, row - before};
        before += count;
    }
    throw Error(errors::rowNotThere, {{"row", change.row}, {"rows", static_cast<std::int64_t>(countRows(model))}});
}

/// A plane behind element k: the run becomes two.
void putPlane(Model& model, std::size_t r, std::size_t k, double z_mm, double sigma_mm)
{
    Run& left = model.runs[r];
    const std::size_t index = left.right;
    Plane plane;
    plane.z_mm = plane.seen_mm = z_mm;
    plane.sigma_mm = sigma_mm;
    model.planes.insert(model.planes.begin() + at(index), plane);
    for (std::size_t i = r + 1; i < model.runs.size(); ++i) {
        ++model.runs[i].left;
        ++model.runs[i].right;
    }
    Run right;
    right.left = index;
    right.right = index + 1;
    right.elements.assign(left.elements.begin() + at(k + 1), left.elements.end());
    right.nodes_mm.assign(left.nodes_mm.begin() + at(k + 1), left.nodes_mm.end());
    left.elements.resize(k + 1);
    left.nodes_mm.resize(k + 2);
    left.nodes_mm.back() = right.nodes_mm.front() = z_mm;
    const auto cut = std::lower_bound(left.walls.begin(), left.walls.end(), z_mm,
                                      [](const Wall& wall, double z) { return wall.z_mm < z; });
    right.walls.assign(cut, left.walls.end());
    left.walls.erase(cut, left.walls.end());
    releaseLostTies(left);
    releaseLostTies(right);
    model.runs.insert(model.runs.begin() + at(r + 1), std::move(right));
}

/// Planes between lines that do not meet.
void partParallels(Model& model, std::size_t r, double sigma_mm)
{
    for (std::size_t k = 0; k + 1 < model.runs[r].elements.size(); ++k) {
        const Element &a = model.runs[r].elements[k], &b = model.runs[r].elements[k + 1];
        if (a.arc || b.arc || std::abs(a.slope - b.slope) > refitLimits.parallel_slope) continue;
        putPlane(model, r, k, model.runs[r].nodes_mm[k + 1], sigma_mm);
        return partParallels(model, r + 1, sigma_mm);
    }
}

void erasePlane(Model& model, std::size_t index)
{
    model.planes.erase(model.planes.begin() + at(index));
    for (Run& run : model.runs) {
        if (run.left > index) --run.left;
        if (run.right > index) --run.right;
    }
}

/// Removes the run; the neighbour nearer in radius is extended over its place.
void deleteRun(Outline& outline, std::size_t r, std::int64_t row)
{
    Model& model = outline.model;
    const Run run = model.runs[r];
    const auto isJoined = [&](std::size_t a) { return model.runs[a].right == model.runs[a + 1].left; };
    const bool before = r > 0 && isJoined(r - 1), after = r + 1 < model.runs.size() && isJoined(r);
    if (!before && !after) refuse(row, LT_TEXT("Engine", "there is no row beside it that could take its place"));
    const double off_before =
        before ? std::abs(endRadius_mm(model.runs[r - 1]) - startRadius_mm(run)) : std::numeric_limits<double>::max();
    const double off_after =
        after ? std::abs(startRadius_mm(model.runs[r + 1]) - endRadius_mm(run)) : std::numeric_limits<double>::max();
    if (off_before <= off_after) {
        model.runs[r - 1].nodes_mm.back() = run.nodes_mm.back();
        model.runs[r - 1].right = run.right;
        erasePlane(model, run.left);
    } else {
        model.runs[r + 1].nodes_mm.front() = run.nodes_mm.front();
        model.runs[r + 1].left = run.left;
        erasePlane(model, run.right);
    }
    model.runs.erase(model.runs.begin() + at(r));
}

void deleteElement(Outline& outline, const ElementPlace& place, std::int64_t row)
{
    Model& model = outline.model;
    Run& run = model.runs[place.run];
    if (run.elements.size() < 2) return deleteRun(outline, place.run, row);
    const std::size_t k = place.element;
    const double from = run.nodes_mm[k], to = run.nodes_mm[k + 1];
    const bool first = k == 0, last = k + 1 == run.elements.size();
    run.elements.erase(run.elements.begin() + at(k));
    run.nodes_mm.erase(run.nodes_mm.begin() + at(first ? 1 : k));
    if (!first && !last) run.nodes_mm[k] = (from + to) / 2;
    // The walls of the row are left out: they would bias the neighbours.
    std::erase_if(run.walls, [&](const Wall& wall) { return wall.z_mm > from && wall.z_mm < to; });
    releaseLostTies(run);
    partParallels(model, place.run,
                  std::max(refitLimits.chosen_place_sigma_mm, (to - from) / refitLimits.deleted_row_part));
}

Element lineThrough(double z0, double r0, double z1, double r1, bool cylinder)
{
    Element line;
    line.cylinder = cylinder;
    line.at_mm = (z0 + z1) / 2;
    line.level_mm = (r0 + r1) / 2;
    line.slope = cylinder ? 0 : (r1 - r0) / std::max(refitLimits.least_length_mm, z1 - z0);
    return line;
}

/// One element in place of a (from z0) and b (to z1).
Element merged(const Element& a, const Element& b, double z0, double middle, double z1)
{
    const double r0 = a.radiusAt_mm(z0), r1 = b.radiusAt_mm(z1);
    if (a.arc && b.arc && a.convex == b.convex)
        return arcOverChord(z0, r0, z1, r1, (a.radius_mm() + b.radius_mm()) / 2, a.convex);
    if (!a.cylinder || !b.cylinder) return lineThrough(z0, r0, z1, r1, false);
    Element both = lineThrough(z0, r0, z1, r1, true);
    both.level_mm =
        (a.level_mm * (middle - z0) + b.level_mm * (z1 - middle)) / std::max(refitLimits.least_length_mm, z1 - z0);
    return both;
}

void mergeElements(Outline& outline, const ElementPlace& place, std::int64_t row)
{
    Model& model = outline.model;
    std::size_t k = place.element;
    if (k + 1 == model.runs[place.run].elements.size()) {  // over a plane, or over a gap in the data
        if (place.run + 1 == model.runs.size()) refuse(row, LT_TEXT("Engine", "there is no row after it"));
        Run& a = model.runs[place.run];
        const Run b = model.runs[place.run + 1];
        const std::size_t first = a.right, second = b.left;
        if (first != second) {
            const double from = model.planes[first].z_mm, to = model.planes[second].z_mm;
            std::erase_if(outline.gaps, [&](const Gap& gap) { return gap.z_start_mm < to && gap.z_end_mm > from; });
        }
        a.elements.insert(a.elements.end(), b.elements.begin(), b.elements.end());
        a.nodes_mm.insert(a.nodes_mm.end(), b.nodes_mm.begin() + 1, b.nodes_mm.end());
        a.walls.insert(a.walls.end(), b.walls.begin(), b.walls.end());
        a.right = b.right;
        model.runs.erase(model.runs.begin() + at(place.run + 1));
        if (first != second) erasePlane(model, second);
        erasePlane(model, first);
    }
    Run& run = model.runs[place.run];
    if (run.elements[k].rough || run.elements[k + 1].rough)
        refuse(row, LT_TEXT("Engine", "a thread or a knurl stays a row of its own"));
    run.elements[k] =
        merged(run.elements[k], run.elements[k + 1], run.nodes_mm[k], run.nodes_mm[k + 1], run.nodes_mm[k + 2]);
    run.elements.erase(run.elements.begin() + at(k + 1));
    run.nodes_mm.erase(run.nodes_mm.begin() + at(k + 1));
    releaseLostTies(run);
    partParallels(model, place.run, refitLimits.chosen_place_sigma_mm);
}

void splitElement(Model& model, const ElementPlace& place, double z_mm, std::int64_t row)
{
    Run& run = model.runs[place.run];
    const std::size_t k = place.element;
    if (run.elements[k].rough) refuse(row, LT_TEXT("Engine", "a thread or a knurl stays a row of its own"));
    constexpr double least_mm = refitLimits.least_row_mm;
    if (!(z_mm > run.nodes_mm[k] + least_mm && z_mm < run.nodes_mm[k + 1] - least_mm))
        refuse(row, LT_TEXT("Engine", "the place of the cut does not lie inside it"));
    run.elements.insert(run.elements.begin() + at(k + 1), run.elements[k]);
    run.nodes_mm.insert(run.nodes_mm.begin() + at(k + 1), z_mm);
    putPlane(model, place.run, k, z_mm, refitLimits.chosen_place_sigma_mm);
}

/// The arc with the ties of least criterion: misfit plus the price of the free parameters.
void fitArc(Model& model, const ElementPlace& place, bool convex)
{
    Run& run = model.runs[place.run];
    const std::size_t k = place.element, last = run.elements.size() - 1;
    const double z0 = run.nodes_mm[k], z1 = run.nodes_mm[k + 1];
    const double r0 = run.elements[k].radiusAt_mm(z0), r1 = run.elements[k].radiusAt_mm(z1);
    const double chord = std::hypot(z1 - z0, r1 - r0);
    const std::vector<Tie> starts = possibleTies(model, run, k, true), ends = possibleTies(model, run, k, false);
    const Window window{place.run, k > 0 ? k - 1 : k, std::min(k + 1, last)};
    const double price =
        selectionLimits.parameter_price * std::log(static_cast<double>(std::max<std::size_t>(2, run.walls.size())));
    const Run before = run;
    double best = std::numeric_limits<double>::infinity();
    Run chosen = run;
    for (const double chords : refitLimits.arc_chords)
        for (const Tie start : starts)
            for (const Tie end : ends) {
                run = before;
                run.elements[k] = arcOverChord(z0, r0, z1, r1, chords * chord, convex);
                run.elements[k].start = start;
                run.elements[k].end = end;
                resolve(model, run);
                const double chi2 = fitWindow(model, window, refitLimits.arc_iterations);
                const auto free = static_cast<double>(slotsOf(model, window.run, window.first, window.last).size());
                const double value = chi2 + price * free;
                if (!(value < best)) continue;
                best = value;
                chosen = run;
            }
    run = chosen;
}

void changeKind(Model& model, const ElementPlace& place, RowChange::What what, std::int64_t row)
{
    Run& run = model.runs[place.run];
    Element& e = run.elements[place.element];
    if (e.rough) refuse(row, LT_TEXT("Engine", "a thread or a knurl stays a row of its own"));
    const double z0 = run.nodes_mm[place.element], z1 = run.nodes_mm[place.element + 1];
    if (what == RowChange::What::Round || what == RowChange::What::Fillet)
        return fitArc(model, place, what == RowChange::What::Round);
    e = lineThrough(z0, e.radiusAt_mm(z0), z1, e.radiusAt_mm(z1), what == RowChange::What::Cylinder);
    releaseLostTies(run);
    partParallels(model, place.run, refitLimits.chosen_place_sigma_mm);
}

}  // namespace

std::size_t countRows(const Model& model)
{
    std::size_t count = 0;
    for (const Run& run : model.runs) count += run.elements.size();
    return count;
}

void changeStructure(Outline& outline, const RowChange& change, double zero_mm)
{
    Model& model = outline.model;
    const ElementPlace place = elementPlaceOf(model, change);
    switch (change.what) {
        case RowChange::What::Delete: deleteElement(outline, place, change.row); break;
        case RowChange::What::Merge: mergeElements(outline, place, change.row); break;
        case RowChange::What::Split: splitElement(model, place, change.z_mm + zero_mm, change.row); break;
        default: changeKind(model, place, change.what, change.row); break;
    }
    for (Run& run : model.runs) resolve(model, run);
}

}  // namespace lathelier::features
