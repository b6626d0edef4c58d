#include "engine/cutting/cutting_forces.h"

#include <cmath>

#include "engine/core/units.h"
#include "engine/cutting/cutting_codes.h"

namespace lathelier::cutting {
namespace {

constexpr double leastEntering_deg = 1;  ///< smallest effective entering angle; a flatter edge rubs
constexpr double largestEntering_deg = 179;

Label required(Text name, Text help, Text unit)
{
    Label label{name, help, unit};
    label.required = true;
    return label;
}

}  // namespace

const std::vector<Field<CuttingCoefficients>>& fieldsOf(const CuttingCoefficients*)
{
    using C = CuttingCoefficients;
    static const auto all = described<C>(
        field("K_tc_N_mm2", &C::K_tc_N_mm2, {0, 1e5},
              required(LT_TEXT("Engine", "K_tc"),
                       LT_TEXT("Engine", "Cutting coefficient along the cutting speed, by chip area."), unit::N_mm2)),
        field("K_te_N_mm", &C::K_te_N_mm, {0, 1e5},
              required(LT_TEXT("Engine", "K_te"),
                       LT_TEXT("Engine", "Edge coefficient along the cutting speed, by contact length."), unit::N_mm)),
        field(
            "K_rfc_N_mm2", &C::K_rfc_N_mm2, {0, 1e5},
            required(LT_TEXT("Engine", "K_rfc"),
                     LT_TEXT("Engine", "Cutting coefficient along the flow of the chip, by chip area."), unit::N_mm2)),
        field("K_rfe_N_mm", &C::K_rfe_N_mm, {0, 1e5},
              required(LT_TEXT("Engine", "K_rfe"),
                       LT_TEXT("Engine", "Edge coefficient along the flow of the chip, by contact length."),
                       unit::N_mm)));
    return all;
}

const std::vector<FieldChoice>& contactLengthChoices()
{
    static const std::vector<FieldChoice> all{{"arc", LT_TEXT("Engine", "arc of the corner and straight edge")},
                                              {"chord", LT_TEXT("Engine", "chord between the ends of the edge in cut")},
                                              {"straight", LT_TEXT("Engine", "straight edge without a corner")}};
    return all;
}

double Chip::flowAngle() const
{
    return std::atan2(across_feed, along_feed);
}

CuttingEdge::CuttingEdge(const Tool& tool, double feed_mm_rev, ContactLength contact, double turned_rad)
    : feed_mm_(feed_mm_rev), radius_mm_(tool.corner_radius_mm.value_or(0)), contact_(contact)
{
    if (!(feed_mm_rev > 0) || !std::isfinite(feed_mm_rev))
        throw Error(errors::feedMissing, {{"feed_mm_rev", feed_mm_rev}});
    if (!(feed_mm_rev < 2 * radius_mm_))
        throw Error(errors::feedBeyondCorner, {{"feed_mm_rev", feed_mm_rev}, {"corner_radius_mm", radius_mm_}});
    const double entering_deg = tool.entering_angle_deg.value_or(0) - turned_rad * deg_per_rad;
    if (!(entering_deg >= leastEntering_deg && entering_deg <= largestEntering_deg))
        throw Error(errors::edgeCannotEnter, {{"entering_angle_deg", entering_deg},
                                              {"minimum_deg", leastEntering_deg},
                                              {"maximum_deg", largestEntering_deg}});
    const double kappa = entering_deg / deg_per_rad;
    const double half = feed_mm_ / 2;
    const double height = std::sqrt(radius_mm_ * radius_mm_ - half * half);
    const double trailing_rad = std::asin(half / radius_mm_);
    sin_ = std::sin(kappa);
    cos_ = std::cos(kappa);
    corner_mm_ = radius_mm_ * (1 - cos_);
    scallop_mm_ = half * half / (radius_mm_ + height);
    trailing_mm_ = radius_mm_ * trailing_rad;
    cornerArc_mm_ = radius_mm_ * kappa;
    cusp_mm2_ = feed_mm_ * radius_mm_ - half * height - radius_mm_ * radius_mm_ * trailing_rad;
}

Chip CuttingEdge::chipAt(double depth_mm) const
{
    Chip chip;
    if (!(depth_mm > scallop_mm_)) return chip;
    chip.is_cut = true;
    const bool beyond_corner = depth_mm >= corner_mm_;
    const double straight_mm = beyond_corner ? (depth_mm - corner_mm_) / sin_ : 0;
    const double forward_mm =
        beyond_corner ? radius_mm_ * sin_ + straight_mm * cos_ : std::sqrt(depth_mm * (2 * radius_mm_ - depth_mm));
    const double along = forward_mm + feed_mm_ / 2;
    const double outward = depth_mm - scallop_mm_;
    const double chord_mm = std::sqrt(along * along + outward * outward);
    // The chip flows perpendicular to the chord, so the height of the chord gives the feed component.
    chip.along_feed = outward / chord_mm;
    chip.across_feed = along / chord_mm;
    chip.area_mm2 = feed_mm_ * depth_mm - cusp_mm2_;
    switch (contact_) {
        case ContactLength::Arc:
            chip.contact_mm = (beyond_corner ? cornerArc_mm_ : radius_mm_ * std::acos(1 - depth_mm / radius_mm_)) +
                              trailing_mm_ + straight_mm;
            break;
        case ContactLength::Chord: chip.contact_mm = chord_mm; break;
        case ContactLength::Straight:
            chip.contact_mm = depth_mm / sin_;
            chip.area_mm2 = feed_mm_ * depth_mm;
            break;
    }
    return chip;
}

CuttingForces cuttingForces(const CuttingCoefficients& coefficients, const Tool& tool, double feed_mm_rev,
                            double depth_mm, ContactLength contact)
{
    return forcesOf(coefficients, CuttingEdge(tool, feed_mm_rev, contact).chipAt(depth_mm));
}

}  // namespace lathelier::cutting
