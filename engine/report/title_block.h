// The title block of a report: whose part this is, which one, measured with what and by whom.
#pragma once

#include <string>
#include <vector>

#include "engine/core/fields.h"
#include "engine/report/document.h"

namespace lathelier::report {

struct TitleBlock {
    std::string company;           ///< that measured
    std::string part;              ///< what it is called
    std::string drawing;           ///< number and revision
    std::string serial;            ///< of this part, or of its batch
    std::string order;             ///< number
    std::string customer;          ///< for whom
    std::string instrument;        ///< that measured, with its number
    std::string calibration_date;  ///< of the instrument, as its certificate states it
    std::string inspector;         ///< who measured
    std::string remark;            ///< whatever else belongs on the first page
    std::string logo_png_base64;   ///< of the company, in base64 (RFC 4648); a picture, so no row of the table
};

/// Key of the logo among the fields: forms leave it to a button.
inline constexpr const char* logoKey = "logo_png_base64";

const std::vector<Field<TitleBlock>>& fieldsOf(const TitleBlock*);

/// What was given, in the order of the form and without the logo; empty when nothing was.
std::vector<Quantity> rowsOf(const TitleBlock& block);

/// Puts the block on the first page of `document`.
void setTitleBlock(Document& document, const TitleBlock& block);

/// The name of a report's file, without folder and suffix: part (else `otherwise`) and serial number, then the date
/// (ISO 8601). Characters that file systems do not take become underscores.
std::string reportFileName(const TitleBlock& block, const std::string& otherwise, const std::string& date);

}  // namespace lathelier::report
