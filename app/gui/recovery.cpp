#include "app/gui/recovery.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QUuid>

#include "engine/io/file.h"
#include "engine/project/parts.h"

namespace lathelier {
namespace {

QString pathFile(const QString& file)
{
    return file + ".path";
}
QString lockFile(const QString& file)
{
    return file + ".lock";
}

void removeAll(const QString& file)
{
    QFile::remove(file);
    QFile::remove(pathFile(file));
}

}  // namespace

Recovery::Recovery(const QString& folder) : folder_(folder)
{
    QDir().mkpath(folder_);
    file_ = folder_ + "/" + QUuid::createUuid().toString(QUuid::WithoutBraces) + ".lathelier";
    lock_ = std::make_unique<QLockFile>(lockFile(file_));
    lock_->setStaleLockTime(0);  // valid as long as its process lives
    lock_->tryLock(0);
}

Recovery::~Recovery()
{
    if (!file_.isEmpty()) forget();
}

void Recovery::leave()
{
    lock_->unlock();
    file_.clear();
}

void Recovery::keep(const Session& session)
{
    if (file_.isEmpty()) return;
    if (!session.isModified()) {
        forget();
        return;
    }
    session.saveCopy(file_);
    io::writeFile(pathFile(file_).toStdString(), session.savedSha256() + "\n" + session.path().toStdString());
}

void Recovery::forget()
{
    if (!file_.isEmpty()) removeAll(file_);
}

namespace {

/// Names of the inputs; none when the project cannot be read, which recovering it will say.
QStringList filesOf(const QString& project)
{
    QStringList names;
    try {
        const project::ProjectFile file = project::readProject(project.toStdString());
        for (const project::Part* part : project::partsOf(file.project))
            for (const auto& [id, panel] : part->panels)
                for (const auto& [role, source] : panel.inputs)
                    if (!source.path.empty()) names << QFileInfo(QString::fromStdString(source.path)).fileName();
    } catch (const Error&) {
        return {};
    }
    names.removeDuplicates();
    return names;
}

}  // namespace

std::vector<LostWork> Recovery::lostWork() const
{
    std::vector<LostWork> result;
    const QDir folder(folder_);
    for (const QString& name : folder.entryList({"*.lathelier"}, QDir::Files, QDir::Time)) {
        const QString file = folder.filePath(name);
        if (file == file_) continue;
        QLockFile lock(lockFile(file));
        lock.setStaleLockTime(0);
        if (!lock.tryLock(0)) continue;  // another window is working on it
        QFile path(pathFile(file));
        std::string sha256;
        QString original;
        if (path.open(QIODevice::ReadOnly)) {
            sha256 = path.readLine().trimmed().toStdString();
            original = QString::fromUtf8(path.readAll());
        }
        result.push_back({file, original, sha256, QFileInfo(file).lastModified(), filesOf(file)});
    }
    return result;
}

void Recovery::discard(const LostWork& work)
{
    removeAll(work.file);
}

}  // namespace lathelier
