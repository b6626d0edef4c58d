// JSON inputs by their description: any bytes are read, refused with a place, or noted; what is read is written and
// read again as the same.
#include <cstdint>
#include <cstdlib>
#include <nlohmann/json.hpp>

#include "engine/core/error.h"
#include "engine/io/json/json_fields.h"
#include "engine/shaft/shaft.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    using namespace lathelier;
    try {
        Notes notes;
        const io::JsonDocument document{std::string(reinterpret_cast<const char*>(data), size)};
        const Shaft shaft = io::readFields<Shaft>(document.root(), notes, {"schema", "schema_version"});
        const std::string written =
            io::objectOf(infos<Shaft>(), toValues(shaft)).dump(-1, ' ', false, Json::error_handler_t::replace);
        Notes none;
        const io::JsonDocument again{written};
        const Shaft same = io::readFields<Shaft>(again.root(), none);
        if (!(same == shaft) || !none.empty()) std::abort();
    } catch (const Error& error) {
        if (error.code().kind != ErrorKind::InputRejected) std::abort();
    }
    return 0;
}
