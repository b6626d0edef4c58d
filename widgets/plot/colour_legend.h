// The colour scale of signed deviations, always shown beside what it colours, with its limit to edit.
#pragma once

#include <QWidget>

#include "engine/report/colours.h"

class QDoubleSpinBox;
class QPainter;

namespace lathelier::plot {

/// Paints title, bar, numbers and the marks of the tolerance into `room`.
void paintColourLegend(QPainter& painter, const QRectF& room, const report::DeviationColours& colours,
                       const QString& title, const QFont& font, const QColor& text, const QLocale& locale);

/// The narrowest width in which the numbers of a legend fit.
int colourLegendWidth(const report::DeviationColours& colours, const QString& title, const QFont& font,
                      const QLocale& locale);

/// The edit field of a scale's limit: "± 0.15 mm".
class LimitEdit : public QWidget {
    Q_OBJECT

public:
    explicit LimitEdit(QWidget* parent = nullptr);
    void setLimit(double limit);
    double limit() const;

signals:
    void edited(double limit);

private:
    QDoubleSpinBox* box_;
};

/// Legend and limit as one widget, to lie over a picture.
class ColourLegend : public QWidget {
    Q_OBJECT

public:
    explicit ColourLegend(QWidget* parent = nullptr);
    void setTitle(const QString& title);
    void setColours(const report::DeviationColours& colours);
    QSize sizeHint() const override;

signals:
    void limitEdited(double limit);

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    QString title_;
    report::DeviationColours colours_;
    LimitEdit* edit_;
};

}  // namespace lathelier::plot
