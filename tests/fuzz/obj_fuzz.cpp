// OBJ files.
#include "engine/io/cloud/obj_reader.h"
#include "tests/fuzz/check_reader.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    using namespace lathelier;
    fuzz::checkReader(io::readObj, fuzz::viewOf(data, size), true);
    return 0;
}
