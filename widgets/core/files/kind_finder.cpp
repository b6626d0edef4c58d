#include "widgets/core/files/kind_finder.h"

namespace lathelier {

KindFinder::KindFinder(io::FileKinds kinds, QObject* parent) : QObject(parent), kinds_(std::move(kinds)) {}

void KindFinder::find(const QStringList& paths, Done done)
{
    std::vector<std::string> names;
    for (const QString& path : paths) names.push_back(path.toStdString());
    waiting_.emplace_back(std::move(names), std::move(done));
    if (!task_.isBusy()) next();
}

void KindFinder::next()
{
    if (waiting_.empty()) return;
    const std::vector<std::string> names = std::move(waiting_.front().first);
    const auto done = std::move(waiting_.front().second);
    waiting_.pop_front();
    task_.compute<std::vector<FoundFile>>(
        [names, kinds = kinds_](const Progress& progress) {
            std::vector<FoundFile> files;
            for (const std::string& name : names) {
                progress.check();
                const io::KindFound found = io::findKind(kinds, name);
                files.push_back({name, found.kind, found.likeness});
            }
            return files;
        },
        [this, done](const std::vector<FoundFile>& files) {
            next();
            done(files);
        },
        [this, names, done](const Error&) {  // the error is reported by the reader of the files
            next();
            std::vector<FoundFile> files;
            files.reserve(names.size());
            for (const std::string& name : names) files.push_back({name});
            done(files);
        });
}

}  // namespace lathelier
