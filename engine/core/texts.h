// Errors, notes and texts as sentences: one table of English patterns, shared by command line, report and GUI.
#pragma once

#include <functional>
#include <string>

#include "engine/core/error.h"
#include "engine/core/text.h"
#include "engine/core/value.h"

namespace lathelier {

/// The engine's units of length.
inline constexpr Text millimetre = LT_TEXT("Engine", "mm");
inline constexpr Text micrometre = LT_TEXT("Engine", "µm");

/// A unit of presentation for values that the engine gives in another.
struct ShownUnit {
    Text unit;              ///< "in"; empty: that of the engine
    double factor = 1;      ///< shown value = value of the engine × factor
    int more_decimals = 0;  ///< additional decimals, to keep the resolution
    friend bool operator==(const ShownUnit&, const ShownUnit&) = default;
};

/// Language of texts: translation of English literals, format of numbers, units of length. Default: English, decimal
/// point, the engine's units.
struct Language {
    std::function<std::string(const char* english)> translate = {};  ///< empty: as it is
    std::function<std::string(double)> number = {};                  ///< empty: 6 significant digits, decimal point
    std::function<std::string(double, int decimals)> fixed = {};     ///< empty: decimal point
    ShownUnit lengths = {};                                          ///< of what the engine gives in mm
    ShownUnit deviations_of_form = {};                               ///< of what the engine gives in µm
};

/// The unit in which `unit` is shown: another for "mm" and "µm" where the language has one, else itself.
ShownUnit shownUnit(Text unit, const Language& language);

/// `value`, which the engine gives in `unit`, with `decimals` places of it, as it is shown, without the unit. Empty
/// when it does not exist.
std::string shownNumber(double value, Text unit, int decimals, const Language& language = {});

/// The numbers of `value` (one, a list, ranges) in the unit shown, to 5 digits where that is another; else as it is.
Value shownValue(const Value& value, Text unit, const Language& language);

/// The same language with the engine's units: for files.
Language inEngineUnits(Language language);

std::string text(Text english, const Language& language = {});

/// "shaft.xyz, line 12, column 4: Found “abc”, expected a number."
std::string text(const Error& error, const Language& language = {});

std::string text(const Note& note, const Language& language = {});

/// One value alone: "auto", "0.05", "10:20, 30:40"; empty for "not given".
std::string text(const Value& value, const Language& language = {});

/// A number with so many decimals; empty when it does not exist (NaN, infinity), and never "-0.000".
std::string fixed(double value, int decimals, const Language& language = {});

/// Replaces each {name} in `pattern` (already translated) by the value of that name; unknown names stay visible.
/// An empty value takes the blank before it away. {name:3} has 3 decimals, {name:3+} more for a small value, {name:+3}
/// the sign of a positive number too. Numbers whose name ends in _mm or _um are shown in the units of the language; the
/// words "mm" and "µm" of such a pattern follow.
std::string fill(const std::string& pattern, const Values& values, const Language& language = {});

}  // namespace lathelier
