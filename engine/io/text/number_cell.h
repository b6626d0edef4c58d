// Numbers in the text forms of PLY, PCD, STL and OBJ, whose words are separated by blanks.
#pragma once

#include <string_view>

#include "engine/io/cloud/raw_scan.h"

namespace lathelier::io {

/// Reads words as numbers. These formats know the point only, but programs in some countries write a comma: it is taken
/// as decimal mark once the text proves it to be one.
class NumberCells {
public:
    explicit NumberCells(const ScanSource& source);

    /// The number, which may be NaN or infinite. Errors malformed, numberAmbiguous.
    double read(std::int64_t lineNumber, std::string_view line, std::string_view word);

    char decimal() const { return decimal_; }
    std::string decimalName() const { return decimal_ == ',' ? "comma" : "point"; }

private:
    std::string_view text_;
    Decimal option_;
    char decimal_ = '.';
};

/// Where in a text of lines "keyword x y z" the first number beyond `largest` stands: `line` and
/// `column`. Only looked for when it is known to be there.
Values placeOfLarge(std::string_view text, std::string_view keyword, char decimal, double largest);

}  // namespace lathelier::io
