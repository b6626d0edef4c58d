#include "engine/features/report/recognition_plots.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>

#include "engine/core/statistics.h"
#include "engine/core/texts.h"
#include "engine/core/units.h"
#include "engine/features/nominal/snap.h"
#include "engine/features/report/recognition_quantities.h"
#include "engine/shaft/shaft_contour.h"

namespace lathelier::features {
namespace {

using Eigen::Vector2d;
using report::Curve;

/// How the charts are laid out; chosen by eye.
struct ChartLayout {
    int arc_chords = 40;
    std::size_t most_labels = 8;          ///< of diameters in the meridian, so that they do not overlap
    double label_place_share = 0.15;      ///< of a row's length: left end of its label
    double labelled_share = 0.04;         ///< of the part's length: shorter cylinders have no label
    double margin_share = 0.03;           ///< of the data's range of z, on both sides
    double disc_ratio = 0.8;              ///< of diameter to length: above it the scales are not equal
    double radius_share = 0.65;           ///< of the largest diameter, shown on both sides of the axis
    double shown_residual_share = 0.995;  ///< of the residuals are within the initial range of the chart
    double residual_room = 1.3;           ///< of the range of the residuals, on both sides
    std::size_t mean_bins = 5;            ///< as the form of a row is judged
};

constexpr ChartLayout chartLayout;

/// Along a piece from its start to its end, arcs cut finely.
std::vector<Vector2d> pointsOf(const ContourPiece& piece)
{
    std::vector<Vector2d> points{piece.from_mm};
    if (piece.isArc()) {
        const Vector2d centre = piece.centre_mm();
        const auto [from, to] = piece.arcAngles();
        for (int i = 1; i < chartLayout.arc_chords; ++i) {
            const double angle = from + (to - from) * i / chartLayout.arc_chords;
            points.push_back(centre + std::abs(piece.arc_radius_mm) * Vector2d(std::cos(angle), std::sin(angle)));
        }
    }
    points.push_back(piece.to_mm);
    return points;
}

/// Range of z of both charts: that of the data, with a margin.
Interval shownRangeOf(const Recognition& result)
{
    double from = std::numeric_limits<double>::infinity(), to = -from;
    const auto add = [&](double z_mm) {
        from = std::min(from, z_mm);
        to = std::max(to, z_mm);
    };
    for (const RecognizedRow& row : result.segments) {
        add(row.z_start_mm);
        add(row.z_end_mm);
    }
    for (const MeridianPoint& point : result.meridian) add(point.z_mm);
    if (!(from < to)) return {0, 1};
    const double margin_mm = chartLayout.margin_share * (to - from);
    return {from - margin_mm, to + margin_mm};
}

/// A disc: at equal scales its rows would be too close to distinguish.
bool isShort(const Recognition& result)
{
    const Interval range = shownRangeOf(result);
    const auto largest = largestDiameter(result);
    return largest && largest->diameter_mm > chartLayout.disc_ratio * (range.to - range.from);
}

report::Axis zAxis(const Recognition& result)
{
    report::Axis axis{LT_TEXT("Engine", "z from the free end"), unit::mm};
    axis.range = shownRangeOf(result);
    return axis;
}

/// A line of several strokes above or below the axis.
class Strokes {
public:
    Strokes(report::Caption name, report::ChartColour colour)
    {
        curve_.name = std::move(name);
        curve_.colour = colour;
    }
    void add(const std::vector<Vector2d>& points, double sign)
    {
        if (points.empty()) return;
        if (!curve_.x.empty()) {
            curve_.x.push_back(points.front().x());
            curve_.y.push_back(notANumber);
        }
        for (const Vector2d& point : points) {
            curve_.x.push_back(point.x());
            curve_.y.push_back(sign * point.y());
        }
    }
    void addTo(report::Plot& plot)
    {
        if (curve_.x.empty()) return;
        curve_.has_readout = false;
        plot.curves.push_back(std::move(curve_));
    }

private:
    Curve curve_;
};

report::ChartColour colourOf(RowKind kind)
{
    switch (kind) {
        case RowKind::Cylinder: return 0;
        case RowKind::Cone: return 1;
        case RowKind::Arc: return 2;
    }
    return {};
}

/// What lies between two radii over the same stretch of z, above or below the axis.
void fill(report::Plot& plot, const std::vector<Vector2d>& outer, const report::ChartColour& colour)
{
    for (const double sign : {1.0, -1.0}) {
        report::Region region;
        region.colour = colour;
        for (const Vector2d& point : outer) {
            region.x.push_back(point.x());
            region.y.push_back(sign * point.y());
        }
        for (const auto& end : {outer.back(), outer.front()}) {
            region.x.push_back(end.x());
            region.y.push_back(0);
        }
        plot.regions.push_back(std::move(region));
    }
}

/// The material of a part with bores.
void fillHollow(report::Plot& plot, const Recognition& result)
{
    const Contour contour = closedContour(measuredShaft(result));
    for (const double sign : {1.0, -1.0}) {
        report::Region region;
        region.colour = report::ColourRole::Original;
        for (const ContourPiece& piece : contour)
            for (const Vector2d& point : pointsOf(piece)) {
                region.x.push_back(point.x());
                region.y.push_back(sign * point.y());
            }
        plot.regions.push_back(std::move(region));
    }
}

Curve binsOf(const Recognition& result)
{
    Curve bins{LT_TEXT("Engine", "data"), {}, {}, Curve::Style::Points};
    bins.colour = report::ColourRole::Neutral;
    bins.thin = true;
    for (const MeridianPoint& point : result.meridian) {
        bins.x.push_back(point.z_mm);
        bins.y.push_back(point.radius_mm);
    }
    return bins;
}

/// The radius of a row over so many bins, as its form is judged; broken between rows.
Curve meansOf(const Recognition& result)
{
    constexpr std::size_t bins = chartLayout.mean_bins;
    Curve means{LT_TEXT("Engine", "mean of five bins"), {}, {}};
    means.colour = report::ColourRole::Copy;
    std::vector<const MeridianPoint*> run;
    const auto close = [&] {
        if (run.size() >= bins && !means.x.empty()) {
            means.x.push_back(run.front()->z_mm);
            means.y.push_back(notANumber);
        }
        for (std::size_t i = 0; i + bins <= run.size(); ++i) {
            double sum_mm = 0;
            for (std::size_t k = 0; k < bins; ++k) sum_mm += run[i + k]->residual_mm;
            means.x.push_back(run[i + bins / 2]->z_mm);
            means.y.push_back(1e3 * sum_mm / bins);
        }
        run.clear();
    };
    for (const MeridianPoint& point : result.meridian) {
        if (point.bore || point.row < 0 || !std::isfinite(point.residual_mm)) continue;
        if (!run.empty() && run.front()->row != point.row) close();
        run.push_back(&point);
    }
    close();
    return means;
}

void addRows(report::Plot& plot, const Recognition& result)
{
    std::array<Strokes, 3> kinds{Strokes(kindName(RowKind::Cylinder), colourOf(RowKind::Cylinder)),
                                 Strokes(kindName(RowKind::Cone), colourOf(RowKind::Cone)),
                                 Strokes(kindName(RowKind::Arc), colourOf(RowKind::Arc))};
    Strokes faces({}, report::ColourRole::Neutral), bores(LT_TEXT("Engine", "bore"), 3);
    const std::vector<RecognizedRow>& rows = result.segments;
    const bool hollow = !result.bores.empty() && result.gaps.empty() && !rows.empty();
    if (hollow) fillHollow(plot, result);
    for (const double sign : {1.0, -1.0}) {
        for (std::size_t i = 0; i < rows.size(); ++i) {
            const std::vector<Vector2d> contour = contourOf(rows[i]);
            kinds[static_cast<std::size_t>(rows[i].kind)].add(contour, sign);
            if (sign > 0 && !hollow) fill(plot, contour, report::ColourRole::Original);
            const bool goes_on = i + 1 < rows.size() && rows[i + 1].z_start_mm - rows[i].z_end_mm < same_mm;
            if (goes_on) faces.add({contour.back(), contourOf(rows[i + 1]).front()}, sign);
        }
        if (rows.empty()) continue;
        const Vector2d first = contourOf(rows.front()).front(), last = contourOf(rows.back()).back();
        faces.add({Vector2d(first.x(), 0), first}, sign);
        faces.add({last, Vector2d(last.x(), 0)}, sign);
        for (const auto& bore : result.bores)
            for (const RecognizedRow& row : bore) bores.add(contourOf(row, true), sign);
    }
    faces.addTo(plot);
    bores.addTo(plot);
    for (Strokes& kind : kinds) kind.addTo(plot);
}

/// Labels: diameters of the longest cylinders in order of z, then the designations of features.
void addNames(report::Plot& plot, const Recognition& result, const Language& language)
{
    const Interval range = *plot.x.range;
    std::vector<const RecognizedRow*> longest;
    for (const RecognizedRow& row : result.segments)
        if (row.kind == RowKind::Cylinder &&
            row.z_end_mm - row.z_start_mm > chartLayout.labelled_share * (range.to - range.from))
            longest.push_back(&row);
    const auto length = [](const RecognizedRow* row) { return row->z_end_mm - row->z_start_mm; };
    std::stable_sort(longest.begin(), longest.end(),
                     [&](const auto* a, const auto* b) { return length(a) > length(b); });
    longest.resize(std::min(longest.size(), chartLayout.most_labels));
    for (const RecognizedRow* row : longest)
        plot.marks.push_back({row->z_start_mm + chartLayout.label_place_share * length(row), row->start_diameter_mm / 2,
                              "⌀ " + shownNumber(row->start_diameter_mm, unit::mm, 3, language)});
    for (const RecognizedFeature& feature : result.features) {
        if (feature.designation.empty() || plot.marks.size() >= 2 * chartLayout.most_labels || feature.rows.empty())
            continue;
        const auto row = static_cast<std::size_t>(feature.rows.front() - 1);
        if (row >= result.segments.size()) continue;
        const RecognizedRow& first = result.segments[row];
        plot.marks.push_back({(feature.z_start_mm + feature.z_end_mm) / 2,
                              -(first.start_diameter_mm + first.end_diameter_mm) / 4, feature.designation});
    }
}

report::Caption captionOf(const Value& name)
{
    if (const auto* text = std::get_if<Text>(&name)) return *text;
    const auto* raw = std::get_if<std::string>(&name);
    return raw ? *raw : std::string();
}

/// Marks and stretches without data, each name once in the legend.
void plotStretches(report::Plot& plot, const Recognition& result)
{
    bool named = false;
    for (const Gap& gap : result.gaps) {
        plot.regions.push_back(report::stretch(named ? Text{} : LT_TEXT("Engine", "no data"),
                                               {gap.z_start_mm, gap.z_end_mm}, report::ColourRole::Limit));
        named = true;
    }
    named = false;
    for (const UnexplainedStructure& one : result.unexplained) {
        plot.regions.push_back(report::stretch(named ? Text{} : LT_TEXT("Engine", "unexplained"),
                                               {one.z_start_mm, std::max(one.z_end_mm, one.z_start_mm + 0.5)},
                                               report::ColourRole::Limit));
        named = true;
    }
    struct MarksOfKind {
        report::Caption name;
        std::vector<Interval> stretches;
    };
    std::map<std::string, MarksOfKind> kinds;  // stretches of one kind that overlap are one
    for (const ShaftMark& mark : result.marks) {
        if (!mark.z_start_mm || !mark.z_end_mm) continue;
        MarksOfKind& own = kinds[key(mark)];
        own.name = captionOf(nameOf(mark));
        own.stretches.push_back({*mark.z_start_mm, *mark.z_end_mm});
    }
    for (auto& [kind, marks] : kinds) {
        auto& [name, stretches] = marks;
        std::sort(stretches.begin(), stretches.end(), [](const auto& a, const auto& b) { return a.from < b.from; });
        std::vector<Interval> whole;
        for (const Interval& one : stretches) {
            if (!whole.empty() && one.from <= whole.back().to)
                whole.back().to = std::max(whole.back().to, one.to);
            else
                whole.push_back(one);
        }
        for (std::size_t i = 0; i < whole.size(); ++i)
            plot.regions.push_back(
                report::stretch(i == 0 ? name : report::Caption(), whole[i], report::ColourRole::Mark));
    }
}

}  // namespace

std::vector<Vector2d> contourOf(const RecognizedRow& row, bool bore)
{
    ContourPiece piece;
    piece.from_mm = {row.z_start_mm, row.start_diameter_mm / 2};
    piece.to_mm = {row.z_end_mm, row.end_diameter_mm / 2};
    const double chord_mm = (piece.to_mm - piece.from_mm).norm();
    if (row.arc_radius_mm && chord_mm > 0 && 2 * std::abs(*row.arc_radius_mm) > chord_mm) {
        // Of a bore, > 0 bulges into the hole: to the right of its way along z.
        const bool along = row.z_end_mm >= row.z_start_mm;
        piece.arc_radius_mm = bore && along ? -*row.arc_radius_mm : *row.arc_radius_mm;
    }
    return pointsOf(piece);
}

report::Plot meridianPlot(const Recognition& result, const Language& language)
{
    report::Plot plot;
    plot.title = LT_TEXT("Engine", "Meridian");
    plot.x = zAxis(result);
    plot.y = {LT_TEXT("Engine", "Radius"), unit::mm};
    plot.equal_scales = !isShort(result);
    if (!plot.equal_scales) plot.remark = LT_TEXT("Engine", "z is drawn larger than the radius");
    plot.curves.push_back(binsOf(result));
    addRows(plot, result);
    const Interval range = *plot.x.range;
    Curve axis{{}, {range.from, range.to}, {0, 0}, Curve::Style::Dashed};
    axis.colour = report::ColourRole::Neutral;
    axis.has_readout = false;
    plot.curves.push_back(std::move(axis));
    plotStretches(plot, result);
    addNames(plot, result, language);
    if (const auto largest = largestDiameter(result)) {  // room for the names
        const double edge_mm = chartLayout.radius_share * largest->diameter_mm;
        plot.y.range = Interval{-edge_mm, edge_mm};
    }
    return plot;
}

report::Plot residualPlot(const Recognition& result)
{
    report::Plot plot;
    plot.title = LT_TEXT("Engine", "Data minus rows");
    plot.x = zAxis(result);
    plot.y = {LT_TEXT("Engine", "Residual of the radius"), unit::um};
    Curve band{LT_TEXT("Engine", "±2 σ of a bin"), {}, {}, Curve::Style::Band};
    band.colour = report::ColourRole::Neutral;
    std::array<Curve, 3> kinds;
    for (const RowKind kind : {RowKind::Cylinder, RowKind::Cone, RowKind::Arc}) {
        Curve& curve = kinds[static_cast<std::size_t>(kind)];
        curve.name = kindName(kind);
        curve.style = Curve::Style::Points;
        curve.colour = colourOf(kind);
        curve.thin = true;
    }
    Curve means = meansOf(result);
    std::vector<double> sizes;
    for (const MeridianPoint& point : result.meridian) {
        if (point.bore || point.row < 0 || !std::isfinite(point.residual_mm)) continue;
        const auto row = static_cast<std::size_t>(point.row);
        if (row >= result.segments.size()) continue;
        Curve& curve = kinds[static_cast<std::size_t>(result.segments[row].kind)];
        curve.x.push_back(point.z_mm);
        curve.y.push_back(1e3 * point.residual_mm);
        band.x.push_back(point.z_mm);
        band.y.push_back(2e3 * point.sigma_mm);
        band.y_low.push_back(-2e3 * point.sigma_mm);
        sizes.push_back(std::abs(curve.y.back()));
    }
    if (!band.x.empty()) plot.curves.push_back(std::move(band));
    for (Curve& curve : kinds)
        if (!curve.x.empty()) plot.curves.push_back(std::move(curve));
    if (!means.x.empty()) plot.curves.push_back(std::move(means));
    double edge_um = 1;
    if (!sizes.empty()) {
        edge_um = std::max(edge_um, lowerQuantileInPlace(sizes, chartLayout.shown_residual_share));
    }
    const double tolerance_um = 1e3 * result.parameters.form_tolerance_mm;
    if (tolerance_um > 0) {
        for (const double sign : {-1.0, 1.0}) {
            report::Limit limit;
            limit.place = sign * tolerance_um;
            if (sign > 0) limit.name = LT_TEXT("Engine", "form tolerance");
            plot.limits.push_back(std::move(limit));
        }
        edge_um = std::max(edge_um, tolerance_um);
    }
    const double range_um = chartLayout.residual_room * edge_um;
    plot.y.range = Interval{-range_um, range_um};
    plotStretches(plot, result);
    return plot;
}

std::string meridianCsv(const Recognition& result)
{
    std::string text = "z_mm,radius_mm,sigma_mm,residual_mm,row,bore\n";
    for (const MeridianPoint& point : result.meridian) {
        text += fmt::format("{},{},{},", point.z_mm, point.radius_mm, point.sigma_mm);
        if (std::isfinite(point.residual_mm)) text += fmt::format("{}", point.residual_mm);
        text +=
            fmt::format(",{},{}\n", point.row < 0 ? std::string() : std::to_string(point.row + 1), point.bore ? 1 : 0);
    }
    return text;
}

}  // namespace lathelier::features
