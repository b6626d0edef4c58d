// Common base of panels: inputs at the left, the answer above the views, progress and exports below.
#pragma once

#include <QElapsedTimer>
#include <QTimer>
#include <QWidget>
#include <functional>
#include <optional>

#include "widgets/core/files/kind_finder.h"
#include "widgets/core/panel/message.h"
#include "widgets/core/panel/panel_facts.h"
#include "widgets/core/task/worker.h"

class QSplitter;
class QStackedWidget;

namespace lathelier {

class AnswerStrip;
class PrimaryViews;
class EmptyState;
class InputColumn;
class MessageLine;
class NextPartBar;
class ProgressRow;
class Shade;

/// The untyped half of Panel<Result> (panel.h). The panel's state is its part of the session's project: every change
/// there, by the user or by undo, requests a new result from the worker; meanwhile the old result stays, dimmed.
class PanelBase : public QWidget {
    Q_OBJECT
public:
    PanelBase(Session& session, const PanelFacts& facts, const PanelInputs& inputs, QWidget* parent = nullptr);
    ~PanelBase() override;

    const PanelFacts& facts() const { return facts_; }
    bool isBusy() const { return poll_.isActive() || finder_.isBusy(); }
    bool hasResult() const { return result_ != nullptr; }
    /// the shown result belongs to the present state
    bool isCurrent() const { return hasResult() && !isBusy() && !stopped_ && !error_; }
    const std::optional<Error>& error() const { return error_; }

    /// Assigns `paths` to the inputs: empty ones first, in order. One undo step. Their heads are read first, in the
    /// background; files of other kinds are refused and take no place. A file in place of a former one that cannot be
    /// read is withdrawn: the former comes back, no undo step remains, and the error is shown.
    void openFiles(const QStringList& paths);
    virtual void openFound(const std::vector<FoundFile>& files);  ///< the same with files of kinds that it accepts
    void askForFiles();                                           ///< openFiles() with a file dialog
    void cancel();
    void recompute();  ///< recomputes although the state is unchanged (a file on disk may have changed)

    /// The answer in the strip; nullopt without a result.
    std::optional<report::Answer> shownAnswer() const;

    /// The panel's part of a report for the shown result; nullopt without a result.
    std::optional<report::Document> reportDocument() const;

    /// Exports of the shown result: those of the panel, and all numbers as JSON.
    std::vector<PanelExport> offeredExports() const;

    /// Writes it. Error outputIsInput where the file was read as an input, under any name; those of PanelExport::write.
    void writeExport(const PanelExport& item, const QString& path) const;

    /// Fields, views, exports and findings, as commands.
    std::vector<PanelCommand> commands();

    /// Presenter mode: the window enlarges the application's font, which all views follow; a panel hides secondary
    /// controls. Overriders must call this one.
    virtual void setPresenting(bool presenting);

signals:
    /// "Roundness of this section": request to open this item in the panel that accepts its kind.
    void itemOffered(const std::string& name, const lathelier::project::Item& item, bool synthetic);
    void busyChanged(bool busy);
    void resultShown();
    void messageRaised(const lathelier::Message& message);
    void sampleRequested();
    void panelRequested(const std::string& id);   ///< request to show another panel
    void filesDropped(const QStringList& paths);  ///< on the panel; not connected: it opens them itself
    void reportRequested(const QString& suffix);  ///< request for a report of this panel: "html" or "pdf"

protected:
    Session& session() const { return session_; }
    InputColumn& inputColumn() const { return *column_; }
    const project::PanelState& state() const { return state_; }  ///< state of this panel with all parameters filled in
    const PanelInputs& inputs() const { return inputs_; }

    /// Changes the panel's state in the project: one undo step.
    void editState(const QString& step, const std::function<void(project::PanelState&)>& change,
                   const QString& mergeKey = {});

    /// "Use this shaft": stores the panel's product in the project as the item `name`, replacing an earlier one. One
    /// undo step.
    void keepItem(const std::string& name, const std::string& kind, const Values& values);

    /// Emits itemOffered() with the panel's product; `synthetic`: from synthetic data.
    void offerItem(const std::string& name, const std::string& kind, const Values& values, bool synthetic);

    /// Reports that an image or the data of a plot could not be written.
    void reportWriteFailure(const QString& path);

    /// `views` contains all views of a result; `primaryViews`, a part of it, lays out the single views: the window
    /// presents them one by one, and the project stores which one is large.
    void setViews(QWidget* views, PrimaryViews* primaryViews = nullptr);

