// How much two pictures differ: means over blocks, since the anti-aliasing of type varies between versions of fonts.
#pragma once

#include <QColor>
#include <QImage>
#include <algorithm>
#include <cmath>

namespace lathelier {

struct PictureDifference {
    double mean = 0;     ///< of all blocks, in levels of 255
    double largest = 0;  ///< of a block
};

/// Means over blocks of 8 pixels a side.
inline QImage shrunk(const QImage& image)
{
    constexpr int block_px = 8;
    return image.convertToFormat(QImage::Format_RGB32)
        .scaled(image.width() / block_px, image.height() / block_px, Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
}

/// Of two shrunk pictures of equal size.
inline PictureDifference differenceOfShrunk(const QImage& x, const QImage& y)
{
    PictureDifference result;
    for (int row = 0; row < x.height(); ++row)
        for (int column = 0; column < x.width(); ++column) {
            const QColor one = x.pixelColor(column, row), other = y.pixelColor(column, row);
            const double off = std::max({std::abs(one.red() - other.red()), std::abs(one.green() - other.green()),
                                         std::abs(one.blue() - other.blue())});
            result.mean += off / (x.width() * x.height());
            result.largest = std::max(result.largest, off);
        }
    return result;
}

}  // namespace lathelier
