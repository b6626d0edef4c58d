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

class MarkCollector {
public:
    MarkCollector(const Shaft& shaft, const std::vector<ContourRow>& outer, SizeTexts& texts, Features& features)
        : shaft_(shaft), outer_(outer), texts_(texts), features_(features), viewed_deg_(viewedAngle_deg(shaft))
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

    /// A size of the mark; `named`: the one that its U is of.
    Size size(const ShaftMark& mark, double value_mm, bool named) const
    {
        Size one{value_mm, {}, {}, {}};
        if (mark.uncertainty_mm || !shaft_.recovered.scan.empty()) one.measured_mm = value_mm;
        if (named && mark.uncertainty_mm) one.U_um = 1000 * *mark.uncertainty_mm;
        return one;
    }

    DimensionText sizeText(const ShaftMark& mark, const std::string& prefix, double value_mm, bool named)
    {
        return texts_.text(prefix, size(mark, value_mm, named));
    }

    DimensionText angleText(const ShaftMark& mark)
    {
        const double turned = std::abs(turn(mark));
        if (turned < turnShown_deg) return {};
        return {texts_.number(turned, 1) + "°", texts_.isMeasured(size(mark, turned, false))};
    }

    DimensionText filled(const ShaftMark& mark, Text pattern, const Values& values)
    {
        return {fill(translated(pattern, texts_.options()), values), texts_.isMeasured(size(mark, 1, false))};
    }

    std::string depthText(const ShaftMark& hole) const
    {
        if (hole.through.value_or(0) > 0) return ", " + translated(LT_TEXT("Engine", "through"), texts_.options());
        if (!hole.depth_mm) return {};
        return ", " + fill(translated(LT_TEXT("Engine", "{depth} deep"), texts_.options()),
                           {{"depth", texts_.number(*hole.depth_mm)}});
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

    /// A length from the free end to a place of a mark.
    void addPlace(const ShaftMark& mark, double z_mm, double radius_mm)
    {
        if (z_mm < same_mm || outer_.empty() || features_.lengths.empty()) return;
        const auto after = std::find_if(features_.lengths.begin(), features_.lengths.end(),
                                        [&](const LengthDimension& one) { return one.to_z_mm > z_mm - 1e-3; });
        if (after == features_.lengths.end() || std::abs(after->to_z_mm - z_mm) < 1e-3) return;
        const double from_radius_mm = outer_.front().start_diameter_mm / 2;
        features_.lengths.insert(after, {0, z_mm, from_radius_mm, radius_mm, sizeText(mark, {}, z_mm, false)});
    }

    bool addKeyway(const ShaftMark& mark)
    {
        const double radius = outerRadius(outer_, middle(mark));
        const std::optional<double> floor = floorOf(mark, radius);
        if (!mark.width_mm || !floor || !(*mark.width_mm > 0) || *mark.width_mm >= 2 * radius ||
            std::abs(*floor) >= radius)
            return false;
        CrossSection& section = sectionAt(*mark.z_start_mm, *mark.z_end_mm);
        section.slots.push_back({turn(mark), *mark.width_mm, *floor, sizeText(mark, {}, *mark.width_mm, true),
                                 sizeText(mark, {}, radius + *floor, false), angleText(mark)});
        section.captions.push_back(filled(mark, LT_TEXT("Engine", "(length {length})"),
                                          {{"length", texts_.number(*mark.z_end_mm - *mark.z_start_mm, 2)}}));
        for (const double z : {*mark.z_start_mm, *mark.z_end_mm}) addPlace(mark, z, *mark.width_mm / 2);
        return true;
    }

    bool addFlat(const ShaftMark& mark)
    {
        const double radius = outerRadius(outer_, middle(mark));
        if (!mark.distance_mm || std::abs(*mark.distance_mm) >= radius) return false;
        CrossSection& section = sectionAt(*mark.z_start_mm, *mark.z_end_mm);
        section.flats.push_back(
            {turn(mark), *mark.distance_mm, sizeText(mark, {}, radius + *mark.distance_mm, true), angleText(mark)});
        for (const double z : {*mark.z_start_mm, *mark.z_end_mm}) addPlace(mark, z, radius);
        return true;
    }

    bool addHole(const ShaftMark& mark)
    {
        const double z = middle(mark), radius = outerRadius(outer_, z);
        if (!mark.diameter_mm || !(*mark.diameter_mm > 0) || *mark.diameter_mm >= 2 * radius) return false;
        const bool through = mark.through.value_or(0) > 0;
        DimensionText label = sizeText(mark, diameterPrefix, *mark.diameter_mm, true);
        label.text += depthText(mark);
        CrossSection& section = sectionAt(z, z);
        RadialHole hole{turn(mark), *mark.diameter_mm, {}, std::move(label), angleText(mark)};
        // A blind hole whose depth is not known is shown as deep as it is wide.
        if (!through) hole.depth_mm = std::min(mark.depth_mm.value_or(*mark.diameter_mm), radius);
        section.holes.push_back(std::move(hole));
        addPlace(mark, z, *mark.diameter_mm / 2);
        return true;
    }

    bool addBoltCircle(const ShaftMark& mark)
    {
        const double count = mark.count.value_or(0);
        if (!mark.diameter_mm || !mark.pitch_circle_mm || !(count >= 1) || count > 1000) return false;
        CrossSection& section = sectionAt(*mark.z_start_mm, *mark.z_end_mm);
        section.circles.push_back(
            {turn(mark), static_cast<std::size_t>(count), *mark.diameter_mm, *mark.pitch_circle_mm});
        DimensionText holes = sizeText(mark, diameterPrefix, *mark.diameter_mm, true);
        holes.text = fill(translated(LT_TEXT("Engine", "{count}×{hole} on ⌀{circle}"), texts_.options()),
                          {{"count", texts_.number(count, 0)},
                           {"hole", holes.text},
                           {"circle", texts_.number(*mark.pitch_circle_mm)}});
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
            sizeText(mark, translated(LT_TEXT("Engine", "AF "), texts_.options()), across, true);
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
            section.teeth->width = sizeText(mark, {}, *mark.width_mm, false);
        }
        section.captions.push_back(sizeText(mark, diameterPrefix, *mark.major_mm, true));
        section.captions.back().text += " / " + sizeText(mark, diameterPrefix, *mark.minor_mm, false).text;
    }

