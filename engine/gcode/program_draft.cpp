#include "engine/gcode/program_draft.h"

#include <algorithm>
#include <filesystem>

#include "engine/core/utf8.h"

namespace lathelier::gcode {

const std::vector<Field<ProgramDraft>>& fieldsOf(const ProgramDraft*)
{
    using D = ProgramDraft;
    static const auto all = described<D>(
        field("path", &D::path,
              Label{LT_TEXT("Engine", "File"), LT_TEXT("Engine", "That was changed."), {}, false, true}),
        field("sha256", &D::sha256,
              Label{LT_TEXT("Engine", "Digest"), LT_TEXT("Engine", "Of the file as it was read."), {}, false, true}),
        field("text", &D::text,
              Label{LT_TEXT("Engine", "Program"), LT_TEXT("Engine", "As changed."), {}, false, true}));
    return all;
}

bool isOf(const ProgramDraft& draft, const std::string& path, const std::string& sha256)
{
    if (draft.path == path) return true;
    const auto nameOf = [](const std::string& of) { return std::filesystem::path(of).filename(); };
    return !sha256.empty() && draft.sha256 == sha256 && nameOf(draft.path) == nameOf(path);
}

const ProgramDraft* draftOf(const std::vector<ProgramDraft>& drafts, const std::string& path, const std::string& sha256)
{
    const auto found = std::find_if(drafts.begin(), drafts.end(),
                                    [&](const ProgramDraft& draft) { return isOf(draft, path, sha256); });
    return found == drafts.end() ? nullptr : &*found;
}

std::string toUtf8(const std::string& bytes)
{
    if (isUtf8(bytes)) return bytes;
    std::string utf8;
    for (const char byte : bytes) appendUtf8(utf8, static_cast<unsigned char>(byte));
    return utf8;
}

std::string bytesOf(const std::string& utf8, const std::string& file)
{
    if (isUtf8(file)) return utf8;
    std::string latin1;
    for (std::size_t at = 0; at < utf8.size();) {
        const Utf8Character character = utf8At(utf8, at);
        constexpr char32_t afterLatin1 = 0x100;
        if (character.length == 0 || character.code >= afterLatin1) return utf8;
        latin1 += static_cast<char>(character.code);
        at += character.length;
    }
    return latin1;
}

}  // namespace lathelier::gcode
