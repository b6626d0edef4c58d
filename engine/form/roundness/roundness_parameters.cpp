#include <span>

#include "engine/core/core_codes.h"
#include "engine/core/decision_field.h"
#include "engine/core/units.h"
#include "engine/form/roundness/no_filter.h"
#include "engine/form/roundness/roundness.h"
#include "engine/form/roundness/roundness_methods.h"

namespace lathelier::form {
namespace {

using P = RoundnessParameters;
const Text uprUnit = LT_TEXT("Engine", "UPR");

/// Sectors may run through 0°.
Field<P> wrapping(Field<P> field)
{
    field.info.wraps = true;
    return field;
}

Field<P> withUsual(Field<P> field, std::span<const double> values)
{
    field.info.usual.assign(values.begin(), values.end());
    return field;
}

[[noreturn]] void reject(const char* parameter, const Value& found, Text expected)
{
    throw Error(errors::valueNotUnderstood, {{"parameter", parameter}, {"found", found}, {"expected", expected}});
}

}  // namespace

const std::vector<Field<P>>& fieldsOf(const P*)
{
    static const std::vector<Field<P>> all{
        withUsual(
            field("cutoff_upr", &P::cutoff_upr, Range{1, 100000},
                  Label{LT_TEXT("Engine", "Filter cut-off"),
                        LT_TEXT("Engine", "Gaussian filter: waves up to so many undulations per revolution pass."),
                        uprUnit}),
            standardCutoffs),
        field("band_upr", &P::band_upr, Range{0, 100000},
              Label{LT_TEXT("Engine", "Filter band"),
                    LT_TEXT("Engine", "Gaussian filter: waves between these undulations per revolution pass."), uprUnit,
                    true}),
        wrapping(
            field("exclude_deg", &P::exclude_deg, Range{-360, 720},
                  Label{LT_TEXT("Engine", "Excluded sectors"),
                        LT_TEXT("Engine", "Keyways and interruptions, as angles seen from the centre."), unit::deg})),
        field(
            "outliers", &P::outliers,
            {{"none", LT_TEXT("Engine", "Keep")}, {"hampel", LT_TEXT("Engine", "Leave out (Hampel)")}},
            Label{LT_TEXT("Engine", "Outliers"),
                  LT_TEXT("Engine", "Points that stand out of their neighbours by more than 5 standard deviations.")}),
        field("circle", &P::circle,
              {{"LSCI", LT_TEXT("Engine", "Least squares (LSCI)")},
               {"MZCI", LT_TEXT("Engine", "Minimum zone (MZCI)")},
               {"MICI", LT_TEXT("Engine", "Maximum inscribed (MICI)")},
               {"MCCI", LT_TEXT("Engine", "Minimum circumscribed (MCCI)")}},
              Label{LT_TEXT("Engine", "Reference circle"),
                    LT_TEXT("Engine", "The circle of the headline and the verdict; all four are reported.")}),
        field("tolerance_um", &P::tolerance_um, Range{1e-6, 1e6},
              Label{LT_TEXT("Engine", "Tolerance"), LT_TEXT("Engine", "Largest roundness deviation RONt allowed."),
                    unit::um}),
        decisionField(&P::decision,
                      LT_TEXT("Engine",
                              "Guarded rejection: out only where surely out. Simple: the value alone. Guarded: only "
                              "what is sure passes "
                              "or fails."),
                      true),
        field("probe_uncertainty_um", &P::probe_uncertainty_um, Range{0, 1e6},
              Label{LT_TEXT("Engine", "Uncertainty of a point"),
                    LT_TEXT("Engine", "One standard deviation; by default found from the profile's own noise."),
                    unit::um, true}),
    };
    return all;
}

signal::TransmissionBand bandOf(const RoundnessParameters& parameters)
{
    signal::TransmissionBand band{{}, parameters.cutoff_upr};
    if (parameters.band_upr.empty()) return band;
    if (parameters.cutoff_upr) reject("band_upr", parameters.band_upr, LT_TEXT("Engine", "either a cut-off or a band"));
    const Interval& wanted = parameters.band_upr.front();
    if (parameters.band_upr.size() > 1 || !(wanted.from < wanted.to) || !(wanted.to >= 1))
        reject("band_upr", parameters.band_upr, LT_TEXT("Engine", "one band such as 15:500"));
    band.high_upr = wanted.to;
    if (wanted.from > 1) band.low_upr = wanted.from;
    return band;
}

void checkFilter(bool no_filter, const RoundnessParameters& parameters)
{
    const bool is_filtered = !bandOf(parameters).isAll();
    if (is_filtered && no_filter)
        reject("--no-filter", std::string("--cutoff-upr / --band-upr"), LT_TEXT("Engine", "no filter beside it"));
}

}  // namespace lathelier::form
