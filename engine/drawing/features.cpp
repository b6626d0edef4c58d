#include "engine/drawing/features.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/core/units.h"
#include "engine/drawing/marks/marks.h"
#include "engine/drawing/rows.h"
#include "engine/drawing/stations.h"

namespace lathelier::drawing {
namespace {

constexpr double wholeAngleFrom_deg = 10;  // cones are given by their whole angle from here on

bool same(double a, double b)
{
    return std::abs(a - b) < same_mm;
}

class Collector {
public:
    Collector(const Shaft& shaft, const DrawingOptions& options)
        : shaft_(shaft), options_(options), texts_(options), outer_(outerRows(shaft))
    {
        known_ = uncertaintiesOf(outer_, options.uncertainties);
        addDiameters();
        addCallouts(outer_, known_, true);
        addLengths();
        for (std::size_t i = 0; i < shaft.bores.size(); ++i) addBore(i);
        addMarks(shaft, outer_, known_, texts_, features_);
    }

    Features take()
    {
        features_.differences = texts_.takeDifferences();
        return std::move(features_);
    }

private:
    std::string number(double value, int decimals = 3) const { return texts_.number(value, decimals); }

    /// U of rows by their index: as the options have them, else of their measured values.
    static std::vector<SizeUncertainty> uncertaintiesOf(const std::vector<ContourRow>& rows,
                                                        std::vector<SizeUncertainty> stated)
    {
        for (std::size_t i = stated.size(); i < rows.size(); ++i)
            stated.push_back(rows[i].measured ? rows[i].measured->uncertainty : SizeUncertainty{});
        return stated;
    }

    static Size startDiameter(const ContourRow& row, const std::vector<SizeUncertainty>& known)
    {
        return {row.start_diameter_mm, row.measured ? row.measured->start_diameter_mm : std::nullopt,
                known[row.index].start_diameter_um, row.tolerance};
    }

    static Size endDiameter(const ContourRow& row, const std::vector<SizeUncertainty>& known)
    {
        return {row.end_diameter_mm, row.measured ? row.measured->end_diameter_mm : std::nullopt,
                known[row.index].end_diameter_um, row.tolerance};
    }

    static Size radius(const ContourRow& row, const std::vector<SizeUncertainty>& known)
    {
        Size size{std::abs(row.arc_radius_mm), {}, known[row.index].arc_radius_um, {}};
        if (row.measured && row.measured->arc_radius_mm) size.measured_mm = std::abs(*row.measured->arc_radius_mm);
        return size;
    }

