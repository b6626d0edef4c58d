// Probe records as tables, with all options.
#include "engine/io/probe/probe_table.h"
#include "tests/fuzz/check_record.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    using namespace lathelier;
    std::string_view bytes = fuzz::viewOf(data, size);
    const io::ImportOptions options = fuzz::takeOptions(bytes);
    fuzz::checkAnswer([&] { fuzz::checkRecord(io::readProbeTable("fuzz", bytes, options)); });
    io::isProbeTable(bytes, options);
    return 0;
}
