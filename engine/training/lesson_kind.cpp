#include "engine/training/lesson_kind.h"

#include <algorithm>
#include <filesystem>

#include "engine/training/lesson.h"

namespace lathelier::training {
namespace {

bool isMarkdown(const std::string& path)
{
    std::string suffix = std::filesystem::path(path).extension().string();
    std::transform(suffix.begin(), suffix.end(), suffix.begin(),
                   [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
    return suffix == ".md" || suffix == ".markdown";
}

io::Likeness likeLesson(const std::string& path, std::string_view head, const Values&)
{
    if (head.starts_with("\xEF\xBB\xBF")) head.remove_prefix(3);
    const std::size_t first = head.find_first_not_of(" \t\r\n");
    const bool has_title = first != std::string_view::npos && head.substr(first).starts_with("# ");
    if (isMarkdown(path)) return has_title ? io::Likeness::Certain : io::Likeness::Likely;
    return io::Likeness::No;
}

io::FileFacts factsOf(const io::FileToRead& file, Notes&)
{
    const Lesson lesson = readLesson(file.bytes, file.path);
    io::FileFacts facts;
    facts.path = file.path;
    facts.format = "lesson";
    facts.details = {{"title", lesson.title}, {"steps", static_cast<std::int64_t>(lesson.steps.size())}};
    return facts;
}

}  // namespace

const io::FileKind& lessonFiles()
{
    static const io::FileKind kind{"lesson", LT_TEXT("Engine", "Lessons"), "*.md", {}, {}, likeLesson, factsOf};
    return kind;
}

}  // namespace lathelier::training
