#include "app/cli/filter_option.h"

#include "engine/core/core_codes.h"

namespace lathelier::cli {
namespace {

constexpr const char* noFilterKey = "no_filter";

}  // namespace

Option flagOption(const char* key, Text label, Text help)
{
    FieldInfo info;
    info.key = key;
    info.kind = FieldInfo::Kind::Flag;
    info.label = label;
    info.help = help;
    return {info, false};
}

Option noFilterOption()
{
    return flagOption(noFilterKey, LT_TEXT("Engine", "No filter"),
                      LT_TEXT("Engine", "Evaluate the points as they are; this is the default."));
}

void checkNoFilter(const Request& request, const form::RoundnessParameters& parameters)
{
    const bool filtered = !bandOf(parameters).isAll();
    const Value* none = find(request.parameters, noFilterKey);
    if (filtered && none && *none == Value(true))
        throw Error(errors::valueNotUnderstood, {{"parameter", "--no-filter"},
                                                 {"found", "--cutoff-upr / --band-upr"},
                                                 {"expected", LT_TEXT("Engine", "no filter beside it")}});
}

}  // namespace lathelier::cli
