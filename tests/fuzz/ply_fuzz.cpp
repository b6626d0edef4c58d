// PLY files, binary and ascii.
#include "engine/io/cloud/ply_reader.h"
#include "tests/fuzz/check_reader.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    using namespace lathelier;
    const std::string_view bytes = fuzz::viewOf(data, size);
    if (bytes.empty()) return 0;
    fuzz::checkReader(io::readPly, bytes, false);
    fuzz::checkReader(io::readPly, bytes, true);
    return 0;
}
