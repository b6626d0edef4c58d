#include "widgets/core/files/kind_finder.h"

#include <algorithm>
#include <utility>

#include "engine/io/file.h"
#include "widgets/core/files/file_codes.h"
#include "widgets/core/language.h"

namespace lathelier {
namespace {

FoundFile foundFile(const std::string& path, const io::FileKinds& kinds)
{
    try {
        const io::KindFound found = io::likeliestKind(kinds, path, io::fileHead(path, io::headForKind), {});
        return {path, found.kind, found.likeness};
    } catch (const Error& error) {
        FoundFile file{path};
        file.error = error;
        if (!lathelier::find(error.values(), "path")) file.error->with("path", path);
        return file;
    }
}

}  // namespace

std::optional<Error> refusalOf(const FoundFile& file, const io::FileKinds& kinds)
{
    if (file.error) return file.error;
    if (kinds.empty() || std::find(kinds.begin(), kinds.end(), file.kind) != kinds.end()) return std::nullopt;
    QStringList names;
    for (const io::FileKind* kind : kinds) names << screenText(kind->name);
    Value found = LT_TEXT("Engine", "a file of no known kind");
    if (file.kind) found = file.kind->name;
    return Error(errors::fileOfOtherKind,
                 {{"path", file.path}, {"found", found}, {"expected", names.join(", ").toStdString()}});
}

KindFinder::KindFinder(io::FileKinds kinds, QObject* parent) : QObject(parent), kinds_(std::move(kinds)) {}

void KindFinder::find(const QStringList& paths, Done done, const io::FileKinds& kinds)
{
    std::vector<std::string> names;
    for (const QString& path : paths) names.push_back(path.toStdString());
    waiting_.push_back({std::move(names), kinds.empty() ? kinds_ : kinds, std::move(done)});
    if (!task_.isBusy()) next();
}

void KindFinder::next()
{
    if (waiting_.empty()) return;
    const Asked asked = std::move(waiting_.front());
    waiting_.pop_front();
    task_.compute<std::vector<FoundFile>>(
        [names = asked.paths, kinds = asked.kinds](const Progress& progress) {
            std::vector<FoundFile> files;
            for (const std::string& name : names) {
                progress.check();
                files.push_back(foundFile(name, kinds));
            }
            return files;
        },
        [this, done = asked.done](const std::vector<FoundFile>& files) {
            next();
            done(files);
        },
        [this, asked](const Error& error) {
            next();
            std::vector<FoundFile> files;
            for (const std::string& name : asked.paths) {
                files.push_back({name});
                files.back().error = error;
            }
            asked.done(files);
        });
}

}  // namespace lathelier
