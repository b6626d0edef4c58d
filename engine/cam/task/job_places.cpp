#include "engine/cam/task/job_places.h"

#include <algorithm>

#include "engine/cam/cam_codes.h"
#include "engine/cam/task/turn_question.h"
#include "engine/io/json/json_locate.h"
#include "engine/task/inputs.h"

namespace lathelier::cam {
namespace {

/// The tool that the error names; of a number that is there twice, the second one.
std::size_t indexOfTool(const Error& error, const Job& job)
{
    const Value* const stated = find(error.values(), "tool");
    const auto* const number = stated ? std::get_if<std::int64_t>(stated) : nullptr;
    std::size_t index = 0, found = 0;
    const std::size_t wanted = error.code() == errors::toolNumberTwice ? 2 : 1;
    for (std::size_t i = 0; i < job.tools.size() && number && found < wanted; ++i)
        if (job.tools[i].number == *number) {
            index = i;
            ++found;
        }
    return index;
}

std::string fileOf(const project::PanelState& state, const char* role)
{
    const project::Source* const source = task::sourceOf(state, role);
    return source && source->item.empty() ? source->path : std::string();
}

}  // namespace

void locateInJob(Error& error, const project::PanelState& state, const Job& job)
{
    const std::string file = fileOf(state, jobRole), part = fileOf(state, partRole);
    const auto is = [&error](const ErrorCode& code) { return error.code() == code; };
    if (is(errors::segmentImpossible)) {
        const bool is_own = task::sourceOf(state, partRole) == nullptr;
        if (const std::string& path = is_own ? file : part; !path.empty())
            io::locateRow(error, path, is_own ? io::JsonPath{"shaft"} : io::JsonPath{});
        return;
    }
    if (file.empty()) return;
    if (is(errors::toolNumberTwice) || is(errors::toolIncomplete))
        return io::locateInFile(error, file, {"tools", std::to_string(indexOfTool(error, job))});
    if (is(errors::jobWithoutShaft)) return io::locateInFile(error, file, {});
    if (!is(errors::stockSmallerThanPart)) return;
    const Value* const quantity = find(error.values(), "quantity");
    const bool is_length = quantity && *quantity == Value(LT_TEXT("Engine", "the length"));
    io::locateInFile(error, file, {"stock", is_length ? "length_mm" : "diameter_mm"});
}

}  // namespace lathelier::cam
