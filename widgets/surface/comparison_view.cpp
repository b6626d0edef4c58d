#include "widgets/surface/comparison_view.h"

#include <QHBoxLayout>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <QVariant>
#include <algorithm>
#include <cmath>

#include "widgets/core/panel/view_frame.h"

namespace lathelier::surface_panel {
namespace {

constexpr int sharePlaces = 1000;  // of the slider

QWidget* withName(QLabel* name, PictureView* view)
{
    auto* side = new QWidget;
    auto* column = new QVBoxLayout(side);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(2);
    name->setAlignment(Qt::AlignCenter);
    name->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    name->setProperty(ViewFrame::onlyLarge, true);
    column->addWidget(name);
    column->addWidget(view, 1);
    return side;
}

}  // namespace

ComparisonView::ComparisonView(QWidget* parent)
    : QWidget(parent),
      before_(new PictureView),
      after_(new PictureView),
      beforeName_(new QLabel),
      afterName_(new QLabel),
      alignment_(new QLabel),
      slider_(new QSlider(Qt::Horizontal)),
      magnifier_(new QToolButton),
      lay_(new QToolButton),
      ways_(new QButtonGroup(this))
{
    before_->setObjectName("surfaceBefore");
    after_->setObjectName("surfaceAfter");
    slider_->setObjectName("surfaceSlider");
    slider_->setRange(0, sharePlaces);
    beforeSide_ = withName(beforeName_, before_);
    afterSide_ = withName(afterName_, after_);
    before_->link(after_);
    auto* bar = new QWidget;
    bar->setProperty(ViewFrame::onlyLarge, true);
    auto* row = new QHBoxLayout(bar);
    row->setContentsMargins(0, 0, 0, 0);
    for (int i = 0; i < 2; ++i) {
        auto* button = new QToolButton;
        button->setObjectName(i == 0 ? "sideBySide" : "underSlider");
        button->setCheckable(true);
        ways_->addButton(button, i);
        row->addWidget(button);
    }
    magnifier_->setObjectName("surfaceMagnifier");
    lay_->setObjectName("surfaceLay");
    for (QToolButton* button : {magnifier_, lay_}) {
        button->setCheckable(true);
        row->addWidget(button);
    }
    row->addWidget(slider_, 1);
    alignment_->setWordWrap(true);
    alignment_->setProperty(ViewFrame::onlyLarge, true);
    auto* pictures = new QHBoxLayout;
    pictures->setSpacing(6);
    pictures->addWidget(beforeSide_, 1);
    pictures->addWidget(afterSide_, 1);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(bar);
    column->addWidget(alignment_);
    column->addLayout(pictures, 1);
    connect(ways_, &QButtonGroup::idClicked, this, [this](int id) { setSlides(id == 1); });
    connect(magnifier_, &QToolButton::toggled, this, [this](bool on) {
        for (PictureView* view : {before_, after_}) view->setMagnifier(on);
    });
    connect(lay_, &QToolButton::toggled, this, &ComparisonView::lay);
    connect(before_, &PictureView::pointChosen, this, [this](const QPointF& pixel) { takePoint(true, pixel); });
    connect(after_, &PictureView::pointChosen, this, [this](const QPointF& pixel) { takePoint(false, pixel); });
    connect(slider_, &QSlider::valueChanged, this, [this](int value) { setShare(double(value) / sharePlaces); });
    for (PictureView* view : {before_, after_})
        connect(view, &plot::PlotWidget::notWritten, this, &ComparisonView::notWritten);
    retranslate();
    arrange();
}

void ComparisonView::setPictures(const QImage& before, const QImage& after, double mm_per_px)
{
    first_ = before;
    second_ = after;
    mm_per_px_ = mm_per_px;
    arrange();
}

void ComparisonView::setNames(const QString& before, const QString& after, const QString& alignment)
{
    beforeName_->setText(before);
    beforeName_->setToolTip(before);
    afterName_->setText(after);
    afterName_->setToolTip(after);
    alignment_->setText(alignment);
}

/// One place is clicked in both pictures, which stand side by side for it.
void ComparisonView::lay(bool on)
{
    placeBefore_.reset();
    placeAfter_.reset();
    if (on && slides_) setSlides(false);
    for (PictureView* view : {before_, after_}) view->setTool(on ? PictureView::Tool::Point : PictureView::Tool::None);
}

void ComparisonView::takePoint(bool first, const QPointF& pixel)
{
    (first ? placeBefore_ : placeAfter_) = pixel;
    if (!placeBefore_ || !placeAfter_) return;
    const QPointF further = *placeAfter_ - *placeBefore_;
    lay_->setChecked(false);
    emit layRequested(further);
}

void ComparisonView::setSlides(bool slides)
{
    slides_ = slides;
    if (slides_) lay_->setChecked(false);
    arrange();
}

void ComparisonView::setShare(double share)
{
    share_ = std::clamp(share, 0.0, 1.0);
    arrange();
}

void ComparisonView::arrange()
{
    const QSignalBlocker quiet(slider_);
    slider_->setValue(static_cast<int>(std::lround(share_ * sharePlaces)));
    slider_->setEnabled(slides_);
    ways_->button(slides_ ? 1 : 0)->setChecked(true);
    afterSide_->setVisible(!slides_);
    beforeName_->setText(beforeName_->toolTip() +
                         (slides_ ? QStringLiteral("  |  ") + afterName_->toolTip() : QString()));
    before_->setPicture(first_, mm_per_px_);
    before_->setSecond(slides_ ? second_ : QImage(), share_);
    after_->setPicture(second_, mm_per_px_);
}

void ComparisonView::retranslate()
{
    ways_->button(0)->setText(tr("Side by side"));
    ways_->button(0)->setToolTip(tr("Both pictures; zoom and place are the same in both"));
    ways_->button(1)->setText(tr("Slider"));
    ways_->button(1)->setToolTip(tr("One picture over the other, parted where the slider stands"));
    magnifier_->setText(tr("Magnifier"));
    magnifier_->setToolTip(tr("Shows the same place of both pictures four times as large"));
    lay_->setText(tr("Lay over"));
    lay_->setToolTip(tr("Click one place, such as a shoulder, in both pictures: they are laid over each other there"));
    slider_->setAccessibleName(tr("Where before ends and after begins"));
    slider_->setToolTip(slider_->accessibleName());
    before_->setAccessibleName(tr("Before"));
    after_->setAccessibleName(tr("After"));
}

}  // namespace lathelier::surface_panel
