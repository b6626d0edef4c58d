#include "widgets/surface/picture_pyramid.h"

namespace lathelier::surface_panel {

QImage halved(const QImage& image)
{
    const QImage grey =
        image.format() == QImage::Format_Grayscale8 ? image : image.convertToFormat(QImage::Format_Grayscale8);
    QImage half(grey.width() / 2, grey.height() / 2, QImage::Format_Grayscale8);
    for (int y = 0; y < half.height(); ++y) {
        const uchar* upper = grey.constScanLine(2 * y);
        const uchar* lower = grey.constScanLine(2 * y + 1);
        uchar* const line = half.scanLine(y);
        for (int x = 0; x < half.width(); ++x, upper += 2, lower += 2)
            line[x] = static_cast<uchar>((upper[0] + upper[1] + lower[0] + lower[1] + 2) / 4);
    }
    return half;
}

const QImage& PicturePyramid::forZoom(double zoom) const
{
    const QImage* found = &whole_;
    for (std::size_t level = 0; 2 * zoom <= 1 && found->width() > 2 && found->height() > 2; ++level, zoom *= 2) {
        if (level == halves_.size()) {
            QImage next = halved(*found);
            halves_.push_back(std::move(next));
        }
        found = &halves_[level];
    }
    return *found;
}

}  // namespace lathelier::surface_panel
