#include "engine/io/frf/frf_unit.h"

#include <cmath>
#include <numbers>

#include "engine/io/text/text_lines.h"
#include "engine/io/text/units.h"

namespace lathelier::io {
namespace {

constexpr std::size_t longestUnit = 60;
constexpr int deepestBrackets = 8;
constexpr double freeFall_mm_s2 = 9806.65;
constexpr double poundForce_N = 4.4482216152605;
constexpr double kilogramForce_N = 9.80665;
constexpr double poundal_N = 0.138254954376;

struct PhysicalUnitWord {
    std::string_view word;  ///< ASCII letters in lower case
    PhysicalUnit unit;
};

constexpr PhysicalUnitWord physicalUnitWords[] = {
    {"m", {1e3, 1, 0, 0}},
    {"mm", {1, 1, 0, 0}},
    {"cm", {10, 1, 0, 0}},
    {"um", {1e-3, 1, 0, 0}},
    {"µm", {1e-3, 1, 0, 0}},
    {"μm", {1e-3, 1, 0, 0}},
    {"nm", {1e-6, 1, 0, 0}},
    {"metre", {1e3, 1, 0, 0}},
    {"metres", {1e3, 1, 0, 0}},
    {"meter", {1e3, 1, 0, 0}},
    {"meters", {1e3, 1, 0, 0}},
    {"millimetre", {1, 1, 0, 0}},
    {"millimetres", {1, 1, 0, 0}},
    {"millimeter", {1, 1, 0, 0}},
    {"millimeters", {1, 1, 0, 0}},
    {"micron", {1e-3, 1, 0, 0}},
    {"microns", {1e-3, 1, 0, 0}},
    {"micrometre", {1e-3, 1, 0, 0}},
    {"micrometer", {1e-3, 1, 0, 0}},
    {"in", {25.4, 1, 0, 0}},
    {"inch", {25.4, 1, 0, 0}},
    {"inches", {25.4, 1, 0, 0}},
    {"mils", {0.0254, 1, 0, 0}},
    {"thou", {0.0254, 1, 0, 0}},
    {"foot", {304.8, 1, 0, 0}},
    {"feet", {304.8, 1, 0, 0}},
    {"mil", {0.0254, 1, 0, 0}},
    {"ft", {304.8, 1, 0, 0}},
    {"s", {1, 0, 1, 0}},
    {"sec", {1, 0, 1, 0}},
    {"second", {1, 0, 1, 0}},
    {"seconds", {1, 0, 1, 0}},
    {"ms", {1e-3, 0, 1, 0}},
    {"n", {1, 0, 0, 1}},
    {"newton", {1, 0, 0, 1}},
    {"newtons", {1, 0, 0, 1}},
    {"kn", {1e3, 0, 0, 1}},
    {"kilonewton", {1e3, 0, 0, 1}},
    {"kilonewtons", {1e3, 0, 0, 1}},
    {"dan", {10, 0, 0, 1}},
    {"cn", {1e-2, 0, 0, 1}},
    {"millinewton", {1e-3, 0, 0, 1}},
    {"millinewtons", {1e-3, 0, 0, 1}},
    {"un", {1e-6, 0, 0, 1}},
    {"µn", {1e-6, 0, 0, 1}},
    {"μn", {1e-6, 0, 0, 1}},
    {"dyn", {1e-5, 0, 0, 1}},
    {"dyne", {1e-5, 0, 0, 1}},
    {"dynes", {1e-5, 0, 0, 1}},
    {"kgf", {kilogramForce_N, 0, 0, 1}},
    {"kp", {kilogramForce_N, 0, 0, 1}},
    {"kilopond", {kilogramForce_N, 0, 0, 1}},
    {"gf", {kilogramForce_N * 1e-3, 0, 0, 1}},
    {"lbf", {poundForce_N, 0, 0, 1}},
    {"lbfs", {poundForce_N, 0, 0, 1}},
    {"lb", {poundForce_N, 0, 0, 1}},
    {"lbs", {poundForce_N, 0, 0, 1}},
    {"pound", {poundForce_N, 0, 0, 1}},
    {"pounds", {poundForce_N, 0, 0, 1}},
    {"kip", {poundForce_N * 1e3, 0, 0, 1}},
    {"klbf", {poundForce_N * 1e3, 0, 0, 1}},
    {"ozf", {poundForce_N / 16, 0, 0, 1}},
    {"pdl", {poundal_N, 0, 0, 1}},
    {"poundal", {poundal_N, 0, 0, 1}},
    {"poundals", {poundal_N, 0, 0, 1}},
    {"kg", {1e-3, -1, 2, 1}},
    {"g", {freeFall_mm_s2, 1, -2, 0}},
    {"gn", {freeFall_mm_s2, 1, -2, 0}},
    {"g0", {freeFall_mm_s2, 1, -2, 0}},
    {"g's", {freeFall_mm_s2, 1, -2, 0}},
    {"g’s", {freeFall_mm_s2, 1, -2, 0}},
    {"gs", {freeFall_mm_s2, 1, -2, 0}},
    {"gal", {10, 1, -2, 0}},
    {"1", {1, 0, 0, 0}},
};

PhysicalUnit power(const PhysicalUnit& unit, int exponent)
{
    return {std::pow(unit.scale, exponent), unit.length * exponent, unit.time * exponent, unit.force * exponent};
}

PhysicalUnit product(const PhysicalUnit& a, const PhysicalUnit& b)
{
    return {a.scale * b.scale, a.length + b.length, a.time + b.time, a.force + b.force};
}

bool isUnitLetter(char c)
{
    return (c >= 'a' && c <= 'z') || static_cast<unsigned char>(c) >= 0x80;
}

/// Parses a unit; `text` is in lower case, `written` the same as it stands in the file.
class UnitParser {
public:
    UnitParser(std::string_view text, std::string_view written) : rest_(text), written_(written) {}

