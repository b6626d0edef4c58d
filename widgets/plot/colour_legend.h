// The colour scale of signed deviations, always shown beside what it colours, with its limit to edit.
#pragma once

#include <QString>
#include <QWidget>
#include <vector>

#include "engine/report/chart.h"

class QAction;
class QDoubleSpinBox;
class QPainter;

namespace lathelier::plot {

/// How many values there are of each size, drawn beside the scale.
struct ScaleCounts {
    std::vector<double> edges;   ///< ascending, one more than counts; empty: nothing is drawn
    std::vector<double> counts;  ///< of each bin, of any sum
};

/// Counts of `values` in even bins of the scale; those beyond its ends in none.
ScaleCounts countsOf(const std::vector<float>& values, const report::DeviationColours& colours);

/// What a legend shows.
struct Legend {
    report::DeviationColours colours;
    ScaleCounts counts;
    QString title;
    Text unit;  ///< of the values, by the engine; empty: none
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
    void setUnit(Text unit);  ///< of the limits, by the engine
    void setColours(const report::DeviationColours& colours);

signals:
    /// `lower`: how far the scale is to go below 0; 0: as far as above.
    void edited(double upper, double lower);

private:
    void showSides();
    void announce();

    Text unit_;                       ///< of the limits, by the engine
    report::DeviationColours shown_;  ///< with the limits
    QDoubleSpinBox* upper_;
    QDoubleSpinBox* lower_;
    QAction* apart_;
};

/// Legend and limit as one widget, to lie over a picture.
class ColourLegend : public QWidget {
    Q_OBJECT

public:
    explicit ColourLegend(QWidget* parent = nullptr);
    void setAxis(const report::Axis& axis);  ///< title and unit of the values
    void setColours(const report::DeviationColours& colours);
    void setCounts(ScaleCounts counts);
    QSize sizeHint() const override;

signals:
    void limitEdited(double upper, double lower);  ///< as LimitEdit::edited()

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    Legend legend_;
    LimitEdit* edit_;
};

}  // namespace lathelier::plot
