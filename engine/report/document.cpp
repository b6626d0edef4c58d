#include "engine/report/document.h"

namespace lathelier {

std::string captionText(const Caption& caption, const Language& language)
{
    if (const Text* phrase = std::get_if<Text>(&caption)) return text(*phrase, language);
    return std::get<std::string>(caption);
}

}  // namespace lathelier
