#include "app/gui/verify_dialog.h"

#include <QEvent>
#include <QFileDialog>
#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QVBoxLayout>

#include "engine/verify/verify_report.h"
#include "widgets/core/language.h"
#include "widgets/core/panel/copy_table.h"
#include "widgets/core/report/report_files.h"

namespace lathelier {

VerifyDialog::VerifyDialog(QWidget* parent)
    : QDialog(parent),
      headline_(new QLabel),
      about_(new QLabel),
      table_(new CopyTable),
      bar_(new QProgressBar),
      report_(new QPushButton),
      close_(new QPushButton)
{
    setObjectName("verifyDialog");
    headline_->setObjectName("verifyHeadline");
    QFont large = headline_->font();
    large.setPointSizeF(large.pointSizeF() * 1.5);
    large.setBold(true);
    headline_->setFont(large);
    for (QLabel* label : {headline_, about_}) label->setWordWrap(true);
    table_->setObjectName("verifyTable");
    bar_->setRange(0, 1000);
    report_->setEnabled(false);
    close_->setDefault(true);
    auto* buttons = new QHBoxLayout;
    buttons->addWidget(bar_, 1);
    buttons->addStretch();
    buttons->addWidget(report_);
    buttons->addWidget(close_);
    auto* layout = new QVBoxLayout(this);
    layout->setSpacing(10);
    layout->addWidget(headline_);
    layout->addWidget(about_);
    layout->addWidget(table_, 1);
    layout->addLayout(buttons);
    connect(close_, &QPushButton::clicked, this, &QDialog::accept);
    connect(report_, &QPushButton::clicked, this, &VerifyDialog::writeReportFile);
    resize(fontMetrics().averageCharWidth() * 105, fontMetrics().height() * 32);
    retranslate();

    connect(&task_, &Task::progressed, this,
            [this](const Worker::State& state) { bar_->setValue(static_cast<int>(state.fraction * 1000)); });
    task_.compute<verify::VerifyResult>(
        [](const Progress& progress) { return verify::verify(verify::verifyParts(), {}, progress); },
        [this](const verify::VerifyResult& found) {
            bar_->hide();
            result_ = std::make_shared<const verify::VerifyResult>(found);
            showResult();
        },
        [this](const Error& error) {
            bar_->hide();
            headline_->setText(screenText(error));
        });
}

void VerifyDialog::showResult()
{
    if (!result_) return;
    headline_->setText(QString::fromStdString(report::sentenceText(answer(*result_), screenLanguage())));
    table_->setTable(verify::verifyTable(*result_));
    report_->setEnabled(true);
}

void VerifyDialog::writeReportFile()
{
    const QString path = QFileDialog::getSaveFileName(this, tr("Write the report"), "verify.html",
                                                      tr("HTML (*.html)") + ";;" + tr("PDF (*.pdf)"));
    if (path.isEmpty()) return;
    try {
        writeReport(path, verify::verifyReport(*result_));
    } catch (const Error& error) {
        about_->setText(screenText(error));
    }
}

void VerifyDialog::retranslate()
{
    setWindowTitle(tr("Verify installation"));
    about_->setText(
        tr("Reference data with known answers are computed on this computer. The largest deviation of each kind has to "
           "stay below its limit."));
    if (!result_) headline_->setText(tr("Computing…"));
    table_->setAccessibleName(tr("Kinds of reference data"));
    report_->setText(tr("Report…"));
    close_->setText(tr("Close"));
    showResult();
}

void VerifyDialog::changeEvent(QEvent* event)
{
    QDialog::changeEvent(event);
    if (event->type() == QEvent::LanguageChange) retranslate();
}

void VerifyDialog::done(int answer)
{
    task_.cancel();
    QDialog::done(answer);
}

}  // namespace lathelier
