#include "widgets/deflection_common/program_draft.h"

#include <QString>
#include <QTextCodec>
#include <algorithm>
#include <filesystem>

namespace lathelier::deflection_common {
namespace {

/// The text if it is UTF-8; none otherwise.
std::optional<QString> decoded(const std::string& bytes)
{
    QTextCodec::ConverterState state;
    QString text = QTextCodec::codecForName("UTF-8")->toUnicode(bytes.data(), static_cast<int>(bytes.size()), &state);
    if (state.invalidChars > 0 || state.remainingChars > 0) return std::nullopt;
    return text;
}

}  // namespace

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
    return decoded(bytes) ? bytes : QString::fromLatin1(bytes.data(), static_cast<int>(bytes.size())).toStdString();
}

std::string bytesOf(const std::string& utf8, const std::string& file)
{
    if (decoded(file)) return utf8;
    const QString text = QString::fromStdString(utf8);
    const bool fits = std::all_of(text.begin(), text.end(), [](QChar c) { return c.unicode() < 0x100; });
    return fits ? text.toLatin1().toStdString() : utf8;
}

}  // namespace lathelier::deflection_common
