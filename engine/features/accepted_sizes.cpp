#include "engine/features/accepted_sizes.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace lathelier::features {
namespace {

constexpr double kMeets_mm = 1e-6;

MeasuredSize measuredOf(const ShaftSegment& segment, const RecognizedRow& row)
{
    return {segment.length_mm, segment.start_diameter_mm, segment.end_diameter_mm, segment.arc_radius_mm,
            row.uncertainty};
}

/// A chamfer or fillet that met the old diameter meets the new one.
void setDiameter(std::vector<ShaftSegment>& segments, std::size_t i, double nominal_mm)
{
    const double start_mm = segments[i].start_diameter_mm, end_mm = segments[i].end_diameter_mm;
    const auto meets = [](double a, double b) { return std::abs(a - b) < kMeets_mm; };
    if (i > 0 && meets(segments[i - 1].end_diameter_mm, start_mm)) segments[i - 1].end_diameter_mm = nominal_mm;
    if (i + 1 < segments.size() && meets(segments[i + 1].start_diameter_mm, end_mm))
        segments[i + 1].start_diameter_mm = nominal_mm;
    segments[i].start_diameter_mm = segments[i].end_diameter_mm = nominal_mm;
}

/// The row's end moves; the next row gives what it takes.
void moveEnd(std::vector<ShaftSegment>& segments, std::size_t i, double by_mm)
{
    if (segments[i].length_mm + by_mm <= 0) return;
    if (i + 1 < segments.size()) {
        if (segments[i + 1].length_mm <= by_mm) return;
        segments[i + 1].length_mm -= by_mm;
    }
    segments[i].length_mm += by_mm;
}

}  // namespace

std::vector<AcceptedSize> acceptedSizes(std::string_view text)
{
    std::vector<AcceptedSize> accepted;
    while (!text.empty()) {
        const std::size_t comma = std::min(text.find(','), text.size());
        const std::string_view word = text.substr(0, comma);
        text.remove_prefix(std::min(comma + 1, text.size()));
        AcceptedSize size;
        const auto [rest, error] = std::from_chars(word.data(), word.data() + word.size(), size.row);
        const auto colon = static_cast<std::size_t>(rest - word.data());
        if (error != std::errc() || colon + 1 >= word.size() || word[colon] != ':') continue;
        size.quantity = std::string(word.substr(colon + 1));
        accepted.push_back(std::move(size));
    }
    return accepted;
}

std::string textOf(const std::vector<AcceptedSize>& accepted)
{
    std::string text;
    for (const AcceptedSize& size : accepted) {
        if (!text.empty()) text += ',';
        text += std::to_string(size.row) + ':' + size.quantity;
    }
    return text;
}

bool isAcceptedAlone(const Suggestion& suggestion)
{
    return suggestion.quantity == "diameter_mm" || suggestion.quantity == "length_mm" ||
           suggestion.quantity == "z_mm" || suggestion.quantity == "radius_mm";
}

Shaft withAccepted(const Recognition& result, const std::vector<AcceptedSize>& accepted)
{
    Shaft shaft = result.shaft;
    if (result.parameters.snap != Snap::Suggest || shaft.segments.size() != result.segments.size()) return shaft;
    for (const AcceptedSize& size : accepted) {
        if (size.row < 1 || size.row > static_cast<std::int64_t>(result.segments.size())) continue;
        const auto i = static_cast<std::size_t>(size.row - 1);
        const RecognizedRow& row = result.segments[i];
        const auto said =
            std::find_if(row.suggestions.begin(), row.suggestions.end(),
                         [&](const Suggestion& suggestion) { return suggestion.quantity == size.quantity; });
        if (said == row.suggestions.end() || !isAcceptedAlone(*said)) continue;
        ShaftSegment& segment = shaft.segments[i];
        if (!segment.measured) segment.measured = measuredOf(result.shaft.segments[i], row);
        if (size.quantity == "diameter_mm")
            setDiameter(shaft.segments, i, said->nominal_mm);
        else if (size.quantity == "radius_mm")
            segment.arc_radius_mm = segment.arc_radius_mm
                                        ? std::optional(std::copysign(said->nominal_mm, *segment.arc_radius_mm))
                                        : std::nullopt;
        else
            moveEnd(shaft.segments, i, said->nominal_mm - said->measured_mm);
    }
    return shaft;
}

}  // namespace lathelier::features
