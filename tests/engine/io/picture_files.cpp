#include "tests/engine/io/picture_files.h"

#include <algorithm>
#include <cstdio>  // jpeglib.h needs it
#include <cstdlib>
#include <cstring>
// clang-format off
#include <jpeglib.h>
#include <tiffio.h>
// clang-format on

namespace lathelier::test {

std::string jpegFile(const Ramp& ramp)
{
    jpeg_compress_struct jpeg{};
    jpeg_error_mgr errors{};
    jpeg.err = jpeg_std_error(&errors);
    jpeg_create_compress(&jpeg);
    unsigned char* out = nullptr;
    unsigned long size = 0;
    jpeg_mem_dest(&jpeg, &out, &size);
    jpeg.image_width = static_cast<JDIMENSION>(ramp.width);
    jpeg.image_height = static_cast<JDIMENSION>(ramp.height);
    jpeg.input_components = 1;
    jpeg.in_color_space = JCS_GRAYSCALE;
    jpeg_set_defaults(&jpeg);
    jpeg_set_quality(&jpeg, 95, TRUE);
    jpeg_start_compress(&jpeg, TRUE);
    std::vector<JSAMPLE> row(static_cast<std::size_t>(ramp.width));
    for (int y = 0; y < ramp.height; ++y) {
        // a gentle ramp, which JPEG keeps
        for (int x = 0; x < ramp.width; ++x)
            row[static_cast<std::size_t>(x)] = static_cast<JSAMPLE>(40 + x / 2 + y / 2);
        JSAMPROW rows[1] = {row.data()};
        jpeg_write_scanlines(&jpeg, rows, 1);
    }
    jpeg_finish_compress(&jpeg);
    std::string bytes(reinterpret_cast<const char*>(out), size);
    jpeg_destroy_compress(&jpeg);
    std::free(out);
    return bytes;
}

namespace {

/// A file in memory that libtiff writes to.
struct Memory {
    std::string bytes;
    std::size_t at = 0;
};

tmsize_t readMemory(thandle_t handle, void* out, tmsize_t count)
{
    auto& memory = *static_cast<Memory*>(handle);
    const std::size_t there = memory.at < memory.bytes.size() ? memory.bytes.size() - memory.at : 0;
    const std::size_t given = std::min(there, static_cast<std::size_t>(count));
    std::memcpy(out, memory.bytes.data() + memory.at, given);
    memory.at += given;
    return static_cast<tmsize_t>(given);
}

tmsize_t writeMemory(thandle_t handle, void* data, tmsize_t count)
{
    auto& memory = *static_cast<Memory*>(handle);
    const auto size = static_cast<std::size_t>(count);
    if (memory.bytes.size() < memory.at + size) memory.bytes.resize(memory.at + size);
    std::memcpy(memory.bytes.data() + memory.at, data, size);
    memory.at += size;
    return count;
}

toff_t seekMemory(thandle_t handle, toff_t offset, int whence)
{
    auto& memory = *static_cast<Memory*>(handle);
    memory.at = whence == SEEK_CUR ? memory.at + offset : whence == SEEK_END ? memory.bytes.size() + offset : offset;
    return memory.at;
}

void putSample(std::vector<std::uint8_t>& block, const Ramp& ramp, const TiffKind& kind, int x, int y)
{
    for (int colour = 0; colour < kind.colours; ++colour) {
        const int value = ramp.value(x, y);
        if (kind.is_float) {
            const auto number = static_cast<float>(value);
            const auto* bytes = reinterpret_cast<const std::uint8_t*>(&number);
            block.insert(block.end(), bytes, bytes + sizeof number);
        } else {
            block.push_back(static_cast<std::uint8_t>(value & 0xFF));
            if (ramp.bits == 16) block.push_back(static_cast<std::uint8_t>(value >> 8));
        }
    }
}

void writePage(TIFF* tiff, const Ramp& ramp, const TiffKind& kind)
{
    TIFFSetField(tiff, TIFFTAG_IMAGEWIDTH, ramp.width);
    TIFFSetField(tiff, TIFFTAG_IMAGELENGTH, ramp.height);
    TIFFSetField(tiff, TIFFTAG_BITSPERSAMPLE, kind.is_float ? 32 : ramp.bits);
    TIFFSetField(tiff, TIFFTAG_SAMPLESPERPIXEL, kind.colours);
    TIFFSetField(tiff, TIFFTAG_SAMPLEFORMAT, kind.is_float ? SAMPLEFORMAT_IEEEFP : SAMPLEFORMAT_UINT);
    TIFFSetField(tiff, TIFFTAG_PHOTOMETRIC,
                 kind.colours == 4   ? PHOTOMETRIC_SEPARATED
                 : kind.colours == 3 ? PHOTOMETRIC_RGB
                                     : PHOTOMETRIC_MINISBLACK);
    TIFFSetField(tiff, TIFFTAG_PLANARCONFIG, PLANARCONFIG_CONTIG);
    TIFFSetField(tiff, TIFFTAG_COMPRESSION, kind.lzw ? COMPRESSION_LZW : COMPRESSION_NONE);
    const int across = kind.tiled ? 64 : ramp.width, down = kind.tiled ? 64 : 16;
    if (kind.tiled) {
        TIFFSetField(tiff, TIFFTAG_TILEWIDTH, across);
        TIFFSetField(tiff, TIFFTAG_TILELENGTH, down);
    } else {
        TIFFSetField(tiff, TIFFTAG_ROWSPERSTRIP, down);
    }
    for (int y = 0; y < ramp.height; y += down)
        for (int x = 0; x < ramp.width; x += across) {
            std::vector<std::uint8_t> block;
            const int rows = kind.tiled ? down : std::min(down, ramp.height - y);
            for (int i = 0; i < rows; ++i)
                for (int k = 0; k < across; ++k) putSample(block, ramp, kind, x + k, y + i);
            const auto size = static_cast<tmsize_t>(block.size());
            const auto column = static_cast<std::uint32_t>(x), row = static_cast<std::uint32_t>(y);
            if (kind.tiled)
                TIFFWriteEncodedTile(tiff, TIFFComputeTile(tiff, column, row, 0, 0), block.data(), size);
            else
                TIFFWriteEncodedStrip(tiff, TIFFComputeStrip(tiff, row, 0), block.data(), size);
        }
    TIFFWriteDirectory(tiff);
}

}  // namespace

std::string tiffFile(const Ramp& ramp, const TiffKind& kind)
{
    Memory memory;
    TIFF* tiff = TIFFClientOpen(
        "test", "wl", &memory, readMemory, writeMemory, seekMemory, [](thandle_t) { return 0; },
        [](thandle_t handle) -> toff_t { return static_cast<Memory*>(handle)->bytes.size(); }, nullptr, nullptr);
    for (int page = 0; page < kind.pages; ++page) writePage(tiff, ramp, kind);
    TIFFClose(tiff);
    return memory.bytes;
}

}  // namespace lathelier::test
