// A technical drawing as data: lines, arcs, texts and arrow heads on a sheet, ready for any writer (SVG, DXF, PDF).
//
// Coordinates are millimetres on paper from the lower left corner of the sheet, y upward. Angles are degrees,
// anticlockwise. Sheets after ISO 5457 (frame 20 mm from the left edge, 10 mm from the others), scales after ISO 5455,
// line widths and types after ISO 128-2 (0.5 mm visible edges, 0.25 mm all others, long dash dot for axes), arrow
// heads and lettering after ISO 129-1 and ISO 3098-1 (a height is that of capitals). The same input gives the same
// entities in the same order.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace lathelier::drawing {

enum class Sheet : std::uint8_t { A4Landscape, A4Portrait, A3Landscape };

/// An axis-parallel rectangle, mm on paper.
struct Box {
    double left_mm = 0, bottom_mm = 0, right_mm = 0, top_mm = 0;

    double width_mm() const { return right_mm - left_mm; }
    double height_mm() const { return top_mm - bottom_mm; }
    bool overlaps(const Box& other) const;
    bool contains(const Box& other) const;
    /// Grown on all sides.
    Box grown(double by_mm) const;
    friend bool operator==(const Box&, const Box&) = default;
};

Box sheetBox(Sheet sheet);      ///< the trimmed sheet
Box frameBox(Sheet sheet);      ///< the drawing space inside the frame
const char* name(Sheet sheet);  ///< "A4", "A3"

/// paper : real, as "2:1" or "1:5".
struct Scale {
    int paper = 1;
    int real = 1;

    double factor() const { return static_cast<double>(paper) / real; }
    std::string text() const;
    friend bool operator==(const Scale&, const Scale&) = default;
};

/// The scales of ISO 5455 from 10:1 to 1:1000, the largest first.
const std::vector<Scale>& scales();

enum class Layer : std::uint8_t { Contour, Axis, Hatch, Dimensions, Text, Frame };
enum class LineType : std::uint8_t { Continuous, DashDot, Dashed };

inline constexpr double thick_mm = 0.5;  ///< width of visible edges
inline constexpr double thin_mm = 0.25;  ///< width of all other lines

struct Line {
    Eigen::Vector2d from_mm = Eigen::Vector2d::Zero(), to_mm = Eigen::Vector2d::Zero();
    Layer layer = Layer::Contour;  ///< one of `layers`, or a further one
    double width_mm = thick_mm;    ///< line width on paper
    LineType type = LineType::Continuous;
    friend bool operator==(const Line&, const Line&) = default;
};

/// Anticlockwise from start to end; 0 to 360 is the whole circle.
struct Arc {
    Eigen::Vector2d centre_mm = Eigen::Vector2d::Zero();
    double radius_mm = 0;                 ///< on paper
    double start_deg = 0, end_deg = 360;  ///< anticlockwise from x
    Layer layer = Layer::Contour;         ///< one of `layers`, or a further one
    double width_mm = thick_mm;           ///< line width on paper
    friend bool operator==(const Arc&, const Arc&) = default;
};

enum class Anchor : std::uint8_t { Start, Middle, End };

/// The size of the outside or of a bore that a text states, for editing in a window. Writers of files ignore it.
struct DimensionTarget {
    enum class Of : std::uint8_t { None, Diameter, Length, ArcRadius, Chamfer, Taper, Groove };
    Of of = Of::None;                      ///< which size; None: a remark, a keyway
    std::vector<std::size_t> rows = {};    ///< of Shaft::segments, from 0. Length, Groove: all from first to last
    std::optional<std::size_t> bore = {};  ///< of Shaft::bores: `rows` are its rows; Diameter and Length (depth) alone
    friend bool operator==(const DimensionTarget&, const DimensionTarget&) = default;
};

/// One line of text on its base line.
struct Label {
    Eigen::Vector2d at_mm = Eigen::Vector2d::Zero();  ///< of the anchor, on the base line
    double height_mm = 3.5;                           ///< of capitals
    double angle_deg = 0;                             ///< 0, or 90: read from the right
    std::string text = {};                            ///< UTF-8
    Anchor anchor = Anchor::Start;
    bool italic = false;          ///< a measured value
    Layer layer = Layer::Text;    ///< one of `layers`, or a further one
    DimensionTarget target = {};  ///< the size that the text states
    friend bool operator==(const Label&, const Label&) = default;
};

/// A filled arrow head.
struct Arrow {
    Eigen::Vector2d tip_mm = Eigen::Vector2d::Zero();
    Eigen::Vector2d direction = Eigen::Vector2d::UnitX();  ///< unit, toward the tip
    double length_mm = 2.5;                                ///< a third of it wide
    Layer layer = Layer::Dimensions;                       ///< one of `layers`, or a further one
    friend bool operator==(const Arrow&, const Arrow&) = default;
};

struct Drawing {
    Sheet sheet = Sheet::A4Landscape;
    Scale scale;                                          ///< of the main view
    std::string title;                                    ///< for screen readers
    std::vector<Line> lines;                              ///< drawn first
    std::vector<Arc> arcs;                                ///< drawn after the lines
    std::vector<Label> labels;                            ///< drawn after the arcs
    std::vector<Arrow> arrows;                            ///< drawn last
    bool complete = true;                                 ///< false: dimensions were left out for lack of space
    Eigen::Vector2d origin_mm = Eigen::Vector2d::Zero();  ///< of the main view: its axis at the free end
    friend bool operator==(const Drawing&, const Drawing&) = default;
};

/// Width of `text` set in DejaVu Sans with capitals of `height_mm`; exact for ASCII and the signs of drawings.
double textWidth_mm(std::string_view text, double height_mm);

/// Box of a label, from below the base line (descenders) to above the capitals (accents).
Box boxOf(const Label& label);

/// Bounding box of all entities without line widths; an empty box at 0 for an empty drawing.
Box boxOf(const Drawing& drawing);

/// All entities moved.
void move(Drawing& drawing, const Eigen::Vector2d& by_mm);

/// Does the line enter the box?
bool passes(const Line& line, const Box& box);

/// Entities of `other` added after those of `drawing`, which keeps its sheet, scale, title and origin.
void append(Drawing& drawing, const Drawing& other);

/// Font size over the height of capitals in DejaVu Sans.
inline constexpr double fontSizeOverHeight = 1 / 0.729;

}  // namespace lathelier::drawing
