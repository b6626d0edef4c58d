#include "engine/cad/task/compare_question.h"

#include "engine/core/field_within.h"

namespace lathelier::cad {
namespace {

Field<CompareQuestion> unitField(const char* key, io::LengthUnit CompareQuestion::*unit, Text label, Text help)
{
    return field(
        key, unit,
        {{"auto", LT_TEXT("Engine", "automatic")}, {"mm", {"mm"}}, {"m", {"m"}}, {"inch", {"inch"}}, {"um", {"µm"}}},
        {label, help});
}

}  // namespace

const std::vector<Field<CompareQuestion>>& fieldsOf(const CompareQuestion*)
{
    using Q = CompareQuestion;
    static const auto all = [] {
        std::vector<Field<Q>> made;
        for (const FieldInfo& info : infos<registration::CompareParameters>())
            made.push_back(within(&Q::compare, info.key));
        made.push_back(unitField(referenceUnitKey, &Q::reference_unit, LT_TEXT("Engine", "Unit of the reference"),
                                 LT_TEXT("Engine", "Rules over --unit for the reference, where it states none.")));
        made.push_back(unitField(copyUnitKey, &Q::copy_unit, LT_TEXT("Engine", "Unit of the copy"),
                                 LT_TEXT("Engine", "Rules over --unit for the copy, where it states none.")));
        return made;
    }();
    return all;
}

}  // namespace lathelier::cad
