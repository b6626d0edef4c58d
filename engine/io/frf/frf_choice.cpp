#include "engine/io/frf/frf_choice.h"

#include <charconv>

#include "engine/core/core_codes.h"
#include "engine/core/error.h"
#include "engine/io/text/text_lines.h"

namespace lathelier::io {
namespace {

constexpr std::size_t longestOffer = 100;  ///< characters of the list of responses in an error

std::string offered(std::span<const MeasuredFrf> responses)
{
    std::string words = "1…" + std::to_string(responses.size());
    for (const MeasuredFrf& response : responses) {
        const std::string pair = nodePair(response);
        if (pair.empty()) continue;
        if (words.size() > longestOffer) return words + " …";
        words += ", " + pair;
    }
    return words;
}

}  // namespace

std::string nodePair(const MeasuredFrf& measured)
{
    if (measured.response_node == 0 && measured.reference_node == 0) return {};
    return std::to_string(measured.response_node) + "/" + std::to_string(measured.reference_node);
}

const MeasuredFrf& chosenResponse(std::span<const MeasuredFrf> responses, const std::string& choice)
{
    const std::string word(trimmed(choice));
    if (word.empty() && !responses.empty()) return responses.front();
    std::size_t number = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
    if (error == std::errc() && end == word.data() + word.size() && number >= 1 && number <= responses.size())
        return responses[number - 1];
    for (const MeasuredFrf& response : responses)
        if (!word.empty() && nodePair(response) == word) return response;
    throw Error(errors::valueNotUnderstood,
                {{"parameter", "response"}, {"found", choice}, {"expected", offered(responses)}});
}

}  // namespace lathelier::io
