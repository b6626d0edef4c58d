// Colour scale of signed deviations with an editable limit, shown beside the coloured view.
#pragma once

#include <QString>
#include <QWidget>
#include <vector>

#include "engine/report/chart.h"

class QAction;
class QDoubleSpinBox;
class QPainter;

namespace lathelier::plot {

/// Histogram of the values, drawn beside the scale.
struct ScaleCounts {
    std::vector<double> edges;   ///< ascending, one more than counts; empty: nothing is drawn
    std::vector<double> counts;  ///< count by bin, in any normalisation
};

/// Counts of `values` in even bins of the scale; values beyond its ends are not counted.
ScaleCounts countsOf(const std::vector<float>& values, const report::DeviationColours& colours);

/// Content of a legend.
struct Legend {
    report::DeviationColours colours;
    ScaleCounts counts;
    QString title;
    Text unit;  ///< unit of the values in the engine; empty: none
};

/// Paints title, bar, numbers, the marks of the tolerance and the counts into `room`.
void paintColourLegend(QPainter& painter, const QRectF& room, const Legend& legend, const QFont& font,
                       const QColor& text, const QLocale& locale);

/// The narrowest width in which the numbers of a legend fit.
int colourLegendWidth(const Legend& legend, const QFont& font, const QLocale& locale);

/// The ends of a scale: "± 0.15", or each side by itself.
class LimitEdit : public QWidget {
    Q_OBJECT

public:
    explicit LimitEdit(QWidget* parent = nullptr);
    void setUnit(Text unit);  ///< unit of the limits in the engine
    void setColours(const report::DeviationColours& colours);

signals:
    /// `lower`: extent of the scale below 0; 0: symmetric.
    void edited(double upper, double lower);

private:
    void showSides();
    void announce();

    Text unit_;                       ///< unit of the limits in the engine
    report::DeviationColours shown_;  ///< shown colours with limits
    QDoubleSpinBox* upper_;
    QDoubleSpinBox* lower_;
    QAction* apart_;
};

/// Legend and limit editor as one overlay widget.
class ColourLegend : public QWidget {
    Q_OBJECT

public:
    explicit ColourLegend(QWidget* parent = nullptr);
    void setAxis(const report::Axis& axis);  ///< title and unit of the values
    void setColours(const report::DeviationColours& colours);
    void setCounts(ScaleCounts counts);
    QSize sizeHint() const override;

signals:
    void limitEdited(double upper, double lower);  ///< see LimitEdit::edited()

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    Legend legend_;
    LimitEdit* edit_;
};

}  // namespace lathelier::plot
