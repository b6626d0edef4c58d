// Drawing as SVG text: only what SVG Tiny 1.2 has, with attributes instead of styles, so that browsers, Qt and
// Inkscape show the same.
#pragma once

#include <string>
#include <string_view>

#include "engine/report/colours.h"

namespace lathelier::report {

/// Text for HTML and XML: &, <, >, quotes escaped; invisible and bidirectional characters made visible(), line breaks
/// kept.
std::string escaped(std::string_view text);

/// "#rrggbb"
std::string hex(const Rgb& colour);

class Svg {
public:
    /// `label` is the accessible name.
    Svg(double width, double height, const std::string& label);

    enum class Anchor { Start, Middle, End };

    void line(double x1, double y1, double x2, double y2, std::string_view stroke, double width = 1,
              std::string_view dashes = {});
    void rect(double x, double y, double width, double height, std::string_view fill, std::string_view stroke = "none");
    void path(std::string_view data, std::string_view stroke, double width, std::string_view fill = "none",
              double opacity = 1, std::string_view dashes = {});
    void text(double x, double y, Anchor anchor, double size, std::string_view content, bool bold = false);
    void verticalText(double x, double y, double size, std::string_view content);  ///< text rotated to read upwards,
                                                                                   ///< centred
    void png(double x, double y, double width, double height, std::string_view bytes);

    std::string finish();

private:
    std::string out_;
};

/// A coordinate: at most two decimals, decimal point.
std::string coordinate(double value);

/// Approximate width of `text` in `size`, for layout only.
double textWidth(std::string_view text, double size);

}  // namespace lathelier::report
