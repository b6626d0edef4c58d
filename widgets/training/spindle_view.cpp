#include "widgets/training/spindle_view.h"

#include <QLocale>
#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/core/units.h"
#include "engine/stability/simulation/cut_views.h"
#include "widgets/core/language.h"
#include "widgets/plot/plot_style.h"

namespace lathelier::training_panel {
namespace {

constexpr double drawnWave = 0.12;  ///< of the radius: the largest vibration
constexpr double sweep_deg = 270;   ///< of the dial
constexpr int divisions = 10;       ///< of the dial, to each side
constexpr double umPerMm = 1000;
constexpr std::size_t mostCorners = 720;

/// A round number not below `value`: 1, 2 or 5 times a power of ten.
double roundUp(double value)
{
    if (!(value > 0)) return 1;
    const double power = std::pow(10, std::floor(std::log10(value)));
    for (const double step : {1.0, 2.0, 5.0, 10.0})
        if (step * power >= value * (1 - 1e-9)) return step * power;
    return 10 * power;
}

QPointF onCircle(const QPointF& middle, double radius, double angle_rad)
{
    return middle + radius * QPointF(std::cos(angle_rad), -std::sin(angle_rad));
}

}  // namespace

SpindleView::SpindleView(QWidget* parent) : QWidget(parent)
{
    setObjectName("spindle");
    retranslate();
}

void SpindleView::retranslate()
{
    setAccessibleName(tr("The turning part and a dial gauge at the tool"));
    update();
}

void SpindleView::setCut(std::shared_ptr<const stability::SimulationResult> cut)
{
    cut_ = std::move(cut);
    revolution_ = -1;
    largest_mm_ = 0;
    if (cut_)
        for (const double x : cut_->deflection_mm)
            largest_mm_ = std::max(largest_mm_, std::abs(x - cut_->static_deflection_mm));
    setTime(time_s_);
}

void SpindleView::setTime(double time_s)
{
    time_s_ = time_s;
    prepare();
    update();
}

void SpindleView::prepare()
{
    if (!cut_ || cut_->steps_per_revolution <= 0) return;
    const int revolution = static_cast<int>(time_s_ / (cut_->step_s * cut_->steps_per_revolution));
    if (revolution == revolution_) return;
    revolution_ = revolution;
    waves_ = wavesOf(*cut_, revolution);
}

double SpindleView::deflection_mm() const
{
    if (!cut_ || cut_->deflection_mm.empty()) return 0;
    const auto i = static_cast<std::size_t>(std::max(0.0, time_s_ / cut_->step_s));
    return cut_->deflection_mm[std::min(i, cut_->deflection_mm.size() - 1)] - cut_->static_deflection_mm;
}

void SpindleView::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const plot::PlotStyle style(palette(), font());
    painter.fillRect(rect(), style.background);
    if (!cut_) return;
    const double radius = std::min(0.17 * width(), 0.38 * height());
    const double gauge = std::min(0.38 * width(), 0.86 * height());
    const double air = (width() - 3.2 * radius - gauge) / 3;  // part, tool and gauge side by side
    const QPointF middle(air + 1.2 * radius, height() * 0.5);
    drawPart(painter, middle, radius);
    const double tool = radius * (1 + drawnWave * (largest_mm_ > 0 ? deflection_mm() / largest_mm_ : 0));
    QPolygonF insert;  // its corner touches the part at three o'clock
    const QPointF tip = middle + QPointF(tool, 0);
    insert << tip << tip + QPointF(0.30 * radius, -0.16 * radius) << tip + QPointF(0.8 * radius, -0.16 * radius)
           << tip + QPointF(0.8 * radius, 0.16 * radius) << tip + QPointF(0.30 * radius, 0.16 * radius);
    painter.setPen(QPen(style.text, style.line_width));
    painter.setBrush(style.colour(report::ColourRole::Mark));
    painter.drawPolygon(insert);
    drawGauge(painter, QRectF(width() - gauge - air, (height() - gauge) / 2, gauge, gauge));
}

