#include "widgets/surface/photograph_view.h"

#include <QToolButton>
#include <QVBoxLayout>
#include <QVariant>

#include "engine/core/units.h"
#include "widgets/core/language.h"
#include "widgets/core/panel/flow_row.h"
#include "widgets/core/panel/view_frame.h"

namespace lathelier::surface_panel {
namespace {

constexpr double least_mm = 1e-4, most_mm = 1e5;

}  // namespace

PhotographView::PhotographView(QWidget* parent)
    : QWidget(parent),
      view_(new PictureView),
      bar_(new QWidget),
      tools_(new QButtonGroup(this)),
      whole_(new QPushButton),
      measured_(new QLabel),
      length_(new NumberEdit(least_mm, most_mm)),
      set_(new QPushButton),
      isDiameter_(new QPushButton),
      alike_(new QCheckBox),
      hint_(new QLabel)
{
    view_->setObjectName("surfacePhotograph");
    length_->setObjectName("surfaceLength");
    set_->setObjectName("surfaceSetScale");
    isDiameter_->setObjectName("surfaceIsDiameter");
    whole_->setObjectName("surfaceWhole");
    alike_->setObjectName("surfaceAlike");
    alike_->hide();
    length_->setOptional({});
    length_->setMaximumWidth(fontMetrics().averageCharWidth() * 14);
    bar_->setProperty(ViewFrame::onlyLarge, true);
    auto* row = new FlowRow(bar_);
    const char* names[] = {"toolLook", "toolRegion", "toolLength", "toolDirection"};
    for (int i = 0; i < 4; ++i) {
        auto* button = new QToolButton;
        button->setObjectName(names[i]);
        button->setCheckable(true);
        tools_->addButton(button, i);
        row->addWidget(button);
    }
    tools_->button(0)->setChecked(true);
    for (QWidget* part :
         {static_cast<QWidget*>(whole_), static_cast<QWidget*>(measured_), static_cast<QWidget*>(length_),
          static_cast<QWidget*>(set_), static_cast<QWidget*>(isDiameter_), static_cast<QWidget*>(alike_),
          static_cast<QWidget*>(hint_)})
        row->addWidget(part);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(bar_);
    column->addWidget(view_, 1);
    connect(tools_, &QButtonGroup::idClicked, this, &PhotographView::chooseTool);
    connect(view_, &PictureView::regionDrawn, this, [this](const QRectF& region) { emit regionRequested(region); });
    connect(view_, &PictureView::directionDrawn, this, &PhotographView::directionRequested);
    connect(view_, &PictureView::lengthDrawn, this, &PhotographView::takeLength);
    connect(alike_, &QCheckBox::clicked, this, &PhotographView::alikeRequested);
    connect(whole_, &QPushButton::clicked, this, [this] { emit regionRequested(std::nullopt); });
    const auto send = [this] {
        if (pixels_ > 0 && length_->number()) emit scaleRequested(pixels_, *length_->number());
    };
    connect(set_, &QPushButton::clicked, this, send);
    connect(length_, &QLineEdit::returnPressed, this, send);
    connect(length_, &NumberEdit::numberChanged, this, &PhotographView::showLength);
    connect(isDiameter_, &QPushButton::clicked, this, [this] {
        if (pixels_ > 0 && diameter_mm_) emit scaleRequested(pixels_, *diameter_mm_);
    });
    retranslate();
    chooseTool(0);
}

void PhotographView::setPicture(const QImage& image, double mm_per_px, const std::optional<double>& diameter_mm)
{
    view_->setPicture(image, mm_per_px);
    diameter_mm_ = diameter_mm;
    showLength();
}

void PhotographView::setTools(bool usable)
{
    if (usable == usable_) return;
    usable_ = usable;
    for (const PictureView::Tool tool : {PictureView::Tool::Region, PictureView::Tool::Direction})
        tools_->button(static_cast<int>(tool))->setEnabled(usable);
    tools_->button(0)->setChecked(true);
    chooseTool(0);
}

void PhotographView::setAlike(bool shown, bool alike)
{
    alike_->setVisible(shown);
    alike_->setChecked(alike);
}

void PhotographView::chooseTool(int id)
{
    pixels_ = 0;
    view_->setTool(static_cast<PictureView::Tool>(id));
    showLength();
}

void PhotographView::takeLength(double pixels)
{
    pixels_ = pixels;
    showLength();
    if (usable_) length_->setFocus(Qt::OtherFocusReason);
}

void PhotographView::showLength()
{
    const PictureView::Tool tool = view_->tool();
    const bool measures = tool == PictureView::Tool::Length;
    whole_->setVisible(tool == PictureView::Tool::Region);
    measured_->setVisible(measures && pixels_ > 0);
    for (QWidget* part : {static_cast<QWidget*>(length_), static_cast<QWidget*>(set_)})
        part->setVisible(measures && pixels_ > 0 && usable_);
    isDiameter_->setVisible(measures && pixels_ > 0 && diameter_mm_ && usable_);
    measured_->setText(usable_ ? tr("%1 px are").arg(screenNumber(pixels_, 1)) : QString());
    set_->setEnabled(length_->number().has_value());
    set_->setText(tr("%1: set the scale").arg(screenUnit(unit::mm)));
    length_->setFactor(screenFactor(unit::mm));
    if (diameter_mm_)
        isDiameter_->setText(tr("Ø %1 between the edges").arg(screenQuantity(*diameter_mm_, unit::mm, 2)));
    switch (tool) {
        case PictureView::Tool::None:
        case PictureView::Tool::Point: hint_->clear(); break;
        case PictureView::Tool::Region: hint_->setText(tr("Drag over the part that is to be evaluated")); break;
        case PictureView::Tool::Length:
            hint_->setText(pixels_ > 0 ? QString() : tr("Click both ends of a scale bar, or both edges of the part"));
            break;
        case PictureView::Tool::Direction: hint_->setText(tr("Drag an arrow the way the tool was fed")); break;
    }
}

void PhotographView::retranslate()
{
    const QStringList names{tr("Look"), tr("Region"), tr("Scale"), tr("Direction of feed")};
    const QStringList tips{tr("Wheel zooms, drag moves, double click shows all"),
                           tr("Choose the part of the picture that is evaluated"), tr("State a length by two clicks"),
                           tr("State the direction of feed by an arrow")};
    for (int i = 0; i < names.size(); ++i) {
        tools_->button(i)->setText(names[i]);
        tools_->button(i)->setToolTip(tips[i]);
    }
    whole_->setText(tr("Whole picture"));
    alike_->setText(tr("Both pictures taken alike"));
    alike_->setToolTip(tr("Scale and direction go for both pictures; without the tick for the one that is shown"));
    length_->setAccessibleName(tr("Length between the two clicks"));
    view_->setAccessibleName(tr("Photograph"));
    showLength();
}

}  // namespace lathelier::surface_panel
