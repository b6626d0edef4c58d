#include "engine/cam/job_item.h"

#include <algorithm>

#include "engine/core/error.h"
#include "engine/shaft/nested_shaft.h"

namespace lathelier::cam {
namespace {

constexpr const char* shaftKey = "shaft";

}  // namespace

Values valuesOf(const Job& job)
{
    Values values = lathelier::toValues(job);
    if (job.shaft) set(values, shaftKey, shaftAsValue(*job.shaft));
    return values;
}

std::optional<Job> jobOf(const Values& values)
{
    const std::vector<FieldInfo> described = infos<Job>();
    if (std::any_of(described.begin(), described.end(),
                    [&](const FieldInfo& info) { return info.required && !find(values, info.key); }))
        return std::nullopt;
    try {
        auto job = fromValues<Job>(values);
        if (const Value* const shaft = find(values, shaftKey)) {
            job.shaft = shaftOf(*shaft);
            if (!job.shaft) return std::nullopt;
        }
        return job;
    } catch (const Error&) {  // a value that a job cannot have
        return std::nullopt;
    }
}

}  // namespace lathelier::cam