    bool addEccentric(const ShaftMark& mark)
    {
        if (!mark.offset_mm || !(*mark.offset_mm > 0)) return false;
        CrossSection& section = sectionAt(*mark.z_start_mm, *mark.z_end_mm);
        if (mark.diameter_mm) section.diameter_mm = *mark.diameter_mm;
        section.eccentric = OffsetAxis{turn(mark), *mark.offset_mm, sizeText(mark, "e ", *mark.offset_mm, true),
                                       mark.angle_deg ? angleOfEccentric(mark) : DimensionText{}};
        return true;
    }

    /// Only beside another mark that it is measured from.
    DimensionText angleOfEccentric(const ShaftMark& mark)
    {
        const bool alone = std::abs(std::remainder(*mark.angle_deg + 90 - viewed_deg_, 360)) < turnShown_deg;
        return alone ? DimensionText{} : angleText(mark);
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
        if (!text.empty()) features_.callouts.push_back({{z, height_mm}, {text, false}, Mouth::None});
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
        if (mark.kind == MarkKind::Unexplained)
            return fill(translated(LT_TEXT("Engine", "NOT EXPLAINED, z {from}-{to}"), options),
                        {{"from", texts_.number(*mark.z_start_mm)}, {"to", texts_.number(*mark.z_end_mm)}});
        if (mark.kind == MarkKind::Other) return mark.other_kind;
        return translated(nameOf(mark.kind), options);
    }

    const Shaft& shaft_;
    const std::vector<ContourRow>& outer_;
    SizeTexts& texts_;
    Features& features_;
    double viewed_deg_;
};

}  // namespace

std::string letterOf(std::size_t section)
{
    const std::string letter(1, static_cast<char>('A' + section % 26));
    return section < 26 ? letter : letter + std::to_string(section / 26);
}

void addMarks(const Shaft& shaft, const std::vector<ContourRow>& outer, SizeTexts& texts, Features& features)
{
    MarkCollector(shaft, outer, texts, features);
}

}  // namespace lathelier::drawing
