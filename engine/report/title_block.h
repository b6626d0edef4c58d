// Title block of a report: customer, part, instrument, inspector.
#pragma once

#include <string>
#include <vector>

#include "engine/core/fields.h"
#include "engine/report/document.h"

namespace lathelier::report {

struct TitleBlock {
    std::string company;  ///< measuring company
    std::string part;     ///< name of the part
    std::string drawing;  ///< drawing number and revision
    std::string serial;   ///< serial number of the part or batch
    std::string order;    ///< order number
    std::string customer;
    std::string instrument;        ///< measuring instrument with its number
    std::string calibration_date;  ///< of the instrument, as its certificate states it
    std::string inspector;
    std::string remark;           ///< further text on the first page
    std::string logo_png_base64;  ///< of the company, in base64 (RFC 4648); a picture, so no row of the table
};

/// Key of the logo among the fields, which forms replace by a button.
inline constexpr const char* logoKey = "logo_png_base64";

const std::vector<Field<TitleBlock>>& fieldsOf(const TitleBlock*);

/// The given entries in the order of the form, without the logo. `to_fill_in`: company, part, drawing, serial number,
/// instrument and inspector also where they are not given, as lines to be filled in by hand.
std::vector<Quantity> rowsOf(const TitleBlock& block, bool to_fill_in = false);

/// Puts the block on the first page of `document`, with lines to be filled in by hand where it states a verdict.
void setTitleBlock(Document& document, const TitleBlock& block);

/// The name of a report's file, without folder and suffix: part (else `otherwise`) and serial number, then the date
/// (ISO 8601). Characters invalid in file names become underscores.
std::string reportFileName(const TitleBlock& block, const std::string& otherwise, const std::string& date);

}  // namespace lathelier::report
