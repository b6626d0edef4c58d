#include "engine/io/frf/frf_choice.h"

#include <algorithm>
#include <charconv>

#include "engine/core/core_codes.h"
#include "engine/core/error.h"
#include "engine/io/frf/frf_codes.h"
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

/// "12x"; without a direction "12".
std::string place(int node, int direction)
{
    constexpr std::string_view letters = " xyz";
    const bool is_stated = direction >= 1 && direction <= 3;
    return std::to_string(node) + (is_stated ? std::string(1, letters[static_cast<std::size_t>(direction)]) : "");
}

/// Response and force at one stated node, in one direction or none stated.
bool isAtOneNode(const MeasuredFrf& measured)
{
    return measured.response_node != 0 && measured.response_node == measured.reference_node &&
           measured.response_direction == measured.reference_direction;
}

/// "12x/5x"; without nodes "#3", its number among the responses.
std::string responseName(std::span<const MeasuredFrf> responses, const MeasuredFrf& measured)
{
    if (nodePair(measured).empty()) return "#" + std::to_string(&measured - responses.data() + 1);
    return place(measured.response_node, measured.response_direction) + "/" +
           place(measured.reference_node, measured.reference_direction);
}

/// The names of all responses but `used`: "2x/1x, 3x/1x …".
std::string otherResponses(std::span<const MeasuredFrf> responses, const MeasuredFrf& used)
{
    std::string words;
    for (const MeasuredFrf& response : responses) {
        if (&response == &used) continue;
        if (words.size() > longestOffer) return words + " …";
        words += (words.empty() ? "" : ", ") + responseName(responses, response);
    }
    return words;
}

}  // namespace

const MeasuredFrf& preferredResponse(std::span<const MeasuredFrf> responses)
{
    for (const auto fits : {isDrivingPoint, isAtOneNode})
        if (const auto found = std::find_if(responses.begin(), responses.end(), fits); found != responses.end())
            return *found;
    return responses.front();
}

Notes notesOfChoice(std::span<const MeasuredFrf> responses, const MeasuredFrf& used, const std::string& path)
{
    if (responses.size() < 2) return {};
    const std::string name = responseName(responses, used);
    Notes found{{notes::severalResponses,
                 {{"path", path},
                  {"count", static_cast<std::int64_t>(responses.size())},
                  {"used", name},
                  {"others", otherResponses(responses, used)}}}};
    const auto states = [](const MeasuredFrf& one) { return one.response_node != 0 && one.reference_node != 0; };
    if (std::all_of(responses.begin(), responses.end(), states) && !isAtOneNode(used))
        found.push_back({notes::noDrivingPoint, {{"path", path}, {"used", name}}});
    return found;
}

std::string nodePair(const MeasuredFrf& measured)
{
    if (measured.response_node == 0 && measured.reference_node == 0) return {};
    return std::to_string(measured.response_node) + "/" + std::to_string(measured.reference_node);
}

const MeasuredFrf& chosenResponse(std::span<const MeasuredFrf> responses, const std::string& choice)
{
    const std::string word(trimmed(choice));
    if (word.empty() && !responses.empty()) return preferredResponse(responses);
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
