#include "widgets/trajectory_common/section_bar.h"

#include <QEvent>
#include <QHBoxLayout>
#include <cmath>
#include <utility>

#include "widgets/core/icons.h"
#include "widgets/core/language.h"

namespace lathelier::trajectory_common {
namespace {

constexpr int frame_ms = 40;
constexpr double turn_s = 6;  // slow enough to follow with the eye

QToolButton* tool(const char* name, const QString& text)
{
    auto* button = new QToolButton;
    button->setObjectName(name);
    button->setText(text);
    button->setAutoRaise(true);
    button->setFocusPolicy(Qt::StrongFocus);
    return button;
}

}  // namespace

SectionBar::SectionBar(QWidget* parent)
    : QWidget(parent),
      before_(tool("sectionBefore", QStringLiteral("◀"))),
      box_(new QComboBox),
      after_(tool("sectionAfter", QStringLiteral("▶"))),
      worst_(tool("sectionWorst", {}))
{
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(2);
    box_->setObjectName("section");
    box_->setSizeAdjustPolicy(QComboBox::AdjustToContents);
    worst_->setCheckable(true);
    for (QWidget* part : {static_cast<QWidget*>(before_), static_cast<QWidget*>(box_), static_cast<QWidget*>(after_),
                          static_cast<QWidget*>(worst_)})
        row->addWidget(part);
    connect(before_, &QToolButton::clicked, this, [this] { step(-1); });
    connect(after_, &QToolButton::clicked, this, [this] { step(1); });
    connect(box_, qOverload<int>(&QComboBox::activated), this,
            [this](int index) { step(index - static_cast<int>(index_)); });
    connect(worst_, &QToolButton::clicked, this, [this](bool on) {
        if (!result_) return;
        emit sectionRequested(on ? std::nullopt : std::optional(result_->sections[index_].section));
    });
    retranslate();
    hide();
}

void SectionBar::setSections(const std::shared_ptr<const trajectory::TrajectoryResult>& result,
                             std::optional<std::size_t> index, bool chosen)
{
    const bool there = result && index;
    if (there) {
        index_ = *index;
        if (std::exchange(result_, result) != result) fill();
    }
    setVisible(there);
    if (!there) return;
    box_->setCurrentIndex(static_cast<int>(index_));
    before_->setEnabled(index_ > 0);
    after_->setEnabled(index_ + 1 < result_->sections.size());
    worst_->setChecked(!chosen);
}

void SectionBar::fill()
{
    box_->clear();
    if (!result_) return;
    for (const trajectory::TrajectorySection& section : result_->sections) {
        QString text = tr("Section %1 of %2").arg(section.section).arg(result_->sections.size());
        if (std::isfinite(section.z_mm)) text += tr(" · z %1").arg(screenQuantity(section.z_mm, millimetre, 1));
        box_->addItem(text);
    }
    box_->setCurrentIndex(static_cast<int>(index_));
    box_->setMinimumWidth(box_->sizeHint().width());
}

void SectionBar::step(int by)
{
    if (!result_) return;
    const auto wanted = static_cast<std::size_t>(static_cast<std::ptrdiff_t>(index_) + by);
    if (wanted < result_->sections.size()) emit sectionRequested(result_->sections[wanted].section);
}

void SectionBar::retranslate()
{
    const auto name = [](QWidget* widget, const QString& text) {
        widget->setToolTip(text);
        widget->setAccessibleName(text);
    };
    name(before_, tr("The section before"));
    name(after_, tr("The next section"));
    name(box_, tr("The section that all panels of Roundness show"));
    worst_->setText(tr("worst"));
    name(worst_, tr("Always the section with the largest roundness deviation"));
    fill();
}

void SectionBar::changeEvent(QEvent* event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange) retranslate();
}

AngleBar::AngleBar(MarkedAngle& angle, QWidget* parent)
    : QWidget(parent), angle_(angle), play_(tool("play", {})), slider_(new QSlider(Qt::Horizontal)), text_(new QLabel)
{
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    play_->setCheckable(true);
    play_->setIcon(icon("play"));
    slider_->setObjectName("angle");
    slider_->setRange(0, 3599);
    slider_->setPageStep(150);
    slider_->setSingleStep(18);
    slider_->setMinimumWidth(fontMetrics().height() * 5);
    text_->setMinimumWidth(fontMetrics().horizontalAdvance("000.0°") + 4);
    row->addWidget(play_);
    row->addWidget(slider_);
    row->addWidget(text_);
    timer_.setInterval(frame_ms);
    connect(play_, &QToolButton::toggled, this, &AngleBar::play);
    connect(&timer_, &QTimer::timeout, this,
            [this] { angle_.set(std::fmod(angle_.angle_deg().value_or(0) + 360 * frame_ms / 1000.0 / turn_s, 360)); });
    connect(slider_, &QSlider::sliderMoved, this, [this](int value) { angle_.set(value / 10.0); });
    connect(slider_, &QSlider::actionTriggered, this, [this] { angle_.set(slider_->sliderPosition() / 10.0); });
    connect(&angle_, &MarkedAngle::changed, this, &AngleBar::showAngle);
    retranslate();
    showAngle();
}

void AngleBar::play(bool on)
{
    play_->setIcon(icon(on ? "pause" : "play"));
    if (on)
        timer_.start();
    else
        timer_.stop();
}

void AngleBar::showAngle()
{
    const double angle = angle_.angle_deg().value_or(0);
    slider_->setValue(static_cast<int>(std::lround(angle * 10)));
    text_->setText(angle_.angle_deg() ? screenNumber(angle, 1) + "°" : QStringLiteral("–"));
}

void AngleBar::hideEvent(QHideEvent* event)
{
    QWidget::hideEvent(event);
    play_->setChecked(false);
}

void AngleBar::retranslate()
{
    play_->setToolTip(tr("Play: run around the part by angle"));
    play_->setAccessibleName(play_->toolTip());
    slider_->setToolTip(tr("Marked angle on the part"));
    slider_->setAccessibleName(slider_->toolTip());
    showAngle();
}

void AngleBar::changeEvent(QEvent* event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange) retranslate();
}

}  // namespace lathelier::trajectory_common
