// TIFF pictures: read, or refused with a place.
#include "engine/io/image/image_canvas.h"
#include "tests/fuzz/check_image.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    lathelier::fuzz::checkImage(data, size, lathelier::io::readTiff);
    return 0;
}
