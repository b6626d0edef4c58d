// Painter of polar plots for screen and paper.
#pragma once

#include <QLocale>
#include <QPainter>

#include "engine/report/ring_labels.h"
#include "widgets/plot/plot_style.h"
#include "widgets/plot/polar_data.h"

namespace lathelier::plot {

/// Lays out and draws one picture in one rectangle.
class PolarPainter {
public:
    /// `asked`: keys of the requested optional circles.
    PolarPainter(const PolarPicture& picture, double magnification, const QRectF& room, const QFont& font,
                 const PlotStyle& style, const QLocale& locale, std::string asked = {});

    const PolarScale& scale() const { return scale_; }

    /// Title, rings, spokes, traces, circles, contacts, legend.
    void paint(QPainter& painter) const;

    /// The marked angle: a spoke, and a dot on the first trace.
    void paintAngle(QPainter& painter, double angle_deg, const QColor& colour, bool strong) const;

    /// `text` on its own line under the title; in a low plot in place of the title. The magnification stays.
    void paintReadout(QPainter& painter, const QString& text) const;

private:
    struct LegendLine {
        enum class Kind { Line, Thin, Dashed, Ring, Outer, Inner };
        QString text;            ///< text of the line
        QColor colour;           ///< colour of the sample line
        Kind kind = Kind::Line;  ///< shape of the sample line
        QPointF place{};         ///< left end relative to the legend
    };
    struct Legend {
        std::vector<LegendLine> lines;  ///< in display order
        QSizeF size{0, 0};              ///< size in px
        double sample_px = 0;           ///< length of the sample before the text, px
    };
    struct Layout {
        QRectF title;       ///< in px of the widget
        QRectF readout;     ///< readout area; empty: replaces the title
        QRectF disc;        ///< in px of the widget
        QPointF legend_at;  ///< upper left corner of the legend
        Legend legend;      ///< legend with positions
        int degrees = 30;   ///< degrees between two labels of the rim; 0: none
    };
    struct Split {           ///< division of the area between disc and legend
        double disc_px = 0;  ///< diameter of the disc
        QRectF disc;         ///< in px of the widget
        QPointF legend_at;   ///< upper left corner of the legend
        Legend legend;       ///< legend with positions
    };
    Layout layOut(const QRectF& room) const;
    Split split(const QRectF& room, const QSizeF& margins, bool shortNames) const;
    std::vector<LegendLine> legendLines(bool shortNames) const;
    Legend column(Legend legend) const;
    Legend rows(Legend legend, double width_px) const;
    QString remark() const;
    std::vector<report::PolarPlace> drawnPlaces() const;
    void paintTitle(QPainter& painter) const;
    void paintGrid(QPainter& painter) const;
    void paintScale(QPainter& painter) const;
    void paintLines(QPainter& painter, bool thin) const;
    void paintCircles(QPainter& painter) const;
    void paintRings(QPainter& painter) const;
    QPolygonF circle(const report::PolarPlot::ReferenceLine& line) const;
    bool isDrawn(const report::PolarPlot::ReferenceLine& line) const
    {
        return line.asked.empty() || line.asked == asked_;
    }
    void paintContacts(QPainter& painter) const;
    void paintContactNames(QPainter& painter) const;
    void paintLegend(QPainter& painter) const;
    void paintMark(QPainter& painter, const QPointF& place, bool outer, const QColor& colour) const;

    const PolarPicture& picture_;
    double magnification_;
    QFont font_;
    const PlotStyle& style_;
    QLocale locale_;
    std::string asked_;
    Layout layout_;
    PolarScale scale_;
    double division_um_;
};

/// The magnification as one micrometre relative to the drawn base radius.
double sharePerUm(const PolarPicture& picture, double magnification);

}  // namespace lathelier::plot
