#include "widgets/turning/tool_scrubber.h"

#include <QHBoxLayout>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <algorithm>

#include "widgets/core/icons.h"

namespace lathelier::turning_panel {
namespace {

constexpr int pause_ms = 33;
constexpr int frames = 600;  // for the whole program

}  // namespace

ToolScrubber::ToolScrubber(QWidget* parent)
    : QWidget(parent),
      clampings_(new QButtonGroup(this)),
      play_(new QToolButton),
      slider_(new QSlider(Qt::Horizontal)),
      where_(new QLabel)
{
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    auto* row = new QHBoxLayout;
    column->addLayout(row);
    for (int i = 0; i < 2; ++i) {
        auto* button = new QToolButton;
        button->setObjectName(QString("clamping%1").arg(i + 1));
        button->setCheckable(true);
        clampings_->addButton(button, i);
        row->addWidget(button);
    }
    play_->setObjectName("turningPlay");
    play_->setAutoRaise(true);
    row->addWidget(play_);
    slider_->setObjectName("turningScrubber");
    slider_->setRange(0, places);
    slider_->setPageStep(places / 40);
    slider_->setValue(places);
    row->addWidget(slider_, 1);
    where_->setObjectName("turningWhere");
    where_->setMinimumWidth(1);  // long text must not widen the panel
    column->addWidget(where_);
    playing_.setInterval(pause_ms);
    connect(clampings_, &QButtonGroup::idClicked, this, &ToolScrubber::clampingChosen);
    connect(slider_, &QSlider::valueChanged, this, &ToolScrubber::moved);
    connect(slider_, &QSlider::sliderPressed, this, [this] { setPlaying(false); });
    connect(play_, &QToolButton::clicked, this, [this] { setPlaying(!playing_.isActive()); });
    connect(&playing_, &QTimer::timeout, this, [this] {
        slider_->setValue(std::min(places, slider_->value() + places / frames));
        if (slider_->value() == places) setPlaying(false);
    });
    setClampings(1, 0);
    retranslate();
}

void ToolScrubber::setPlace(int place)
{
    const QSignalBlocker quiet(slider_);
    slider_->setValue(place);
}

void ToolScrubber::setClampings(std::size_t count, std::size_t shown)
{
    for (QAbstractButton* button : clampings_->buttons()) button->setVisible(count > 1);
    clampings_->button(static_cast<int>(shown))->setChecked(true);
}

void ToolScrubber::setPlaying(bool playing)
{
    if (playing && slider_->value() == places) slider_->setValue(0);
    if (playing)
        playing_.start();
    else
        playing_.stop();
    play_->setIcon(icon(playing ? "pause" : "play"));
    play_->setToolTip(playing ? tr("Pause") : tr("Play the program"));
}

void ToolScrubber::retranslate()
{
    clampings_->button(0)->setText(tr("Clamping 1"));
    clampings_->button(1)->setText(tr("Clamping 2"));
    play_->setAccessibleName(tr("Play the program"));
    slider_->setAccessibleName(tr("Place along the program"));
    slider_->setToolTip(tr("Place along the program: the tool moves, the stock is as it is by then"));
    setPlaying(playing_.isActive());
}

}  // namespace lathelier::turning_panel
