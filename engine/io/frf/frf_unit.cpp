#include "engine/io/frf/frf_unit.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "engine/io/text/number.h"
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

/// Which metric prefixes stand before a word: none, letters ("daN"), names ("kilonewton").
enum class Prefixes { None, Letters, Names };

struct PhysicalUnitWord {
    std::string_view word;  ///< ASCII letters in lower case
    PhysicalUnit unit;
    Prefixes prefixes = Prefixes::None;
};

constexpr PhysicalUnitWord physicalUnitWords[] = {
    {"m", {1e3, 1, 0, 0}, Prefixes::Letters},
    {"mm", {1, 1, 0, 0}},  // also in capitals
    {"metre", {1e3, 1, 0, 0}, Prefixes::Names},
    {"metres", {1e3, 1, 0, 0}, Prefixes::Names},
    {"meter", {1e3, 1, 0, 0}, Prefixes::Names},
    {"meters", {1e3, 1, 0, 0}, Prefixes::Names},
    {"micron", {1e-3, 1, 0, 0}},
    {"microns", {1e-3, 1, 0, 0}},
    {"in", {25.4, 1, 0, 0}},
    {"inch", {25.4, 1, 0, 0}, Prefixes::Names},
    {"inches", {25.4, 1, 0, 0}},
    {"uin", {25.4e-6, 1, 0, 0}},
    {"µin", {25.4e-6, 1, 0, 0}},
    {"μin", {25.4e-6, 1, 0, 0}},
    {"mil", {0.0254, 1, 0, 0}},
    {"mils", {0.0254, 1, 0, 0}},
    {"thou", {0.0254, 1, 0, 0}},
    {"ft", {304.8, 1, 0, 0}},
    {"foot", {304.8, 1, 0, 0}},
    {"feet", {304.8, 1, 0, 0}},
    {"s", {1, 0, 1, 0}, Prefixes::Letters},
    {"ms", {1e-3, 0, 1, 0}},
    {"sec", {1, 0, 1, 0}},
    {"second", {1, 0, 1, 0}, Prefixes::Names},
    {"seconds", {1, 0, 1, 0}, Prefixes::Names},
    {"n", {1, 0, 0, 1}, Prefixes::Letters},
    {"newton", {1, 0, 0, 1}, Prefixes::Names},
    {"newtons", {1, 0, 0, 1}, Prefixes::Names},
    {"dyn", {1e-5, 0, 0, 1}, Prefixes::Letters},
    {"dyne", {1e-5, 0, 0, 1}, Prefixes::Names},
    {"dynes", {1e-5, 0, 0, 1}, Prefixes::Names},
    {"gf", {kilogramForce_N * 1e-3, 0, 0, 1}, Prefixes::Letters},
    {"gramforce", {kilogramForce_N * 1e-3, 0, 0, 1}, Prefixes::Names},
    {"kp", {kilogramForce_N, 0, 0, 1}},
    {"pond", {kilogramForce_N * 1e-3, 0, 0, 1}, Prefixes::Names},
    {"tf", {kilogramForce_N * 1e3, 0, 0, 1}},
    {"lbf", {poundForce_N, 0, 0, 1}},
    {"lbfs", {poundForce_N, 0, 0, 1}},
    {"lb", {poundForce_N, 0, 0, 1}},
    {"lbs", {poundForce_N, 0, 0, 1}},
    {"pound", {poundForce_N, 0, 0, 1}},
    {"pounds", {poundForce_N, 0, 0, 1}},
    {"poundforce", {poundForce_N, 0, 0, 1}},
    {"poundsforce", {poundForce_N, 0, 0, 1}},
    {"kip", {poundForce_N * 1e3, 0, 0, 1}},
    {"kips", {poundForce_N * 1e3, 0, 0, 1}},
    {"klbf", {poundForce_N * 1e3, 0, 0, 1}},
    {"oz", {poundForce_N / 16, 0, 0, 1}},
    {"ozf", {poundForce_N / 16, 0, 0, 1}},
    {"ounceforce", {poundForce_N / 16, 0, 0, 1}},
    {"pdl", {poundal_N, 0, 0, 1}},
    {"poundal", {poundal_N, 0, 0, 1}},
    {"poundals", {poundal_N, 0, 0, 1}},
    {"kg", {1e-3, -1, 2, 1}},
    {"kilogram", {1e-3, -1, 2, 1}},
    {"kilograms", {1e-3, -1, 2, 1}},
    {"gram", {1e-6, -1, 2, 1}},
    {"grams", {1e-6, -1, 2, 1}},
    {"tonne", {1, -1, 2, 1}},
    {"lbm", {0.45359237e-3, -1, 2, 1}},
    {"slug", {poundForce_N / 304.8, -1, 2, 1}},
    {"slugs", {poundForce_N / 304.8, -1, 2, 1}},
    {"slinch", {poundForce_N / 25.4, -1, 2, 1}},
    {"blob", {poundForce_N / 25.4, -1, 2, 1}},
    {"g", {freeFall_mm_s2, 1, -2, 0}},
    {"gn", {freeFall_mm_s2, 1, -2, 0}},
    {"g0", {freeFall_mm_s2, 1, -2, 0}},
    {"g's", {freeFall_mm_s2, 1, -2, 0}},
    {"g’s", {freeFall_mm_s2, 1, -2, 0}},
    {"gs", {freeFall_mm_s2, 1, -2, 0}},
    {"gal", {10, 1, -2, 0}},
    {"1", {1, 0, 0, 0}},
};

