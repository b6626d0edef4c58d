#include "engine/report/document.h"

#include "engine/core/visible.h"

namespace lathelier {

std::string captionText(const Caption& caption, const Language& language)
{
    if (const Text* phrase = std::get_if<Text>(&caption)) return text(*phrase, language);
    return visible(std::get<std::string>(caption));
}

}  // namespace lathelier
