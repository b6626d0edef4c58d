#include "engine/drawing/marks/marks.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/core/texts.h"
#include "engine/core/units.h"
#include "engine/drawing/marks/view_marks.h"

namespace lathelier::drawing {
namespace {

constexpr double turnShown_deg = 0.05;  // smaller angles between marks are none
constexpr double opposite_deg = 2;      // flats that lie opposite each other within this are dimensioned as a pair
constexpr double cornerShown_mm = 0.1;  // corners that are turned by less are sharp
constexpr double onePlace_mm = 0.0005;  // shorter stretches are printed as one place

class MarkCollector {
public:
    MarkCollector(const Shaft& shaft, const std::vector<ContourRow>& outer, const std::vector<SizeUncertainty>& known,
                  SizeTexts& texts, Features& features)
        : shaft_(shaft),
          outer_(outer),
          known_(known),
          texts_(texts),
          features_(features),
          viewed_(viewedMark(shaft)),
          viewed_deg_(viewedAngle_deg(shaft))
    {
        for (const ShaftMark& mark : shaft.marks)
            if (mark.z_start_mm && mark.z_end_mm) add(mark);
        std::stable_sort(features.sections.begin(), features.sections.end(),
                         [](const CrossSection& a, const CrossSection& b) { return a.from_z_mm < b.from_z_mm; });
    }

private:
    void add(const ShaftMark& mark)
    {
        switch (mark.kind) {
            case MarkKind::Thread:
            case MarkKind::Bore:
            case MarkKind::Sphere: return;  // with their rows
            case MarkKind::Keyway:
                if (addKeyway(mark)) return;
                break;
            case MarkKind::Flat:
                if (addFlat(mark)) return;
                break;
            case MarkKind::CrossHole:
                if (addHole(mark)) return;
                break;
            case MarkKind::BoltCircle:
                if (addBoltCircle(mark)) return;
                break;
            case MarkKind::Hexagon: addPrism(mark, 6); break;
            case MarkKind::Square: addPrism(mark, 4); break;
            case MarkKind::Spline: addSpline(mark); break;
            case MarkKind::Eccentric:
                if (addEccentric(mark)) return;
                break;
            default: break;
        }
        addCallout(mark);
    }

    double middle(const ShaftMark& mark) const { return (*mark.z_start_mm + *mark.z_end_mm) / 2; }
    double turn(const ShaftMark& mark) const { return turnOf_deg(mark, viewed_deg_); }

    using Expanded = std::optional<double>;  // U of k = 2, mm or degrees; none: not known

    static Expanded joined(const Expanded& a, const Expanded& b)
    {
        return a && b ? Expanded(std::hypot(*a, *b)) : std::nullopt;
    }

    bool isMeasured(const ShaftMark& mark) const { return texts_.isMeasured(size(mark, 1, {})); }

    /// A size of the mark and its U.
    Size size(const ShaftMark& mark, double value_mm, const Expanded& U_mm) const
    {
        Size one{value_mm, {}, {}, {}};
        if (mark.uncertainty_mm || !shaft_.recovered.scan.empty()) one.measured_mm = value_mm;
        if (U_mm) one.U_um = 1000 * *U_mm;
        return one;
    }

    DimensionText sizeText(const ShaftMark& mark, const std::string& prefix, double value_mm, const Expanded& U_mm)
    {
        return texts_.text(prefix, size(mark, value_mm, U_mm));
    }

    /// U of the ⌀ and of the radius at z.
    Expanded diameterUncertainty_mm(double z_mm) const
    {
        for (const ContourRow& row : outer_)
            if (z_mm > row.start_z_mm && z_mm < row.end_z_mm && known_[row.index].start_diameter_um)
                return *known_[row.index].start_diameter_um / 1000;
        return std::nullopt;
    }

    Expanded radiusUncertainty_mm(double z_mm) const
    {
        const Expanded whole = diameterUncertainty_mm(z_mm);
        return whole ? Expanded(*whole / 2) : std::nullopt;
    }

