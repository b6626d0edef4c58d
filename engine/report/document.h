// A report as data: what is to be said, without how it looks. HTML and PDF are made from the same document.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "engine/core/error.h"
#include "engine/core/input_file.h"
#include "engine/core/text.h"
#include "engine/core/texts.h"
#include "engine/core/value.h"

namespace lathelier {

struct VerifyPart;

/// The heading of a column of numbers.
struct Labelled {
    Text label;
    Text unit;  ///< in brackets behind it; empty: none
    friend bool operator==(const Labelled&, const Labelled&) = default;
};

/// A label of the report: a translatable literal, or a name that is the same in every language (a path).
using Caption = std::variant<Text, std::string, Labelled>;

std::string captionText(const Caption& caption, const Language& language = {});

/// One line of a two-column table: name, value, unit.
struct Quantity {
    Caption name;
    Value value;
    Text unit;
    int decimals = 3;  ///< for numbers
};

struct QuantityTable {
    Caption title;
    std::vector<Quantity> rows;
};

struct Table {
    Caption title;
    std::vector<Caption> columns;  ///< with units
    std::vector<std::vector<Value>> rows;
    std::vector<int> decimals;  ///< of the numbers, by column; 3 where not given

    int decimalsOf(std::size_t column) const { return column < decimals.size() ? decimals[column] : 3; }
};

/// A sentence of explanation: a pattern with named values, as in errors and notes.
struct Paragraph {
    Text pattern;
    Values values;
};

struct Curve {
    Caption name;           ///< for the legend; empty: not in it
    std::vector<double> x;  ///< Bars: the edges, one more than y
    std::vector<double> y;  ///< NaN breaks the line
    enum class Style { Line, Bars, Band } style = Style::Line;
    std::vector<double> y_low;  ///< Band only: the other edge
    int colour = -1;            ///< 0: the original's blue, 1: the copy's red, 2…: others; -1: by position
};

/// An XY plot, drawn as SVG.
struct Plot {
    Caption title;
    Caption x_title;  ///< with unit
    Caption y_title;
    std::vector<Curve> curves;
    std::vector<double> y_marks;      ///< horizontal lines, such as tolerance limits
    std::vector<double> x_marks;      ///< vertical lines
    Caption marks_name = Text{};      ///< what the marks are, for the legend
    std::optional<Interval> x_range;  ///< what is shown. Default: all
    std::optional<Interval> y_range;  ///< what is shown; values beyond are drawn at the edge. Default: all
};

/// A map of values on a grid in a diverging colour scale, drawn as an embedded picture with axes and scale in SVG.
struct ColourMap {
    Caption title;
    Caption x_title;
    Caption y_title;
    Caption value_title;
    double x_from = 0, x_to = 1, y_from = 0, y_to = 1;
    int columns = 0, rows = 0;
    std::vector<float> values;        ///< row-major, rows along y; NaN is left blank
    double limit = 1;                 ///< the scale runs from -limit to +limit
    std::optional<double> tolerance;  ///< green inside
};

/// Deviations of closed profiles from a circle, drawn around it as SVG with a stated magnification.
struct PolarPlot {
    struct Trace {
        Caption name;
        std::vector<double> angle_deg;
        std::vector<double> deviation_um;  ///< from the base circle; NaN breaks the line
        int colour = -1;
        bool thin = false;  ///< one of many (single revolutions)
    };
    struct ReferenceLine {  ///< a circle of a radius differing from the base circle's, off its centre
        Caption name;
        double x_um = 0, y_um = 0, deviation_um = 0;
        int colour = -1;
        bool dashed = false;
    };
    struct Mark {
        double angle_deg = 0, deviation_um = 0;
        bool outer = true;  ///< shape of the mark
    };
    Caption title;
    double base_radius_mm = 0;  ///< of the base circle, about whose centre angles and deviations are given
    std::vector<Trace> traces;
    std::vector<ReferenceLine> circles;
    std::vector<Mark> contacts;
    /// So many times a deviation is drawn larger than the base circle's radius. Default: a round one that fits.
    std::optional<double> magnification;
};

/// A ready picture (PNG bytes), such as a 3-D view.
struct Picture {
    Caption title;
    std::string png;
};

/// The answer in large type, as the headline of the panel.
struct Headline {
    std::string text;             ///< already filled and in the reader's language
    std::optional<bool> verdict;  ///< nullopt: none
};

using Block = std::variant<Headline, Paragraph, QuantityTable, Table, Plot, PolarPlot, ColourMap, Picture, Notes>;

struct Section {
    Caption title;
    std::vector<Block> blocks;
};

struct Document {
    Caption title;
    std::vector<const VerifyPart*> verification;  ///< of its capabilities: quoted as the last section
    bool verified = false;                        ///< holds what "Verify installation" found
    std::vector<Section> sections;
    std::vector<InputFile> inputs;
    std::vector<std::string> results;  ///< what it reports, each as JSON (result_json.h); written beside the report
    bool synthetic = false;            ///< the data are synthetic: marked on the first page
    std::string created;               ///< ISO 8601, empty leaves it out (golden tests)
};

}  // namespace lathelier
