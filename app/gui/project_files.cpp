#include "app/gui/project_files.h"

#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QLocale>
#include <QMessageBox>
#include <QPushButton>
#include <QStandardPaths>
#include <algorithm>

#include "app/gui/settings.h"
#include "app/gui/waiting.h"
#include "engine/sample/sample_files.h"
#include "widgets/core/form/typing.h"
#include "widgets/core/language.h"

namespace lathelier {
namespace {

constexpr const char* projectSuffix = "lathelier";
constexpr int keepAfter_ms = 1000;

}  // namespace

ProjectFiles::ProjectFiles(Session& session, const QString& recoveryFolder, QWidget* window)
    : QObject(window), session_(session), window_(window)
{
    if (!recoveryFolder.isEmpty()) recovery_ = std::make_unique<Recovery>(recoveryFolder);
    keeping_.setSingleShot(true);
    keeping_.setInterval(keepAfter_ms);
    connect(&keeping_, &QTimer::timeout, this, &ProjectFiles::keepAside);
    connect(&session_, &Session::changed, this, [this] {
        if (!keeping_.isActive()) keeping_.start();
    });
    connect(&session_.watch(), &SourceWatch::found, this, [this](const Note& note) { emit messageRaised({note, {}}); });
}

bool ProjectFiles::isProject(const QString& path)
{
    return QFileInfo(path).suffix() == projectSuffix;
}

QString ProjectFiles::filter()
{
    return tr("Lathelier projects (*.lathelier)");
}

void ProjectFiles::startNew()
{
    if (mayLeave()) session_.reset();
}

void ProjectFiles::open(const QString& path)
{
    if (!mayLeave()) return;
    try {
        session_.open(QFileInfo(path).absoluteFilePath());
    } catch (const Error& error) {
        emit messageRaised({error, {}});
        return;
    }
    addRecentFile(path);
    emit recentChanged();
}

bool ProjectFiles::save()
{
    takeOverTyping(window_);
    return session_.path().isEmpty() ? saveAs() : write(session_.path());
}

/// Another process has written the project since it was opened: asks before either version is lost.
ProjectFiles::Overtaken ProjectFiles::askOvertaken(const QString& path)
{
    QMessageBox box(
        QMessageBox::Warning, tr("Changed elsewhere"),
        tr("%1 was changed by another window or program since it was opened here.").arg(screenFileName(path)),
        QMessageBox::NoButton, window_);
    box.setInformativeText(tr("Both versions stay when yours gets another name."));
    const QPushButton* other = box.addButton(tr("Save under another name…"), QMessageBox::AcceptRole);
    const QPushButton* replace = box.addButton(tr("Replace it"), QMessageBox::DestructiveRole);
    box.addButton(QMessageBox::Cancel);
    box.exec();
    if (box.clickedButton() == other) return Overtaken::OtherName;
    return box.clickedButton() == replace ? Overtaken::Replace : Overtaken::Stay;
}

bool ProjectFiles::saveAs()
{
    takeOverTyping(window_);
    QFileDialog dialog(window_, tr("Save the project"), session_.path(), filter());
    dialog.setAcceptMode(QFileDialog::AcceptSave);
    dialog.setDefaultSuffix(projectSuffix);
    return dialog.exec() == QDialog::Accepted && write(dialog.selectedFiles().value(0));
}

void ProjectFiles::saveRecipe(const project::PartInputs& part_inputs)
{
    takeOverTyping(window_);
    QFileDialog dialog(window_, tr("Save as recipe"), QFileInfo(session_.path()).dir().path(), filter());
    dialog.setAcceptMode(QFileDialog::AcceptSave);
    dialog.setDefaultSuffix(projectSuffix);
    if (dialog.exec() != QDialog::Accepted) return;
    const QString path = dialog.selectedFiles().value(0);
    session_.collectViews();
    try {
        session_.saveRecipe(path, part_inputs);
    } catch (const Error& error) {
        emit messageRaised({error, {}});
        return;
    }
    addRecentFile(path);
    emit recentChanged();
    emit messageRaised({Phrase{LT_TEXT("Engine", "Saved {path}."), {{"path", path.toStdString()}}}, {}});
}

bool ProjectFiles::write(const QString& path)
{
    if (QFileInfo(path) == QFileInfo(session_.path()) && session_.isOvertaken()) {
        const Overtaken answer = askOvertaken(path);
        if (answer == Overtaken::OtherName) return saveAs();
        if (answer == Overtaken::Stay) return false;
    }
    try {
        session_.save(path);
    } catch (const Error& error) {
        emit messageRaised({error, {}});
        return false;
    }
    if (recovery_) recovery_->forget();
    addRecentFile(path);
    emit recentChanged();
    emit messageRaised({Phrase{LT_TEXT("Engine", "Saved {path}."), {{"path", path.toStdString()}}}, {}});
    return true;
}

bool ProjectFiles::mayLeave()
{
    takeOverTyping(window_);
    if (!session_.isModified()) return true;
    QMessageBox box(QMessageBox::Question, tr("Unsaved changes"), tr("The project has unsaved changes."),
                    QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, window_);
    box.setInformativeText(tr("Save them before going on?"));
    const int answer = box.exec();
    if (answer == QMessageBox::Save) return save();
    if (answer != QMessageBox::Discard) return false;
    if (recovery_) recovery_->forget();
    return true;
}

void ProjectFiles::offerLostWork()
{
    if (!recovery_) return;
    for (const LostWork& work : recovery_->lostWork()) {
        const QString name = work.original.isEmpty() ? tr("a project without a name") : screenFileName(work.original);
        QMessageBox box(QMessageBox::Question, tr("Recover unsaved work"),
                        tr("Lathelier ended unexpectedly. Unsaved work on %1 was kept.").arg(name),
                        QMessageBox::NoButton, window_);
        const QString files = work.files.isEmpty() ? tr("no files") : work.files.join(", ");
        box.setInformativeText(
            tr("Kept on %1, with %2.").arg(QLocale().toString(work.kept, QLocale::ShortFormat), files));
        box.setDetailedText(work.original);
        QPushButton* recover = box.addButton(tr("Recover"), QMessageBox::AcceptRole);
        QPushButton* discard = box.addButton(tr("Throw away"), QMessageBox::DestructiveRole);
        box.addButton(tr("Later"), QMessageBox::RejectRole);
        box.exec();
        if (box.clickedButton() == discard) Recovery::discard(work);
        if (box.clickedButton() != recover) continue;
        if (!mayLeave()) return;
        try {
            session_.recover(work.file, work.original, work.original_sha256);
            keepAside();
            Recovery::discard(work);
        } catch (const Error& error) {
            emit messageRaised({error, {}});
        }
        return;
    }
}

void ProjectFiles::keepAside()
{
    if (!recovery_) return;
    session_.collectViews();
    try {
        recovery_->keep(session_);
    } catch (const Error& error) {
        emit messageRaised({error, {}});
    }
}

void ProjectFiles::leaveWithoutAsking()
{
    takeOverTyping(window_);
    keepAside();
    if (recovery_) recovery_->leave();
}

QString ProjectFiles::makeSample()
{
    const QString folder = QStandardPaths::writableLocation(QStandardPaths::AppLocalDataLocation) + "/sample";
    const std::vector<std::string> names = sample::sampleFileNames();
    QString project = folder + "/" + QString::fromStdString(names.back());  // written last
    // A folder of an earlier version lacks later files.
    if (std::all_of(names.begin(), names.end(), [&folder](const std::string& name) {
            return QFileInfo::exists(folder + "/" + QString::fromStdString(name));
        }))
        return project;

    const Worker::Outcome outcome =
        waitFor(window_, tr("Making the sample scans…"),
                [path = folder.toStdString()](const Progress& progress) -> std::shared_ptr<const void> {
                    sample::writeSample(path, 1, progress);
                    return nullptr;
                });
    if (std::holds_alternative<std::shared_ptr<const void>>(outcome)) return project;
    if (const auto* error = std::get_if<Error>(&outcome)) emit messageRaised({*error, {}});
    return {};
}

void ProjectFiles::openSample()
{
    const QString project = makeSample();
    if (!project.isEmpty()) open(project);
}

}  // namespace lathelier
