#include "engine/report/parameters_table.h"

namespace lathelier::report {

QuantityTable parametersTable(const std::vector<FieldInfo>& infos, const Values& values, const Language& language)
{
    QuantityTable table{LT_TEXT("Engine", "Parameters"), {}};
    for (const FieldInfo& info : infos) {
        const Value* given = find(values, info.key);
        Value value = given ? *given : Value();
        for (const FieldChoice& choice : info.choices)
            if (value == Value(choice.key)) {
                value = choice.label;
                break;
            }
        if (std::holds_alternative<double>(value)) value = text(value, language);  // as it was typed
        table.rows.push_back({info.label, value, info.unit});
    }
    return table;
}

}  // namespace lathelier::report
