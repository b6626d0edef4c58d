#include "widgets/frf/frf_question.h"

#include <algorithm>
#include <stdexcept>

namespace lathelier::frf_panel {
namespace {

/// The field `key` of a struct within the question.
template <class Part>
Field<FrfQuestion> within(Part FrfQuestion::*member, const std::string& key)
{
    for (const Field<Part>& inner : fields<Part>())
        if (inner.info.key == key)
            return {inner.info, [member, inner](const FrfQuestion& q) { return inner.get(q.*member); },
                    [member, inner](FrfQuestion& q, const Value& value) { inner.set(q.*member, value); }};
    throw std::logic_error("no such parameter: " + key);
}

/// The same, folded away in the form.
template <class Part>
Field<FrfQuestion> folded(Part FrfQuestion::*member, const std::string& key)
{
    Field<FrfQuestion> field = within(member, key);
    field.info.advanced = true;
    return field;
}

}  // namespace

const std::vector<Field<FrfQuestion>>& fieldsOf(const FrfQuestion*)
{
    using Q = FrfQuestion;
    using M = receptance::ModalParameters;
    using R = receptance::ReceptanceParameters;
    static const std::vector<Field<Q>> all{
        field("response", &Q::response,
              Label{LT_TEXT("Engine", "Response"),
                    LT_TEXT("Engine",
                            "Which of several in the file: its number, or its nodes as 12/5 (response/force). Empty: "
                            "the first.")}),
        field("fit", &Q::fit, Label{LT_TEXT("Engine", "Fit modes"), LT_TEXT("Engine", "Finds the modes.")}),
        within<M>(&Q::modal, "number_of_modes"),
        within<M>(&Q::modal, "range_hz"),
        field("handed_on", &Q::handed_on,
              {{"measured", LT_TEXT("Engine", "The response itself")}, {"model", LT_TEXT("Engine", "The modal model")}},
              Label{LT_TEXT("Engine", "Use for lobes"),
                    LT_TEXT("Engine", "What “Use this response” hands on: the response, or its modal model.")}),
        rows("modes", &Q::modes, Range{0, receptance::mostModes},
             Label{LT_TEXT("Engine", "Modes changed by hand"),
                   LT_TEXT("Engine", "In place of those of the fit; drag a peak in the magnitude chart.")}),
        within<M>(&Q::modal, "complex_residues"),
        folded<R>(&Q::computing, "respond_z_mm"),
        folded<R>(&Q::computing, "excite_z_mm"),
        folded<R>(&Q::computing, "shear"),
        folded<R>(&Q::computing, "step_correction")};
    return all;
}

}  // namespace lathelier::frf_panel
