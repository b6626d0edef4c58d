#include "engine/report/parameters_table.h"

namespace lathelier::report {

namespace {

/// "30 (from the file)", "50 (assumed)".
std::string usedText(const UsedValue& value, const Language& language)
{
    const Text pattern = value.origin == ValueOrigin::File ? LT_TEXT("Engine", "{value} (from the file)")
                                                           : LT_TEXT("Engine", "{value} (assumed)");
    return fill(text(pattern, language), {{"value", text(value.value, language)}}, language);
}

}  // namespace

QuantityTable parametersTable(const std::vector<FieldInfo>& infos, const Values& values, const Language& language,
                              const UsedValues& used)
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
        for (const UsedValue& one : used)
            if (one.key == info.key && one.origin != ValueOrigin::Given) value = usedText(one, language);
        if (std::holds_alternative<double>(value)) value = text(value, language);  // as it was typed
        table.rows.push_back({info.label, value, info.unit});
    }
    return table;
}

}  // namespace lathelier::report
