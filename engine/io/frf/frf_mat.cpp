#include "engine/io/frf/frf_mat.h"

#include <algorithm>
#include <cmath>

#include "engine/io/frf/frf_codes.h"
#include "engine/io/frf/frf_columns.h"
#include "engine/io/frf/frf_lines.h"
#include "engine/io/text/text_lines.h"
#include "engine/io/text/units.h"

namespace lathelier::io {
namespace {

/// The two variables of a response.
struct Pair {
    const MatVariable* frequency = nullptr;
    const MatVariable* response = nullptr;
};

std::string variableNames(const std::vector<MatVariable>& variables)
{
    std::string names;
    for (const MatVariable& variable : variables) {
        if (names.size() > 200) return names + ", …";
        names += (names.empty() ? "" : ", ") + variable.name + (variable.is_complex ? " (complex)" : "");
    }
    return names.empty() ? "-" : names;
}

Error unknown(const std::vector<MatVariable>& variables, Text expected)
{
    return Error(errors::frfVariablesUnknown,
                 {{"byte", std::int64_t{0}}, {"found", variableNames(variables)}, {"expected", expected}});
}

bool isVector(const MatVariable& variable)
{
    return variable.is_number && (variable.rows == 1 || variable.columns == 1) && variable.count() > 0;
}

/// What the name of a variable says of frequencies.
struct FrequencyName {
    bool is_frequency = false;
    bool is_angular = false;   ///< "w", "om", "omega_axis"
    std::optional<double> hz;  ///< per unit, where the name states one: "lines_hz", "omega_rad_s"
};

FrequencyName frequencyName(const std::string& name)
{
    FrequencyName found;
    const std::string lower = lowerCase(name);
    for (std::size_t at = 0; at != std::string::npos && !found.hz; at = lower.find('_', at + 1)) {
        std::string unit = lower.substr(at == 0 ? 0 : at + 1);
        std::replace(unit.begin(), unit.end(), '_', '/');
        if (unit.ends_with("hz") || unit.starts_with("rad") || unit == "krad/s") found.hz = hzPerUnit(unit);
    }
    found.is_angular = isAngularName(lower);
    found.is_frequency = found.is_angular || found.hz || isOneOf(lower, {"f", "freq", "frequency"});
    return found;
}

bool isFrequency(const MatVariable& variable)
{
    return isVector(variable) && !variable.is_complex && frequencyName(variable.name).is_frequency;
}

/// The one vector of frequencies. One named as an angular frequency counts where there is no other.
const MatVariable& findFrequency(const std::vector<MatVariable>& variables)
{
    for (const bool is_angular : {false, true}) {
        const MatVariable* found = nullptr;
        for (const MatVariable& variable : variables) {
            if (!isFrequency(variable) || frequencyName(variable.name).is_angular != is_angular) continue;
            if (found) throw unknown(variables, LT_TEXT("Engine", "one vector of frequencies"));
            found = &variable;
        }
        if (found) return *found;
    }
    throw unknown(variables, LT_TEXT("Engine", "a real vector f, freq, frequency, omega or one that ends with _hz"));
}

/// Hz per unit of the frequencies: as the name states, else as given; else Hz, but for an angular frequency.
double hzOf(const MatVariable& frequency, const FrfOptions& options, Notes& notes)
{
    const FrequencyName name = frequencyName(frequency.name);
    const auto given = hzPerUnit(options.frequency_unit);
    if (name.hz && given && *name.hz != *given)
        notes.push_back({notes::frfUnitNotUsed,
                         {{"unit", frequency.name},
                          {"given", frequencyUnitKey(options.frequency_unit)},
                          {"count", std::int64_t{1}},
                          {"line", std::int64_t{1}}}});
    if (name.hz) return *name.hz;
    if (given) return *given;
    if (name.is_angular)
        throw Error(errors::frequencyUnitMissing, {{"byte", frequency.byte}, {"found", frequency.name}});
    return 1;
}

/// "f=NAME,H=NAME".
std::pair<std::string, std::string> parseNames(const std::string& text, const std::vector<MatVariable>& variables)
{
    constexpr Text expected = LT_TEXT("Engine", "f=NAME,H=NAME");
    const std::size_t comma = text.find(',');
    if (comma == std::string::npos) throw unknown(variables, expected);
    std::pair<std::string, std::string> names;
    for (const std::string& part : {text.substr(0, comma), text.substr(comma + 1)}) {
        const std::size_t mark = part.find('=');
        if (mark == std::string::npos) throw unknown(variables, expected);
        const std::string_view key = trimmed(std::string_view(part).substr(0, mark));
        const std::string name(trimmed(std::string_view(part).substr(mark + 1)));
        if (key == "f")
            names.first = name;
        else if (key == "H")
            names.second = name;
    }
    if (names.first.empty() || names.second.empty()) throw unknown(variables, expected);
    return names;
}

Pair findNamed(const std::vector<MatVariable>& variables, const std::string& text)
{
    const auto [f, h] = parseNames(text, variables);
    Pair pair;
    for (const MatVariable& variable : variables) {
        if (variable.name == f) pair.frequency = &variable;
        if (variable.name == h) pair.response = &variable;
    }
    if (!pair.frequency || !isVector(*pair.frequency) || pair.frequency->is_complex)
        throw unknown(variables, LT_TEXT("Engine", "a real vector of frequencies of the given name"));
    if (!pair.response || !pair.response->is_number || pair.response->count() != pair.frequency->count())
        throw unknown(variables, LT_TEXT("Engine", "an array of the given name, as long as the frequencies"));
    return pair;
}

Pair findPair(const std::vector<MatVariable>& variables, const FrfOptions& options)
{
    if (!options.variables.empty()) return findNamed(variables, options.variables);
    Pair pair;
    pair.frequency = &findFrequency(variables);
    for (const MatVariable& variable : variables)
        if (variable.is_number && variable.is_complex && variable.count() == pair.frequency->count()) {
            if (pair.response) throw unknown(variables, LT_TEXT("Engine", "one complex array as long as frequencies"));
            pair.response = &variable;
        }
    if (!pair.response) throw unknown(variables, LT_TEXT("Engine", "one complex array as long as frequencies"));
    return pair;
}

}  // namespace

FileFacts matFacts(const std::string& name, const std::vector<MatVariable>& variables)
{
    FileFacts facts;
    facts.path = name;
    facts.format = "MAT";
    Rows rows;
    for (const MatVariable& variable : variables)
        rows.rows.push_back({{{"name", variable.name},
                              {"rows", variable.rows},
                              {"columns", variable.columns},
                              {"class", variable.class_name},
                              {"complex", variable.is_complex}}});
    set(facts.details, "variables", std::move(rows));
    return facts;
}

FrfFile readFrfMat(const std::string& name, std::string_view bytes, const FrfOptions& options, const Progress& progress)
{
    const std::vector<MatVariable> variables = readMatVariables(bytes, progress);
    const Pair pair = findPair(variables, options);
    const auto unit = frfUnit(options.frf_unit);
    if (!unit)
        throw Error(errors::frfUnitMissing, {{"byte", pair.response->byte},
                                             {"found", pair.response->name},
                                             {"expected", LT_TEXT("Engine", "a unit; a MAT file states none")}});
    FrfFile file;
    const double hz = hzOf(*pair.frequency, options, file.notes);
    MeasuredFrf measured;
    measured.frf.name = pair.response->name;
    measured.frf.quantity = unit->quantity;
    for (const std::complex<double>& f : readMatValues(bytes, *pair.frequency))
        measured.frf.frequency_hz.push_back(f.real() * hz);
    measured.frf.value = readMatValues(bytes, *pair.response);
    for (std::complex<double>& value : measured.frf.value) value *= unit->scale;
    file.facts = matFacts(name, variables);
    file.facts.unit = frfUnitKey(options.frf_unit);
    file.facts.unit_source = "given";
    file.facts.rows = pair.frequency->count();
    const std::int64_t dropped = dropUnusableLines(measured.frf);
    if (dropped > 0)
        file.notes.push_back(
            {notes::frfLinesDropped, {{"lines", dropped}, {"count", std::int64_t{1}}, {"line", std::int64_t{1}}}});
    try {
        requireAscending(measured.frf);
    } catch (Error& error) {
        throw error.with("byte", pair.frequency->byte);
    }
    file.frfs.push_back(std::move(measured));
    return file;
}

}  // namespace lathelier::io
