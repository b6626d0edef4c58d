// A picture compressed as JPEG, as by cameras.
#pragma once

#include <string>

#include "engine/io/image/image.h"

namespace lathelier::surface::test {

/// The grey picture as the bytes of a JPEG file. `quality`: 1 to 100.
std::string jpegFile(const io::Image& image, int quality);

}  // namespace lathelier::surface::test
