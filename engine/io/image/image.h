// A greyscale image from a PNG, JPEG or TIFF file, in upright orientation.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "engine/core/error.h"
#include "engine/core/progress.h"
#include "engine/io/import.h"

namespace lathelier::io {

struct Image {
    std::string format;    ///< "png", "jpeg" or "tiff"
    int width = 0;         ///< in px, after the orientation was applied
    int height = 0;        ///< in px, after the orientation was applied
    int bits = 8;          ///< bits per sample in the file, 1 to 16
    int channels = 1;      ///< in the file: 1 grey or palette, 2 grey and alpha, 3 colour, 4 colour and alpha
    int orientation = 1;   ///< EXIF orientation of the file, 1 to 8, which was applied; 1: it was upright
    double um_per_px = 0;  ///< size of a pixel as the file states it; 0: it states none. Cameras write the resolution
                           ///< of a printer there (72 dpi is 353 µm), microscopes their scale
    std::vector<float> grey;  ///< row-major from the top left: 0 black, 1 full scale of the file. Colour by the weights
                              ///< of ITU-R BT.601 (0.299, 0.587, 0.114)
    Notes notes;  ///< imageScaleStated, imageTurned, imageProfileIgnored, imageAlphaDropped, imagePagesIgnored

    bool turned() const { return orientation != 1; }
    float at(int x, int y) const
    {
        return grey[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)];
    }
};

/// Limits checked on the header before memory is allocated.
inline constexpr int mostImageSide_px = 65535;        ///< of width and height
inline constexpr double mostImagePixels = 100e6;      ///< of the whole picture
inline constexpr double mostImageBytes = 400e6;       ///< decoded, as samples of the file
inline constexpr double mostImageCompression = 2000;  ///< decoded bytes for each byte of the file
inline constexpr std::string_view imageExpected = "PNG, JPEG or TIFF";

/// True when the first bytes are those of a PNG, JPEG or TIFF file.
bool isImage(std::string_view head);

/// Reads a picture from the bytes of its file. Warnings of a decoder are errors, so that no incomplete image is
/// returned. Errors formatUnknown, imageTooLarge, imageEmpty, imageImplausible, imageUnsupported, imageDamaged,
/// imageEndsEarly, malformed; all but those of the whole file with `byte`. Throws Cancelled. Memory: 4 bytes a pixel,
/// the samples of the file where it is interlaced or turned.
Image readImage(const std::string& name, std::string_view bytes, const Progress& progress = {});

/// Facts for `inspect`: details "width", "height", "bits", "channels", "orientation", "um_per_px" where it is stated.
FileFacts imageFacts(const std::string& name, const Image& image);

}  // namespace lathelier::io
