#include "engine/io/frf/frf_columns.h"

#include <algorithm>
#include <numbers>

#include "engine/core/core_codes.h"
#include "engine/io/table/column_names.h"
#include "engine/io/text/quantity.h"
#include "engine/io/text/text_lines.h"

namespace lathelier::io {
namespace {

struct RoleWord {
    std::string_view word;
    FrfRole role;
};

constexpr RoleWord roleWords[] = {{"frequency", FrfRole::Frequency}, {"freq", FrfRole::Frequency},
                                  {"f", FrfRole::Frequency},         {"hz", FrfRole::Frequency},
                                  {"omega", FrfRole::Frequency},     {"om", FrfRole::Frequency},
                                  {"w", FrfRole::Frequency},         {"ω", FrfRole::Frequency},
                                  {"real", FrfRole::Real},           {"re", FrfRole::Real},
                                  {"imag", FrfRole::Imaginary},      {"imaginary", FrfRole::Imaginary},
                                  {"im", FrfRole::Imaginary},        {"magnitude", FrfRole::Magnitude},
                                  {"mag", FrfRole::Magnitude},       {"abs", FrfRole::Magnitude},
                                  {"amplitude", FrfRole::Magnitude}, {"db", FrfRole::Magnitude},
                                  {"phase", FrfRole::Phase},         {"angle", FrfRole::Phase},
                                  {"arg", FrfRole::Phase},           {"coherence", FrfRole::Coherence},
                                  {"coh", FrfRole::Coherence},       {"gamma", FrfRole::Coherence},
                                  {"γ", FrfRole::Coherence}};

bool isHeadingLetter(char c)
{
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || static_cast<unsigned char>(c) >= 0x80;
}

/// Where "dB" stands as a word; npos: nowhere.
std::size_t decibelAt(const std::string& lower)
{
    for (std::size_t at = lower.find("db"); at != std::string::npos; at = lower.find("db", at + 1)) {
        const bool begins = at == 0 || !isHeadingLetter(lower[at - 1]);
        const bool ends = at + 2 == lower.size() || !isHeadingLetter(lower[at + 2]);
        if (begins && ends) return at;
    }
    return std::string::npos;
}

/// What stands behind the word of a heading, without the marks around it.
std::string unitBehind(std::string_view rest)
{
    const std::size_t open = rest.find_last_of("[(");
    // "(m/s)/N" is a unit as a whole; "(H) [m/N]" ends with one.
    if (open != std::string_view::npos && (open > 0 || rest.back() == ')' || rest.back() == ']'))
        if (const std::size_t close = rest.find_first_of("])", open); close + 1 == rest.size())
            rest = rest.substr(open + 1, close - open - 1);
    while (!rest.empty() && std::string_view("_ ,:/-").find(rest.front()) != std::string_view::npos)
        rest.remove_prefix(1);
    std::string unit(rest);
    std::replace(unit.begin(), unit.end(), '_', '/');
    return unit;
}

bool isAngularColumn(const TableColumn& column)
{
    return parseFrfHeading(column.heading).is_angular;
}

std::optional<std::size_t> frfColumn(const TableLayout& layout, FrfRole role)
{
    std::vector<std::size_t> found;
    for (std::size_t k = 0; k < layout.columns.size(); ++k)
        if (layout.columns[k].is_number && parseFrfHeading(layout.columns[k].heading).role == role) found.push_back(k);
    // The same lines may be stated in rad/s as well.
    if (role == FrfRole::Frequency && found.size() > 1)
        std::erase_if(found, [&layout](std::size_t k) { return isAngularColumn(layout.columns[k]); });
    if (found.size() > 1) throwAmbiguous(layout, found, LT_TEXT("Engine", "a column of a frequency response"));
    return found.empty() ? std::nullopt : std::optional(found.front());
}

std::optional<FrfColumns> byHeadings(const TableLayout& layout)
{
    if (!layout.has_names) return std::nullopt;
    const auto frequency = frfColumn(layout, FrfRole::Frequency);
    if (!frequency) return std::nullopt;
    FrfColumns columns;
    auto first = frfColumn(layout, FrfRole::Real), second = frfColumn(layout, FrfRole::Imaginary);
    if (!(first && second)) {
        first = frfColumn(layout, FrfRole::Magnitude);
        second = frfColumn(layout, FrfRole::Phase);
        if (!(first && second)) return std::nullopt;
        const bool is_level = decibelUnit(unitWord(layout.columns[*first])).has_value();
        columns.form = is_level ? FrfColumns::Form::Level : FrfColumns::Form::Polar;
    }
    columns.frequency = *frequency;
    columns.first = *first;
    columns.second = *second;
    columns.coherence = frfColumn(layout, FrfRole::Coherence);
    return columns;
}

[[noreturn]] void throwRolesUnknown(const std::string& stated)
{
    throw Error(errors::valueNotUnderstood,
                {{"parameter", "frf_columns"},
                 {"found", stated},
                 {"expected", LT_TEXT("Engine",
                                      "frequency with real,imag, with complex, or with magnitude or magnitude_db and "
                                      "phase (degrees) or phase_rad; coherence; skip for others")}});
}

/// Places of the roles; empty where one is not stated.
struct StatedColumns {
    std::optional<std::size_t> frequency, real, imaginary, magnitude, level, phase, phase_rad, coherence;
    std::size_t count = 0;  ///< columns of numbers
};

StatedColumns placesOf(const std::string& stated)
{
    StatedColumns places;
    std::size_t begin = 0;
    const auto put = [&places, &stated](std::optional<std::size_t>& place) {
        if (place) throwRolesUnknown(stated);
        place = places.count++;
    };
    while (begin <= stated.size()) {
        const std::size_t end = std::min(stated.find(',', begin), stated.size());
        const std::string word = lowerCase(trimmed(std::string_view(stated).substr(begin, end - begin)));
        begin = end + 1;
        if (word == "frequency" || word == "f") {
            put(places.frequency);
        } else if (word == "real") {
            put(places.real);
        } else if (word == "imag") {
            put(places.imaginary);
        } else if (word == "complex") {  // its two numbers stand apart by now
            put(places.real);
            put(places.imaginary);
        } else if (word == "magnitude") {
            put(places.magnitude);
        } else if (word == "magnitude_db") {
            put(places.level);
        } else if (word == "phase" || word == "phase_deg") {
            put(places.phase);
        } else if (word == "phase_rad") {
            put(places.phase_rad);
        } else if (word == "coherence") {
            put(places.coherence);
        } else if (word == "skip") {
            ++places.count;
        } else {
            throwRolesUnknown(stated);
        }
    }
    return places;
}

std::optional<FrfColumns> byStatement(const TableLayout& layout, const std::string& stated)
{
    const StatedColumns places = placesOf(stated);
    const bool are_parts =
        places.real && places.imaginary && !places.magnitude && !places.level && !places.phase && !places.phase_rad;
    const bool is_polar = places.magnitude.has_value() != places.level.has_value() && !places.real &&
                          !places.imaginary && places.phase.has_value() != places.phase_rad.has_value();
    if (!places.frequency || !(are_parts || is_polar)) throwRolesUnknown(stated);
    FrfColumns columns;
    columns.frequency = *places.frequency;
    columns.coherence = places.coherence;
    if (are_parts) {
        columns.first = *places.real;
        columns.second = *places.imaginary;
    } else {
        columns.form = places.level ? FrfColumns::Form::Level : FrfColumns::Form::Polar;
        columns.first = places.level ? *places.level : *places.magnitude;
        columns.second = places.phase ? *places.phase : *places.phase_rad;
        columns.phase_rad = places.phase ? std::numbers::pi / 180 : 1;
    }
    for (const std::size_t k : columns.all())
        if (k >= layout.columns.size() || !layout.columns[k].is_number) return std::nullopt;
    return columns;
}

}  // namespace

bool isAngularName(std::string_view name)
{
    const std::string lower = lowerCase(trimmed(name));
    const std::string word = lower.substr(0, lower.find('_'));
    return isOneOf(word, {"w", "om", "omega", "ω"});
}

FrfHeading parseFrfHeading(std::string_view heading)
{
    heading = trimmed(heading);
    std::size_t end = 0;
    while (end < heading.size() && isHeadingLetter(heading[end])) ++end;
    FrfHeading found;
    const std::string word = lowerCase(heading.substr(0, end));
    for (const RoleWord& known : roleWords)
        if (word == known.word) found.role = known.role;
    found.is_angular = found.role == FrfRole::Frequency && isAngularName(word);
    if (const std::size_t at = decibelAt(lowerCase(heading)); at != std::string::npos) {
        found.unit = heading.substr(at);
        std::replace(found.unit.begin(), found.unit.end(), '_', '/');
    } else {
        found.unit = unitBehind(heading.substr(end));
    }
    return found;
}

TableExpectation frfExpectation()
{
    TableExpectation expectation;
    expectation.minimum_columns = 3;
    expectation.knows_name = [](const std::string& name) { return parseFrfHeading(name).role != FrfRole::Other; };
    expectation.knows_unit = [](std::string_view word) {
        return frfUnit(word) || (!isUnstated(word) && hzPerUnit(word)) || quantityUnit(word) || decibelUnit(word);
    };
    return expectation;
}

std::vector<std::size_t> FrfColumns::all() const
{
    std::vector<std::size_t> indices{frequency, first, second};
    if (coherence) indices.push_back(*coherence);
    return indices;
}

std::optional<FrfColumns> findFrfColumns(const TableLayout& layout, const std::string& stated)
{
    return stated.empty() ? byHeadings(layout) : byStatement(layout, stated);
}

std::string unitWord(const TableColumn& column)
{
    std::string unit = parseFrfHeading(column.heading).unit;
    std::string below(trimmed(column.unit_text));
    if (unit.empty()) return below;
    // "dB" over "dB re 1 m/N", or over "m/N"
    const auto level = decibelUnit(unit);
    if (!level || !level->unit.empty() || isUnstated(below)) return unit;
    if (!decibelUnit(below)) below.insert(0, unit + " re 1 ");
    return below;
}

}  // namespace lathelier::io
