#include "engine/drawing/features.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/core/texts.h"
#include "engine/core/units.h"
#include "engine/drawing/rows.h"
#include "engine/drawing/stations.h"

namespace lathelier::drawing {
namespace {

constexpr double wholeAngleFrom_deg = 10;  // cones are given by their whole angle from here on
const char* const diameterPrefix = "⌀";

bool same(double a, double b)
{
    return std::abs(a - b) < same_mm;
}

/// Largest radius of a contour at z, both sides of a shoulder.
double outerRadius(const std::vector<ContourRow>& rows, double z_mm)
{
    double radius = 0;
    for (const ContourRow& row : rows) {
        if (z_mm < std::min(row.start_z_mm, row.end_z_mm) - same_mm ||
            z_mm > std::max(row.start_z_mm, row.end_z_mm) + same_mm)
            continue;
        const double length = row.end_z_mm - row.start_z_mm;
        const double share = length == 0 ? 1 : (z_mm - row.start_z_mm) / length;
        radius = std::max(radius, (row.start_diameter_mm + share * (row.end_diameter_mm - row.start_diameter_mm)) / 2);
    }
    return radius;
}

class Collector {
public:
    Collector(const Shaft& shaft, const DrawingOptions& options)
        : shaft_(shaft), options_(options), outer_(outerRows(shaft))
    {
        addDiameters();
        addCallouts(outer_, options.uncertainties, true);
        addLengths();
        for (std::size_t i = 0; i < shaft.bores.size(); ++i) addBore(i);
        addMarks();
    }

    Features take() { return std::move(features_); }

private:
    std::string number(double value, int decimals = 3) const
    {
        return shortNumber(value, decimals, options_.decimal_separator);
    }

    /// U of the rows of the outside, or of a bore; those that are missing are unknown.
    static SizeUncertainty uncertaintyOf(const ContourRow& row, const std::vector<SizeUncertainty>& known)
    {
        return row.index < known.size() ? known[row.index] : SizeUncertainty{};
    }

    bool isMeasured(const ContourRow& row) const { return row.as_measured || (options_.measured && !row.is_nominal); }

    DimensionText size(const ContourRow& row, double size_mm, const std::optional<double>& u_um) const
    {
        if (row.tolerance || !isMeasured(row))
            return {nominalSize(size_mm, row.tolerance, options_.decimal_separator), false};
        return {measuredSize(size_mm, u_um, options_.decimal_separator), true};
    }

    DimensionText withPrefix(const std::string& prefix, DimensionText label) const
    {
        label.text = prefix + label.text;
        return label;
    }

    const ShaftMark* threadOver(const ContourRow& row) const
    {
        for (const ShaftMark& mark : shaft_.marks)
            if (mark.kind == MarkKind::Thread && mark.z_start_mm && mark.z_end_mm &&
                row.middleZ_mm() > *mark.z_start_mm && row.middleZ_mm() < *mark.z_end_mm &&
                !threadDesignation(mark, options_.decimal_separator).empty())
                return &mark;
        return nullptr;
    }

    static double rootOf(const ShaftMark& thread)
    {
        return thread.minor_mm.value_or(thread.major_mm.value_or(0) - rootDepth * thread.pitch_mm.value_or(0));
    }

    void addDiameters()
    {
        const ShaftMark* last_thread = nullptr;
        const ContourRow* last = nullptr;  // the cylinder that a groove may interrupt
        using Of = DimensionTarget::Of;
        for (const ContourRow& row : outer_) {
            if (row.kind == RowKind::Groove || row.kind == RowKind::Undercut) continue;
            if (row.kind != RowKind::Cylinder) {
                last = nullptr;
                continue;
            }
            if (const ShaftMark* thread = threadOver(row)) {
                last = nullptr;
                if (thread == last_thread) continue;
                last_thread = thread;
                std::string text = threadDesignation(*thread, options_.decimal_separator) + " - " +
                                   number(*thread->z_end_mm - *thread->z_start_mm, 2);
                features_.diameters.push_back({row.start_z_mm,
                                               row.end_z_mm,
                                               row.start_diameter_mm,
                                               {std::move(text), isMeasured(row)},
                                               rootOf(*thread)});
                continue;
            }
            const bool goes_on = last && same(last->end_diameter_mm, row.start_diameter_mm) &&
                                 last->tolerance == row.tolerance && last->is_nominal == row.is_nominal;
            last = &row;
            if (goes_on) {
                features_.diameters.back().label.target.rows.push_back(row.index);
                continue;
            }
            DimensionText label = withPrefix(
                diameterPrefix,
                size(row, row.start_diameter_mm, uncertaintyOf(row, options_.uncertainties).start_diameter_um));
            label.target = {Of::Diameter, {row.index}};
            features_.diameters.push_back(
                {row.start_z_mm, row.end_z_mm, row.start_diameter_mm, std::move(label), row.start_diameter_mm});
        }
    }

