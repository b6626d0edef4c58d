#include "widgets/core/task/progress_row.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QMenu>
#include <QPainter>
#include <QVBoxLayout>

#include "widgets/core/icons.h"
#include "widgets/core/language.h"

namespace lathelier {

EmptyState::EmptyState(QWidget* parent)
    : QWidget(parent), sentence_(new QLabel), missing_(new QLabel), open_(new QPushButton), sample_(new QPushButton)
{
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(48, 48, 48, 48);
    layout->setSpacing(18);
    for (QLabel* label : {sentence_, missing_}) {
        label->setAlignment(Qt::AlignCenter);
        label->setWordWrap(true);
    }
    QFont large = sentence_->font();
    large.setPointSizeF(large.pointSizeF() * 1.4);
    sentence_->setFont(large);
    open_->setObjectName("open");
    open_->setIcon(icon("open"));
    open_->setDefault(true);
    sample_->setObjectName("openSample");
    sample_->setIcon(icon("sample"));
    auto* buttons = new QHBoxLayout;
    buttons->addStretch();
    buttons->addWidget(open_);
    buttons->addWidget(sample_);
    buttons->addStretch();
    layout->addStretch();
    layout->addWidget(sentence_);
    layout->addWidget(missing_);
    layout->addLayout(buttons);
    layout->addStretch();
    connect(open_, &QPushButton::clicked, this, &EmptyState::openRequested);
    connect(sample_, &QPushButton::clicked, this, &EmptyState::sampleRequested);
    retranslate();
}

void EmptyState::setInvitation(const QString& sentence, const QString& missing)
{
    invitation_ = sentence;
    missing_->setText(missing);
    refresh();
}

void EmptyState::setWaiting(bool waiting)
{
    waiting_ = waiting;
    refresh();
}

void EmptyState::refresh()
{
    sentence_->setText(waiting_ ? tr("Computing…") : invitation_);
    missing_->setVisible(!waiting_ && !missing_->text().isEmpty());
    for (QPushButton* button : {open_, sample_}) button->setVisible(!waiting_);
}

void EmptyState::retranslate()
{
    open_->setText(tr("Open…"));
    sample_->setText(tr("Open the sample"));
    refresh();
}

void EmptyState::changeEvent(QEvent* event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange) retranslate();
}

void EmptyState::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    QPen pen(palette().color(QPalette::Mid), 2, Qt::DashLine);
    painter.setPen(pen);
    painter.drawRoundedRect(QRectF(rect()).adjusted(12, 12, -12, -12), 12, 12);
}

ProgressRow::ProgressRow(QWidget* parent)
    : QWidget(parent),
      phase_(new QLabel),
      bar_(new QProgressBar),
      cancel_(new QPushButton),
      export_(new QToolButton),
      exportMenu_(new QMenu(this)),
      inReport_(new QToolButton),
      report_(new QToolButton)
{
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    phase_->setObjectName("phase");
    bar_->setObjectName("progress");
    bar_->setRange(0, 1000);
    bar_->setTextVisible(false);
    cancel_->setObjectName("cancel");
    cancel_->setIcon(icon("stop"));
    layout->addWidget(bar_, 2);
    layout->addWidget(phase_, 3);
    layout->addWidget(cancel_);
    layout->addSpacing(12);
    export_->setObjectName("export");
    export_->setIcon(icon("export"));
    export_->setMenu(exportMenu_);
    export_->setPopupMode(QToolButton::InstantPopup);
    inReport_->setObjectName("inReport");
    inReport_->setIcon(icon("add_report"));
    inReport_->setCheckable(true);
    report_->setObjectName("report");
    report_->setIcon(icon("report"));
    for (QToolButton* button : {inReport_, report_, export_}) {
        button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
        button->setFocusPolicy(Qt::StrongFocus);
        layout->addWidget(button);
    }
    connect(cancel_, &QPushButton::clicked, this, &ProgressRow::cancelRequested);
    connect(inReport_, &QToolButton::clicked, this, &ProgressRow::addToReportToggled);
    auto* reportMenu = new QMenu(this);
    html_ = reportMenu->addAction(QString(), this, [this] { emit reportRequested("html"); });
    pdf_ = reportMenu->addAction(QString(), this, [this] { emit reportRequested("pdf"); });
    report_->setMenu(reportMenu);
    report_->setPopupMode(QToolButton::InstantPopup);
    retranslate();
    showState({});
    setResultThere(false);
}

void ProgressRow::showState(const Worker::State& state)
{
    bar_->setVisible(state.busy);
    cancel_->setVisible(state.busy);
    cancel_->setEnabled(!state.stopping);
    bar_->setValue(static_cast<int>(state.fraction * 1000));
    if (!state.busy)
        phase_->clear();
    else
        phase_->setText(state.stopping        ? tr("Stopping…")
                        : state.stage.empty() ? tr("Computing…")
                                              : screenText(state.stage));
}

void ProgressRow::setResultThere(bool there)
{
    for (QToolButton* button : {inReport_, report_, export_}) button->setEnabled(there);
}

void ProgressRow::setInReport(bool in)
{
    inReport_->setChecked(in);
}

void ProgressRow::retranslate()
{
    bar_->setAccessibleName(tr("Progress"));
    cancel_->setText(tr("Cancel"));
    export_->setText(tr("Export"));
    export_->setToolTip(tr("Save pictures and data of this result"));
    inReport_->setText(tr("In the report"));
    inReport_->setToolTip(tr("Make this result part of the project's report"));
    report_->setText(tr("Report"));
    html_->setText(tr("HTML report…"));
    pdf_->setText(tr("PDF report…"));
    report_->setToolTip(tr("Write a report of this result"));
}

void ProgressRow::changeEvent(QEvent* event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange) retranslate();
}

Shade::Shade(QWidget* covered) : QWidget(covered)
{
    setAttribute(Qt::WA_TransparentForMouseEvents);
    setFocusPolicy(Qt::NoFocus);
    covered->installEventFilter(this);
    hide();
}

bool Shade::eventFilter(QObject*, QEvent* event)
{
    if (event->type() == QEvent::Resize || event->type() == QEvent::Show) {
        setGeometry(parentWidget()->rect());
        raise();
    }
    return false;
}

void Shade::paintEvent(QPaintEvent*)
{
    QColor veil = palette().color(QPalette::Window);
    veil.setAlphaF(0.55);
    QPainter(this).fillRect(rect(), veil);
}

}  // namespace lathelier
