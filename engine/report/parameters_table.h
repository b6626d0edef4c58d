// The parameters of a method as a table of the report: labels, choices and units from their description.
#pragma once

#include "engine/core/fields.h"
#include "engine/core/texts.h"
#include "engine/report/document.h"

namespace lathelier::report {

/// `values` by key, as toValues() makes them.
QuantityTable parametersTable(const std::vector<FieldInfo>& infos, const Values& values, const Language& language);

template <class P>
QuantityTable parametersTable(const P& parameters, const Language& language)
{
    return parametersTable(infos<P>(), toValues(parameters), language);
}

}  // namespace lathelier::report