    bool continuesAsCylinder(const std::vector<ContourRow>& rows, std::size_t i, bool at_end) const
    {
        if (at_end ? i + 1 >= rows.size() : i == 0) return false;
        const ContourRow& next = rows[at_end ? i + 1 : i - 1];
        return next.kind == RowKind::Cylinder &&
               same(next.start_diameter_mm, at_end ? rows[i].end_diameter_mm : rows[i].start_diameter_mm);
    }

    std::string taperText(const std::vector<ContourRow>& rows, std::size_t i) const
    {
        const ContourRow& row = rows[i];
        const double difference = std::abs(row.end_diameter_mm - row.start_diameter_mm);
        std::string text;
        if (row.angle_deg() >= wholeAngleFrom_deg) {
            text = number(2 * row.angle_deg(), 2) + "°";
        } else {
            const double x = row.length_mm() / difference;
            const bool whole = std::abs(x - std::round(x)) < 2e-3 * x;
            text = fmt::format("▷1:{}", whole ? number(std::round(x)) : roundedNumber(x, options_.decimal_separator));
        }
        const bool large_at_end = row.end_diameter_mm > row.start_diameter_mm;
        if (!continuesAsCylinder(rows, i, large_at_end))
            text += fmt::format(" {}{}", diameterPrefix, number(std::max(row.start_diameter_mm, row.end_diameter_mm)));
        return text + " (" + number(row.length_mm()) + ")";
    }

    /// The last row of the run of rows of one kind that begins at i.
    static std::size_t endOfRun(const std::vector<ContourRow>& rows, std::size_t i)
    {
        std::size_t last = i;
        while (last + 1 < rows.size() && rows[last + 1].kind == rows[i].kind) ++last;
        return last;
    }

    DimensionText grooveText(const std::vector<ContourRow>& rows, std::size_t first, std::size_t last,
                             bool outside) const
    {
        const double width = std::abs(rows[last].end_z_mm - rows[first].start_z_mm);
        double bottom = outside ? 1e300 : 0;
        for (std::size_t i = first; i <= last; ++i)
            for (const double diameter : {rows[i].start_diameter_mm, rows[i].end_diameter_mm})
                bottom = outside ? std::min(bottom, diameter) : std::max(bottom, diameter);
        std::string text = number(width) + "×" + diameterPrefix + number(bottom);
        if (rows[first].tolerance)
            text = number(width) + "×" + diameterPrefix +
                   nominalSize(bottom, rows[first].tolerance, options_.decimal_separator);
        return {std::move(text), isMeasured(rows[first])};
    }

    /// DIN 509 with a face recess is form F, without one form E; another shape: width × bottom.
    DimensionText undercutText(const std::vector<ContourRow>& rows, std::size_t first, std::size_t last) const
    {
        for (const ShaftMark& mark : shaft_.marks)
            if (!mark.designation.empty() && mark.kind != MarkKind::Thread && mark.kind != MarkKind::Knurl &&
                mark.z_start_mm && mark.z_end_mm && rows[last].end_z_mm > *mark.z_start_mm &&
                rows[first].start_z_mm < *mark.z_end_mm)
                return {mark.designation, false};
        double radius = 0, bottom = 1e300;
        bool face = false;
        for (std::size_t i = first; i <= last; ++i) {
            if (rows[i].arc_radius_mm < 0) radius = -rows[i].arc_radius_mm;
            face = face || rows[i].end_z_mm < rows[i].start_z_mm;
            bottom = std::min(bottom, rows[i].start_diameter_mm);
        }
        const double depth = (std::max(rows[first].start_diameter_mm, rows[first].end_diameter_mm) - bottom) / 2;
        if (radius == 0 || !(depth > same_mm)) return grooveText(rows, first, last, true);
        return {std::string("DIN 509 - ") + (face ? "F " : "E ") + number(radius, 2) + "×" + number(depth, 2),
                isMeasured(rows[first])};
    }

