// The chain as a strip over the panels of "Copy a part": scan · drawing · machine · speeds · program · deflection ·
// copy · proof. Each step shows its state as text and symbol, its files in the tooltip, and opens its panel. Missing or
// outdated steps are run on request only.
#pragma once

#include <QLabel>
#include <QPointer>
#include <QProgressBar>
#include <QPushButton>
#include <QStackedWidget>
#include <QTimer>
#include <QToolButton>
#include <vector>

#include "engine/chain/of_project/project_chain.h"
#include "engine/chain/remanufacture.h"
#include "widgets/chain/step_tile.h"
#include "widgets/chain/strip_steps.h"
#include "widgets/core/panel/workspace_strip.h"
#include "widgets/core/session.h"
#include "widgets/core/task/task.h"

namespace lathelier::chain_panel {

class RunDialog;
struct StripStep;

class ChainStrip : public WorkspaceStrip {
    Q_OBJECT

public:
    ChainStrip(Session& session, QWidget* parent = nullptr);
    ~ChainStrip() override;

    const std::shared_ptr<const chain::Dossier>& looked() const { return looked_; }  ///< null: not inspected yet
    bool isLooking() const { return due_.isActive() || look_.isBusy(); }
    bool isRunning() const { return run_.isBusy(); }
    StepTile* tile(const std::string& key) const;

    void askToRun();  ///< runs missing and outdated steps after confirmation
    void look();      ///< inspects the folder again, since a file may have changed

protected:
    void changeEvent(QEvent* event) override;
    void showEvent(QShowEvent* event) override;

private:
    void lookSoon() { due_.start(); }
    void openStep(const StripStep& step);
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
    std::vector<StepTile*> tiles_;
    QStackedWidget* stack_;
    QPushButton* start_;
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
