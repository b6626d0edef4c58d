// The entry that finds out the format by itself.
#include "tests/fuzz/check_reader.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    using namespace lathelier;
    std::string_view bytes = fuzz::viewOf(data, size);
    const io::ImportOptions options = fuzz::takeOptions(bytes);
    fuzz::check([&] { return io::readScan("fuzz", bytes, options); });
    return 0;
}
