// ASSIST.json: any bytes are refused with a code of rejected input, or give a configuration that is written and read
// again as the same.
#include <cstdint>
#include <cstdlib>
#include <string>

#include "engine/link/link_config.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    using namespace lathelier;
    link::LinkConfig config;
    try {
        config = link::readConfig(std::string(reinterpret_cast<const char*>(data), size), "/folder");
    } catch (const Error& error) {
        if (error.code().kind != ErrorKind::InputRejected) std::abort();
        return 0;
    }
    const std::string text = link::textOf(config, "/folder");
    if (link::textOf(link::readConfig(text, "/folder"), "/folder") != text) std::abort();
    return 0;
}