    /// R of an arc; of a ball SR, or S⌀ where more than half of it is there (ISO 129-1).
    DimensionText arcText(const ContourRow& row, std::optional<double> u_um) const
    {
        const double radius = std::abs(row.arc_radius_mm);
        const bool is_ball = row.isBall(), has_diameter = is_ball && row.length_mm() > radius;
        if (has_diameter && u_um) *u_um *= 2;
        return withPrefix(has_diameter ? std::string("S") + diameterPrefix
                          : is_ball    ? "SR"
                                       : "R",
                          size({.is_nominal = row.is_nominal, .as_measured = row.as_measured},
                               has_diameter ? 2 * radius : radius, u_um));
    }

    void addCallouts(const std::vector<ContourRow>& rows, const std::vector<SizeUncertainty>& known, bool outside,
                     Mouth mouth = Mouth::None)
    {
        for (std::size_t i = 0; i < rows.size(); ++i) {
            const ContourRow& row = rows[i];
            using Of = DimensionTarget::Of;
            const auto add = [&](DimensionText label, const Eigen::Vector2d& at, Of of, std::size_t last) {
                if (outside) label.target.of = of;
                for (std::size_t k = i; outside && k <= last; ++k) label.target.rows.push_back(rows[k].index);
                features_.callouts.push_back({at, std::move(label), i == 0 ? mouth : Mouth::None});
            };
            switch (row.kind) {
                case RowKind::Chamfer:
                    add({number(row.length_mm(), 2) + "×" + number(row.angle_deg(), 1) + "°", isMeasured(row)},
                        row.middle_mm(), Of::Chamfer, i);
                    break;
                case RowKind::Radius:
                case RowKind::Curve:
                    add(arcText(row, uncertaintyOf(row, known).arc_radius_um), row.middle_mm(), Of::ArcRadius, i);
                    break;
                case RowKind::Taper: add({taperText(rows, i), isMeasured(row)}, row.middle_mm(), Of::Taper, i); break;
                case RowKind::Groove:
                case RowKind::Undercut: {
                    const std::size_t last = endOfRun(rows, i);
                    const ContourRow& middle = rows[i + (last - i) / 2];
                    add(row.kind == RowKind::Groove || !outside ? grooveText(rows, i, last, outside)
                                                                : undercutText(rows, i, last),
                        middle.middle_mm(), Of::Groove, last);
                    i = last;
                    break;
                }
                case RowKind::Cylinder:
                case RowKind::Face: break;
            }
        }
    }

    /// U of a length: those of both ends, where the far one is known. `first`: the row that it begins with; of the
    /// free end an unknown U counts as 0.
    static std::optional<double> lengthUncertainty(const Station& station, const std::vector<SizeUncertainty>& known,
                                                   std::size_t first = 0)
    {
        const std::size_t i = station.before;
        std::optional<double> end = i < known.size() ? known[i].z_end_um : std::nullopt;
        if (!end && i + 1 < known.size()) end = known[i + 1].z_start_um;
        if (!end) return end;
        std::optional<double> begin = known[first].z_start_um;
        if (!begin && first > 0) begin = known[first - 1].z_end_um;
        if (!begin && first > 0) return std::nullopt;
        return std::hypot(*end, begin.value_or(0));
    }

