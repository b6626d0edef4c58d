// Tables of frequency responses that are not columns of plain numbers: complex numbers in one cell, and names behind
// the numbers of the first row.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "engine/core/progress.h"
#include "engine/io/table/table_layout.h"

namespace lathelier::io {

/// A text as columns of plain numbers, line for line.
class FrfText {
public:
    /// Keeps a reference to `text`. A complex number ("1e-5-2e-6j", "1e-5 - 2e-6i", "(1e-5,-2e-6)") becomes two cells,
    /// and so do the name and the unit above it. CutPro: words behind the numbers of the first row ("Freq Hz Real m/N
    /// Imag Real") become the names of the columns.
    FrfText(std::string_view text, const ImportOptions& options, const Progress& progress);

    std::string_view view() const { return changed_.empty() ? written_ : std::string_view(changed_); }
    bool isComplex() const { return isComplex_; }
    bool isCutPro() const { return !names_.empty(); }

    /// Enters the names found behind the first row.
    void name(TableLayout& layout) const;

private:
    std::string_view written_;
    std::string changed_;  ///< empty: as written
    bool isComplex_ = false;
    std::vector<std::string> names_;  ///< "Real (m/N)"; of the first columns
};

}  // namespace lathelier::io
