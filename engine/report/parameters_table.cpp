#include "engine/report/parameters_table.h"

namespace lathelier::report {

namespace {

/// A number with the digits as entered, in the displayed unit.
Value asTyped(const Value& value, Text unit, const Language& language)
{
    if (!std::holds_alternative<double>(value)) return value;
    return text(shownValue(value, unit, language), language);
}

/// "30 (from the file)", "50 (assumed)".
std::string usedText(const UsedValue& value, const Language& language)
{
    const Text pattern = value.origin == ValueOrigin::File ? LT_TEXT("Engine", "{value} (from the file)")
                                                           : LT_TEXT("Engine", "{value} (assumed)");
    return fill(text(pattern, language), {{"value", text(shownValue(value.value, value.unit, language), language)}},
                language);
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
        table.rows.push_back({info.label, asTyped(value, info.unit, language), info.unit});
    }
    return table;
}

}  // namespace lathelier::report
