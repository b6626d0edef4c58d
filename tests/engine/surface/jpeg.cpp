#include "tests/engine/surface/jpeg.h"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <vector>

#include <jpeglib.h>  // needs stdio before it

namespace lathelier::surface::test {

std::string jpegFile(const io::Image& image, int quality)
{
    jpeg_compress_struct file{};
    jpeg_error_mgr problems{};
    file.err = jpeg_std_error(&problems);
    jpeg_create_compress(&file);
    unsigned char* bytes = nullptr;
    unsigned long size = 0;
    jpeg_mem_dest(&file, &bytes, &size);
    file.image_width = static_cast<JDIMENSION>(image.width);
    file.image_height = static_cast<JDIMENSION>(image.height);
    file.input_components = 1;
    file.in_color_space = JCS_GRAYSCALE;
    jpeg_set_defaults(&file);
    jpeg_set_quality(&file, quality, TRUE);
    jpeg_start_compress(&file, TRUE);
    std::vector<JSAMPLE> line(static_cast<std::size_t>(image.width));
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x)
            line[static_cast<std::size_t>(x)] = static_cast<JSAMPLE>(std::lround(255 * image.at(x, y)));
        JSAMPROW row = line.data();
        jpeg_write_scanlines(&file, &row, 1);
    }
    jpeg_finish_compress(&file);
    jpeg_destroy_compress(&file);
    std::string result(reinterpret_cast<const char*>(bytes), size);
    std::free(bytes);
    return result;
}

}  // namespace lathelier::surface::test
