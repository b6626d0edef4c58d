// A slider along a program, with a button that plays it, the place in words, and a switch between clampings.
#pragma once

#include <QButtonGroup>
#include <QLabel>
#include <QSlider>
#include <QTimer>
#include <QToolButton>
#include <QWidget>

namespace lathelier::turning_panel {

class ToolScrubber : public QWidget {
    Q_OBJECT

public:
    static constexpr int places = 4000;  ///< evenly along the way of the tool; the last one: the program is done

    explicit ToolScrubber(QWidget* parent = nullptr);

    QSlider* slider() const { return slider_; }
    int place() const { return slider_->value(); }
    void setPlace(int place);  ///< announces nothing
    /// The switch is there where there are two.
    void setClampings(std::size_t count, std::size_t shown);
    void say(const QString& where) { where_->setText(where); }
    void setPlaying(bool playing);
    void retranslate();

signals:
    void moved(int place);              ///< by the user, or as it plays
    void clampingChosen(int clamping);  ///< from 0

private:
    QButtonGroup* clampings_;
    QToolButton* play_;
    QSlider* slider_;
    QLabel* where_;
    QTimer playing_;
};

}  // namespace lathelier::turning_panel
