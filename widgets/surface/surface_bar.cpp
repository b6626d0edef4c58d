#include "widgets/surface/surface_bar.h"

#include <QButtonGroup>
#include <QHBoxLayout>
#include <QToolButton>
#include <algorithm>

#include "engine/core/units.h"
#include "widgets/core/language.h"
#include "widgets/core/panel/flow_row.h"

namespace lathelier::surface_panel {
namespace {

constexpr std::size_t mostCandidates = 5;

}  // namespace

SurfaceBar::SurfaceBar(QWidget* parent)
    : QWidget(parent),
      images_(new QButtonGroup(this)),
      candidates_(new QWidget),
      send_(new QPushButton),
      synthetic_(new QLabel)
{
    send_->setObjectName("surfaceSend");
    auto* row = new FlowRow(this);
    for (int i = 0; i < 2; ++i) {
        auto* button = new QToolButton;
        button->setObjectName(i == 0 ? "showBefore" : "showAfter");
        button->setCheckable(true);
        images_->addButton(button, i);
        row->addWidget(button);
    }
    auto* chips = new QHBoxLayout(candidates_);
    chips->setContentsMargins(0, 0, 0, 0);
    chips->setSpacing(4);
    row->addWidget(candidates_);
    row->addWidget(send_);
    synthetic_->setFrameShape(QFrame::Box);
    synthetic_->setMargin(2);
    row->setTrailing(synthetic_);
    connect(images_, &QButtonGroup::idClicked, this, &SurfaceBar::imageChosen);
    connect(send_, &QPushButton::clicked, this, &SurfaceBar::sendRequested);
    retranslate();
}

void SurfaceBar::setOutcome(const ShownOutcome& outcome, int chosen)
{
    const bool two = outcome.shown.size() > 1;
    for (int i = 0; i < 2; ++i) {
        auto* button = images_->button(i);
        button->setVisible(two);
        button->setChecked(i == chosen);
        if (two) button->setToolTip(QString::fromStdString(outcome.shown[static_cast<std::size_t>(i)].name));
    }
    showCandidates(outcome);
    send_->setVisible(outcome.marks.has_value() && !outcome.asks());
    if (outcome.marks)
        send_->setText(tr("Send %1 to the lobe chart").arg(screenQuantity(outcome.marks->frequency_hz, unit::hz, 1)));
    synthetic_->setVisible(outcome.sources.synthetic);
}

/// One button for each reading that the picture leaves open.
void SurfaceBar::showCandidates(const ShownOutcome& outcome)
{
    for (QWidget* chip : candidates_->findChildren<QWidget*>(QString(), Qt::FindDirectChildrenOnly)) {
        chip->hide();
        chip->setObjectName({});
        chip->deleteLater();
    }
    const surface::ImageMarks* const first = outcome.result ? &outcome.first() : nullptr;
    const bool open =
        !outcome.asks() && first && first->chatter_marks && first->chatter_marks->candidates_hz.size() > 1;
    candidates_->setVisible(open);
    if (!open) return;
    const std::vector<double>& all = first->chatter_marks->candidates_hz;
    for (std::size_t i = 0; i < std::min(mostCandidates, all.size()); ++i) {
        const double hz = all[i];
        auto* chip = new QToolButton;
        chip->setObjectName(QString("candidate%1").arg(i));
        chip->setText(screenQuantity(hz, unit::hz, 1));
        chip->setCheckable(true);
        chip->setChecked(i == 0);
        chip->setToolTip(i == 0 ? tr("The reading that is used") : tr("Use this reading of the marks"));
        candidates_->layout()->addWidget(chip);
        connect(chip, &QToolButton::clicked, this, [this, hz] { emit candidateRequested(hz); });
    }
}

void SurfaceBar::retranslate()
{
    images_->button(0)->setText(tr("Before"));
    images_->button(1)->setText(tr("After"));
    send_->setToolTip(tr("The panel Lobes marks the speed, and the frequency over it"));
    synthetic_->setText(tr("Synthetic data"));
}

}  // namespace lathelier::surface_panel
