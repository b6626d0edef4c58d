#include "engine/core/module.h"

#include <dlfcn.h>

#include <filesystem>

#include "engine/core/core_codes.h"

namespace lathelier {
namespace {

namespace fs = std::filesystem;

/// lib/<program> beside bin, as installed; lib/lathelier for programs that were only built.
fs::path moduleFile(const std::string& name)
{
    std::error_code ignored;
    const fs::path program = fs::read_symlink("/proc/self/exe", ignored);
    const fs::path lib = program.parent_path().parent_path() / "lib";
    const fs::path own = lib / program.filename() / (name + ".so");
    return fs::exists(own, ignored) ? own : lib / "lathelier" / (name + ".so");
}

}  // namespace

const void* moduleSymbol(const std::string& name, const char* symbol)
{
    const std::string file = moduleFile(name).string();
    // Loaded again it is the same one, and counted: never unloaded, because its texts and tables are in use.
    void* const module = dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
    const void* const found = module ? dlsym(module, symbol) : nullptr;
    if (!found) {
        const char* const reason = dlerror();
        throw Error(errors::moduleMissing, {{"file", file}, {"reason", std::string(reason ? reason : symbol)}});
    }
    return found;
}

}  // namespace lathelier
