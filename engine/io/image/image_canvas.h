// The brightness of a picture while a decoder fills it row by row: limits of its header, weights, orientation.
#pragma once

#include <cstdint>
#include <string_view>

#include "engine/io/image/image.h"

namespace lathelier::io {

/// What the header of a picture declares.
struct ImageHeader {
    std::int64_t width = 0;   ///< in pixels
    std::int64_t height = 0;  ///< in pixels
    int bits = 8;             ///< of a sample
    int channels = 1;         ///< of a pixel
};

/// Errors imageEmpty, imageTooLarge, imageImplausible, with `byte` where the header states the size.
void checkHeader(const ImageHeader& header, std::size_t file_bytes, std::size_t byte);

/// Weights of red, green and blue after ITU-R BT.601.
inline constexpr double redWeight = 0.299;
inline constexpr double greenWeight = 0.587;
inline constexpr double blueWeight = 0.114;

/// A picture with room for its brightness. Precondition: checkHeader().
Image emptyImage(std::string_view format, const ImageHeader& header);

/// Writes row `row` from `width` pixels of `channels` samples (1 or 3 of colour; further ones are passed over), each
/// one byte or, `wide`, two with the higher first.
void putRow(Image& image, int row, const std::uint8_t* samples, int channels, bool wide);

/// Brings the picture upright. `orientation` as EXIF (CIPA DC-008) counts them, 1 to 8; others change nothing.
void applyOrientation(Image& image, int orientation, const std::string& name);

/// The orientation that an EXIF block (a TIFF header with its first directory) states; 1 when it states none.
int exifOrientation(std::string_view block);

// The decoders. Errors of readImage().
Image readPng(const std::string& name, std::string_view bytes, const Progress& progress);
Image readJpeg(const std::string& name, std::string_view bytes, const Progress& progress);
Image readTiff(const std::string& name, std::string_view bytes, const Progress& progress);

}  // namespace lathelier::io