struct MetricPrefix {
    std::string_view letters, name;
    double factor;
};

/// Mega as a letter is none: in capitals MN may be meant as mN.
constexpr MetricPrefix metricPrefixes[] = {
    {"da", "deca", 10},   {"", "deka", 10},     {"p", "pico", 1e-12}, {"n", "nano", 1e-9},  {"u", "micro", 1e-6},
    {"µ", "micro", 1e-6}, {"μ", "micro", 1e-6}, {"m", "milli", 1e-3}, {"c", "centi", 0.01}, {"d", "deci", 0.1},
    {"h", "hecto", 100},  {"k", "kilo", 1e3},   {"", "mega", 1e6},    {"", "giga", 1e9},
};

/// A whole word, without the hyphen of "pound-force"; `written` as it stands in the file.
std::optional<PhysicalUnit> knownWord(std::string_view word, std::string_view written)
{
    for (const PhysicalUnitWord& known : physicalUnitWords)
        if (word == known.word) return known.unit;
    for (const MetricPrefix& prefix : metricPrefixes)
        for (const Prefixes kind : {Prefixes::Letters, Prefixes::Names}) {
            const std::string_view begin = kind == Prefixes::Letters ? prefix.letters : prefix.name;
            if (begin.empty() || !word.starts_with(begin)) continue;
            for (const PhysicalUnitWord& known : physicalUnitWords) {
                if (known.prefixes != kind || word.substr(begin.size()) != known.word) continue;
                // The prefixes whose case decides: mN and MN, nm and Nm.
                if (begin == "m" && known.word == "n" && !written.starts_with("mN")) continue;
                if (begin == "m" && !written.starts_with('m')) continue;
                if (begin == "n" && known.word == "m" && !written.starts_with('n')) continue;
                PhysicalUnit unit = known.unit;
                unit.scale *= prefix.factor;
                return unit;
            }
        }
    return std::nullopt;
}

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
            if (!divides && !take("**") && !take("*") && !take("·") && !take("⋅") && !take(".")) take("");
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
            const auto exponent = unit ? readExponent() : std::nullopt;
            return exponent ? std::optional(power(*unit, *exponent)) : std::nullopt;
        }
        const std::size_t length = wordLength();
        const std::string_view word = rest_.substr(0, length);
        const std::string_view written = written_.substr(written_.size() - rest_.size(), length);
        rest_.remove_prefix(length);
        const auto exponent = readExponent();
        if (!exponent) return std::nullopt;
        // "ms-2" is metres per second squared in all who write so, never a millisecond.
        if ((*exponent == -1 || *exponent == -2) && word.ends_with('s'))
            if (unit = knownWord(word.substr(0, length - 1), written); unit && isLength(*unit))
                return product(*unit, {1, 0, *exponent, 0});
        std::string joined(word);
        std::erase(joined, '-');
        unit = knownWord(joined, written);
        return unit ? std::optional(power(*unit, *exponent)) : std::nullopt;
    }

    static bool isLength(const PhysicalUnit& unit) { return unit.length == 1 && unit.time == 0 && unit.force == 0; }

    /// Length of the word that begins the rest.
    std::size_t wordLength()
    {
        take("");
        const auto letters = [this](std::size_t from) {
            std::size_t at = from;
            const auto endsAt = [this, &at](std::string_view mark) { return rest_.substr(at).starts_with(mark); };
            while (at < rest_.size() && isUnitLetter(rest_[at]) && !endsAt("²") && !endsAt("³") && !endsAt("¹") &&
                   !endsAt("⁻") && !endsAt("·") && !endsAt("⋅"))
                ++at;
            return at;
        };
        std::size_t length = letters(0);
        if (length == 0) return std::min<std::size_t>(rest_.size(), 1);  // dimensionless 1
        if (rest_.substr(length).starts_with("-f")) length = letters(length + 1);
        if (rest_.substr(length).starts_with("'s")) length += 2;
        if (rest_.substr(0, length) == "g" && rest_.substr(length).starts_with("0")) ++length;
        return length;
    }

    /// Exponent; 1 when none is written.
    std::optional<int> readExponent()
    {
        if (take("⁻²")) return -2;
        if (take("⁻¹")) return -1;
        if (take("¹")) return 1;
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
    constexpr double perRadian = 0.5 / std::numbers::pi;
    constexpr std::pair<std::string_view, double> words[] = {{"hz", 1},
                                                             {"hertz", 1},
                                                             {"1/s", 1},
                                                             {"cps", 1},
                                                             {"khz", 1e3},
                                                             {"rpm", 1.0 / 60},
                                                             {"1/min", 1.0 / 60},
                                                             {"cpm", 1.0 / 60},
                                                             {"rad/s", perRadian},
                                                             {"rad/sec", perRadian},
                                                             {"rads/s", perRadian},
                                                             {"rads/sec", perRadian},
                                                             {"rads", perRadian},
                                                             {"radps", perRadian},
                                                             {"radian/s", perRadian},
                                                             {"radians/s", perRadian},
                                                             {"rad/per/s", perRadian},
                                                             {"rad s-1", perRadian},
                                                             {"rad s^-1", perRadian},
                                                             {"rad*s^-1", perRadian},
                                                             {"rad·s⁻¹", perRadian},
                                                             {"rad s⁻¹", perRadian},
                                                             {"krad/s", 1e3 * perRadian}};
    std::string_view bare = trimmed(text);
    if (bare.size() > 2 && ((bare.front() == '(' && bare.back() == ')') || (bare.front() == '[' && bare.back() == ']')))
        bare = trimmed(bare.substr(1, bare.size() - 2));
    if (isUnstated(bare)) return 1;
    const std::string word = lowerCase(bare);
    for (const auto& [known, hz] : words)
        if (word == known) return hz;
    return std::nullopt;
}