    /// U of a length from the free end, whose own U counts as 0 where it is not known.
    Expanded lengthUncertainty_mm(const ShaftMark& mark) const
    {
        const Expanded end_um = outer_.empty() ? std::nullopt : known_[outer_.front().index].z_start_um;
        return joined(mark.place_uncertainty_mm, end_um.value_or(0) / 1000);
    }

    /// From the direction of the view, `turned_deg` away from it.
    DimensionText angleText(const ShaftMark& mark, double turned_deg)
    {
        const double turned = std::abs(turned_deg);
        if (turned < turnShown_deg) return {};
        const Expanded U_deg =
            joined(mark.angle_uncertainty_deg, viewed_ ? viewed_->angle_uncertainty_deg : Expanded());
        return {texts_.withUnit(turned, U_deg, isMeasured(mark), 1, "°"), isMeasured(mark)};
    }

    DimensionText angleText(const ShaftMark& mark) { return angleText(mark, turn(mark)); }

    DimensionText filled(const ShaftMark& mark, Text pattern, const Values& values)
    {
        return {fill(translated(pattern, texts_.options()), values), isMeasured(mark)};
    }

    std::string depthText(const ShaftMark& hole) const
    {
        if (hole.through.value_or(0) > 0) return ", " + translated(LT_TEXT("Engine", "through"), texts_.options());
        if (!hole.depth_mm)
            return hole.through ? ", " + translated(LT_TEXT("Engine", "blind, depth not known"), texts_.options())
                                : std::string();
        return ", " + fill(translated(LT_TEXT("Engine", "{depth} deep"), texts_.options()),
                           {{"depth", texts_.part(size(hole, *hole.depth_mm, hole.depth_uncertainty_mm))}});
    }

    /// The section whose plane may lie in this stretch: one that is there, or a new one.
    CrossSection& sectionAt(double from_mm, double to_mm)
    {
        for (CrossSection& section : features_.sections) {
            const double from = std::max(from_mm, section.from_z_mm), to = std::min(to_mm, section.to_z_mm);
            if (from > to) continue;
            section.from_z_mm = from;
            section.to_z_mm = to;
            if (!section.teeth && !section.eccentric) section.diameter_mm = 2 * outerRadius(outer_, (from + to) / 2);
            return section;
        }
        const double z = (from_mm + to_mm) / 2;
        CrossSection section{from_mm, to_mm, 2 * outerRadius(outer_, z), 0};
        for (std::size_t i = 0; i < shaft_.bores.size(); ++i)
            section.bore_diameter_mm = std::max(section.bore_diameter_mm, 2 * outerRadius(boreRows(shaft_, i), z));
        features_.sections.push_back(std::move(section));
        return features_.sections.back();
    }

    /// How far below the axis what is cut into this radius ends in the view: there its extension lines begin.
    double lowerEdge_mm(const ShaftMark& mark, double radius_mm, double width_mm) const
    {
        const double turned = turn(mark) * rad_per_deg;
        return radius_mm * std::sin(turned) + width_mm / 2 * std::abs(std::cos(turned));
    }

    /// A length from the free end to a place of a mark.
    void addPlace(const ShaftMark& mark, double z_mm, double radius_mm)
    {
        if (z_mm < same_mm || outer_.empty() || features_.lengths.empty()) return;
        const auto after = std::find_if(features_.lengths.begin(), features_.lengths.end(),
                                        [&](const LengthDimension& one) { return one.to_z_mm > z_mm - 1e-3; });
        if (after == features_.lengths.end() || std::abs(after->to_z_mm - z_mm) < 1e-3) return;
        const double from_radius_mm = outer_.front().start_diameter_mm / 2;
        features_.lengths.insert(
            after, {0, z_mm, from_radius_mm, radius_mm, sizeText(mark, {}, z_mm, lengthUncertainty_mm(mark))});
    }