    virtual Worker::Job makeJob(const project::PanelState& state) const = 0;
    virtual void showValue(std::shared_ptr<const void> result) = 0;
    virtual report::Answer answerOf(const void* result) const = 0;
    virtual Notes notesOf(const void* result) const = 0;
    virtual report::Document documentOf(const void* result) const = 0;
    virtual std::optional<Error> problemOf(const void* result) const = 0;

    /// Marks a place of the answer in the panel's views.
    virtual void showPlace(const report::Place&) {}

    /// View settings saved with the project: colours, scale, camera. PanelBase saves which view is large.
    virtual Values view() const { return {}; }

    /// Restores the view settings of an opened project. Settings not in `kept` return to their default.
    virtual void restoreView(const Values& kept) { (void)kept; }

    /// Sets all texts of the panel's own views in the user's language.
    virtual void retranslate() {}

    /// Ways to write the result to a file, besides its numbers as JSON.
    virtual std::vector<PanelExport> exports() const { return {}; }

    std::vector<Text> missingInputs(const project::PanelState& state) const;
    bool isComplete(const project::PanelState& state) const;  ///< the inputs are sufficient for a computation

    /// Assigns files of any kind to the inputs of `state`; by default to empty ones first, in order.
    virtual void assignFiles(project::PanelState& state, const std::vector<FoundFile>& files) const;

    /// The rule of files of one kind: free inputs in their order, then the next part; more files replace all.
    void assignInOrder(project::PanelState& state, const std::vector<FoundFile>& files) const;

    /// Reads the given inputs of an incomplete state, so that their facts can be shown.
    virtual Worker::Job makeReadingJob(const project::PanelState& state) const;

    /// Facts of a file in the user's language; empty when it was not read.
    virtual QString understood(const InputRole& role, const project::Source& source) const;

    void changeEvent(QEvent* event) override;
    void showEvent(QShowEvent* event) override;
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dropEvent(QDropEvent* event) override;

private:
    QWidget* makeResultColumn();
    void readProject();
    void request();
    void begin();
    void pollWorker();
    void accept(std::shared_ptr<const void> result);
    void logNotes(const Notes& notes);
    void refuse(const Error& error);
    void showAnswer();
    void layOutAgain();
    void updateStack();
    void showFacts();
    bool hasInputs() const;
    bool isLate() const;
    void offerOtherRole(const project::PanelState& before);
    io::FileKinds acceptedKinds() const;
    void takeSources(const InputRole& role, const std::vector<project::Source>& sources, const QString& step);
    void takeFiles(const InputRole& role, const QStringList& paths);
    void takePlaces(const QString& step, const std::function<void(project::PanelState&)>& change);
    bool takeBack(const Error& error);
    std::vector<FoundFile> withoutRefused(const std::vector<FoundFile>& files, const io::FileKinds& kinds);
    void editParameter(const std::string& key, const Value& value, int gesture, const QString& step);
    void fillExportMenu();
    void runExport(const PanelExport& item);
    void takeOffer(const Values& proposed);

    Session& session_;
    PanelFacts facts_;
    PanelInputs inputs_;
    std::shared_ptr<const void> result_;
    std::optional<Error> error_;
    Notes loggedNotes_;          ///< notes of the last result already in the message log
    bool stopped_ = false;       ///< the newest request was cancelled
    bool again_ = false;         ///< the state has changed since the running request, which is allowed to finish
    project::PanelState state_;  ///< latest requested state
    bool asked_ = false;
    int opened_ = 0;  ///< projectsOpened() of the shown project

    InputColumn* column_ = nullptr;
    QSplitter* splitter_ = nullptr;
    AnswerStrip* answer_ = nullptr;
    PrimaryViews* primaryViews_ = nullptr;
    Value keptPrimary_;  ///< large view stored in the project; none: not chosen
    MessageLine* message_ = nullptr;
    NextPartBar* nextPart_ = nullptr;
    /// Files that took the place of others, until they are read.
    struct Taken {
        std::vector<std::string> paths;
        int step = 0;              ///< index of the undo stack after it
        bool was_current = false;  ///< the shown result is that of the state before
    };
    std::optional<Taken> taken_;
    bool restoring_ = false;        ///< the state before comes back, and its result is still shown
    std::optional<Error> refusal_;  ///< of a file that took no place: the state is as it was
    std::map<std::string, project::Source> takenInputs_;  ///< inputs at the time of nextPart_'s offer
    QStackedWidget* stack_ = nullptr;
    EmptyState* empty_ = nullptr;
    QWidget* viewsPage_ = nullptr;
    Shade* shade_ = nullptr;
    ProgressRow* progress_ = nullptr;
    KindFinder finder_;
    QTimer poll_;
    QElapsedTimer asking_;  ///< time since the newest request
    Worker worker_;         ///< last member: stopped before the others are destroyed
};

}  // namespace lathelier
