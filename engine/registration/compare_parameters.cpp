#include "engine/registration/compare.h"

#include "engine/core/decision_field.h"
#include "engine/core/units.h"

namespace lathelier::registration {

const std::vector<Field<ZoneLimits>>& fieldsOf(const ZoneLimits*)
{
    using P = ZoneLimits;
    constexpr Range along{-100000, 100000};
    constexpr Range limit{-1000, 1000};
    static const std::vector<Field<P>> all{
        field("name", &P::name,
              Label{LT_TEXT("Engine", "Name"), LT_TEXT("Engine", "What the zone is called."), {}, false, true}),
        field("z_start_mm", &P::z_start_mm, along,
              Label{LT_TEXT("Engine", "From"), LT_TEXT("Engine", "Along the axis, from the reference's first data."),
                    unit::mm, false, true}),
        field("z_end_mm", &P::z_end_mm, along,
              Label{LT_TEXT("Engine", "To"), LT_TEXT("Engine", "Along the axis, from the reference's first data."),
                    unit::mm, false, true}),
        field("lower_mm", &P::lower_mm, limit,
              Label{LT_TEXT("Engine", "Lower limit"),
                    LT_TEXT("Engine", "Smallest deviation allowed; without both limits the zone is left out."),
                    unit::mm, false, true}),
        field("upper_mm", &P::upper_mm, limit,
              Label{LT_TEXT("Engine", "Upper limit"),
                    LT_TEXT("Engine", "Largest deviation allowed; without both limits the zone is left out."), unit::mm,
                    false, true}),
    };
    return all;
}

namespace {

/// How the copy is aligned.
std::vector<Field<CompareParameters>> alignmentFields()
{
    using P = CompareParameters;
    return {
        field("method", &P::method,
              {{"auto", LT_TEXT("Engine", "Automatic")},
               {"revolution", LT_TEXT("Engine", "Body of revolution")},
               {"plane", LT_TEXT("Engine", "Point to plane")},
               {"point", LT_TEXT("Engine", "Point to point")}},
              Label{LT_TEXT("Engine", "Method"),
                    LT_TEXT("Engine", "How the copy is aligned; automatic takes the axis of a body of revolution.")}),
        field("symmetry", &P::symmetry,
              {{"auto", LT_TEXT("Engine", "Automatic")},
               {"revolution", LT_TEXT("Engine", "Body of revolution")},
               {"none", LT_TEXT("Engine", "None")}},
              Label{LT_TEXT("Engine", "Symmetry"),
                    LT_TEXT("Engine", "Whether the part is a body of revolution."),
                    {},
                    true}),
        field("initial", &P::initial,
              {{"auto", LT_TEXT("Engine", "Automatic")}, {"identity", LT_TEXT("Engine", "As scanned")}},
              Label{LT_TEXT("Engine", "Initial pose"),
                    LT_TEXT("Engine", "Automatic finds any pose; as scanned searches near the given one only."),
                    {},
                    true}),
    };
}

/// Which limits hold, where, and which points count.
std::vector<Field<CompareParameters>> verdictFields()
{
    using P = CompareParameters;
    return {
        field("tolerance_mm", &P::tolerance_mm, Range{1e-6, 1000},
              Label{LT_TEXT("Engine", "Tolerance ±"), LT_TEXT("Engine", "Largest deviation allowed to either side."),
                    unit::mm}),
        field(
            "verdict_rule", &P::verdict_rule,
            {{"surface", LT_TEXT("Engine", "Surface")}, {"points", LT_TEXT("Engine", "Points")}},
            Label{LT_TEXT("Engine", "Verdict by"),
                  LT_TEXT("Engine", "Surface: local means against the tolerance. Points: the share of points within."),
                  {},
                  true}),
        decisionField(
            &P::decision,
            LT_TEXT("Engine",
                    "Guarded rejection: out only where a local mean surely exceeds the limit, within where none does. "
                    "Simple: the mean alone. Guarded: only what is sure passes or fails. Rule surface."),
            false),
        field("pass_percent", &P::pass_percent, Range{0, 100},
              Label{LT_TEXT("Engine", "Pass from"),
                    LT_TEXT("Engine", "Rule points: share of points that must lie within the tolerance."),
                    unit::percent, true}),
        rows("zones", &P::zones, Range{0, 1000},
             Label{LT_TEXT("Engine", "Zones"),
                   LT_TEXT("Engine", "Limits of their own along the axis, counted from the reference's first data."),
                   {},
                   true}),
        field("scanner_accuracy_mm", &P::scanner_accuracy_mm, Range{0, 100},
              Label{LT_TEXT("Engine", "Scanner accuracy"), LT_TEXT("Engine", "One standard deviation of the scanner."),
                    unit::mm}),
        field("max_distance_mm", &P::max_distance_mm, Range{1e-6, 100000},
              Label{LT_TEXT("Engine", "Largest distance"),
                    LT_TEXT("Engine",
                            "Points further from the reference are left out; by default 0.6 % of its size or 10 "
                            "standard deviations."),
                    unit::mm, true}),
        field("exclude_z_mm", &P::exclude_z_mm, Range{-100000, 100000},
              Label{LT_TEXT("Engine", "Excluded zones"),
                    LT_TEXT("Engine", "Clamping areas along the axis, counted from the reference's first data."),
                    unit::mm, true}),
    };
}

}  // namespace

const std::vector<Field<CompareParameters>>& fieldsOf(const CompareParameters*)
{
    static const std::vector<Field<CompareParameters>> all = [] {
        std::vector<Field<CompareParameters>> fields = alignmentFields();
        const std::vector<Field<CompareParameters>> of_verdict = verdictFields();
        fields.insert(fields.end(), of_verdict.begin(), of_verdict.end());
        return fields;
    }();
    return all;
}

}  // namespace lathelier::registration
