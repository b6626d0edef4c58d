#include "engine/core/failure.h"

#include <new>
#include <string_view>
#include <system_error>

#include "engine/core/core_codes.h"

namespace lathelier {
namespace {

/// A thread needs memory for its stack. TBB reports a failed start in the text of the exception only.
bool isShortage(const std::exception& failure)
{
    if (dynamic_cast<const std::bad_alloc*>(&failure)) return true;
    if (const auto* system = dynamic_cast<const std::system_error*>(&failure))
        return system->code() == std::errc::resource_unavailable_try_again ||
               system->code() == std::errc::not_enough_memory;
    return std::string_view(failure.what()).find("pthread_create") != std::string_view::npos;
}

}  // namespace

Error toError(const std::exception& failure)
{
    if (const auto* error = dynamic_cast<const Error*>(&failure)) return *error;
    if (isShortage(failure)) return Error(errors::outOfMemory, {});
    return Error(errors::internal, {{"reason", std::string(failure.what())}});
}

}  // namespace lathelier
