// How a panel comes to its files and parameters, and how its result leaves it.
#include <QCoreApplication>
#include <QDragEnterEvent>
#include <QEventLoop>
#include <QFileDialog>
#include <QFileInfo>
#include <QMenu>
#include <QMimeData>
#include <QPointer>
#include <QUrl>
#include <algorithm>

#include "widgets/core/answer_parts.h"
#include "widgets/core/input_box.h"
#include "widgets/core/input_column.h"
#include "widgets/core/language.h"
#include "widgets/core/number_edit.h"
#include "widgets/core/panel_base.h"
#include "widgets/core/scan_store.h"
#include "widgets/core/session.h"
#include "widgets/core/wait_parts.h"

namespace lathelier {

bool PanelBase::hasInputs() const
{
    return std::any_of(inputs_.roles.begin(), inputs_.roles.end(),
                       [&](const InputRole& role) { return state_.inputs.count(role.role) > 0; });
}

bool PanelBase::isComplete(const PanelState& state) const
{
    return missingInputs(state).empty();
}

std::vector<Text> PanelBase::missingInputs(const PanelState& state) const
{
    return facts_.missing ? facts_.missing(state) : missingOf(inputs_.roles)(state);
}

Worker::Job PanelBase::makeReadingJob(const PanelState& state) const
{
    return [scans = session_.stores().of<ScanStore>(),
            inputs = state.inputs](const Progress& progress) -> std::shared_ptr<const void> {
        for (const auto& [role, source] : inputs)
            scans->load(source, progress.part(0, 1, LT_TEXT("Engine", "Reading")));
        return nullptr;
    };
}

QString PanelBase::understood(const InputRole&, const Source& source) const
{
    const LoadedScanPtr loaded = session_.stores().of<ScanStore>()->known(source);
    if (!loaded) return {};
    const Scan& scan = loaded->file.scan;
    return understoodText(loaded->file.facts, scan.isMesh() ? tr("%L1 triangles").arg(scan.triangles.size())
                                                            : tr("%L1 points").arg(scan.points_mm.size()));
}

void PanelBase::editState(const QString& step, const std::function<void(PanelState&)>& change, const QString& mergeKey)
{
    session_.edit(
        step, [&](Project& project) { change(project.panels[facts_.stateKey()]); }, mergeKey);
}

void PanelBase::takeSources(const InputRole& role, const std::vector<Source>& sources, const QString& step)
{
    editState(step, [&](PanelState& state) { setSources(state, role, sources); });
}

void PanelBase::openFiles(const QStringList& paths)
{
    if (paths.isEmpty()) return;
    editState(tr("Open %1").arg(screenFileName(paths.front())), [&](PanelState& state) { assignFiles(state, paths); });
}

void PanelBase::assignFiles(PanelState& state, const QStringList& paths) const
{
    std::vector<std::string> free;
    for (const InputRole& role : inputs_.roles)
        if (!state.inputs.count(role.role)) free.push_back(role.role);
    if (static_cast<qsizetype>(free.size()) < paths.size()) {  // more files than free places: start anew
        free.clear();
        for (const InputRole& role : inputs_.roles) free.push_back(role.role);
    }
    for (std::size_t i = 0; i < free.size() && static_cast<qsizetype>(i) < paths.size(); ++i)
        state.inputs[free[i]] = newSource(paths[static_cast<int>(i)]);
}

void PanelBase::askForFiles()
{
    openFiles(QFileDialog::getOpenFileNames(this, tr("Open"), {}, fileFilter(inputs_.files)));
}

void PanelBase::editParameter(const std::string& key, const Value& value, int gesture, const QString& step)
{
    editState(
        step, [&](PanelState& state) { lathelier::set(state.parameters, key, value); },
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
    takeOverTyping(this);
    QFileDialog dialog(this, item.label, {}, item.filter);
    dialog.setAcceptMode(QFileDialog::AcceptSave);
    dialog.setDefaultSuffix(item.suffix);
    if (dialog.exec() != QDialog::Accepted) return;
    const QString path = dialog.selectedFiles().value(0);
    // What was typed last is computed first.
    const QPointer<PanelBase> alive(this);
    while (alive && isBusy()) QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents, 50);
    if (!alive) return;
    try {
        item.write(path);
        showAnswer();  // an earlier failure is over
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