    bool addKeyway(const ShaftMark& mark)
    {
        const double radius = outerRadius(outer_, middle(mark));
        const std::optional<double> floor = floorOf(mark, radius);
        if (!mark.width_mm || !floor || !(*mark.width_mm > 0) || *mark.width_mm >= 2 * radius ||
            std::abs(*floor) >= radius)
            return false;
        CrossSection& section = sectionAt(*mark.z_start_mm, *mark.z_end_mm);
        const Expanded across_uncertainty_mm = joined(mark.depth_uncertainty_mm, radiusUncertainty_mm(middle(mark)));
        section.slots.push_back({turn(mark), *mark.width_mm, *floor,
                                 sizeText(mark, {}, *mark.width_mm, mark.uncertainty_mm),
                                 sizeText(mark, {}, radius + *floor, across_uncertainty_mm), angleText(mark)});
        const Size length =
            size(mark, *mark.z_end_mm - *mark.z_start_mm, joined(mark.place_uncertainty_mm, mark.place_uncertainty_mm));
        section.captions.push_back(
            filled(mark, LT_TEXT("Engine", "(length {length})"),
                   {{"length", length.U_um ? texts_.part(length) : texts_.number(length.value_mm, 2)}}));
        if (section.slots.size() > 1)  // which one it is of
            section.captions.back().text.insert(0, texts_.number(std::abs(turn(mark)), 0) + "°: ");
        if (!mark.designation.empty()) section.captions.push_back({mark.designation, false});
        for (const double z : {*mark.z_start_mm, *mark.z_end_mm})
            addPlace(mark, z, lowerEdge_mm(mark, radius, *mark.width_mm));
        return true;
    }

    bool addFlat(const ShaftMark& mark)
    {
        const double radius = outerRadius(outer_, middle(mark));
        if (!mark.distance_mm || std::abs(*mark.distance_mm) >= radius) return false;
        CrossSection& section = sectionAt(*mark.z_start_mm, *mark.z_end_mm);
        for (const double z : {*mark.z_start_mm, *mark.z_end_mm}) addPlace(mark, z, radius);
        for (FlatCut& other : section.flats) {
            const double off_deg = std::remainder(turn(mark) - other.angle_deg - 180, 360);
            if (other.across.text.empty() || std::abs(off_deg) > opposite_deg) continue;
            // Where the opposite side is flat too, the distance of both; the first one has no U of its own here.
            other.across = sizeText(mark, {}, other.distance_mm + *mark.distance_mm,
                                    joined(mark.uncertainty_mm, mark.uncertainty_mm));
            other.opposite_mm = *mark.distance_mm;
            section.flats.push_back({turn(mark), *mark.distance_mm, {}, {}});
            if (std::abs(off_deg) > turnShown_deg) section.flats.back().angle = angleText(mark);
            return true;
        }
        section.flats.push_back({turn(mark), *mark.distance_mm,
                                 sizeText(mark, {}, radius + *mark.distance_mm,
                                          joined(mark.uncertainty_mm, radiusUncertainty_mm(middle(mark)))),
                                 angleText(mark)});
        return true;
    }

    bool addHole(const ShaftMark& mark)
    {
        const double z = middle(mark), radius = outerRadius(outer_, z);
        if (!mark.diameter_mm || !(*mark.diameter_mm > 0) || *mark.diameter_mm >= 2 * radius) return false;
        const bool through = mark.through.value_or(0) > 0;
        DimensionText label = sizeText(mark, diameterPrefix, *mark.diameter_mm, mark.uncertainty_mm);
        label.text += depthText(mark);
        CrossSection& section = sectionAt(z, z);
        RadialHole hole{turn(mark), *mark.diameter_mm, {}, std::move(label), angleText(mark)};
        // A blind hole whose depth is not known is shown as deep as it is wide.
        if (!through) hole.depth_mm = std::min(mark.depth_mm.value_or(*mark.diameter_mm), radius);
        section.holes.push_back(std::move(hole));
        addPlace(mark, z, lowerEdge_mm(mark, radius, *mark.diameter_mm));
        return true;
    }

