#include "engine/link/focas/focas_library.h"

#include <dlfcn.h>

#include <map>
#include <mutex>

#include "engine/link/link_codes.h"

namespace lathelier::link::focas {
namespace {

// The library for Linux logs into a file of the working directory unless it is told another one.
constexpr const char* noLogFile = "/dev/null";
constexpr long leastLogLevel = 0;

[[noreturn]] void refuse(const std::string& reason)
{
    throw Error(errors::linkNotFound, {{"reason", reason}});
}

template <class Function>
Function optionalSymbol(void* library, const char* name)
{
    return reinterpret_cast<Function>(::dlsym(library, name));
}

template <class Function>
Function neededSymbol(void* library, const std::string& file, const char* name)
{
    const auto found = optionalSymbol<Function>(library, name);
    if (!found) refuse(file + ": " + name);
    return found;
}

}  // namespace

Library::Library(const std::string& file)
{
    void* const library = ::dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
    if (!library) {
        const char* const reason = ::dlerror();
        refuse(reason ? reason : file);
    }
    allocate = neededSymbol<Allocate>(library, file, allocateName);
    free = neededSymbol<Free>(library, file, freeName);
    read = neededSymbol<ReadRange>(library, file, readName);
    write = neededSymbol<WriteRange>(library, file, writeName);
    const auto start = optionalSymbol<StartProcess>(library, startProcessName);
    if (start)
        if (const short result = start(leastLogLevel, noLogFile); result != ok)
            refuse(resultText(startProcessName, result));
    exit_ = optionalSymbol<ExitProcess>(library, exitProcessName);
}

Library::~Library()
{
    if (exit_) exit_();
}

std::shared_ptr<const Library> sharedLibrary(const std::string& file)
{
    // Counted under one lock: the start of a new user never overlaps the end of the last one.
    struct Entry {
        std::unique_ptr<const Library> library;
        int users = 0;
    };
    static std::mutex mutex;
    static auto& all =
        *new std::map<std::string, Entry>;  // kept to the end: a call that is late may still give one back
    const std::lock_guard lock(mutex);
    Entry& entry = all[file];
    if (!entry.library) entry.library = std::make_unique<const Library>(file);
    ++entry.users;
    return {entry.library.get(), [&entry](const Library*) {
                const std::lock_guard release(mutex);
                if (--entry.users == 0) entry.library.reset();
            }};
}

}  // namespace lathelier::link::focas
