// The machine as a class sees it, slowed down: the part turns and carries the waves it was cut with, the tool follows
// them, the needle of a dial gauge shows the deflection.
#pragma once

#include <QWidget>
#include <memory>

#include "engine/stability/simulation/simulation.h"

namespace lathelier::training_panel {

class SpindleView : public QWidget {
    Q_OBJECT

public:
    explicit SpindleView(QWidget* parent = nullptr);

    void setCut(std::shared_ptr<const stability::SimulationResult> cut);
    void setTime(double time_s);  ///< of the cut, from its beginning
    void retranslate();

    QSize sizeHint() const override { return {480, 320}; }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    void prepare();
    void drawPart(QPainter& painter, const QPointF& middle, double radius) const;
    void drawGauge(QPainter& painter, const QRectF& place) const;
    double deflection_mm() const;

    std::shared_ptr<const stability::SimulationResult> cut_;
    stability::WavePair waves_;  ///< of the revolution at time_s_
    double largest_mm_ = 0;      ///< of the vibration about the steady cut
    double time_s_ = 0;
    int revolution_ = -1;
};

}  // namespace lathelier::training_panel
