// The pieces a printed report is laid out from; used by report_pdf.cpp only.
#pragma once

#include <QString>
#include <vector>

#include "engine/report/document.h"

namespace lathelier {

/// A printed block: rich text, a vector drawing or an image; a long table may be split between rows.
struct Piece {
    enum class Kind { RichText, Svg, Png, Rows } kind = Kind::RichText;
    QString html;                 ///< RichText; Rows: content above the rows, including the header row
    std::vector<QString> rows;    ///< Rows: one "<tr>…</tr>" each
    std::string data;             ///< content of Svg or Png
    double share = 1;             ///< of the width: that a drawing takes
    bool narrow = false;          ///< two narrow blocks are placed side by side
    bool keep_with_next = false;  ///< true for a heading
};

std::vector<Piece> piecesOf(const report::Document& document, const Language& language);

inline constexpr const char* tableEnd = "</table>";

}  // namespace lathelier
