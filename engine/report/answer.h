// The answer of a panel as a value: the verdict, the number with its uncertainty against its limits, one sentence, and
// findings with their places. Screen, report and command line share it. Source: ISO 14253-1 (conformity), JCGM 100
// (expanded uncertainty, k = 2).
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "engine/core/conformity.h"
#include "engine/core/texts.h"
#include "engine/core/used_value.h"
#include "engine/core/value.h"
#include "engine/report/caption.h"

namespace lathelier::report {

/// A place of the part, as far as known; views mark it.
struct Place {
    std::optional<Interval> z_mm;           ///< along the axis, in the coordinate of the panel's views
    std::optional<double> angle_deg;        ///< about the axis, 0…360
    std::optional<int> upr;                 ///< undulations per revolution
    std::optional<std::int64_t> line = {};  ///< line of a program, from 1

    bool isAny() const { return z_mm || angle_deg || upr || line; }  ///< at least one coordinate is known
    friend bool operator==(const Place&, const Place&) = default;
};

/// A notable result with its place. A pattern with named values, as in notes.
struct Finding {
    Text pattern;                    ///< "Step {value} mm ± {uncertainty}, limit {limit} · z {from}-{to}"
    Values values;                   ///< values named in braces in the pattern
    std::optional<Verdict> verdict;  ///< against its limit; none: no limit
    Place place;                     ///< marked in the views
    Values offer{};                  ///< proposed parameters by key; empty: no proposal
};

struct Answer {
    Caption quantity;                            ///< evaluated quantity: "RONt(MZCI)"
    std::string subject;                         ///< part of the data: "section 7 of 20"; empty: all
    std::optional<double> value;                 ///< in `unit`; none: no single number
    std::optional<double> expanded_uncertainty;  ///< k = 2 or 95 %, in `unit`; none: not known
    Text unit;                                   ///< of value, uncertainty and limits
    bool is_signed = false;                      ///< true for a deviation: "+" is written
    int decimals = 3;                            ///< of value and uncertainty
    std::optional<double> lower_limit;           ///< none: only one side is limited
    std::optional<double> upper_limit;           ///< none: no limit was given
    std::optional<Verdict> verdict;              ///< nullopt: no limit was given
    Text verdict_words;             ///< replaces the standard wording of the verdict; empty: standard wording
    Text sentence;                  ///< one sentence, as a pattern; empty: none
    Values values;                  ///< values named in braces in the sentence
    std::vector<Finding> findings;  ///< at most three, the most important first
    UsedValues used;                ///< values of optional parameters with their origin
};

/// "RONt(MZCI) 15.30 ± 0.21 µm"; without a value the quantity alone.
std::string valueLine(const Answer& answer, const Language& language = {});

/// "0.050 ± 0.012 mm", "+0.049 mm"; empty without a value.
std::string valueText(const Answer& answer, const Language& language = {});

/// "limit 15 µm", "limits -0.080 … +0.080 mm", "no limit given".
std::string limitText(const Answer& answer, const Language& language = {});

/// "✓ within tolerance", "✗ out of tolerance", "? cannot be decided", "no limit given".
std::string verdictText(const Answer& answer, const Language& language = {});

/// "assumed: Sensitivity 50 µm/V, …"; empty when nothing is.
std::string assumedText(const Answer& answer, const Language& language = {});

std::string sentenceText(const Answer& answer, const Language& language = {});
std::string findingText(const Finding& finding, const Language& language = {});  ///< the finding as text, without its
                                                                                 ///< verdict

/// The answer as plain text: value and verdict, the sentence, a line for each finding, assumed values.
std::string plainText(const Answer& answer, const Language& language = {});

}  // namespace lathelier::report
