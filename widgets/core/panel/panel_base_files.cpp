// Assignment of files and parameters to a panel.
#include <QDragEnterEvent>
#include <QFileDialog>
#include <QMetaMethod>
#include <QMimeData>
#include <QUrl>
#include <algorithm>

#include "engine/core/version.h"
#include "engine/io/cloud/scan_input.h"
#include "engine/task/inputs.h"
#include "widgets/core/form/input_box.h"
#include "widgets/core/form/input_column.h"
#include "widgets/core/language.h"
#include "widgets/core/panel/next_part_bar.h"
#include "widgets/core/panel/panel_base.h"
#include "widgets/core/session.h"

namespace lathelier {

bool PanelBase::hasInputs() const
{
    // A panel with sufficient parameters needs no file.
    return isComplete(state_) || std::any_of(inputs_.roles.begin(), inputs_.roles.end(),
                                             [&](const InputRole& role) { return state_.inputs.count(role.role) > 0; });
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
    return [scans = session_.stores().of<task::CacheOf<io::ScanInput>>(),
            inputs = state.inputs](const Progress& progress) -> std::shared_ptr<const void> {
        for (const auto& [role, source] : inputs)
            scans->load(source, progress.part(0, 1, LT_TEXT("Engine", "Reading")));
        return nullptr;
    };
}

QString PanelBase::understood(const InputRole&, const project::Source& source) const
{
    const auto loaded = session_.stores().of<task::CacheOf<io::ScanInput>>()->known(source);
    if (!loaded) return {};
    const Scan& scan = loaded->file.scan;
    return understoodText(loaded->file.facts, scan.isMesh() ? tr("%L1 triangles").arg(scan.triangles.size())
                                                            : tr("%L1 points").arg(scan.points_mm.size()));
}

void PanelBase::editState(const QString& step, const std::function<void(project::PanelState&)>& change,
                          const QString& mergeKey)
{
    session_.edit(
        step,
        [&](project::Project& project) {
            const bool begins = !project.panels.count(facts_.stateKey());
            project::PanelState& state = project.panels[facts_.stateKey()];
            if (begins)
                for (const auto& [key, value] : session_.startingValues())
                    if (lathelier::find(inputs_.defaults, key)) lathelier::set(state.parameters, key, value);
            change(state);
        },
        mergeKey);
}

void PanelBase::keepItem(const std::string& name, const std::string& kind, const Values& values)
{
    session_.edit(tr("Keep “%1” in the project").arg(QString::fromStdString(name)), [&](project::Project& project) {
        project.items[name] = {kind, values, project::originOf(project, facts_.stateKey(), programVersion)};
    });
}

void PanelBase::offerItem(const std::string& name, const std::string& kind, const Values& values, bool synthetic)
{
    emit itemOffered(name, {kind, values, project::originOf(session_.project(), facts_.stateKey(), programVersion)},
                     synthetic);
}

void PanelBase::takeSources(const InputRole& role, const std::vector<project::Source>& sources, const QString& step)
{
    editState(step, [&](project::PanelState& state) { setSources(state, role, sources); });
}

void PanelBase::openFiles(const QStringList& paths)
{
    if (paths.isEmpty()) return;
    finder_.find(paths, [this](const std::vector<FoundFile>& files) {
        const std::vector<FoundFile> taken = withoutRefused(files, acceptedKinds());
        const std::optional<Error> refused = refusal_;
        if (!taken.empty()) openFound(taken);  // a new state, which has no refusal
        refusal_ = refused;
        showAnswer();
    });
}

io::FileKinds PanelBase::acceptedKinds() const
{
    io::FileKinds kinds = kindsOf(inputs_.roles);
    io::unite(kinds, facts_.kinds);
    return kinds;
}

/// Files for one input, chosen or dropped there.
void PanelBase::takeFiles(const InputRole& role, const QStringList& paths)
{
    const auto take = [this, role](const std::vector<FoundFile>& files) {
        std::vector<project::Source> sources;
        for (const FoundFile& file : withoutRefused(files, role.kinds))
            sources.push_back(newSource(QString::fromStdString(file.path)));
        if (sources.empty()) return;
        const std::optional<Error> refused = refusal_;
        takePlaces(tr("Open %1").arg(screenFileName(QString::fromStdString(sources.front().path))),
                   [&](project::PanelState& state) { setSources(state, role, sources); });
        refusal_ = refused;
        showAnswer();
    };
    finder_.find(paths, take, role.kinds);
}

/// Reports the files that are refused; the state keeps what it has.
std::vector<FoundFile> PanelBase::withoutRefused(const std::vector<FoundFile>& files, const io::FileKinds& kinds)
{
    std::vector<FoundFile> taken;
    refusal_.reset();
    for (const FoundFile& file : files) {
        const std::optional<Error> refusal = refusalOf(file, kinds);
        if (!refusal) {
            taken.push_back(file);
            continue;
        }
        refusal_ = refusal;
        emit messageRaised({*refusal, facts_.title});
    }
    showAnswer();
    return taken;
}

/// Remembers which files replaced others, for takeBack().
void PanelBase::takePlaces(const QString& step, const std::function<void(project::PanelState&)>& change)
{
    const std::map<std::string, project::Source> before = session_.panel(facts_.stateKey()).inputs;
    const bool was_current = isCurrent();
    taken_.reset();
    editState(step, change);
    const std::map<std::string, project::Source>& after = session_.panel(facts_.stateKey()).inputs;
    const auto stays = [&after](const auto& input) {
        const auto now = after.find(input.first);
        return now != after.end() && now->second == input.second;
    };
    if (std::all_of(before.begin(), before.end(), stays)) return;
    taken_ = Taken{{}, session_.undoStack().index(), was_current};
    for (const auto& [key, source] : after)
        if (const auto earlier = before.find(key); earlier == before.end() || earlier->second != source)
            taken_->paths.push_back(source.path);
}

/// The reader refuses a file that replaced another: the former comes back, without an undo step. Where a reading option
/// settles the error, the file stays. False: nothing was taken back.
bool PanelBase::takeBack(const Error& error)
{
    if (!taken_ || asksHowToRead(error.code())) return false;
    const Taken taken = *taken_;
    taken_.reset();
    const Value* const path = lathelier::find(error.values(), "path");
    const bool is_meant = path && std::any_of(taken.paths.begin(), taken.paths.end(),
                                              [&](const std::string& one) { return *path == Value(one); });
    if (!is_meant) return false;
    restoring_ = taken.was_current;
    const bool is_back = session_.withdraw(taken.step);
    restoring_ = false;
    if (!is_back) return false;
    refusal_ = error;
    emit messageRaised({error, facts_.title});
    showAnswer();
    return true;
}

void PanelBase::openFound(const std::vector<FoundFile>& files)
{
    const project::PanelState before = state_;
    takePlaces(tr("Open %1").arg(screenFileName(QString::fromStdString(files.front().path))),
               [&](project::PanelState& state) { assignFiles(state, files); });
    if (files.size() == 1) offerOtherRole(before);
}

/// One file with all inputs given is used as the next part; the other role is offered.
void PanelBase::offerOtherRole(const project::PanelState& before)
{
    const auto role = [&](bool takes_next) {
        return std::find_if(inputs_.roles.begin(), inputs_.roles.end(),
                            [&](const InputRole& each) { return each.required && each.takes_next == takes_next; });
    };
    const auto next = role(true), other = role(false);
    if (next == inputs_.roles.end() || other == inputs_.roles.end()) return;
    const auto earlier = before.inputs.find(next->role), kept = before.inputs.find(other->role);
    if (earlier == before.inputs.end() || kept == before.inputs.end()) return;
    const auto taken = state_.inputs.find(next->role);
    if (taken == state_.inputs.end() || taken->second == earlier->second) return;
    takenInputs_ = state_.inputs;
    nextPart_->disconnect(this);
    connect(nextPart_, &NextPartBar::otherRequested, this,
            [this, next = next->role, other = other->role, earlier = earlier->second, taken = taken->second] {
                editState(tr("Use as another input"), [&](project::PanelState& state) {
                    state.inputs[other] = taken;
                    state.inputs[next] = earlier;
                });
            });
    nextPart_->offer(screenFileName(QString::fromStdString(taken->second.path)), screenText(next->label),
                     screenText(other->label));
}

void PanelBase::assignFiles(project::PanelState& state, const std::vector<FoundFile>& files) const
{
    assignInOrder(state, files);
}

void PanelBase::assignInOrder(project::PanelState& state, const std::vector<FoundFile>& files) const
{
    // What comes from elsewhere in the part is not free: a scan dropped beside a drawing is the copy.
    const auto walk = session_.walk();
    const auto comes = [&](const std::string& role) {
        const std::vector<walk::Taken>& taken = walk->taken(facts_.id);
        return std::any_of(taken.begin(), taken.end(), [&](const walk::Taken& one) { return one.role == role; });
    };
    std::vector<std::string> free;
    const InputRole* rest = nullptr;  // accepts the remaining files
    for (const InputRole& role : inputs_.roles) {
        if (role.several && !role.required)
            rest = &role;
        else if (!state.inputs.count(role.role) && !comes(role.role))
            free.push_back(role.role);
    }
    const auto next =
        std::find_if(inputs_.roles.begin(), inputs_.roles.end(), [](const InputRole& role) { return role.takes_next; });
    if (free.empty() && files.size() == 1 && next != inputs_.roles.end()) {
        free = {next->role};
    } else if (free.size() < files.size()) {  // more files than free inputs: replace all
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
    if (isSignalConnected(QMetaMethod::fromSignal(&PanelBase::filesDropped)))
        emit filesDropped(paths);
    else
        openFiles(paths);
}

}  // namespace lathelier
