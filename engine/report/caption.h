// The words of a report and of its charts.
#pragma once

#include <string>
#include <variant>

#include "engine/core/text.h"
#include "engine/core/texts.h"

namespace lathelier {

/// A label of the report: a translatable literal, or a name that is the same in every language (a path).
using Caption = std::variant<Text, std::string>;

std::string captionText(const Caption& caption, const Language& language = {});

}  // namespace lathelier
