#include "engine/io/cloud/unit_choice.h"

#include "engine/io/io_codes.h"

namespace lathelier::io {
namespace {

constexpr double smallestGuess = 1;
constexpr double largestGuess = 10000;

}  // namespace

double largestCoordinate(const std::optional<LengthScale>& stated, const ImportOptions& options)
{
    const std::optional<LengthScale> known = stated ? stated : lengthScale(options.unit);
    return known ? largestCoordinate_mm / known->mm : largestCoordinate_mm;
}

LengthScale chooseLengthUnit(const std::optional<LengthScale>& stated, const ImportOptions& options, double extent,
                             FileFacts& facts, Notes& notes)
{
    const std::optional<LengthScale> given = lengthScale(options.unit);
    LengthScale unit{"mm", 1};
    if (stated) {
        unit = *stated;
        facts.unit_source = "stated";
        if (given && given->key != stated->key)
            notes.push_back({notes::unitNotUsed, {{"unit", stated->key}, {"given", given->key}}});
    } else if (given) {
        unit = *given;
        facts.unit_source = "given";
    } else {
        if (!(extent >= smallestGuess && extent <= largestGuess))
            throw Error(errors::unitUnknown, {{"extent", extent}});
        facts.unit_source = "guessed";
        notes.push_back({notes::unitGuessed, {{"unit", unit.key}, {"extent", extent}}});
    }
    facts.unit = unit.key;
    return unit;
}

}  // namespace lathelier::io
