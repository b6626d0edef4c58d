#include "engine/report/document.h"

#include "engine/core/visible.h"

namespace lathelier::report {

std::string captionText(const Caption& caption, const Language& language)
{
    if (const Text* phrase = std::get_if<Text>(&caption)) return text(*phrase, language);
    if (const Labelled* heading = std::get_if<Labelled>(&caption)) {
        const std::string label = heading->name.empty() ? text(heading->label, language) : visible(heading->name);
        return heading->unit.empty() ? label
                                     : label + " (" + text(shownUnit(heading->unit, language).unit, language) + ")";
    }
    return visible(std::get<std::string>(caption));
}

}  // namespace lathelier::report