void SpindleView::drawPart(QPainter& painter, const QPointF& middle, double radius) const
{
    const plot::PlotStyle style(palette(), font());
    const double turned = 2 * std::numbers::pi * std::fmod(time_s_ * *cut_->parameters.speed_rpm / 60, 1.0);
    // The surface at the angle φ behind the tool was cut φ ago: by this revolution, or by the one before.
    QPolygonF outline;
    const std::size_t steps = waves_.inner_mm.size();
    if (steps == 0) return;
    const auto now = static_cast<std::size_t>(std::max(0.0, time_s_ / cut_->step_s)) % steps;
    const std::size_t every = std::max<std::size_t>(1, steps / mostCorners);
    for (std::size_t i = 0; i < steps; i += every) {
        const std::size_t place = (now + steps - i) % steps;
        const double left_mm = place <= now ? waves_.inner_mm[place] : waves_.outer_mm[place];
        const double height = largest_mm_ > 0 ? (left_mm - cut_->static_deflection_mm) / largest_mm_ : 0;
        const double r = radius * (1 + drawnWave * std::clamp(height, -1.5, 1.5));
        outline << onCircle(middle, r, 2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(steps));
    }
    painter.setPen(QPen(style.text, 1.5 * style.line_width));
    painter.setBrush(style.grid);
    painter.drawPolygon(outline);
    painter.setPen(QPen(style.text, style.line_width));
    for (int jaw = 0; jaw < 3; ++jaw) {  // three jaws show that it turns
        const double angle = turned + jaw * 2 * std::numbers::pi / 3;
        painter.setBrush(style.background);
        painter.drawEllipse(onCircle(middle, 0.45 * radius, angle), 0.09 * radius, 0.09 * radius);
    }
    painter.setBrush(style.text);
    painter.drawEllipse(middle, 0.04 * radius, 0.04 * radius);
}

void SpindleView::drawGauge(QPainter& painter, const QRectF& place) const
{
    const plot::PlotStyle style(palette(), font());
    const double radius = place.width() / 2;
    const QPointF middle = place.center();
    const double full_um = roundUp(umPerMm * largest_mm_);
    const auto angleOf = [&](double share) {  // 0 stands upright
        return std::numbers::pi / 2 - share * sweep_deg / 2 * std::numbers::pi / 180;
    };
    painter.setPen(QPen(style.text, 2 * style.line_width));
    painter.setBrush(style.background);
    painter.drawEllipse(place);
    QFont small = font();
    small.setPixelSize(std::max(7, static_cast<int>(0.11 * radius)));
    painter.setFont(small);
    const double factor = screenFactor(unit::um);
    for (int i = -divisions; i <= divisions; ++i) {
        const double share = static_cast<double>(i) / divisions;
        const bool is_long = i % (divisions / 2) == 0;
        painter.setPen(QPen(style.text, (is_long ? 1.6 : 0.8) * style.line_width));
        painter.drawLine(onCircle(middle, (is_long ? 0.80 : 0.86) * radius, angleOf(share)),
                         onCircle(middle, 0.93 * radius, angleOf(share)));
        if (!is_long) continue;
        const QString number = QLocale().toString(share * full_um * factor, 'g', 3);
        const QPointF at = onCircle(middle, 0.64 * radius, angleOf(share));
        const QRectF box = QFontMetricsF(small).boundingRect(number);
        painter.drawText(at - QPointF(box.width() / 2, -0.35 * box.height()), number);
    }
    painter.drawText(QRectF(place.left(), middle.y() + 0.35 * radius, place.width(), 0.2 * radius), Qt::AlignCenter,
                     screenUnit(unit::um));
    const double share = std::clamp(umPerMm * deflection_mm() / full_um, -1.05, 1.05);
    painter.setPen(QPen(style.colour(report::ColourRole::Unstable), 2.5 * style.line_width));
    painter.drawLine(onCircle(middle, -0.15 * radius, angleOf(share)), onCircle(middle, 0.82 * radius, angleOf(share)));
    painter.setBrush(style.text);
    painter.setPen(Qt::NoPen);
    painter.drawEllipse(middle, 0.05 * radius, 0.05 * radius);
}

}  // namespace lathelier::training_panel
