// The open project and its only mutator.
#pragma once

#include <QObject>
#include <QString>
#include <QUndoStack>
#include <functional>

#include "engine/project/project.h"
#include "engine/project/recipe.h"
#include "engine/task/stores.h"
#include "engine/walk/walk.h"
#include "widgets/core/files/source_watch.h"

namespace lathelier {

/// Owns the project. The display follows changed(); every change goes through edit() and is one undo step. For the GUI
/// thread (objects of stores() may be used in jobs).
class Session : public QObject {
    Q_OBJECT
public:
    explicit Session(QObject* parent = nullptr);

    const project::Project& project() const { return project_; }
    /// A panel's state by its key in the project; empty when the project has none.
    const project::PanelState& panel(const std::string& id) const;

    /// Changes the project. `text` names the step in the Edit menu ("Change the tolerance"). Consecutive edits with the
    /// same non-empty `mergeKey` are one step (a slider while it is dragged). A change that changes nothing is no step.
    void edit(const QString& text, const std::function<void(project::Project&)>& change, const QString& mergeKey = {});

    /// Takes back the step after which undoStack().index() was `index`, as if it had not been made: it cannot be
    /// redone. False when it is not the last one any more.
    bool withdraw(int index);

    /// Parameters of new evaluations by key that replace the defaults: the user's settings.
    void setStartingValues(const Values& values) { starting_ = values; }
    const Values& startingValues() const { return starting_; }

    /// The shop that new projects begin with, and that one which states none is saved with: elsewhere it would be made
    /// with another one.
    void setStartingShop(const Values& shop);

    /// Which workspace is open is kept with the project, but switching it is no undo step and no modification.
    void setWorkspace(const std::string& id);

    /// Shows another part of the project; likewise no undo step and no modification. An undo step carries the whole
    /// project: undoing one shows the part that it was made in, and changes no other.
    void showPart(std::size_t index);

    /// What panel `id` shows and how, kept with the project: no undo step, no modification, nothing is computed.
    void setView(const std::string& id, const std::string& key, const Value& value);
    Value view(const std::string& id, const std::string& key) const;  ///< none when nothing was saved

    /// Collects the view settings of all panels before saving (viewsRequested()).
    void collectViews() { emit viewsRequested(); }
    int projectsOpened() const { return opened_; }  ///< incremented with each opened project and each shown part

    /// The undo text of a step is that of edit(); its text() contains the locale of that time.
    QUndoStack& undoStack() { return undo_; }
    const std::string& savedSha256() const { return sha256_; }  ///< digest of the project file as opened or saved here
    bool isModified() const { return !undo_.isClean(); }

    /// Path of the project file; empty when it was never saved.
    QString path() const { return path_; }

    /// An empty project. Does not ask about unsaved changes: that is the window's business.
    void reset();

    /// Opens a project; a recipe begins a new one. Changes of its sources since it was saved are reported by watch().
    /// Throws Error.
    void open(const QString& path);

    /// Opens `projectPath` as a recovered, unsaved state of the project at `original` (empty: it had no file), whose
    /// digest was `original_sha256` when it was opened.
    void recover(const QString& projectPath, const QString& original, const std::string& original_sha256 = {});

    /// Writes the project, with the digests of the sources read so far. Throws Error and keeps the modified state.
    void save(const QString& path);

    /// Writes the project as a recipe; the open project is unchanged. Throws Error.
    void saveRecipe(const QString& path, const project::PartInputs& part_inputs) const;

    /// Whether another process has written the project file since it was opened or saved here. Reads the file.
    bool isOvertaken() const;

    /// Writes what save() would write, without becoming clean: for autosave. Throws Error.
    void saveCopy(const QString& path) const;

    /// Files changed by other programs are used as read until this is called; then panels that use them recompute.
    void takeNewFiles();
    SourceWatch& watch() { return *watch_; }

    /// Objects shared by panels beside the project; jobs hold shared ownership of the ones they use.
    Stores& stores() const { return *stores_; }
    std::shared_ptr<Stores> sharedStores() const { return stores_; }

    /// The places of a part, in the order of the work, and what it is made with.
    void setPlaces(std::vector<walk::Place> places);
    void setSupply(walk::Supply supply);  ///< panels that use it recompute

    /// The walk through the part as the project now is; jobs hold shared ownership.
    std::shared_ptr<const walk::Walk> walk() const;

    /// Stops the computations of all panels that work on this state.
    void stop(const std::string& state) { emit stopRequested(state); }

signals:
    void changed();      ///< the project has a new value
    void pathChanged();  ///< the project was opened, saved under a name, or reset
    void modifiedChanged(bool modified);
    void workspaceChanged();
    void filesTaken();      ///< emitted by takeNewFiles()
    void viewsRequested();  ///< panels store their view settings by setView()
    void stopRequested(const std::string& state);

private:
    class Edit;
    void assign(const project::Project& project);
    void replace(project::ProjectFile file, const QString& path);
    project::Project forDisk() const;

    project::Project project_;
    Values starting_;
    Values startingShop_;
    QString path_;
    std::string sha256_;  ///< digest of the project file as opened or saved here
    bool withdrawing_ = false;
    int opened_ = 0;  ///< opened projects and shown parts
    QUndoStack undo_;
    std::shared_ptr<Stores> stores_;
    std::vector<walk::Place> places_;
    walk::Supply supply_;
    int generation_ = 0;                              ///< counts how often changed files were taken
    mutable std::shared_ptr<const walk::Walk> walk_;  ///< null: the project has changed since
    SourceWatch* watch_;
};

}  // namespace lathelier
