#include "engine/report/document.h"

#include "engine/core/visible.h"

namespace lathelier::report {

std::string captionText(const Caption& caption, const Language& language)
{
    if (const Text* phrase = std::get_if<Text>(&caption)) return text(*phrase, language);
    if (const Labelled* heading = std::get_if<Labelled>(&caption)) {
        const Text* const phrase = std::get_if<Text>(&heading->label);
        const std::string label = phrase ? text(*phrase, language) : visible(std::get<std::string>(heading->label));
        return heading->unit.empty() ? label
                                     : label + " (" + text(shownUnit(heading->unit, language).unit, language) + ")";
    }
    return visible(std::get<std::string>(caption));
}

}  // namespace lathelier::report
