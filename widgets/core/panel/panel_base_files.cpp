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

#include "engine/io/file.h"
#include "engine/io/io_codes.h"
#include "engine/report/result_json.h"
#include "widgets/core/files/scan_store.h"
#include "widgets/core/form/input_box.h"
#include "widgets/core/form/input_column.h"
#include "widgets/core/form/number_edit.h"
#include "widgets/core/language.h"
#include "widgets/core/panel/answer_strip.h"
#include "widgets/core/panel/message_line.h"
#include "widgets/core/panel/panel_base.h"
#include "widgets/core/session.h"
#include "widgets/core/task/progress_row.h"

namespace lathelier {

bool PanelBase::hasInputs() const
{
    // A panel that takes no files has all it needs in its parameters.
    return inputs_.roles.empty() || std::any_of(inputs_.roles.begin(), inputs_.roles.end(), [&](const InputRole& role) {
               return state_.inputs.count(role.role) > 0;
           });
}

bool PanelBase::isComplete(const project::PanelState& state) const
{
    return missingInputs(state).empty();
}

std::vector<Text> PanelBase::missingInputs(const project::PanelState& state) const
{
    return facts_.missing ? facts_.missing(state) : missingOf(inputs_.roles)(state);
}

Worker::Job PanelBase::makeReadingJob(const project::PanelState& state) const
{
    return [scans = session_.stores().of<ScanStore>(),
            inputs = state.inputs](const Progress& progress) -> std::shared_ptr<const void> {
        for (const auto& [role, source] : inputs)
            scans->load(source, progress.part(0, 1, LT_TEXT("Engine", "Reading")));
        return nullptr;
    };
}

QString PanelBase::understood(const InputRole&, const project::Source& source) const
{
    const LoadedScanPtr loaded = session_.stores().of<ScanStore>()->known(source);
    if (!loaded) return {};
    const Scan& scan = loaded->file.scan;
    return understoodText(loaded->file.facts, scan.isMesh() ? tr("%L1 triangles").arg(scan.triangles.size())
                                                            : tr("%L1 points").arg(scan.points_mm.size()));
}

void PanelBase::editState(const QString& step, const std::function<void(project::PanelState&)>& change,
                          const QString& mergeKey)
{
    session_.edit(
        step, [&](project::Project& project) { change(project.panels[facts_.stateKey()]); }, mergeKey);
}

void PanelBase::keepItem(const std::string& name, const std::string& kind, const Values& values)
{
    session_.edit(tr("Keep “%1” in the project").arg(QString::fromStdString(name)), [&](project::Project& project) {
        project.items[name] = {kind, values, project::originOf(project, facts_.stateKey(), LATHELIER_VERSION)};
    });
}

void PanelBase::offerItem(const std::string& name, const std::string& kind, const Values& values, bool synthetic)
{
    emit itemOffered(name, {kind, values, project::originOf(session_.project(), facts_.stateKey(), LATHELIER_VERSION)},
                     synthetic);
}

void PanelBase::takeSources(const InputRole& role, const std::vector<project::Source>& sources, const QString& step)
{
    editState(step, [&](project::PanelState& state) { setSources(state, role, sources); });
}

void PanelBase::openFiles(const QStringList& paths)
{
    if (paths.isEmpty()) return;
    if (finder_.isBusy() || kindsOf(inputs_.roles).size() > 1)
        return finder_.find(paths, [this](const std::vector<FoundFile>& files) { openFound(files); });
    std::vector<FoundFile> files;
    for (const QString& path : paths) files.push_back({path.toStdString()});
    openFound(files);
}

void PanelBase::openFound(const std::vector<FoundFile>& files)
{
    editState(tr("Open %1").arg(screenFileName(QString::fromStdString(files.front().path))),
              [&](project::PanelState& state) { assignFiles(state, files); });
}

void PanelBase::assignFiles(project::PanelState& state, const std::vector<FoundFile>& files) const
{
    std::vector<std::string> free;
    const InputRole* rest = nullptr;  // takes what is left over
    for (const InputRole& role : inputs_.roles) {
        if (role.several && !role.required)
            rest = &role;
        else if (!state.inputs.count(role.role))
            free.push_back(role.role);
    }
    const auto next =
        std::find_if(inputs_.roles.begin(), inputs_.roles.end(), [](const InputRole& role) { return role.takes_next; });
    if (free.empty() && files.size() == 1 && next != inputs_.roles.end()) {
        free = {next->role};
    } else if (free.size() < files.size()) {  // more files than free places: start anew
        free.clear();
        for (const InputRole& role : inputs_.roles)
            if (&role != rest) free.push_back(role.role);
    }
    std::vector<project::Source> left;
    for (std::size_t i = 0; i < files.size(); ++i) {
        const project::Source source = newSource(QString::fromStdString(files[i].path));
        if (i < free.size())
            state.inputs[free[i]] = source;
        else if (rest)
            left.push_back(source);
    }
    if (!left.empty()) setSources(state, *rest, left);
}

void PanelBase::askForFiles()
{
    openFiles(QFileDialog::getOpenFileNames(this, tr("Open"), {}, fileFilter(kindsOf(inputs_.roles))));
}

void PanelBase::editParameter(const std::string& key, const Value& value, int gesture, const QString& step)
{
    editState(
        step, [&](project::PanelState& state) { lathelier::set(state.parameters, key, value); },
        QString("%1/%2/%3").arg(QString::fromStdString(facts_.id), QString::fromStdString(key)).arg(gesture));
}

std::vector<PanelExport> PanelBase::offeredExports() const
{
    std::vector<PanelExport> all = exports();
    if (result_)
        all.push_back({tr("All numbers (JSON)…"), tr("JSON (*.json)"), "json", [this](const QString& path) {
                           const auto part = reportDocument();
                           io::writeFile(path.toStdString(),
                                         part ? report::joinedResults(part->results) : std::string());
                       }});
    return all;
}

void PanelBase::sayNotWritten(const QString& path)
{
    const Error error(errors::fileNotWritable,
                      {{"path", path.toStdString()}, {"reason", LT_TEXT("Engine", "the system refused it")}});
    emit messageRaised({error, facts_.title});
}

void PanelBase::fillExportMenu()
{
    QMenu* menu = progress_->exportMenu();
    menu->clear();
    for (const PanelExport& item : offeredExports())
        menu->addAction(item.label, this, [this, item] { runExport(item); });
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
