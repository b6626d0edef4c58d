#include "widgets/training/transport_bar.h"

#include <QHBoxLayout>
#include <QLocale>
#include <QPainter>
#include <algorithm>
#include <cmath>

#include "widgets/core/icons.h"
#include "widgets/training/sound_player.h"

namespace lathelier::training_panel {

/// A bar as long as the sound is loud.
class SoundMeter : public QWidget {
public:
    explicit SoundMeter(QWidget* parent = nullptr) : QWidget(parent) { setObjectName("meter"); }
    void setLevel(double level)
    {
        level_ = level;
        update();
    }
    QSize sizeHint() const override { return {6 * fontMetrics().height(), fontMetrics().height() / 2}; }
    QSize minimumSizeHint() const override { return {2 * fontMetrics().height(), fontMetrics().height() / 2}; }

protected:
    void paintEvent(QPaintEvent*) override
    {
        QPainter painter(this);
        const QRectF all = QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5);
        painter.fillRect(QRectF(all.left(), all.top(), all.width() * std::min(1.0, level_), all.height()),
                         palette().highlight());
        painter.setPen(palette().mid().color());
        painter.drawRect(all);
    }

private:
    double level_ = 0;
};

namespace {

constexpr int frameBeat_ms = 33;
constexpr int places = 1000;  ///< of the slider
constexpr double paces[] = {1.0 / 100, 1.0 / 50, 1.0 / 20, 1.0 / 5, 1.0};
constexpr int usualPace = 1;

QToolButton* makeButton(const char* name, const char* icon)
{
    auto* button = new QToolButton;
    button->setObjectName(name);
    button->setIcon(lathelier::icon(icon));
    button->setAutoRaise(true);
    return button;
}

}  // namespace

TransportBar::TransportBar(SoundPlayer& player, QWidget* parent)
    : QWidget(parent),
      player_(player),
      play_(makeButton("play", "play")),
      back_(makeButton("stepBack", "step_back")),
      forth_(makeButton("stepForth", "step_forth")),
      pace_(new QComboBox),
      place_(new QSlider(Qt::Horizontal)),
      words_(new QLabel),
      stop_(makeButton("stopWriting", "stop")),
      sound_(makeButton("sound", "sound")),
      volume_(new QSlider(Qt::Horizontal)),
      meter_(new SoundMeter)
{
    pace_->setObjectName("pace");
    place_->setObjectName("time");
    volume_->setObjectName("volume");
    place_->setRange(0, places);
    volume_->setRange(0, 100);
    volume_->setValue(static_cast<int>(std::lround(100 * player.volume() / SoundPlayer::loudest)));
    volume_->setMaximumWidth(6 * fontMetrics().height());
    sound_->setCheckable(true);
    for (const double pace : paces) pace_->addItem(QString("1 : %1").arg(std::lround(1 / pace)));
    pace_->setCurrentIndex(usualPace);
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(4, 0, 4, 0);
    layout->setSpacing(4);
    for (QWidget* widget : std::initializer_list<QWidget*>{back_, play_, forth_, pace_}) layout->addWidget(widget);
    layout->addWidget(place_, 1);
    layout->addWidget(words_);
    layout->addWidget(stop_);
    stop_->hide();
    for (QWidget* widget : std::initializer_list<QWidget*>{sound_, volume_, meter_}) layout->addWidget(widget);
    clock_.setInterval(frameBeat_ms);
    connect(&clock_, &QTimer::timeout, this, &TransportBar::advance);
    connect(play_, &QToolButton::clicked, this, [this] { setPlaying(!isPlaying()); });
    connect(back_, &QToolButton::clicked, this, [this] { step(-1); });
    connect(forth_, &QToolButton::clicked, this, [this] { step(1); });
    connect(place_, &QSlider::valueChanged, this, [this](int value) { setTime(length_s_ * value / places); });
    connect(stop_, &QToolButton::clicked, this, [this] {
        stop_->hide();
        emit writingStopped();
        showTime();
    });
    connect(sound_, &QToolButton::toggled, &player_, &SoundPlayer::setOn);
    connect(volume_, &QSlider::valueChanged, this,
            [this](int value) { player_.setVolume(SoundPlayer::loudest * value / 100); });
    connect(&player_, &SoundPlayer::levelChanged, this, [this](double level) { meter_->setLevel(level); });
    retranslate();
}

void TransportBar::setCut(double length_s, double revolution_s)
{
    length_s_ = std::max(length_s, 1e-3);
    revolution_s_ = std::clamp(revolution_s, 1e-6, length_s_);
    setTime(atEnd_ ? length_s_ : time_s_);
}

void TransportBar::setTime(double time_s)
{
    time_s = std::clamp(time_s, 0.0, length_s_ - revolution_s_ / 100);
    atEnd_ = time_s >= length_s_ - revolution_s_ / 50;
    const bool moved = time_s != time_s_;
    time_s_ = time_s;
    showTime();
    if (moved) emit timeChanged(time_s_);
}

void TransportBar::setPlaying(bool playing)
{
    if (playing == isPlaying()) return;
    since_.start();
    if (playing)
        clock_.start();
    else
        clock_.stop();
    play_->setIcon(lathelier::icon(playing ? "pause" : "play"));
    retranslate();
}

void TransportBar::step(int revolutions)
{
    setPlaying(false);
    setTime((std::floor(time_s_ / revolution_s_ + 0.01) + revolutions) * revolution_s_ + revolution_s_ / 100);
}

/// Driven by time and not by timer ticks: slow drawing reduces the frame rate, not the speed. Cyclic.
void TransportBar::advance()
{
    const double gone_s = 1e-3 * static_cast<double>(since_.restart());
    const double next = time_s_ + gone_s * paces[pace_->currentIndex()];
    setTime(next < length_s_ - revolution_s_ / 50 ? next : 0);
}

void TransportBar::showWriting(int done, int count)
{
    stop_->setVisible(done < count);
    if (done == count) return showTime();
    words_->setText(tr("picture %1 of %2").arg(done).arg(count));
}

void TransportBar::showTime()
{
    const QSignalBlocker quiet(place_);
    place_->setValue(static_cast<int>(std::lround(places * time_s_ / length_s_)));
    words_->setText(
        tr("revolution %L1 · %L2 s").arg(static_cast<int>(time_s_ / revolution_s_) + 1).arg(time_s_, 0, 'f', 3));
}

void TransportBar::retranslate()
{
    const auto name = [](QWidget* widget, const QString& words) {
        widget->setToolTip(words);
        widget->setAccessibleName(words);
    };
    name(play_, isPlaying() ? tr("Pause") : tr("Play in slow motion"));
    name(back_, tr("One revolution back"));
    name(forth_, tr("One revolution on"));
    name(pace_, tr("Slow motion"));
    name(place_, tr("Time in the cut"));
    name(stop_, tr("Stop writing pictures"));
    name(sound_, SoundPlayer::hasDevice() ? tr("Sound of the cut")
                                          : tr("Sound of the cut: this computer has no device for it; the meter shows "
                                               "it, and Export writes it as a file"));
    name(volume_, tr("Volume"));
    name(meter_, tr("Loudness"));
    showTime();
}

}  // namespace lathelier::training_panel
