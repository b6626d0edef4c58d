#include "engine/features/nominal/accepted_sizes.h"

#include <algorithm>
#include <charconv>

#include "engine/features/features_codes.h"
#include "engine/features/nominal/agreeing_sizes.h"
#include "engine/features/nominal/snap.h"

namespace lathelier::features {

std::vector<AcceptedSize> acceptedSizes(std::string_view text)
{
    std::vector<AcceptedSize> accepted;
    while (!text.empty()) {
        const std::size_t comma = std::min(text.find(','), text.size());
        const std::string_view entry = text.substr(0, comma);
        text.remove_prefix(std::min(comma + 1, text.size()));
        AcceptedSize size;
        const auto [rest, error] = std::from_chars(entry.data(), entry.data() + entry.size(), size.row);
        const auto colon = static_cast<std::size_t>(rest - entry.data());
        if (error != std::errc() || colon + 1 >= entry.size() || entry[colon] != ':') continue;
        size.quantity = std::string(entry.substr(colon + 1));
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

std::vector<AcceptedSize> afterChange(std::vector<AcceptedSize> accepted, const RowChange& change)
{
    const bool merges = change.what == RowChange::What::Merge;
    std::erase_if(accepted, [&](const AcceptedSize& size) {
        return size.row == change.row || (merges && size.row == change.row + 1);
    });
    const std::int64_t more = change.what == RowChange::What::Split              ? 1
                              : merges || change.what == RowChange::What::Delete ? -1
                                                                                 : 0;
    for (AcceptedSize& size : accepted)
        if (size.row > change.row) size.row += more;
    return accepted;
}

Shaft withAccepted(const Recognition& result, const std::vector<AcceptedSize>& accepted)
{
    const RecognitionParameters& parameters = result.parameters;
    if (parameters.snap == Snap::None || parameters.method != RecognitionMethod::Robust || accepted.empty())
        return result.shaft;
    if (parameters.snap == Snap::Apply) return agreeingNominal(result, accepted).shaft;
    Recognition chosen = result;
    for (std::size_t i = 0; i < chosen.segments.size(); ++i)
        std::erase_if(chosen.segments[i].suggestions, [&](const Suggestion& suggestion) {
            const AcceptedSize size{static_cast<std::int64_t>(i) + 1, suggestion.quantity};
            return std::find(accepted.begin(), accepted.end(), size) == accepted.end();
        });
    for (auto& bore : chosen.bores)
        for (RecognizedRow& row : bore) row.suggestions.clear();
    return appliedNominal(chosen);
}

Notes notesOfSizes(const Recognition& result, const std::vector<AcceptedSize>& accepted)
{
    const RecognitionParameters& parameters = result.parameters;
    if (parameters.snap != Snap::Apply || parameters.method != RecognitionMethod::Robust) return {};
    const std::vector<AcceptedSize> left_out = agreeingNominal(result, accepted).left_out;
    if (left_out.empty()) return {};
    return {{notes::nominalNotApplied,
             {{"count", static_cast<std::int64_t>(left_out.size())}, {"sizes", textOf(left_out)}}}};
}

}  // namespace lathelier::features
