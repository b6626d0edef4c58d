#include "engine/features/refit/row_change.h"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <cmath>
#include <optional>

#include "engine/features/refit/refit_limits.h"

namespace lathelier::features {
namespace {

constexpr std::array<std::string_view, 7> changeNames{"delete", "merge", "split", "cylinder",
                                                      "cone",   "round", "fillet"};

template <class Number>
std::optional<Number> numberIn(std::string_view text)
{
    Number value{};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    return error == std::errc() && end == text.data() + text.size() ? std::optional(value) : std::nullopt;
}

std::optional<RowChange> changeIn(std::string_view text)
{
    const std::size_t colon = text.find(':'), sign = text.find('@');
    if (colon == std::string_view::npos) return std::nullopt;
    RowChange change;
    std::size_t name = 0;
    while (name < changeNames.size() && changeNames[name] != text.substr(0, colon)) ++name;
    if (name == changeNames.size()) return std::nullopt;
    change.what = static_cast<RowChange::What>(name);
    const bool split = change.what == RowChange::What::Split;
    if (split != (sign != std::string_view::npos)) return std::nullopt;
    const auto row = numberIn<std::int64_t>(text.substr(colon + 1, split ? sign - colon - 1 : std::string_view::npos));
    if (!row || *row < 1) return std::nullopt;
    change.row = *row;
    if (split) {
        const auto z_mm = numberIn<double>(text.substr(sign + 1));
        if (!z_mm || !std::isfinite(*z_mm)) return std::nullopt;
        change.z_mm = *z_mm;
    }
    return change;
}

}  // namespace

std::vector<RowChange> rowChanges(std::string_view text)
{
    std::vector<RowChange> all;
    while (!text.empty() && all.size() < refitLimits.most_changes) {
        const std::size_t comma = text.find(',');
        if (const auto change = changeIn(text.substr(0, comma))) all.push_back(*change);
        text = comma == std::string_view::npos ? std::string_view() : text.substr(comma + 1);
    }
    return all;
}

std::string textOf(const std::vector<RowChange>& changes)
{
    std::string text;
    for (const RowChange& change : changes) {
        if (!text.empty()) text += ',';
        text += fmt::format("{}:{}", changeNames[static_cast<std::size_t>(change.what)], change.row);
        if (change.what == RowChange::What::Split) text += fmt::format("@{}", change.z_mm);
    }
    return text;
}

}  // namespace lathelier::features
