// "No filter" as a parameter: the default of the tasks that filter, stated explicitly.
#pragma once

#include "engine/form/roundness/roundness.h"

namespace lathelier::form {

template <class Q>
Field<Q> noFilterField(bool Q::*member)
{
    return field("no_filter", member,
                 Label{LT_TEXT("Engine", "No filter"),
                       LT_TEXT("Engine", "Evaluate the points as they are; this is the default.")});
}

/// Error valueNotUnderstood when "no filter" stands beside a filter; those of bandOf().
void checkFilter(bool no_filter, const RoundnessParameters& parameters);

}  // namespace lathelier::form