    void addLengths()
    {
        if (outer_.empty()) return;
        const Station end_face{0, outer_.front().start_diameter_mm / 2, 0};
        const std::vector<Station> stations = stationsOf(outer_);
        const bool chain = options_.lengths_from == LengthsFrom::Previous;
        for (std::size_t i = 0; i < stations.size(); ++i) {
            const bool from_before = chain && i > 0;
            addLength(from_before ? stations[i - 1] : end_face, stations[i],
                      from_before ? stations[i - 1].before + 1 : 0);
        }
        if (chain && stations.size() > 1) addLength(end_face, stations.back(), 0);
    }

    void addLength(const Station& from, const Station& to, std::size_t first_row)
    {
        ContourRow row = outer_[to.before];
        row.tolerance.reset();
        DimensionText label = size(row, to.z_mm - from.z_mm, lengthUncertainty(to, options_.uncertainties, first_row));
        label.target.of = DimensionTarget::Of::Length;
        for (std::size_t i = first_row; i <= to.before; ++i) label.target.rows.push_back(outer_[i].index);
        features_.lengths.push_back({from.z_mm, to.z_mm, from.radius_mm, to.radius_mm, std::move(label)});
    }

    void addBore(std::size_t number_of_bore)
    {
        const std::vector<ContourRow> rows = boreRows(shaft_, number_of_bore);
        if (rows.empty()) return;
        const bool free = shaft_.bores[number_of_bore].from == ShaftEnd::Free;
        const std::vector<SizeUncertainty> known = number_of_bore < options_.bore_uncertainties.size()
                                                       ? options_.bore_uncertainties[number_of_bore]
                                                       : std::vector<SizeUncertainty>();
        const double length = shaft_.length_mm(), mouth = rows.front().start_z_mm;
        const bool through = std::abs(rows.back().end_z_mm - mouth) > length - same_mm;
        const ContourRow* last = nullptr;  // the cylinder that a groove may interrupt
        for (std::size_t i = 0; i < rows.size(); ++i) {
            const ContourRow& row = rows[i];
            if (row.kind == RowKind::Groove || row.kind == RowKind::Undercut) continue;
            const bool goes_on =
                last && row.kind == RowKind::Cylinder && same(last->end_diameter_mm, row.start_diameter_mm);
            last = row.kind == RowKind::Cylinder ? &row : nullptr;
            if (!last || goes_on) continue;
            const auto isOpen = [&](std::size_t from, std::size_t to) {
                return std::all_of(rows.begin() + static_cast<std::ptrdiff_t>(from),
                                   rows.begin() + static_cast<std::ptrdiff_t>(to), [&](const ContourRow& other) {
                                       return std::min(other.start_diameter_mm, other.end_diameter_mm) >
                                              row.start_diameter_mm - same_mm;
                                   });
            };
            const bool from_mouth = isOpen(0, i), from_far = through && isOpen(i + 1, rows.size());
            BoreDimension bore{
                {std::min(row.start_z_mm, row.end_z_mm), std::max(row.start_z_mm, row.end_z_mm), row.start_diameter_mm,
                 withPrefix(diameterPrefix,
                            size(row, row.start_diameter_mm, uncertaintyOf(row, known).start_diameter_um)),
                 row.start_diameter_mm},
                free ? from_mouth : from_far,
                free ? from_far : from_mouth};
            bore.size.label.target = {DimensionTarget::Of::Diameter, {row.index}, number_of_bore};
            features_.bores.push_back(std::move(bore));
        }
        addCallouts(rows, known, false, free ? Mouth::Free : Mouth::Chuck);
        if (through && rows.size() > 1 && rows.back().isMinor())
            features_.callouts.back().mouth = free ? Mouth::Chuck : Mouth::Free;
        for (const Station& station : stationsOf(rows)) {
            const bool drill_point = same(rows[station.before].end_diameter_mm, 0);
            if (drill_point || (through && same(station.z_mm, rows.back().end_z_mm))) continue;
            const double depth = std::abs(station.z_mm - mouth);
            LengthDimension length_of{mouth, station.z_mm, outerRadius(outer_, mouth), station.radius_mm,
                                      size(rows[station.before], depth, lengthUncertainty(station, known))};
            length_of.label.target = {DimensionTarget::Of::Length, {rows[station.before].index}, number_of_bore};
            features_.bore_lengths.push_back(std::move(length_of));
        }
    }

