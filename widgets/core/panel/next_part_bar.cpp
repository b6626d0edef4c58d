#include "widgets/core/panel/next_part_bar.h"

#include <QHBoxLayout>
#include <QToolButton>

#include "widgets/core/panel/message_line.h"

namespace lathelier {

NextPartBar::NextPartBar(QWidget* parent)
    : QFrame(parent), text_(new WrappingLabel("nextPart")), use_(new QToolButton), close_(new QToolButton)
{
    setObjectName("nextPartBar");
    setFrameShape(QFrame::StyledPanel);
    setAutoFillBackground(true);
    setBackgroundRole(QPalette::AlternateBase);
    use_->setObjectName("useAsOther");
    close_->setObjectName("closeNextPart");
    close_->setAutoRaise(true);
    close_->setText(QStringLiteral("×"));
    auto* layout = new QHBoxLayout(this);
    layout->addWidget(text_, 1);
    layout->addWidget(use_);
    layout->addWidget(close_);
    connect(use_, &QToolButton::clicked, this, [this] {
        hide();
        emit otherRequested();
    });
    connect(close_, &QToolButton::clicked, this, &QWidget::hide);
    hide();
}

void NextPartBar::offer(const QString& file, const QString& taken, const QString& other)
{
    text_->say(tr("“%1” is the next part: it took the place of “%2”, everything else stays.").arg(file, taken));
    use_->setText(tr("Use as “%1” instead").arg(other));
    close_->setToolTip(tr("Leave it so"));
    close_->setAccessibleName(close_->toolTip());
    show();
}

}  // namespace lathelier
