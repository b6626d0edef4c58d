// How a polar plot is drawn, on the screen and on paper alike.
#pragma once

#include <QLocale>
#include <QPainter>

#include "widgets/plot/plot_style.h"
#include "widgets/plot/polar_data.h"

namespace lathelier {

/// Lays out and draws one picture in one rectangle.
class PolarPainter {
public:
    PolarPainter(const PolarPicture& picture, double magnification, const QRectF& room, const QFont& font,
                 const PlotStyle& style, const QLocale& locale);

    const PolarScale& scale() const { return scale_; }

    /// Title, rings, spokes, traces, circles, contacts, legend.
    void paint(QPainter& painter) const;

    /// The marked angle: a spoke, and a dot on the first trace.
    void paintAngle(QPainter& painter, double angle_deg, const QColor& colour, bool strong) const;

    /// `text` in the title's place.
    void paintReadout(QPainter& painter, const QString& text) const;

private:
    struct LegendLine;
    struct Layout {
        QRectF title;
        QRectF disc;
        QRectF legend;
        bool beside = false;  ///< the legend stands at the right, not below
    };
    Layout layOut(const QRectF& room) const;
    std::vector<LegendLine> legendLines() const;
    QString remark() const;
    QColor colourOf(int wanted, std::size_t position) const;
    void paintTitle(QPainter& painter) const;
    void paintGrid(QPainter& painter) const;
    void paintScale(QPainter& painter) const;
    void paintLines(QPainter& painter, bool thin) const;
    void paintCircles(QPainter& painter) const;
    void paintContacts(QPainter& painter) const;
    void paintLegend(QPainter& painter) const;
    void paintMark(QPainter& painter, const QPointF& place, bool outer, const QColor& colour) const;

    const PolarPicture& picture_;
    double magnification_;
    QFont font_;
    const PlotStyle& style_;
    QLocale locale_;
    Layout layout_;
    PolarScale scale_;
    double division_um_;
};

/// The magnification as the share of the drawn base radius that one micrometre takes.
double sharePerUm(const PolarPicture& picture, double magnification);

}  // namespace lathelier
