#include "engine/io/frf/frf_choice.h"

#include <algorithm>
#include <charconv>

#include "engine/core/core_codes.h"
#include "engine/core/error.h"
#include "engine/io/frf/frf_codes.h"
#include "engine/io/text/text_lines.h"

namespace lathelier::io {
namespace {

constexpr double coherenceOfUse = 0.8;
constexpr double aboveNoise = 4;           ///< |G| over the noise of a line that is looked at
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

/// Without nodes "#3", its number among the responses.
std::string nameAmong(std::span<const MeasuredFrf> responses, const MeasuredFrf& measured)
{
    const std::string name = responseName(measured);
    return name.empty() ? "#" + std::to_string(&measured - responses.data() + 1) : name;
}

/// The names of all responses but `used`: "2x/1x, 3x/1x …".
std::string otherResponses(std::span<const MeasuredFrf> responses, const MeasuredFrf& used)
{
    std::string words;
    for (const MeasuredFrf& response : responses) {
        if (&response == &used) continue;
        if (words.size() > longestOffer) return words + " …";
        words += (words.empty() ? "" : ", ") + nameAmong(responses, response);
    }
    return words;
}

}  // namespace

double largestFlexibility(const Frf& frf)
{
    const Frf receptance = toReceptance(frf);
    double largest = 0, before = 0, last = 0;  // of the two lines before
    for (std::size_t i = 0; i < receptance.value.size(); ++i) {
        if (!receptance.coherence.empty() && receptance.coherence[i] < coherenceOfUse) continue;
        if (!receptance.noise.empty() && std::abs(receptance.value[i]) < aboveNoise * receptance.noise[i]) continue;
        const double now = -receptance.value[i].real();
        largest = std::max(largest, std::min({before, last, now}));
        before = last;
        last = now;
    }
    return largest;
}

const MeasuredFrf& preferredResponse(std::span<const MeasuredFrf> responses)
{
    for (const auto fits : {isDrivingPoint, isAtOneNode}) {
        const MeasuredFrf* softest = nullptr;
        double largest = -1;
        for (const MeasuredFrf& response : responses) {
            if (!fits(response)) continue;
            const double flexibility = largestFlexibility(response.frf);
            if (flexibility > largest) softest = &response;
            largest = std::max(largest, flexibility);
        }
        if (softest) return *softest;
    }
    return responses.front();
}

Notes notesOfChoice(std::span<const MeasuredFrf> responses, const MeasuredFrf& used, const std::string& path)
{
    if (responses.size() < 2) return {};
    const std::string name = nameAmong(responses, used);
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

std::string responseName(const MeasuredFrf& measured)
{
    if (nodePair(measured).empty()) return {};
    return place(measured.response_node, measured.response_direction) + "/" +
           place(measured.reference_node, measured.reference_direction);
}

const MeasuredFrf& chosenResponse(std::span<const MeasuredFrf> responses, const FrfOptions& options)
{
    return chosenResponse(responses, options.response);
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
