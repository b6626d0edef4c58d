// Labels of a report and of its charts.
#pragma once

#include <string>
#include <variant>

#include "engine/core/text.h"
#include "engine/core/texts.h"

namespace lathelier::report {

/// The heading of a column of numbers.
struct Labelled {
    Text label;
    Text unit;              ///< in brackets behind it; empty: none
    std::string name = {};  ///< replaces the label when it is the same in every language
    friend bool operator==(const Labelled&, const Labelled&) = default;
};

/// A label of the report: a translatable literal, or a name that is the same in every language (a path).
using Caption = std::variant<Text, std::string, Labelled>;

std::string captionText(const Caption& caption, const Language& language = {});

}  // namespace lathelier::report