    void addMarks()
    {
        for (const ShaftMark& mark : shaft_.marks) {
            if (!mark.z_start_mm || !mark.z_end_mm || mark.kind == MarkKind::Thread) continue;
            const double z = (*mark.z_start_mm + *mark.z_end_mm) / 2;
            const bool in_undercut = std::any_of(outer_.begin(), outer_.end(), [&](const ContourRow& row) {
                return row.kind == RowKind::Undercut && row.start_z_mm < *mark.z_end_mm &&
                       row.end_z_mm > *mark.z_start_mm;
            });
            if (mark.kind == MarkKind::Keyway && mark.width_mm && mark.floor_mm) {
                addKeyway(mark, z);
            } else if (mark.kind == MarkKind::Knurl || mark.kind == MarkKind::Flat ||
                       mark.kind == MarkKind::CrossHole || mark.kind == MarkKind::Unexplained || !in_undercut) {
                const std::string text = markText(mark);
                if (!text.empty())
                    features_.callouts.push_back({{z, outerRadius(outer_, z)}, {text, false}, Mouth::None});
            }
        }
    }

    std::string markText(const ShaftMark& mark) const
    {
        if (!mark.designation.empty()) return mark.designation;
        if (mark.kind == MarkKind::Knurl && mark.teeth)
            return fill(translated(LT_TEXT("Engine", "knurl, {teeth} teeth"), options_),
                        {{"teeth", number(*mark.teeth, 0)}});
        if (mark.kind == MarkKind::Flat && mark.distance_mm)
            return fill(translated(LT_TEXT("Engine", "flat, {distance} from the axis"), options_),
                        {{"distance", number(*mark.distance_mm)}});
        if (mark.kind == MarkKind::CrossHole && mark.diameter_mm) return diameterPrefix + number(*mark.diameter_mm);
        if (mark.kind == MarkKind::Unexplained)
            return fill(translated(LT_TEXT("Engine", "NOT EXPLAINED, z {from}-{to}"), options_),
                        {{"from", number(*mark.z_start_mm)}, {"to", number(*mark.z_end_mm)}});
        return {};
    }

    void addKeyway(const ShaftMark& mark, double z_mm)
    {
        const double diameter = 2 * outerRadius(outer_, z_mm);
        KeywayView view{*mark.z_start_mm, *mark.z_end_mm, *mark.width_mm, *mark.floor_mm, diameter, 0, {}, {}};
        for (std::size_t i = 0; i < shaft_.bores.size(); ++i)
            view.bore_diameter_mm = std::max(view.bore_diameter_mm, 2 * outerRadius(boreRows(shaft_, i), z_mm));
        if (!(view.width_mm > 0) || view.width_mm >= diameter || std::abs(view.floor_mm) >= diameter / 2) return;
        const ContourRow plain;
        view.width = size(plain, view.width_mm, std::nullopt);
        view.across = size(plain, diameter / 2 + view.floor_mm, std::nullopt);
        features_.keyways.push_back(view);
        if (outer_.empty() || features_.lengths.empty()) return;
        for (const double z : {view.from_z_mm, view.to_z_mm}) {
            if (z < same_mm) continue;
            const auto after = std::find_if(features_.lengths.begin(), features_.lengths.end(),
                                            [&](const LengthDimension& length) { return length.to_z_mm > z - 1e-3; });
            if (after == features_.lengths.end() || std::abs(after->to_z_mm - z) < 1e-3) continue;
            features_.lengths.insert(
                after, {0, z, outer_.front().start_diameter_mm / 2, view.width_mm / 2, size(plain, z, std::nullopt)});
        }
    }

    const Shaft& shaft_;
    const DrawingOptions& options_;
    std::vector<ContourRow> outer_;
    Features features_;
};

}  // namespace

Features featuresOf(const Shaft& shaft, const DrawingOptions& options)
{
    return Collector(shaft, options).take();
}

}  // namespace lathelier::drawing
