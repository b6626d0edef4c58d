// Messages of the simulated control and lines of the log: any bytes are refused with a code of rejected input, or are a
// message that is written and read again as the same.
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <string>

#include "engine/core/error.h"
#include "engine/link/exchange.h"
#include "engine/link/loopback/messages.h"

namespace {

using namespace lathelier;

template <class Read>
void tried(const Read& read)
{
    try {
        read();
    } catch (const Error& error) {
        if (error.code().kind != ErrorKind::InputRejected) std::abort();
    }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    const std::string line(reinterpret_cast<const char*>(data), size);
    tried([&] {
        const link::Message message = link::messageFrom(line);
        const link::Message again = link::messageFrom(link::lineOf(message));
        if (again.id != message.id || again.ask != message.ask || again.names != message.names ||
            again.name != message.name || again.value != message.value)
            std::abort();
    });
    tried([&] {
        const link::ControlValues values = link::valuesFrom(line, 1, {link::requestName, link::diameterName});
        if (values.size() != 2) std::abort();
    });
    tried([&] { link::errorFrom(line, 1); });
    tried([&] { link::programFrom(line, 1); });
    tried([&] { link::exchangesOf(line, {}); });
    return 0;
}
