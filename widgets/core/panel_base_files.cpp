// What the user gives to a panel and takes from it: files, parameters, exports.
#include <QDragEnterEvent>
#include <QFileDialog>
#include <QFileInfo>
#include <QMenu>
#include <QMimeData>
#include <QUrl>

#include "widgets/core/answer_parts.h"
#include "widgets/core/input_column.h"
#include "widgets/core/panel_base.h"
#include "widgets/core/session.h"
#include "widgets/core/wait_parts.h"

namespace lathelier {

void PanelBase::setSource(const std::string& role, const std::optional<Source>& source, const QString& step)
{
    session_.edit(step, [&](Project& project) {
        auto& inputs = project.panels[facts_.id].inputs;
        if (source)
            inputs[role] = *source;
        else
            inputs.erase(role);
    });
}

void PanelBase::openFiles(const QStringList& paths)
{
    if (paths.isEmpty()) return;
    session_.edit(tr("Open %1").arg(QFileInfo(paths.front()).fileName()), [&](Project& project) {
        auto& inputs = project.panels[facts_.id].inputs;
        std::vector<std::string> free;
        for (const InputRole& role : inputs_.roles)
            if (!inputs.count(role.role)) free.push_back(role.role);
        if (static_cast<qsizetype>(free.size()) < paths.size()) {  // more files than free places: start anew
            free.clear();
            for (const InputRole& role : inputs_.roles) free.push_back(role.role);
        }
        for (std::size_t i = 0; i < free.size() && static_cast<qsizetype>(i) < paths.size(); ++i)
            inputs[free[i]] = newSource(paths[static_cast<int>(i)]);
    });
}

void PanelBase::askForFiles()
{
    openFiles(QFileDialog::getOpenFileNames(this, tr("Open"), {}, fileFilter(inputs_)));
}

void PanelBase::editParameter(const std::string& key, const Value& value, int gesture, const QString& step)
{
    session_.edit(
        step, [&](Project& project) { lathelier::set(project.panels[facts_.id].parameters, key, value); },
        QString("%1/%2/%3").arg(QString::fromStdString(facts_.id), QString::fromStdString(key)).arg(gesture));
}

void PanelBase::fillExportMenu()
{
    QMenu* menu = progress_->exportMenu();
    menu->clear();
    for (const PanelExport& item : exports()) menu->addAction(item.label, this, [this, item] { runExport(item); });
}

void PanelBase::runExport(const PanelExport& item)
{
    QFileDialog dialog(this, item.label, {}, item.filter);
    dialog.setAcceptMode(QFileDialog::AcceptSave);
    dialog.setDefaultSuffix(item.suffix);
    if (dialog.exec() != QDialog::Accepted) return;
    const QString path = dialog.selectedFiles().value(0);
    try {
        item.write(path);
        emit messageRaised({Phrase{LT_TEXT("Engine", "Saved {path}."), {{"path", path.toStdString()}}}, facts_.title});
    } catch (const Error& error) {
        message_->setError(error);
        emit messageRaised({error, facts_.title});
    }
}

void PanelBase::dragEnterEvent(QDragEnterEvent* event)
{
    if (event->mimeData()->hasUrls()) event->acceptProposedAction();
}

void PanelBase::dropEvent(QDropEvent* event)
{
    QStringList paths;
    for (const QUrl& url : event->mimeData()->urls())
        if (url.isLocalFile()) paths << url.toLocalFile();
    event->acceptProposedAction();
    openFiles(paths);
}

}  // namespace lathelier