    /// Of the rows from first to last, along the axis.
    static Size width(const std::vector<ContourRow>& rows, const std::vector<SizeUncertainty>& known, std::size_t first,
                      std::size_t last)
    {
        Size size{std::abs(rows[last].end_z_mm - rows[first].start_z_mm), {}, {}, {}};
        if (rows[first].measured_start_z_mm)
            size.measured_mm = std::abs(*rows[last].measured_end_z_mm - *rows[first].measured_start_z_mm);
        const auto &start = known[rows[first].index].z_start_um, &end = known[rows[last].index].z_end_um;
        if (start && end) size.U_um = std::hypot(*start, *end);
        return size;
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
                                               {std::move(text), texts_.isMeasured(startDiameter(row, known_))},
                                               rootOf(*thread)});
                continue;
            }
            const auto [from_z_mm, to_z_mm] = roundStretch(shaft_, row);
            if (to_z_mm <= from_z_mm) {
                last = nullptr;
                continue;
            }
            const bool goes_on =
                last && same(last->end_diameter_mm, row.start_diameter_mm) && last->tolerance == row.tolerance &&
                texts_.isReplaced(startDiameter(*last, known_)) == texts_.isReplaced(startDiameter(row, known_));
            last = &row;
            if (goes_on) {
                features_.diameters.back().label.target.rows.push_back(row.index);
                continue;
            }
            DimensionText label = texts_.text(diameterPrefix, startDiameter(row, known_));
            label.target = {Of::Diameter, {row.index}};
            features_.diameters.push_back({from_z_mm, to_z_mm, row.start_diameter_mm, std::move(label),
                                           row.start_diameter_mm, offsetOf(shaft_, row)});
        }
    }

    bool continuesAsCylinder(const std::vector<ContourRow>& rows, std::size_t i, bool at_end) const
    {
        if (at_end ? i + 1 >= rows.size() : i == 0) return false;
        const ContourRow& next = rows[at_end ? i + 1 : i - 1];
        return next.kind == RowKind::Cylinder &&
               same(next.start_diameter_mm, at_end ? rows[i].end_diameter_mm : rows[i].start_diameter_mm);
    }

    DimensionText taperText(const std::vector<ContourRow>& rows, std::size_t i,
                            const std::vector<SizeUncertainty>& known)
    {
        const ContourRow& row = rows[i];
        const bool large_at_end = row.end_diameter_mm > row.start_diameter_mm;
        const Size large = large_at_end ? endDiameter(row, known) : startDiameter(row, known);
        std::string text;
        if (row.angle_deg() >= wholeAngleFrom_deg) {
            std::optional<double> expanded_deg = known[row.index].angle_deg;
            if (expanded_deg) *expanded_deg *= 2;
            text = texts_.withUnit(2 * row.angle_deg(), expanded_deg, texts_.isMeasured(large), 2, "°");
        } else {
            const double x = row.length_mm() / std::abs(row.end_diameter_mm - row.start_diameter_mm);
            const bool whole = std::abs(x - std::round(x)) < 2e-3 * x;
            text = fmt::format("▷1:{}", whole ? number(std::round(x)) : roundedNumber(x, options_.decimal_separator));
        }
        if (!continuesAsCylinder(rows, i, large_at_end)) text += std::string(" ") + diameterPrefix + texts_.part(large);
        return texts_.composed(text + " (" + number(row.length_mm()) + ")", large);
    }

    DimensionText chamferText(const ContourRow& row, const std::vector<SizeUncertainty>& known)
    {
        Size leg{row.length_mm(), {}, known[row.index].length_um, {}};
        if (row.measured && row.measured->length_mm) leg.measured_mm = std::abs(*row.measured->length_mm);
        const bool measured = texts_.isMeasured(leg);
        const std::string length = measured ? texts_.part(leg) : number(row.length_mm(), 2);
        // Between two values with ± the sign needs air.
        const bool has_uncertainty = measured && (leg.U_um || known[row.index].angle_deg);
        return texts_.composed(length + (has_uncertainty ? " × " : "×") +
                                   texts_.withUnit(row.angle_deg(), known[row.index].angle_deg, measured, 1, "°"),
                               leg);
    }

    /// The last row of the run of rows of one kind that begins at i.
    static std::size_t endOfRun(const std::vector<ContourRow>& rows, std::size_t i)
    {
        std::size_t last = i;
        while (last + 1 < rows.size() && rows[last + 1].kind == rows[i].kind) ++last;
        return last;
    }

    DimensionText grooveText(const std::vector<ContourRow>& rows, std::size_t first, std::size_t last, bool outside,
                             const std::vector<SizeUncertainty>& known)
    {
        Size bottom = startDiameter(rows[first], known);
        const auto isDeeper = [&](const Size& other) {
            return outside ? other.value_mm < bottom.value_mm : other.value_mm > bottom.value_mm;
        };
        for (std::size_t i = first; i <= last; ++i)
            for (const Size& size : {startDiameter(rows[i], known), endDiameter(rows[i], known)})
                if (isDeeper(size)) bottom = size;
        const Size wide = width(rows, known, first, last);
        const Size& leading = !texts_.isReplaced(bottom) && texts_.isReplaced(wide) ? wide : bottom;
        return texts_.composed(texts_.part(wide) + "×" + diameterPrefix + texts_.part(bottom), leading);
    }

    /// DIN 509 with a face recess is form F, without one form E; another shape: width × bottom.
    DimensionText undercutText(const std::vector<ContourRow>& rows, std::size_t first, std::size_t last,
                               const std::vector<SizeUncertainty>& known)
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
        if (radius == 0 || !(depth > same_mm)) return grooveText(rows, first, last, true, known);
        return {std::string("DIN 509 - ") + (face ? "F " : "E ") + number(radius, 2) + "×" + number(depth, 2),
                texts_.isMeasured(startDiameter(rows[first], known))};
    }

    /// R of an arc; of a ball SR, or S⌀ where more than half of it is there (ISO 129-1).
    DimensionText arcText(const ContourRow& row, const std::vector<SizeUncertainty>& known, bool outside)
    {
        Size size = radius(row, known);
        const bool is_ball = row.isBall() || (outside && markOver(shaft_, MarkKind::Sphere, row));
        if (!is_ball && outside && row.kind == RowKind::Curve && row.arc_radius_mm > 0) return crownText(row, known);
        if (!is_ball || !(row.length_mm() > std::abs(row.arc_radius_mm)))
            return texts_.text(is_ball ? "SR" : "R", size);
        size.value_mm *= 2;
        if (size.measured_mm) *size.measured_mm *= 2;
        if (size.U_um) *size.U_um *= 2;
        return texts_.text(std::string("S") + diameterPrefix, size);
    }

    /// "R2665.3 ±3.8, ⌀50.000 ±0.001 (⌀49.4 - ⌀49.4)": its largest ⌀, where no cylinder can be measured, and its ends.
    DimensionText crownText(const ContourRow& row, const std::vector<SizeUncertainty>& known)
    {
        const Size arc = radius(row, known), start = startDiameter(row, known), end = endDiameter(row, known);
        Size crest = start.value_mm > end.value_mm ? start : end;
        const double more_mm = row.crestDiameter_mm() - crest.value_mm;
        crest.value_mm += more_mm;
        if (crest.measured_mm) *crest.measured_mm += more_mm;
        if (start.U_um && end.U_um) crest.U_um = std::max(*start.U_um, *end.U_um);
        return texts_.composed(
            fmt::format("R{}, {}{} ({}{} - {}{})", texts_.part(arc), diameterPrefix, texts_.part(crest), diameterPrefix,
                        number(start.value_mm, 2), diameterPrefix, number(end.value_mm, 2)),
            texts_.isReplaced(crest) ? crest : arc);
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
                case RowKind::Chamfer: add(chamferText(row, known), row.middle_mm(), Of::Chamfer, i); break;
                case RowKind::Radius:
                case RowKind::Curve: add(arcText(row, known, outside), row.middle_mm(), Of::ArcRadius, i); break;
                case RowKind::Taper: add(taperText(rows, i, known), row.middle_mm(), Of::Taper, i); break;
                case RowKind::Groove:
                case RowKind::Undercut: {
                    const std::size_t last = endOfRun(rows, i);
                    const ContourRow& middle = rows[i + (last - i) / 2];
                    add(row.kind == RowKind::Groove || !outside ? grooveText(rows, i, last, outside, known)
                                                                : undercutText(rows, i, last, known),
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
        Size size{to.z_mm - from.z_mm, {}, lengthUncertainty(to, known_, first_row), {}};
        if (const auto& end_mm = outer_[to.before].measured_end_z_mm)
            size.measured_mm = *end_mm - outer_[first_row].measured_start_z_mm.value_or(0);
        DimensionText label = texts_.text({}, size);
        // A length that a person stated is no measured one, and has no U.
        const std::optional<double>& stated_mm = shaft_.recovered.stated_length_mm;
        if (stated_mm && first_row == 0 && to.before + 1 == outer_.size() && !texts_.isReplaced(size))
            label = {texts_.number(size.value_mm), false};
        label.target.of = DimensionTarget::Of::Length;
        for (std::size_t i = first_row; i <= to.before; ++i) label.target.rows.push_back(outer_[i].index);
        features_.lengths.push_back({from.z_mm, to.z_mm, from.radius_mm, to.radius_mm, std::move(label)});
    }

    void addBore(std::size_t number_of_bore)
    {
        const std::vector<ContourRow> rows = boreRows(shaft_, number_of_bore);
        if (rows.empty()) return;
        const bool free = shaft_.bores[number_of_bore].from == ShaftEnd::Free;
        const std::vector<SizeUncertainty> known = uncertaintiesOf(
            rows, number_of_bore < options_.bore_uncertainties.size() ? options_.bore_uncertainties[number_of_bore]
                                                                      : std::vector<SizeUncertainty>());
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
                 texts_.text(diameterPrefix, startDiameter(row, known)), row.start_diameter_mm, 0},
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
            Size depth{std::abs(station.z_mm - mouth), {}, lengthUncertainty(station, known), {}};
            if (const auto& end_mm = rows[station.before].measured_end_z_mm)
                depth.measured_mm = std::abs(*end_mm - *rows.front().measured_start_z_mm);
            LengthDimension length_of{mouth, station.z_mm, outerRadius(outer_, mouth), station.radius_mm,
                                      texts_.text({}, depth)};
            length_of.label.target = {DimensionTarget::Of::Length, {rows[station.before].index}, number_of_bore};
            features_.bore_lengths.push_back(std::move(length_of));
        }
    }

    const Shaft& shaft_;
    const DrawingOptions& options_;
    SizeTexts texts_;
    std::vector<ContourRow> outer_;
    std::vector<SizeUncertainty> known_;  // of outer_
    Features features_;
};

}  // namespace

Features featuresOf(const Shaft& shaft, const DrawingOptions& options)
{
    return Collector(shaft, options).take();
}

}  // namespace lathelier::drawing
