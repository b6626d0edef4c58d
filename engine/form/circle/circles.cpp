#include "engine/form/circle/circles.h"

#include <algorithm>
#include <cmath>

#include "engine/core/units.h"
#include "engine/form/circle/circle_enclosing.h"
#include "engine/form/circle/circle_least_squares.h"
#include "engine/form/circle/circle_region.h"
#include "engine/form/circle/circle_zone.h"

namespace lathelier::form {
namespace {

using Eigen::Vector2d;
using Side = CircleContact::Side;

/// Centre, radii and RONt; the radius proper is filled by the caller.
FittedCircle measured(const CirclePoints& points, const Vector2d& centre)
{
    const CirclePoints::Extremes e = points.extremes(centre);
    FittedCircle circle;
    circle.centre_mm = points.toMm(centre);
    circle.inner_radius_mm = e.nearest * points.scale_mm();
    circle.outer_radius_mm = e.farthest * points.scale_mm();
    circle.RONt_um = e.width() * points.scale_mm() * um_per_mm;
    return circle;
}

FittedCircle toResult(const CirclePoints& points, const LeastSquaresCircle& fit)
{
    FittedCircle circle = measured(points, fit.centre);
    circle.radius_mm = fit.radius * points.scale_mm();
    circle.RONp_um = (circle.outer_radius_mm - circle.radius_mm) * um_per_mm;
    circle.RONv_um = (circle.radius_mm - circle.inner_radius_mm) * um_per_mm;
    circle.RONq_um = fit.rms * points.scale_mm() * um_per_mm;
    return circle;
}

FittedCircle toResult(const CirclePoints& points, const EnclosingCircle& fit)
{
    FittedCircle circle = measured(points, fit.centre);
    circle.radius_mm = circle.outer_radius_mm;
    for (const std::size_t index : fit.contacts) circle.contacts.push_back({index, Side::Outer});
    std::sort(circle.contacts.begin(), circle.contacts.end(),
              [](const CircleContact& a, const CircleContact& b) { return a.index < b.index; });
    return circle;
}

FittedCircle toResult(const CirclePoints& points, const ZoneOptimum& fit)
{
    FittedCircle circle = measured(points, fit.centre);
    circle.held = fit.held;
    for (const std::size_t index : fit.outer) circle.contacts.push_back({index, Side::Outer});
    for (const std::size_t index : fit.inner) circle.contacts.push_back({index, Side::Inner});
    std::sort(circle.contacts.begin(), circle.contacts.end(),
              [](const CircleContact& a, const CircleContact& b) { return a.index < b.index; });
    return circle;
}

/// Gap at which the certificate is complete, in the unit of the points.
double toleranceOf(const CirclePoints& points, const ZoneOptimum& best, const CircleOptions& options)
{
    const double rounding = 1e-15 * (1 + best.centre.norm());
    return std::max(
        {options.certificate_um / um_per_mm / points.scale_mm(), options.certificate_relative * best.width, rounding});
}

void prove(ZoneProblem& problem, const CirclePoints& points, const Vector2d& middle, double half,
           const CircleOptions& options, ZoneOptimum& best, FittedCircle& circle)
{
    if (!options.certify) {
        circle = toResult(points, best);
        return;
    }
    const ZoneProof proof =
        problem.prove(best, middle, half, toleranceOf(points, best, options), options.certificate_nodes);
    circle = toResult(points, best);
    circle.certified_gap_um = proof.gap * points.scale_mm() * um_per_mm;
    circle.unique = proof.unique;
}

}  // namespace

std::string_view name(ReferenceCircle circle)
{
    switch (circle) {
        case ReferenceCircle::LSCI: return "LSCI";
        case ReferenceCircle::MZCI: return "MZCI";
        case ReferenceCircle::MICI: return "MICI";
        case ReferenceCircle::MCCI: return "MCCI";
    }
    return {};
}

const FittedCircle& ReferenceCircles::of(ReferenceCircle circle) const
{
    switch (circle) {
        case ReferenceCircle::MZCI: return MZCI;
        case ReferenceCircle::MICI: return MICI;
        case ReferenceCircle::MCCI: return MCCI;
        case ReferenceCircle::LSCI: break;
    }
    return LSCI;
}

FittedCircle fitLeastSquaresCircle(std::span<const Vector2d> points_mm)
{
    const CirclePoints points(points_mm, 3);
    return toResult(points, leastSquaresCircle(points));
}

ReferenceCircles fitCircles(std::span<const Vector2d> points_mm, const CircleOptions& options, const Progress& progress)
{
    progress.report(0);
    CirclePoints points(points_mm, 4);
    points.prepareForManyCentres();
    progress.report(0.05);
    ReferenceCircles circles;
    const LeastSquaresCircle least_squares = leastSquaresCircle(points);
    circles.LSCI = toResult(points, least_squares);
    progress.report(0.2);
    const EnclosingCircle enclosing = enclosingCircle(points);
    circles.MCCI = toResult(points, enclosing);
    const auto sectors = points.sectors(least_squares.centre);
    progress.report(0.3);

    ZoneProblem inscribed(points, MinimaxGoal::Nearest, inscribedRegion(points, least_squares.centre, sectors),
                          progress);
    inscribed.seed(sectors);
    ZoneOptimum largest = inscribed.descend(least_squares.centre);
    prove(inscribed, points, Vector2d::Zero(),
          std::max(points.extent(), least_squares.centre.lpNorm<Eigen::Infinity>()), options, largest, circles.MICI);
    circles.MICI.radius_mm = circles.MICI.inner_radius_mm;
    progress.report(0.6);

    ZoneProblem zone(points, MinimaxGoal::Width, {}, progress);
    zone.seed(sectors);
    ZoneOptimum narrowest = zone.descend(least_squares.centre);
    // Invariant with or without a certificate: no other reference circle has a smaller zone.
    for (const Vector2d& centre : {largest.centre, enclosing.centre})
        if (points.extremes(centre).width() < narrowest.value)
            if (const ZoneOptimum other = zone.descend(centre); other.value < narrowest.value) narrowest = other;
    prove(zone, points, least_squares.centre, 2 * std::max(points.extent(), least_squares.radius), options, narrowest,
          circles.MZCI);
    circles.MZCI.radius_mm = 0.5 * (circles.MZCI.inner_radius_mm + circles.MZCI.outer_radius_mm);
    progress.report(1);
    return circles;
}

}  // namespace lathelier::form
