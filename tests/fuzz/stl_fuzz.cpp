// STL files, binary and ascii.
#include "engine/io/cloud/stl_reader.h"
#include "tests/fuzz/check_reader.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    using namespace lathelier;
    const std::string_view bytes = fuzz::viewOf(data, size);
    if (bytes.size() >= 84) fuzz::checkReader(io::readBinaryStl, bytes, false);
    fuzz::checkReader(io::readAsciiStl, bytes, true);
    return 0;
}
