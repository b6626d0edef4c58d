// Selection of the section of a record and of the marked angle, common to the panels of Roundness.
#pragma once

#include <QComboBox>
#include <QLabel>
#include <QSlider>
#include <QTimer>
#include <QToolButton>
#include <QWidget>
#include <memory>

#include "engine/trajectory/trajectory.h"
#include "widgets/trajectory_common/marked_angle.h"

namespace lathelier::trajectory_common {

/// "◀ Section 7 of 20 · z 35 mm ▶ worst". Hidden when there is no record.
class SectionBar : public QWidget {
    Q_OBJECT

public:
    explicit SectionBar(QWidget* parent = nullptr);
    /// `index`: of the shown section; none: nothing to choose. `chosen`: by the user, not as the worst one.
    void setSections(const std::shared_ptr<const trajectory::TrajectoryResult>& result,
                     std::optional<std::size_t> index, bool chosen);
    bool isWorst() const { return worst_->isChecked(); }

signals:
    void sectionRequested(std::optional<int> section);  ///< its number; none: the worst one

protected:
    void changeEvent(QEvent* event) override;

private:
    void retranslate();
    void step(int by);
    void fill();

    std::shared_ptr<const trajectory::TrajectoryResult> result_;
    std::size_t index_ = 0;
    QToolButton* before_;
    QComboBox* box_;
    QToolButton* after_;
    QToolButton* worst_;
};

/// Plays the marked angle around once a few seconds, and shows it.
class AngleBar : public QWidget {
    Q_OBJECT

public:
    explicit AngleBar(MarkedAngle& angle, QWidget* parent = nullptr);
    bool isPlaying() const { return timer_.isActive(); }

protected:
    void changeEvent(QEvent* event) override;
    void hideEvent(QHideEvent* event) override;

private:
    void retranslate();
    void play(bool on);
    void showAngle();

    MarkedAngle& angle_;
    QToolButton* play_;
    QSlider* slider_;
    QLabel* text_;
    QTimer timer_;
};

}  // namespace lathelier::trajectory_common
