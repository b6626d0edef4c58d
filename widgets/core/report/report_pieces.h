// The pieces a printed report is laid out from; used by report_pdf.cpp only.
#pragma once

#include <QString>
#include <vector>

#include "engine/report/document.h"

namespace lathelier {

/// Something that is printed in one go. Rich text, a vector drawing or a picture; a long table may be cut between rows.
struct Piece {
    enum class Kind { RichText, Svg, Png, Rows } kind = Kind::RichText;
    QString html;               ///< RichText; Rows: what stands above the rows, up to and with the header row
    std::vector<QString> rows;  ///< Rows: one "<tr>…</tr>" each
    std::string data;           ///< Svg, Png
    bool narrow = false;        ///< two of them stand side by side
    bool keepWithNext = false;  ///< a heading
};

std::vector<Piece> piecesOf(const report::Document& document, const Language& language);

inline constexpr const char* tableEnd = "</table>";

}  // namespace lathelier