    bool addBoltCircle(const ShaftMark& mark)
    {
        const double count = mark.count.value_or(0);
        if (!mark.diameter_mm || !mark.pitch_circle_mm || !(count >= 1) || count > 1000) return false;
        CrossSection& section = sectionAt(*mark.z_start_mm, *mark.z_end_mm);
        const double nearest_deg = std::remainder(turn(mark), 360 / std::round(count));
        section.circles.push_back({nearest_deg, static_cast<std::size_t>(count), *mark.diameter_mm,
                                   *mark.pitch_circle_mm,
                                   &mark == viewed_ ? DimensionText{} : angleText(mark, nearest_deg)});
        DimensionText holes = sizeText(mark, diameterPrefix, *mark.diameter_mm, mark.uncertainty_mm);
        holes.text = fill(translated(LT_TEXT("Engine", "{count}×{hole} on ⌀{circle}"), texts_.options()),
                          {{"count", texts_.number(count, 0)},
                           {"hole", holes.text},
                           {"circle", texts_.part(size(mark, *mark.pitch_circle_mm, mark.place_uncertainty_mm))}});
        holes.text += depthText(mark);
        section.captions.push_back(std::move(holes));
        return true;
    }

    void addPrism(const ShaftMark& mark, int faces)
    {
        const double across = mark.across_flats_mm.value_or(0), radius = outerRadius(outer_, middle(mark));
        if (!(across > 0) || across / 2 >= radius) return;
        CrossSection& section = sectionAt(*mark.z_start_mm, *mark.z_end_mm);
        for (int i = 0; i < faces; ++i) section.flats.push_back({turn(mark) + 360.0 * i / faces, across / 2, {}, {}});
        section.flats[section.flats.size() - static_cast<std::size_t>(faces)].across =
            sizeText(mark, translated(LT_TEXT("Engine", "AF "), texts_.options()), across, mark.uncertainty_mm);
        // Corners that are turned: their ⌀; the row has none of its own.
        const double corner_mm = across / std::cos(180.0 / faces * rad_per_deg);
        if (2 * radius < corner_mm - cornerShown_mm)
            section.captions.push_back(
                sizeText(mark, translated(LT_TEXT("Engine", "corners "), texts_.options()) + diameterPrefix, 2 * radius,
                         diameterUncertainty_mm(middle(mark))));
        addPlace(mark, *mark.z_start_mm, radius);
        addPlace(mark, *mark.z_end_mm, radius);
    }

    void addSpline(const ShaftMark& mark)
    {
        if (!mark.major_mm || !mark.minor_mm || !(*mark.minor_mm > 0) || *mark.minor_mm >= *mark.major_mm) return;
        CrossSection& section = sectionAt(*mark.z_start_mm, *mark.z_end_mm);
        section.diameter_mm = *mark.major_mm;
        section.teeth = Teeth{turn(mark), *mark.minor_mm, {}, {}};
        if (mark.width_mm && *mark.width_mm > 0 && *mark.width_mm < *mark.minor_mm) {
            section.teeth->width_mm = mark.width_mm;
            section.teeth->width = sizeText(mark, {}, *mark.width_mm, {});
        }
        section.captions.push_back(sizeText(mark, diameterPrefix, *mark.major_mm, mark.uncertainty_mm));
        section.captions.back().text +=
            " / " + sizeText(mark, diameterPrefix, *mark.minor_mm, mark.depth_uncertainty_mm).text;
        for (const double z : {*mark.z_start_mm, *mark.z_end_mm}) addPlace(mark, z, *mark.major_mm / 2);
    }

    bool addEccentric(const ShaftMark& mark)
    {
        if (!mark.offset_mm || !(*mark.offset_mm > 0)) return false;
        CrossSection& section = sectionAt(*mark.z_start_mm, *mark.z_end_mm);
        if (mark.diameter_mm) section.diameter_mm = *mark.diameter_mm;
        section.eccentric =
            OffsetAxis{turn(mark), *mark.offset_mm, sizeText(mark, "e ", *mark.offset_mm, mark.uncertainty_mm),
                       mark.angle_deg ? angleOfEccentric(mark) : DimensionText{}};
        return true;
    }

