// Play, pause and step through a cut in slow motion; sound with its volume and meter.
#pragma once

#include <QComboBox>
#include <QElapsedTimer>
#include <QLabel>
#include <QSlider>
#include <QTimer>
#include <QToolButton>
#include <QWidget>

namespace lathelier::training_panel {

class SoundPlayer;
class SoundMeter;

class TransportBar : public QWidget {
    Q_OBJECT

public:
    explicit TransportBar(SoundPlayer& player, QWidget* parent = nullptr);

    /// The cut that is gone through: its length and one revolution of it. The time stays, at the end at first.
    void setCut(double length_s, double revolution_s);
    double time_s() const { return time_s_; }
    void setTime(double time_s);  ///< within the cut
    bool isPlaying() const { return clock_.isActive(); }
    void setPlaying(bool playing);
    void step(int revolutions);
    void showWriting(int done, int count);  ///< pictures of a demonstration; a button stops it
    void retranslate();

signals:
    void timeChanged(double time_s);
    void writingStopped();

private:
    void advance();
    void showTime();

    SoundPlayer& player_;
    QToolButton* play_;
    QToolButton* back_;
    QToolButton* forth_;
    QComboBox* pace_;
    QSlider* place_;
    QLabel* words_;
    QToolButton* stop_;  ///< the writing of pictures; else hidden
    QToolButton* sound_;
    QSlider* volume_;
    SoundMeter* meter_;
    QTimer clock_;
    QElapsedTimer since_;
    double length_s_ = 1;
    double revolution_s_ = 0.03;
    double time_s_ = 0;
    bool atEnd_ = true;  ///< and stays there when the cut changes
};

}  // namespace lathelier::training_panel
