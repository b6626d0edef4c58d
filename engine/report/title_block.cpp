#include "engine/report/title_block.h"

#include <algorithm>

#include "engine/core/utf8.h"

namespace lathelier::report {
namespace {

constexpr std::size_t longestName_bytes = 120;

}  // namespace

const std::vector<Field<TitleBlock>>& fieldsOf(const TitleBlock*)
{
    using T = TitleBlock;
    static const std::vector<Field<T>> all{
        field("company", &T::company, Label{LT_TEXT("Engine", "Company"), LT_TEXT("Engine", "That measured.")}),
        field("part", &T::part, Label{LT_TEXT("Engine", "Part"), LT_TEXT("Engine", "What it is called.")}),
        field("drawing", &T::drawing,
              Label{LT_TEXT("Engine", "Drawing"), LT_TEXT("Engine", "Number and revision of the drawing.")}),
        field("serial", &T::serial,
              Label{LT_TEXT("Engine", "Serial number"), LT_TEXT("Engine", "Of this part, or of its batch.")}),
        field("order", &T::order, Label{LT_TEXT("Engine", "Order"), LT_TEXT("Engine", "Number of the order.")}),
        field("customer", &T::customer, Label{LT_TEXT("Engine", "Customer"), LT_TEXT("Engine", "For whom it is.")}),
        field("instrument", &T::instrument,
              Label{LT_TEXT("Engine", "Instrument"), LT_TEXT("Engine", "What measured, with its number.")}),
        field("calibration_date", &T::calibration_date,
              Label{LT_TEXT("Engine", "Calibrated"),
                    LT_TEXT("Engine", "Date of the instrument's calibration, as its certificate states it.")}),
        field("inspector", &T::inspector,
              Label{LT_TEXT("Engine", "Inspector"), LT_TEXT("Engine", "Who measured and evaluated.")}),
        field("remark", &T::remark,
              Label{LT_TEXT("Engine", "Remark"), LT_TEXT("Engine", "Whatever else belongs on the first page.")}),
        field(logoKey, &T::logo_png_base64,
              Label{LT_TEXT("Engine", "Logo"), LT_TEXT("Engine", "Of the company, on the first page.")}),
    };
    return all;
}

std::vector<Quantity> rowsOf(const TitleBlock& block, bool to_fill_in)
{
    static const std::vector<std::string> always{"company", "part", "drawing", "serial", "instrument", "inspector"};
    std::vector<Quantity> rows;
    const Values values = toValues(block);
    for (const FieldInfo& info : infos<TitleBlock>()) {
        if (info.key == logoKey) continue;
        const auto* const given = std::get_if<std::string>(find(values, info.key));
        const bool is_line = to_fill_in && std::find(always.begin(), always.end(), info.key) != always.end();
        if (given && (!given->empty() || is_line)) rows.push_back({info.label, *given, {}});
    }
    return rows;
}

namespace {

/// It states a verdict, so that somebody signs for it.
bool isCertificate(const Document& document)
{
    if (document.sections.empty() || document.sections.front().blocks.empty()) return false;
    const auto* const answer = std::get_if<Answer>(&document.sections.front().blocks.front());
    return answer && answer->verdict;
}

}  // namespace

void setTitleBlock(Document& document, const TitleBlock& block)
{
    document.title_block = rowsOf(block, isCertificate(document));
    document.logo_png_base64 = block.logo_png_base64;
}

std::string reportFileName(const TitleBlock& block, const std::string& otherwise, const std::string& date)
{
    std::string name = block.part.empty() ? otherwise : block.part;
    if (!block.serial.empty()) name.append("_").append(block.serial);
    name = std::string(firstBytes(name, longestName_bytes));
    std::replace_if(
        name.begin(), name.end(),
        [](char c) {
            return static_cast<unsigned char>(c) < 32 ||
                   std::string_view("/\\:*?\"<>|").find(c) != std::string_view::npos;
        },
        '_');
    const std::size_t first = name.find_first_not_of(" .");  // a leading dot would hide the file
    name = first == std::string::npos ? std::string() : name.substr(first);
    if (name.empty()) name = "report";
    return name.append("_").append(date);
}

}  // namespace lathelier::report
