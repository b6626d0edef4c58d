// A grey picture with halves of itself: drawn small, it shows means and no moiré.
#pragma once

#include <QImage>
#include <vector>

namespace lathelier::surface_panel {

class PicturePyramid {
public:
    PicturePyramid() = default;
    explicit PicturePyramid(QImage whole) : whole_(std::move(whole)) {}

    const QImage& whole() const { return whole_; }

    /// The smallest half that has at least one pixel for each that is drawn, `zoom` of them for one of the picture.
    /// Halves are made when they are first asked for; cost: one pass over the pixels.
    const QImage& forZoom(double zoom) const;

private:
    QImage whole_;
    mutable std::vector<QImage> halves_;  ///< each of the one before
};

/// Means of 2 × 2 pixels, Format_Grayscale8; an odd row or column at the end is left out.
QImage halved(const QImage& image);

}  // namespace lathelier::surface_panel
