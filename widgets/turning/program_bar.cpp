#include "widgets/turning/program_bar.h"

#include <QVBoxLayout>

#include "engine/cam/plan_outcome.h"
#include "widgets/core/language.h"
#include "widgets/core/panel/flow_row.h"

namespace lathelier::turning_panel {
namespace {

constexpr int digestDigits = 12;

}  // namespace

ProgramBar::ProgramBar(QWidget* parent)
    : QWidget(parent), state_(new QLabel), check_(new QToolButton), takeBack_(new QToolButton), use_(new QToolButton)
{
    state_->setObjectName("turningState");
    check_->setObjectName("turningCheck");
    takeBack_->setObjectName("turningTakeBack");
    use_->setObjectName("turningUse");
    state_->setWordWrap(true);
    auto* row = new FlowRow;
    for (QToolButton* button : {use_, check_, takeBack_}) row->addWidget(button);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(2);
    column->addWidget(state_);
    column->addLayout(row);
    connect(check_, &QToolButton::clicked, this, &ProgramBar::checkRequested);
    connect(takeBack_, &QToolButton::clicked, this, &ProgramBar::takeBackRequested);
    connect(use_, &QToolButton::clicked, this, &ProgramBar::useRequested);
}

void ProgramBar::setOutcome(const cam::TurningOutcome& outcome, std::size_t setup)
{
    const cam::ShownProgram& program = outcome.programs[setup];
    const cam::CheckResult& check = outcome.plan->setups[setup].check;
    const bool is_sound = isSound(outcome, setup);
    QString of = program.origin == cam::ProgramOrigin::Planned ? tr("planned")
                 : program.origin == cam::ProgramOrigin::Corrected
                     ? tr("compensated")
                     : screenFileName(QString::fromStdString(program.name));
    if (program.is_changed) of = tr("%1, changed by hand").arg(of);
    const QString state = program.is_void           ? tr("? Check void: the text was changed after it")
                          : check.path.has_errors   ? tr("✗ The program has errors")
                          : !check.stock            ? tr("? Not checked: the program before it is not")
                          : is_sound                ? tr("✓ %1, checked").arg(of)
                          : !check.findings.empty() ? tr("✗ %1, findings: %2").arg(of).arg(check.findings.size())
                          : cam::unknownToolOf(check) != 0
                              ? tr("? %1: a tool is not in the job, what it cuts is not checked").arg(of)
                              : tr("✗ %1: cuts into the drawing").arg(of);
    const QString digest = QString::fromStdString(program.sha256);
    state_->setText(QString("%1 · SHA-256 %2").arg(state, digest.left(digestDigits)));
    state_->setToolTip("SHA-256 " + digest);
    check_->setVisible(program.is_void);
    takeBack_->setVisible(program.is_changed);
    use_->setEnabled(is_sound);
    use_->setToolTip(is_sound ? tr("Hands it to the panels Deflection, Correction and Program, with its bar")
                              : tr("Only a program that was checked and has no findings is handed on"));
}

void ProgramBar::retranslate()
{
    check_->setText(tr("Check again"));
    check_->setToolTip(tr("Checks the text as it stands here against drawing, stock and chuck"));
    takeBack_->setText(tr("Take back changes"));
    takeBack_->setToolTip(tr("The program as it was before it was changed by hand"));
    use_->setText(tr("Use this program"));
}

}  // namespace lathelier::turning_panel
