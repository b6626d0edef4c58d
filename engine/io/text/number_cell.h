// Numbers in the text forms of PLY, PCD, STL and OBJ, whose words are separated by blanks.
#pragma once

#include <string_view>

#include "engine/io/cloud/raw_scan.h"

namespace lathelier::io {

/// Reads words as numbers. These formats define the point only, but localised programs write a comma: it is accepted as
/// decimal mark once the text shows it unambiguously.
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

/// Location of the first number beyond `largest` in a text of lines "keyword x y z": `line` and `column`. Precondition:
/// there is such a number.
Values placeOfLarge(std::string_view text, std::string_view keyword, char decimal, double largest);

}  // namespace lathelier::io
