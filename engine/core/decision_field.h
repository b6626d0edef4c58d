// The parameter "decision" of every verdict: its key and its choices in one place.
#pragma once

#include "engine/core/conformity.h"
#include "engine/core/fields.h"

namespace lathelier {

/// `help`: effect of the rule in this capability. An advanced one is folded away in forms.
template <class P>
Field<P> decisionField(DecisionRule P::*member, Text help, bool advanced)
{
    return field("decision", member,
                 {{"guarded_rejection", LT_TEXT("Engine", "Guarded rejection")},
                  {"simple", LT_TEXT("Engine", "Simple")},
                  {"guarded", LT_TEXT("Engine", "Guarded (ISO 14253-1)")}},
                 Label{LT_TEXT("Engine", "Decision rule"), help, {}, advanced});
}

}  // namespace lathelier
