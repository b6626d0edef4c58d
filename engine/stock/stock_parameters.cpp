#include "engine/stock/stock_check.h"

#include "engine/core/units.h"

namespace lathelier::stock {
namespace {

Label folded(Text name, Text help, Text unit = {})
{
    Label label{name, help, unit};
    label.advanced = true;
    return label;
}

}  // namespace

const std::vector<Field<StockParameters>>& fieldsOf(const StockParameters*)
{
    using P = StockParameters;
    static const auto all = described<P>(
        field("z_zero_mm", &P::z_zero_mm, {-longest_mm, longest_mm},
              Label{LT_TEXT("Engine", "z of the program's zero"),
                    LT_TEXT("Engine", "z = this less the program's Z; 0: the program's zero is the free end."),
                    unit::mm}),
        rows("tools", &P::tools, {0, 1000},
             Label{LT_TEXT("Engine", "Tools"), LT_TEXT("Engine", "By the numbers of the program.")}),
        group("chuck", &P::chuck,
              Label{LT_TEXT("Engine", "Chuck"), LT_TEXT("Engine", "What the tool must not meet; none: not checked.")}),
        group("tailstock", &P::tailstock,
              Label{LT_TEXT("Engine", "Tailstock"), LT_TEXT("Engine", "Centre and quill; none: not there.")}),
        field("dog_leg", &P::dog_leg,
              Label{LT_TEXT("Engine", "Dog-leg of rapid moves"),
                    LT_TEXT("Engine", "Test the path of a control that moves each axis at its own rate, too.")}),
        field("rapid_x_m_min", &P::rapid_x_m_min, {0.001, 1000},
              folded(LT_TEXT("Engine", "Rapid rate along x"),
                     LT_TEXT("Engine", "Of the slide, on radius; the ratio of both rates shapes the dog-leg."),
                     unit::m_min)),
        field("rapid_z_m_min", &P::rapid_z_m_min, {0.001, 1000},
              folded(LT_TEXT("Engine", "Rapid rate along z"), LT_TEXT("Engine", "Of the slide."), unit::m_min)),
        field("stock_step_mm", &P::step_mm, {1e-3, 10},
              folded(LT_TEXT("Engine", "Column of stock"),
                     LT_TEXT("Engine", "Width along z; wider where stock or program are long."), unit::mm)),
        field("feed_step_mm", &P::feed_step_mm, {1e-2, 100},
              folded(LT_TEXT("Engine", "Step of a feed move"),
                     LT_TEXT("Engine", "Longest step between two tests of the holder."), unit::mm)),
        field(
            "touch_mm", &P::touch_mm, {0, 1},
            folded(LT_TEXT("Engine", "Touching"), LT_TEXT("Engine", "What meets no deeper is no finding."), unit::mm)));
    return all;
}

const char* key(FindingKind kind)
{
    switch (kind) {
        case FindingKind::RapidThroughStock: return "rapid_through_stock";
        case FindingKind::HolderInStock: return "holder_in_stock";
        case FindingKind::Chuck: return "chuck";
        case FindingKind::Tailstock: break;
    }
    return "tailstock";
}

Text nameOf(FindingKind kind)
{
    switch (kind) {
        case FindingKind::RapidThroughStock: return LT_TEXT("Engine", "rapid move through stock");
        case FindingKind::HolderInStock: return LT_TEXT("Engine", "holder in stock");
        case FindingKind::Chuck: return LT_TEXT("Engine", "tool in the chuck");
        case FindingKind::Tailstock: break;
    }
    return LT_TEXT("Engine", "tool in the tailstock");
}

const char* key(MovePath path)
{
    switch (path) {
        case MovePath::Programmed: return "programmed";
        case MovePath::Straight: return "straight";
        case MovePath::DogLeg: return "dog_leg";
        case MovePath::Both: break;
    }
    return "both";
}

Text nameOf(MovePath path)
{
    switch (path) {
        case MovePath::Programmed: return LT_TEXT("Engine", "as programmed");
        case MovePath::Straight: return LT_TEXT("Engine", "on the straight path");
        case MovePath::DogLeg: return LT_TEXT("Engine", "on the dog-leg path");
        case MovePath::Both: break;
    }
    return LT_TEXT("Engine", "on both paths");
}

}  // namespace lathelier::stock
