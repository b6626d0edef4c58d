// What all panels share: inputs at the left, the answer above the views, progress and exports under them.
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
class HeroViews;
class EmptyState;
class InputColumn;
class MessageLine;
class NextPartBar;
class ProgressRow;
class Shade;

/// The untyped half of Panel<Result> (panel.h). The panel's state is its part of the session's project: every change
/// there, by the user or by undo, asks the worker for a new result; while it computes the old picture stays, dimmed.
class PanelBase : public QWidget {
    Q_OBJECT
public:
    PanelBase(Session& session, const PanelFacts& facts, const PanelInputs& inputs, QWidget* parent = nullptr);
    ~PanelBase() override;

    const PanelFacts& facts() const { return facts_; }
    bool isBusy() const { return poll_.isActive() || finder_.isBusy(); }
    bool hasResult() const { return result_ != nullptr; }
    bool isCurrent() const { return hasResult() && !isBusy() && !stopped_ && !error_; }  ///< it answers what is asked
    const std::optional<Error>& error() const { return error_; }

    /// Gives `paths` to the inputs: empty ones first, in their order. One undo step. Where the panel works on several
    /// kinds of file, their heads are looked at first, in the background.
    void openFiles(const QStringList& paths);
    void openFound(const std::vector<FoundFile>& files);  ///< the same with files whose kind is known
    void askForFiles();                                   ///< openFiles() with a file dialog
    void cancel();
    void recompute();  ///< again, although nothing changed (a file on disk may have)

    /// The panel's part of a report, of the result on screen; nullopt without a result.
    std::optional<report::Document> reportDocument() const;

    /// What the Export menu offers for the result on screen: the panel's own exports, and all numbers as JSON.
    std::vector<PanelExport> offeredExports() const;

    /// Fields, views, exports and findings, as commands.
    std::vector<PanelCommand> commands();

    /// For the last row of a room: the window enlarges the application's font, which type and lines of all views
    /// follow; a panel leaves out what only takes room. Overriders call this one too.
    virtual void setPresenting(bool presenting);

signals:
    /// "Roundness of this section": the user wants this in the panel that takes items of its kind.
    void itemOffered(const std::string& name, const lathelier::project::Item& item, bool synthetic);
    void busyChanged(bool busy);
    void resultShown();
    void messageRaised(const lathelier::Message& message);
    void sampleWanted();
    void reportWanted(const QString& suffix);  ///< the user asked for a report of this panel: "html" or "pdf"

protected:
    Session& session() const { return session_; }
    InputColumn& inputColumn() const { return *column_; }
    const project::PanelState& state() const { return state_; }  ///< of this panel, with all parameters filled in
    const PanelInputs& inputs() const { return inputs_; }

    /// Changes the panel's state in the project: one undo step.
    void editState(const QString& step, const std::function<void(project::PanelState&)>& change,
                   const QString& mergeKey = {});

    /// "Use this shaft": puts what the panel made into the project as the item `name`, in place of an earlier one. One
    /// undo step.
    void keepItem(const std::string& name, const std::string& kind, const Values& values);

    /// Announces itemOffered() with what the panel made; `synthetic`: of data that were made by a program.
    void offerItem(const std::string& name, const std::string& kind, const Values& values, bool synthetic);

    /// The system refused to write a picture or the data of a plot.
    void sayNotWritten(const QString& path);

    /// `views` is all that the panel shows of a result; `heroes`, a part of it, lays out the single views: the window
    /// presents them one by one, and the project keeps which one is large.
    void setViews(QWidget* views, HeroViews* heroes = nullptr);

    virtual Worker::Job makeJob(const project::PanelState& state) const = 0;
    virtual void showValue(std::shared_ptr<const void> result) = 0;
    virtual report::Answer answerOf(const void* result) const = 0;
    virtual Notes notesOf(const void* result) const = 0;
    virtual report::Document documentOf(const void* result) const = 0;
    virtual std::optional<Error> problemOf(const void* result) const = 0;

    /// Marks a place of the answer in the panel's views.
    virtual void showPlace(const report::Place&) {}

    /// What the panel's views show and how, to be kept with the project: colours, scale, camera. PanelBase keeps which
    /// view is large.
    virtual Values view() const { return {}; }

    /// Another project was opened: shows what was kept with it. What is not in `kept` goes back to its default.
    virtual void restoreView(const Values& kept) { (void)kept; }

    /// Everything the panel says in its own views, again, in the language of the screen.
    virtual void retranslate() {}

    /// Ways to write the result to a file, besides its numbers as JSON.
    virtual std::vector<PanelExport> exports() const { return {}; }

    std::vector<Text> missingInputs(const project::PanelState& state) const;
    bool isComplete(const project::PanelState& state) const;  ///< there is enough to compute

    /// Gives files of any kind to the inputs of `state`; by default empty ones first, in their order.
    virtual void assignFiles(project::PanelState& state, const std::vector<FoundFile>& files) const;

    /// Reads what is there of an incomplete state, so that its facts can be shown before the other inputs come.
    virtual Worker::Job makeReadingJob(const project::PanelState& state) const;

    /// What was understood of a file that was read, in the language of the screen; empty when it was not.
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
    void sayNotes(const Notes& notes);
    void refuse(const Error& error);
    void showAnswer();
    void layOutAgain();
    void updateStack();
    void showFacts();
    bool hasInputs() const;
    bool isLate() const;
    void offerOtherRole(const project::PanelState& before);
    void takeSources(const InputRole& role, const std::vector<project::Source>& sources, const QString& step);
    void editParameter(const std::string& key, const Value& value, int gesture, const QString& step);
    void fillExportMenu();
    void runExport(const PanelExport& item);
    void takeOffer(const Values& proposed);

    Session& session_;
    PanelFacts facts_;
    PanelInputs inputs_;
    std::shared_ptr<const void> result_;
    std::optional<Error> error_;
    Notes said_;                 ///< of the last result, in the message log
    bool stopped_ = false;       ///< the newest request was cancelled
    bool again_ = false;         ///< the state has changed since the running request, which is let finish
    project::PanelState state_;  ///< what was asked last
    bool asked_ = false;
    int opened_ = 0;  ///< projectsOpened() of the project whose views are shown

    InputColumn* column_ = nullptr;
    QSplitter* splitter_ = nullptr;
    AnswerStrip* answer_ = nullptr;
    HeroViews* heroes_ = nullptr;
    Value keptHero_;  ///< which view is large by the project; not given: nobody chose one
    MessageLine* message_ = nullptr;
    NextPartBar* nextPart_ = nullptr;
    std::map<std::string, project::Source> takenInputs_;  ///< at the time of nextPart_'s offer
    QStackedWidget* stack_ = nullptr;
    EmptyState* empty_ = nullptr;
    QWidget* viewsPage_ = nullptr;
    Shade* shade_ = nullptr;
    ProgressRow* progress_ = nullptr;
    KindFinder finder_;
    QTimer poll_;
    QElapsedTimer asking_;  ///< since the newest request
    Worker worker_;         ///< last: stopped before anything else goes
};

}  // namespace lathelier