std::optional<DecibelUnit> decibelUnit(std::string_view text)
{
    const auto skip = [&text](std::string_view marks) {
        while (!text.empty() && marks.find(text.front()) != std::string_view::npos) text.remove_prefix(1);
    };
    text = trimmed(text);
    if (lowerCase(text.substr(0, 2)) != "db") return std::nullopt;
    text.remove_prefix(2);
    const bool is_separated = text.empty() || std::string_view(" _/:,([").find(text.front()) != std::string_view::npos;
    if (!is_separated) return std::nullopt;
    skip(" _/:,([");
    for (const std::string_view word : {"ref.", "ref", "rel.", "rel", "re.", "re"})
        if (lowerCase(text.substr(0, word.size())) == word) {
            text.remove_prefix(word.size());
            break;
        }
    skip(" _/:,");
    DecibelUnit unit;
    if (const char* const end = parseNumber(text.data(), text.data() + text.size(), '.', unit.reference)) {
        text.remove_prefix(static_cast<std::size_t>(end - text.data()));
        skip(" _/*·");
    }
    if (!(unit.reference > 0) || !std::isfinite(unit.reference)) return std::nullopt;
    const auto count = [&text](char mark) { return std::count(text.begin(), text.end(), mark); };
    while (!text.empty() &&
           ((text.back() == ')' && count(')') > count('(')) || (text.back() == ']' && count(']') > count('['))))
        text.remove_suffix(1);
    unit.unit = trimmed(text);
    return unit;
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
