// Image assembly row by row by a decoder: limits of the header, grey weights, orientation.
#pragma once

#include <cstdint>
#include <string_view>

#include "engine/io/image/image.h"

namespace lathelier::io {

/// Declared properties of an image.
struct ImageHeader {
    std::int64_t width = 0;   ///< in px
    std::int64_t height = 0;  ///< in px
    int bits = 8;             ///< bits per sample
    int channels = 1;         ///< samples per pixel
};

/// Errors imageEmpty, imageTooLarge, imageImplausible, with `byte` where the header states the size.
void checkHeader(const ImageHeader& header, std::size_t file_bytes, std::size_t byte);

/// Weights of red, green and blue after ITU-R BT.601.
inline constexpr double redWeight = 0.299;
inline constexpr double greenWeight = 0.587;
inline constexpr double blueWeight = 0.114;

/// An allocated image. Precondition: checkHeader().
Image emptyImage(std::string_view format, const ImageHeader& header);

/// Writes row `row` from `width` pixels of `channels` samples (1 or 3 of colour; further ones are ignored), each one
/// byte or, `wide`, two with the higher first.
void putRow(Image& image, int row, const std::uint8_t* samples, int channels, bool wide);

/// Enters the size of a pixel that the file states, with a note for a scale finer than printers have. Sizes that are
/// not finite or beyond 1 nm to 1 m are not used.
void setScale(Image& image, double um_per_px, const std::string& name);

/// Rotates or mirrors the image into upright orientation. `orientation` as EXIF (CIPA DC-008) counts them, 1 to 8;
/// others change nothing.
void applyOrientation(Image& image, int orientation, const std::string& name);

/// The orientation that an EXIF block (a TIFF header with its first directory) states; 1 when it states none.
int exifOrientation(std::string_view block);

// The decoders. Errors of readImage().
Image readPng(const std::string& name, std::string_view bytes, const Progress& progress);
Image readJpeg(const std::string& name, std::string_view bytes, const Progress& progress);
Image readTiff(const std::string& name, std::string_view bytes, const Progress& progress);

}  // namespace lathelier::io
