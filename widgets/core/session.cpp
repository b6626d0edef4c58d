#include "widgets/core/session.h"

#include <QLocale>
#include <QUndoCommand>
#include <utility>

#include "engine/project/parts.h"

namespace lathelier {
namespace {

/// Takes over what each part shows: by its place, or by its name where a part came or went.
void keepViews(const project::Project& from, project::Project& into)
{
    const std::vector<const project::Part*> former = project::partsOf(from);
    const std::vector<project::Part*> present = project::partsOf(into);
    for (std::size_t i = 0; i < present.size(); ++i) {
        if (former.size() == present.size()) {
            present[i]->views = former[i]->views;
            continue;
        }
        for (const project::Part* part : former)
            if (part->name == present[i]->name) present[i]->views = part->views;
    }
}

}  // namespace

/// One step: the project before and after. Snapshots are cheap, since large data are not in the project.
class Session::Edit : public QUndoCommand {
public:
    Edit(Session& session, const QString& text, project::Project before, project::Project after, QString mergeKey)
        : QUndoCommand(QLocale().name() + "\n" + text),  // "\n" separates the list text from the menu text
          session_(session),
          before_(std::move(before)),
          after_(std::move(after)),
          mergeKey_(std::move(mergeKey))
    {
    }

    void undo() override
    {
        setObsolete(session_.withdrawing_);
        session_.assign(before_);
    }
    void redo() override { session_.assign(after_); }
    int id() const override { return mergeKey_.isEmpty() ? -1 : 1; }

    bool mergeWith(const QUndoCommand* next) override
    {
        const auto* edit = static_cast<const Edit*>(next);
        if (edit->mergeKey_ != mergeKey_) return false;
        after_ = edit->after_;
        setObsolete(after_ == before_);  // restored to the value before the drag
        return true;
    }

private:
    Session& session_;
    project::Project before_;
    project::Project after_;
    QString mergeKey_;
};

Session::Session(QObject* parent)
    : QObject(parent), stores_(std::make_shared<Stores>()), watch_(new SourceWatch(stores_, this))
{
    connect(&undo_, &QUndoStack::cleanChanged, this, [this](bool clean) { emit modifiedChanged(!clean); });
}

const project::PanelState& Session::panel(const std::string& id) const
{
    static const project::PanelState nothing;
    const auto found = project_.panels.find(id);
    return found == project_.panels.end() ? nothing : found->second;
}

void Session::edit(const QString& text, const std::function<void(project::Project&)>& change, const QString& mergeKey)
{
    project::Project after = project_;
    change(after);
    if (after == project_) return;
    // One drag ends where another part is shown.
    const QString key = mergeKey.isEmpty() ? mergeKey : mergeKey + "/" + QString::number(opened_);
    undo_.push(new Edit(*this, text, project_, std::move(after), key));
}

bool Session::withdraw(int index)
{
    if (index <= 0 || undo_.index() != index || undo_.count() != index) return false;
    withdrawing_ = true;
    undo_.undo();
    withdrawing_ = false;
    return true;
}

void Session::setWorkspace(const std::string& id)
{
    if (project_.workspace == id) return;
    project_.workspace = id;
    emit workspaceChanged();
}

void Session::setStartingShop(const Values& shop)
{
    startingShop_ = shop;
    project::Project untouched;
    untouched.workspace = project_.workspace;
    if (path_.isEmpty() && project_ == untouched) project_.shop = shop;
}

void Session::showPart(std::size_t index)
{
    if (index == project_.place || index > project_.others.size()) return;
    collectViews();
    project::showPart(project_, index);
    ++opened_;
    walk_.reset();
    emit changed();
}

void Session::setView(const std::string& id, const std::string& key, const Value& value)
{
    set(project_.views[id], key, value);
}

Value Session::view(const std::string& id, const std::string& key) const
{
    const auto kept = project_.views.find(id);
    const Value* value = kept == project_.views.end() ? nullptr : find(kept->second, key);
    return value ? *value : Value();
}

void Session::assign(const project::Project& project)
{
    const bool otherPart = project.place != project_.place || project.others.size() != project_.others.size();
    if (otherPart) collectViews();
    // Neither is part of an undo step.
    project::Project next = project;
    next.workspace = project_.workspace;
    keepViews(project_, next);
    project_ = std::move(next);
    if (otherPart) ++opened_;
    walk_.reset();
    emit changed();
}

void Session::replace(project::ProjectFile file, const QString& path)
{
    const bool otherWorkspace = file.project.workspace != project_.workspace;
    const bool anyNew = stores_->forgetChanged();  // reload from the present files
    watch_->clear();
    undo_.clear();
    ++opened_;
    project_ = std::move(file.project);
    ++generation_;
    walk_.reset();
    path_ = path;
    sha256_ = std::move(file.sha256);
    emit pathChanged();
    if (otherWorkspace) emit workspaceChanged();
    emit changed();
    if (anyNew) emit filesTaken();
}

void Session::reset()
{
    project::Project empty;
    empty.workspace = project_.workspace;
    empty.shop = startingShop_;
    replace({std::move(empty), {}}, {});
}

void Session::open(const QString& path)
{
    project::ProjectFile file = project::readProject(path.toStdString());
    if (file.project.recipe) {
        file.project.recipe = false;
        replace({std::move(file.project), {}}, {});
    } else {
        replace(std::move(file), path);
    }
    watch_->compareWithSaved(project_);
}

void Session::recover(const QString& projectPath, const QString& original, const std::string& original_sha256)
{
    project::ProjectFile file = project::readProject(projectPath.toStdString());
    file.sha256 = original_sha256;
    replace(std::move(file), original);
    undo_.resetClean();
    watch_->compareWithSaved(project_);
}

void Session::save(const QString& path)
{
    collectViews();
    sha256_ = project::writeProject(path.toStdString(), forDisk());
    path_ = path;
    undo_.setClean();
    emit pathChanged();
}

void Session::saveRecipe(const QString& path, const project::PartInputs& part_inputs) const
{
    project::writeProject(path.toStdString(), recipeOf(forDisk(), part_inputs));
}

bool Session::isOvertaken() const
{
    if (path_.isEmpty() || sha256_.empty()) return false;
    try {
        return io::fileSha256(path_.toStdString()) != sha256_;
    } catch (const Error&) {
        return false;  // missing: will be written again by save()
    }
}

void Session::saveCopy(const QString& path) const
{
    project::writeProject(path.toStdString(), forDisk());
}

void Session::takeNewFiles()
{
    const bool any = stores_->forgetChanged();
    ++generation_;
    walk_.reset();
    watch_->clear();
    if (any) emit filesTaken();
}

void Session::setPlaces(std::vector<walk::Place> places)
{
    places_ = std::move(places);
    walk_.reset();
}

void Session::setSupply(walk::Supply supply)
{
    if (supply.digest == supply_.digest) return;
    supply_ = std::move(supply);
    walk_.reset();
    emit changed();
}

std::shared_ptr<const walk::Walk> Session::walk() const
{
    if (!walk_) walk_ = std::make_shared<const walk::Walk>(project_, places_, supply_, stores_, generation_);
    return walk_;
}

project::Project Session::forDisk() const
{
    project::Project project = project_;
    if (project.shop.empty()) project.shop = startingShop_;
    for (project::Part* part : project::partsOf(project))
        for (auto& [id, panel] : part->panels)
            for (auto& [role, source] : panel.inputs)
                if (const auto digest = stores_->digest(source)) source.sha256 = *digest;
    return project;
}

}  // namespace lathelier
