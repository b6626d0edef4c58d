// Errors, notes and texts as sentences: one table of English patterns, shared by command line, report and GUI.
#pragma once

#include <functional>
#include <string>

#include "engine/core/error.h"
#include "engine/core/text.h"
#include "engine/core/value.h"

namespace lathelier {

/// How to speak: a translation of English literals and the look of numbers. Default: English, decimal point.
struct Language {
    std::function<std::string(const char* english)> translate;  ///< empty: as it is
    std::function<std::string(double)> number;                  ///< empty: 6 significant digits, decimal point
    std::function<std::string(double, int decimals)> fixed;     ///< empty: decimal point
};

std::string text(Text english, const Language& language = {});

/// "shaft.xyz, line 12, column 4: Found “abc”, expected a number."
std::string text(const Error& error, const Language& language = {});

std::string text(const Note& note, const Language& language = {});

/// One value alone: "auto", "0.05", "10:20, 30:40"; empty for "not given".
std::string text(const Value& value, const Language& language = {});

/// A number with so many decimals; empty when it does not exist (NaN, infinity), and never "-0.000".
std::string fixed(double value, int decimals, const Language& language = {});

/// Replaces each {name} in `pattern` (already translated) by the value of that name; unknown names stay visible.
/// An empty value takes the blank before it away.
std::string fill(const std::string& pattern, const Values& values, const Language& language = {});

}  // namespace lathelier