    /// Only beside another mark that it is measured from.
    DimensionText angleOfEccentric(const ShaftMark& mark)
    {
        return &mark == viewed_ ? DimensionText{} : angleText(mark);
    }

    void addCallout(const ShaftMark& mark)
    {
        const bool in_undercut = std::any_of(outer_.begin(), outer_.end(), [&](const ContourRow& row) {
            return row.kind == RowKind::Undercut && row.start_z_mm < *mark.z_end_mm && row.end_z_mm > *mark.z_start_mm;
        });
        const bool names_undercut = mark.kind == MarkKind::Other || mark.kind == MarkKind::FreeForm;
        if (in_undercut && names_undercut) return;
        const std::string text = textOf(mark);
        const double z = middle(mark);
        double height_mm = outerRadius(outer_, z);
        for (const ShapedStretch& stretch : shapedStretches(shaft_))
            if (z > stretch.from_z_mm && z < stretch.to_z_mm) height_mm = stretch.high_mm;
        const bool states_size = mark.designation.empty() && mark.kind != MarkKind::Unexplained;
        if (!text.empty())
            features_.callouts.push_back({{z, height_mm}, {text, states_size && isMeasured(mark)}, Mouth::None});
    }

    std::string textOf(const ShaftMark& mark) const
    {
        const DrawingOptions& options = texts_.options();
        if (!mark.designation.empty()) return mark.designation;
        if (mark.kind == MarkKind::Knurl && mark.teeth)
            return fill(translated(LT_TEXT("Engine", "knurl, {teeth} teeth"), options),
                        {{"teeth", texts_.number(*mark.teeth, 0)}});
        if (mark.kind == MarkKind::Spline && mark.teeth && mark.major_mm && mark.minor_mm)
            return fill(translated(LT_TEXT("Engine", "spline {teeth}×{root}×{crest}"), options),
                        {{"teeth", texts_.number(*mark.teeth, 0)},
                         {"root", texts_.number(*mark.minor_mm)},
                         {"crest", texts_.number(*mark.major_mm)}});
        if (mark.kind == MarkKind::Unexplained && *mark.z_end_mm - *mark.z_start_mm < onePlace_mm)
            return fill(translated(LT_TEXT("Engine", "NOT EXPLAINED, z {z}"), options),
                        {{"z", texts_.number(*mark.z_start_mm)}});
        if (mark.kind == MarkKind::Unexplained)
            return fill(translated(LT_TEXT("Engine", "NOT EXPLAINED, z {from}-{to}"), options),
                        {{"from", texts_.number(*mark.z_start_mm)}, {"to", texts_.number(*mark.z_end_mm)}});
        if (mark.kind == MarkKind::Other && mark.width_mm && mark.depth_mm)
            return fill(translated(LT_TEXT("Engine", "{kind}, {width} wide, {depth} deep"), options),
                        {{"kind", mark.other_kind},
                         {"width", texts_.number(*mark.width_mm)},
                         {"depth", texts_.number(*mark.depth_mm)}});
        if (mark.kind == MarkKind::Other) return mark.other_kind;
        return translated(nameOf(mark.kind), options);
    }

    const Shaft& shaft_;
    const std::vector<ContourRow>& outer_;
    const std::vector<SizeUncertainty>& known_;  // of outer_
    SizeTexts& texts_;
    Features& features_;
    const ShaftMark* viewed_;
    double viewed_deg_;
};

}  // namespace

std::string letterOf(std::size_t section)
{
    const std::string letter(1, static_cast<char>('A' + section % 26));
    return section < 26 ? letter : letter + std::to_string(section / 26);
}

void addMarks(const Shaft& shaft, const std::vector<ContourRow>& outer, const std::vector<SizeUncertainty>& known,
              SizeTexts& texts, Features& features)
{
    MarkCollector(shaft, outer, known, texts, features);
}

}  // namespace lathelier::drawing
