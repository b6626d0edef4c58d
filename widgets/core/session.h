// The open project and the only way to change it.
#pragma once

#include <QObject>
#include <QString>
#include <QUndoStack>
#include <functional>

#include "engine/project/project.h"
#include "engine/project/recipe.h"
#include "widgets/core/files/source_watch.h"
#include "widgets/core/files/stores.h"

namespace lathelier {

/// Owns the project. Everything on screen follows from changed(); every change goes through edit(), is one undo step,
/// and is announced. Lives in the GUI thread (what stores() gives may be used from jobs).
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

    /// Parameters that new evaluations begin with, by key, in place of the defaults: the user's settings.
    void setStartingValues(const Values& values) { starting_ = values; }
    const Values& startingValues() const { return starting_; }

    /// Which workspace is open is kept with the project, but switching it is no undo step and no modification.
    void setWorkspace(const std::string& id);

    /// What panel `id` shows and how, kept with the project: no undo step, no modification, nothing is computed.
    void setView(const std::string& id, const std::string& key, const Value& value);
    Value view(const std::string& id, const std::string& key) const;  ///< not given when nothing was kept

    /// Asks all panels what they show, so that what is written next has it (viewsWanted()).
    void collectViews() { emit viewsWanted(); }
    int projectsOpened() const { return opened_; }  ///< grows with each project that takes the place of another

    /// Each step's undo text is that of edit(); its text() is the locale that was spoken then.
    QUndoStack& undoStack() { return undo_; }
    const std::string& savedSha256() const { return sha256_; }  ///< of the project file as it was opened or saved here
    bool isModified() const { return !undo_.isClean(); }

    /// Path of the project file; empty when it was never saved.
    QString path() const { return path_; }

    /// An empty project. Does not ask about unsaved changes: that is the window's business.
    void reset();

    /// Opens a project; a recipe begins a new one. What became of its sources since it was saved is told by watch().
    /// Throws Error.
    void open(const QString& path);

    /// Opens `projectPath` as a recovered, unsaved state of the project at `original` (empty: it had no file), which
    /// had the digest `original_sha256` when the work on it began.
    void recover(const QString& projectPath, const QString& original, const std::string& original_sha256 = {});

    /// Writes the project, with the digests of the sources read so far. Throws Error and keeps the modified state.
    void save(const QString& path);

    /// Writes the project as a recipe: this one stays what it is. Throws Error.
    void saveRecipe(const QString& path, const project::PartInputs& part_inputs) const;

    /// Whether somebody else has written the project's file since it was opened or saved here. Reads the file.
    bool isOvertaken() const;

    /// Writes what save() would write, without becoming clean: for autosave. Throws Error.
    void saveCopy(const QString& path) const;

    /// Files that were changed by other programs stay as they were read until this is called: panels that use them
    /// compute again.
    void takeNewFiles();
    SourceWatch& watch() { return *watch_; }

    /// What panels share beside the project; jobs keep what they use of it.
    Stores& stores() const { return *stores_; }
    std::shared_ptr<Stores> sharedStores() const { return stores_; }

    /// Stops the computations of all panels that work on this state.
    void stop(const std::string& state) { emit stopWanted(state); }

signals:
    void changed();      ///< the project has a new value
    void pathChanged();  ///< opened, saved under a name, or reset
    void modifiedChanged(bool modified);
    void workspaceChanged();
    void filesTaken();   ///< by takeNewFiles()
    void viewsWanted();  ///< panels give what they show by setView()
    void stopWanted(const std::string& state);

private:
    class Edit;
    void assign(const project::Project& project);
    void replace(project::ProjectFile file, const QString& path);
    project::Project forDisk() const;

    project::Project project_;
    Values starting_;
    QString path_;
    std::string sha256_;  ///< of the project file as it was opened or saved here
    int opened_ = 0;
    QUndoStack undo_;
    std::shared_ptr<Stores> stores_;
    SourceWatch* watch_;
};

}  // namespace lathelier
