#include "widgets/chain/run_dialog.h"

#include <QDialogButtonBox>
#include <QFileDialog>
#include <QHBoxLayout>
#include <QLabel>
#include <QVBoxLayout>

#include "engine/chain/dossier_report.h"
#include "widgets/chain/chain_steps.h"
#include "widgets/core/language.h"

namespace lathelier::chain_panel {
namespace {

bool isToRun(const chain::ChainStep& step)
{
    return step.state == chain::StepState::OutOfDate || step.state == chain::StepState::NotReached ||
           step.state == chain::StepState::Failed;
}

QStringList stepsWithout(const chain::Dossier& looked)
{
    QStringList lines;
    for (const chain::ChainStep& step : looked.steps)
        if (step.state == chain::StepState::Missing && step.error)
            lines << screenText(chain::titleOf(step.id)) + ": " + screenText(*step.error);
    return lines;
}

QLabel* paragraph(const QString& text)
{
    auto* label = new QLabel(text);
    label->setTextFormat(Qt::PlainText);
    label->setWordWrap(true);
    return label;
}

}  // namespace

QStringList stepsToRun(const chain::Dossier& looked)
{
    QStringList lines;
    for (const chain::ChainStep& step : looked.steps)
        if (isToRun(step))
            lines << signOf({step.state, {}}) + " " + screenText(chain::titleOf(step.id)) + " (" +
                         screenText(chain::nameOf(step.state)) + ")";
    return lines;
}

RunDialog::RunDialog(const chain::Dossier& looked, const chain::AskedChain& asked, QWidget* parent)
    : QDialog(parent),
      folder_(new QLineEdit(QString::fromStdString(asked.question.out))),
      elsewhere_(paragraph(tr("In another folder every step runs that has its files."))),
      run_(nullptr),
      lookedFolder_(folder_->text().trimmed())
{
    setObjectName("runChain");
    setWindowTitle(tr("Run the chain"));
    const QStringList steps = stepsToRun(looked), without = stepsWithout(looked);
    hasSteps_ = !steps.isEmpty();
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(paragraph(hasSteps_ ? tr("These steps will run; all others stay as they are:")
                                          : tr("Every step that has its files is done and up to date.")));
    if (hasSteps_) layout->addWidget(paragraph(steps.join("\n")));
    if (!without.isEmpty()) {
        layout->addWidget(paragraph(tr("These lack a file and are left out:")));
        layout->addWidget(paragraph(without.join("\n")));
    }
    folder_->setObjectName("chainFolder");
    folder_->setMinimumWidth(fontMetrics().averageCharWidth() * 60);
    auto* label = new QLabel(tr("&Folder of the chain:"));
    label->setBuddy(folder_);
    auto* choose = new QPushButton(tr("Choose…"));
    choose->setAutoDefault(false);  // Enter runs
    auto* row = new QHBoxLayout;
    row->addWidget(label);
    row->addWidget(folder_, 1);
    row->addWidget(choose);
    layout->addLayout(row);
    elsewhere_->setObjectName("chainElsewhere");
    layout->addWidget(elsewhere_);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel);
    run_ = buttons->addButton(tr("Run"), QDialogButtonBox::AcceptRole);
    run_->setObjectName("runChainNow");
    run_->setDefault(true);
    layout->addWidget(buttons);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    connect(choose, &QPushButton::clicked, this, &RunDialog::chooseFolder);
    connect(folder_, &QLineEdit::textChanged, this, &RunDialog::enableRun);
    enableRun();
}

void RunDialog::chooseFolder()
{
    const QString chosen = QFileDialog::getExistingDirectory(this, tr("Folder of the chain"), folder_->text());
    if (!chosen.isEmpty()) folder_->setText(chosen);
}

void RunDialog::enableRun()
{
    const bool is_elsewhere = folder() != lookedFolder_;
    elsewhere_->setVisible(is_elsewhere);
    run_->setEnabled((hasSteps_ || is_elsewhere) && !folder().isEmpty());
}

}  // namespace lathelier::chain_panel