    std::optional<PhysicalUnit> whole()
    {
        auto unit = readProduct(0);
        return unit && rest_.empty() ? unit : std::nullopt;
    }

private:
    bool take(std::string_view mark)
    {
        while (!rest_.empty() && isBlank(rest_.front())) rest_.remove_prefix(1);
        if (!rest_.starts_with(mark)) return false;
        rest_.remove_prefix(mark.size());
        return true;
    }

    std::optional<PhysicalUnit> readProduct(int depth)
    {
        auto unit = readFactor(depth);
        while (unit) {
            const bool divides = take("/");
            if (!divides && !take("**") && !take("*") && !take("·") && !take(".")) take("");
            if (!divides && (rest_.empty() || rest_.front() == ')' || rest_.front() == ']')) break;
            const auto factor = readFactor(depth);
            if (!factor) return std::nullopt;
            unit = product(*unit, power(*factor, divides ? -1 : 1));
        }
        return unit;
    }

    std::optional<PhysicalUnit> readFactor(int depth)
    {
        std::optional<PhysicalUnit> unit;
        if (take("(") || take("[")) {
            if (depth == deepestBrackets) return std::nullopt;
            unit = readProduct(depth + 1);
            if (!take(")") && !take("]")) return std::nullopt;
        } else {
            unit = readWord();
        }
        if (!unit) return std::nullopt;
        const auto exponent = readExponent();
        return exponent ? std::optional(power(*unit, *exponent)) : std::nullopt;
    }

    std::optional<PhysicalUnit> readWord()
    {
        take("");
        std::size_t length = 0;
        while (length < rest_.size() && isUnitLetter(rest_[length]) && !rest_.substr(length).starts_with("²") &&
               !rest_.substr(length).starts_with("³") && !rest_.substr(length).starts_with("·"))
            ++length;
        if (length == 0) length = 1;  // dimensionless 1
        if (rest_.substr(length).starts_with("'s")) length += 2;
        const std::string_view word = rest_.substr(0, length);
        // The one prefix whose case decides: mN and MN.
        if (word == "mn") {
            const bool isMilli = written_.substr(written_.size() - rest_.size()).starts_with("mN");
            rest_.remove_prefix(length);
            return isMilli ? std::optional(PhysicalUnit{1e-3, 0, 0, 1}) : std::nullopt;
        }
        for (const PhysicalUnitWord& known : physicalUnitWords)
            if (word == known.word) {
                rest_.remove_prefix(length);
                return known.unit;
            }
        return std::nullopt;
    }

    /// Exponent; 1 when none is written.
    std::optional<int> readExponent()
    {
        if (take("²")) return 2;
        if (take("³")) return 3;
        // "s-2": a sign and a digit directly behind the word.
        const bool isSigned = rest_.size() > 1 && rest_[0] == '-' && rest_[1] >= '1' && rest_[1] <= '4';
        const bool marked = !isSigned && (take("^") || take("**"));
        const bool negative = (marked || isSigned) && take("-");
        if (rest_.empty() || rest_.front() < '1' || rest_.front() > '4')
            return marked || negative ? std::nullopt : std::optional(1);
        const int exponent = rest_.front() - '0';
        rest_.remove_prefix(1);
        return negative ? -exponent : exponent;
    }

    std::string_view rest_, written_;
};

}  // namespace

std::optional<PhysicalUnit> physicalUnit(std::string_view text)
{
    text = trimmed(text);
    if (text.empty() || text.size() > longestUnit) return std::nullopt;
    const std::string lower = lowerCase(text);
    return UnitParser(lower, text).whole();
}

std::optional<FrfUnit> frfUnit(const PhysicalUnit& unit)
{
    if (unit.length != 1 || unit.force != -1) return std::nullopt;
    if (unit.time == 0) return FrfUnit{FrfQuantity::Receptance, unit.scale};
    if (unit.time == -1) return FrfUnit{FrfQuantity::Mobility, unit.scale};
    if (unit.time == -2) return FrfUnit{FrfQuantity::Accelerance, unit.scale};
    return std::nullopt;
}

std::optional<FrfUnit> frfUnit(std::string_view text)
{
    const auto unit = physicalUnit(text);
    return unit ? frfUnit(*unit) : std::nullopt;
}

std::optional<double> hzPerUnit(std::string_view text)
{
    const std::string word = lowerCase(trimmed(text));
    if (isUnstated(word) || word == "hz" || word == "1/s" || word == "(hz)") return 1;
    if (word == "khz") return 1e3;
    if (word == "rad/s" || word == "rad/sec") return 0.5 / std::numbers::pi;
    if (word == "rpm" || word == "1/min") return 1.0 / 60;
    return std::nullopt;
}

std::string quantityName(FrfQuantity quantity)
{
    if (quantity == FrfQuantity::Receptance) return "receptance";
    return quantity == FrfQuantity::Mobility ? "mobility" : "accelerance";
}

bool isUnstated(std::string_view text)
{
    return trimmed(text).empty() || lowerCase(trimmed(text)) == "none";
}

}  // namespace lathelier::io
