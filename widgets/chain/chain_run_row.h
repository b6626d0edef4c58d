// The row of Proof that runs the chain: missing or outdated steps on request only, progress and Cancel, report and
// dossier. It inspects the folder of the chain again when a file has changed.
#pragma once

#include <QLabel>
#include <QPointer>
#include <QProgressBar>
#include <QPushButton>
#include <QTimer>
#include <QToolButton>
#include <QWidget>

#include "engine/chain/of_project/project_chain.h"
#include "engine/chain/remanufacture.h"
#include "widgets/core/panel/message.h"
#include "widgets/core/session.h"
#include "widgets/core/task/task.h"

namespace lathelier::chain_panel {

class RunDialog;

class ChainRunRow : public QWidget {
    Q_OBJECT

public:
    explicit ChainRunRow(Session& session, QWidget* parent = nullptr);
    ~ChainRunRow() override;

    const std::shared_ptr<const chain::Dossier>& looked() const { return looked_; }  ///< null: not inspected yet
    bool isLooking() const { return due_.isActive() || look_.isBusy(); }
    bool isRunning() const { return run_.isBusy(); }

    void askToRun();  ///< runs missing and outdated steps after confirmation
    void look();      ///< inspects the folder again, since a file may have changed

    /// Gives the panel of a step the files and parameters of the chain, in one step that can be undone, and asks for
    /// it. What the chain takes from panels becomes its own first, so that they no longer rule its question.
    void openStep(const std::string& step);

signals:
    void lookedAgain(const std::shared_ptr<const lathelier::chain::Dossier>& dossier);
    void panelRequested(const std::string& id);
    void messageRaised(const lathelier::Message& message);

protected:
    void changeEvent(QEvent* event) override;
    void showEvent(QShowEvent* event) override;

private:
    void lookSoon() { due_.start(); }
    void watchFiles();
    void show(const std::shared_ptr<const chain::Dossier>& dossier);
    void run(const chain::AskedChain& asked);
    void reportRun(const chain::ChainQuestion& question, const chain::Dossier& dossier);
    void followProject();
    void showProgress(const Worker::State& state);
    void setRunning(bool running);
    void exportReport();
    void exportDossier();
    void openFolder();
    void retranslate();

    Session& session_;
    QPushButton* start_;
    QWidget* running_;  ///< phase, progress and Cancel
    QLabel* phase_;
    QProgressBar* bar_;
    QPushButton* cancel_;
    QToolButton* more_;
    QAction* report_;
    QAction* dossier_;
    QAction* folder_;
    QPointer<RunDialog> dialog_;
    std::shared_ptr<const chain::Dossier> looked_;
    chain::AskedChain asked_;        ///< question for which looked_ was inspected
    chain::ChainQuestion question_;  ///< the same with the changes of forms
    bool hasDossier_ = false;        ///< the folder of asked_ had a dossier when inspected
    int opened_ = 0;                 ///< projectsOpened() of the shown project
    QTimer due_;
    QTimer turn_;         ///< timer of the check for changed files of the chain
    std::string stamps_;  ///< stamps of the files at the last inspection
    Task watch_;
    Task look_;
    Task run_;
};

}  // namespace lathelier::chain_panel
