// Dimension lines with their arrows, extension lines and texts (ISO 129-1), added to a drawing.
#pragma once

#include <limits>
#include <optional>
#include <utility>

#include "engine/drawing/dimension_texts.h"
#include "engine/drawing/drawing.h"

namespace lathelier::drawing {

inline constexpr double arrow_mm = 2.5;  ///< length of arrow heads

/// Adds dimensions with lettering of one height.
class DimensionPainter {
public:
    DimensionPainter(Drawing& drawing, double height_mm) : drawing_(drawing), height_mm_(height_mm) {}

    double height_mm() const { return height_mm_; }
    double widthOf(const DimensionText& text) const { return textWidth_mm(text.text, height_mm_); }
    /// Across the writing, with its distance from the dimension line.
    double band_mm() const { return 1.15 * height_mm_ + gap_mm(); }
    /// From a dimension line to the base line of its text.
    double gap_mm() const { return 0.32 * height_mm_ + 0.3; }

    void line(const Eigen::Vector2d& from, const Eigen::Vector2d& to, Layer layer = Layer::Dimensions);
    void arrow(const Eigen::Vector2d& tip, const Eigen::Vector2d& direction);
    void text(const Eigen::Vector2d& at, const DimensionText& text, Anchor anchor, double angle_deg = 0);

    /// From `from_x` to `to_x` at height y, the text above the line: about its middle (or about `text_x`) where it
    /// fits, else beyond `from_x`. Extension lines begin at the two heights `from_y` and `to_y`.
    void horizontal(double from_x, double to_x, double y, double from_y, double to_y, const DimensionText& label,
                    std::optional<double> text_x = {});
    /// From where to where horizontal() draws along the line, its text in the usual place; from_x < to_x.
    std::pair<double, double> extentOf(double from_x, double to_x, const DimensionText& label) const;
    /// For `text_x`: the text beyond `from_x` even where it would fit.
    static constexpr double outside = std::numeric_limits<double>::infinity();
    /// Is the dimension line as long as its text?
    bool fitsInside(double length_mm, const DimensionText& label) const;

    /// From `from_y` to `to_y` at x, the text left of the line, reading upward, about its middle, or above the line's
    /// upper end where it does not fit.
    void vertical(double x, double from_y, double to_y, const DimensionText& label);

private:
    Drawing& drawing_;
    double height_mm_;
};

}  // namespace lathelier::drawing
