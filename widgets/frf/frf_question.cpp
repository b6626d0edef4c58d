#include "widgets/frf/frf_question.h"

#include "engine/core/field_within.h"

namespace lathelier::frf_panel {

const std::vector<Field<FrfQuestion>>& fieldsOf(const FrfQuestion*)
{
    using Q = FrfQuestion;
    static const std::vector<Field<Q>> all{
        field("response", &Q::response,
              Label{LT_TEXT("Engine", "Response"),
                    LT_TEXT("Engine",
                            "Which of several in the file: its number, or its nodes as 12/5 (response/force). Empty: "
                            "the first.")}),
        field("fit", &Q::fit, Label{LT_TEXT("Engine", "Fit modes"), LT_TEXT("Engine", "Finds the modes.")}),
        within(&Q::modal, "number_of_modes"),
        within(&Q::modal, "range_hz"),
        field("handed_on", &Q::handed_on,
              {{"measured", LT_TEXT("Engine", "The response itself")}, {"model", LT_TEXT("Engine", "The modal model")}},
              Label{LT_TEXT("Engine", "Use for lobes"),
                    LT_TEXT("Engine", "What “Use this response” hands on: the response, or its modal model.")}),
        rows("modes", &Q::modes, Range{0, receptance::mostModes},
             Label{LT_TEXT("Engine", "Modes changed by hand"),
                   LT_TEXT("Engine", "In place of those of the fit; drag a peak in the magnitude chart.")}),
        within(&Q::modal, "complex_residues"),
        foldedWithin(&Q::computing, "respond_z_mm"),
        foldedWithin(&Q::computing, "excite_z_mm"),
        foldedWithin(&Q::computing, "shear"),
        foldedWithin(&Q::computing, "step_correction")};
    return all;
}

}  // namespace lathelier::frf_panel
