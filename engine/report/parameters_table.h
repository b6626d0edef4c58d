// The parameters of a method as a table of the report: labels, choices and units from their description.
#pragma once

#include "engine/core/fields.h"
#include "engine/core/texts.h"
#include "engine/core/used_value.h"
#include "engine/report/document.h"

namespace lathelier::report {

/// `values` by key, as toValues() makes them; optional parameters that were not given are shown with the value used and
/// its origin.
QuantityTable parametersTable(const std::vector<FieldInfo>& infos, const Values& values, const Language& language,
                              const UsedValues& used = {});

template <class P>
QuantityTable parametersTable(const P& parameters, const Language& language, const UsedValues& used = {})
{
    return parametersTable(infos<P>(), toValues(parameters), language, used);
}

}  // namespace lathelier::report
