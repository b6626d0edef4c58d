// A report as data: content without layout. HTML and PDF are made from the same document.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "engine/core/error.h"
#include "engine/core/input_file.h"
#include "engine/core/text.h"
#include "engine/core/value.h"
#include "engine/report/answer.h"
#include "engine/report/caption.h"
#include "engine/report/chart.h"

namespace lathelier {
struct VerifyPart;
}

namespace lathelier::report {

/// One line of a two-column table: name, value, unit.
struct Quantity {
    Caption name;
    Value value;       ///< not given: shown as a dash
    Text unit;         ///< empty: no unit
    int decimals = 3;  ///< decimals of numbers
};

struct QuantityTable {
    Caption title;  ///< above the table
    std::vector<Quantity> rows;
};

struct Table {
    Caption title;                         ///< above the table
    std::vector<Caption> columns;          ///< headings with units
    std::vector<std::vector<Value>> rows;  ///< each with a cell for each column
    std::vector<int> decimals;             ///< decimals by column; 3 where not given

    int decimalsOf(std::size_t column) const { return column < decimals.size() ? decimals[column] : 3; }
    /// Unit of the numbers of a column, from its heading; empty: none.
    Text unitOf(std::size_t column) const
    {
        const Labelled* heading = column < columns.size() ? std::get_if<Labelled>(&columns[column]) : nullptr;
        return heading ? heading->unit : Text{};
    }
};

/// A sentence of explanation: a pattern with named values, as in errors and notes.
struct Paragraph {
    Text pattern;
    Values values;  ///< values named in braces in the pattern
};

/// An image, such as a 3-D view.
struct Picture {
    enum class Width { Own, Half, Page };  ///< Own: an SVG takes the width of the page, a PNG half of it

    Caption title;
    std::string png;  ///< content of the file; or an SVG, which begins with "<svg"
    Width width = Width::Own;

    bool isSvg() const { return png.starts_with("<svg"); }
    bool isHalf() const { return width == Width::Half || (width == Width::Own && !isSvg()); }  ///< two side by side
};

using Block = std::variant<Answer, Paragraph, QuantityTable, Table, Plot, PolarPlot, ColourMap, Picture, Notes>;

struct Section {
    Caption title;              ///< heading
    std::vector<Block> blocks;  ///< in order of appearance
};

struct Document {
    Caption title;                                ///< on the first page
    std::vector<Quantity> title_block;            ///< part, drawing, instrument… (title_block.h); empty: none
    std::string logo_png_base64;                  ///< on the first page; empty: none
    std::vector<const VerifyPart*> verification;  ///< verification of the capabilities used, quoted as the last section
    bool verified = false;                        ///< the verification section has been added
    std::vector<Section> sections;                ///< in order of appearance
    std::vector<InputFile> inputs;                ///< files, each with its SHA-256
    std::vector<std::string> results;  ///< reported results, each as JSON (result_json.h); written beside the report
    bool synthetic = false;            ///< synthetic data: marked on the first page
    std::string created;               ///< ISO 8601, empty leaves it out (golden tests)
};

}  // namespace lathelier::report
