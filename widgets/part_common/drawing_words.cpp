#include "widgets/part_common/drawing_words.h"

#include <fmt/format.h>

#include <ctime>

namespace lathelier::part_common {

std::string today()
{
    const std::time_t now = std::time(nullptr);
    std::tm local{};
    localtime_r(&now, &local);
    return fmt::format("{:04}-{:02}-{:02}", local.tm_year + 1900, local.tm_mon + 1, local.tm_mday);
}

std::string decimalSeparator(const Language& language)
{
    const std::string half = fixed(0.5, 1, language);
    return half.size() > 2 ? half.substr(1, half.size() - 2) : ".";
}

}  // namespace lathelier::part_common
