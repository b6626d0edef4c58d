// Confirmation before the chain runs: steps, missing files, output folder.
#pragma once

#include <QDialog>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <memory>

#include "engine/chain/dossier.h"
#include "engine/chain/of_project/project_chain.h"

namespace lathelier::chain_panel {

class RunDialog : public QDialog {
    Q_OBJECT

public:
    RunDialog(const chain::Dossier& looked, const chain::AskedChain& asked, QWidget* parent);

    QString folder() const { return folder_->text().trimmed(); }

private:
    void chooseFolder();
    void enableRun();

    QLineEdit* folder_;
    QLabel* elsewhere_;
    QPushButton* run_;
    QString lookedFolder_;
    bool hasSteps_ = false;
};

/// Titles of the steps to be run, one per line with its state.
QStringList stepsToRun(const chain::Dossier& looked);

}  // namespace lathelier::chain_panel
