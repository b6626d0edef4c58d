#include "engine/core/module.h"

#include <dlfcn.h>

#include <filesystem>

#include "engine/core/core_codes.h"

namespace lathelier {

const void* moduleSymbol(const std::string& name, const char* symbol)
{
    std::error_code ignored;
    const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe", ignored);
    const std::string file = (program.parent_path().parent_path() / "lib/lathelier" / (name + ".so")).string();
    // dlopen() counts references; never unloaded, because its texts and tables stay in use.
    void* const module = dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
    const void* const found = module ? dlsym(module, symbol) : nullptr;
    if (!found) {
        const char* const reason = dlerror();
        throw Error(errors::moduleMissing, {{"file", file}, {"reason", std::string(reason ? reason : symbol)}});
    }
    return found;
}

}  // namespace lathelier
