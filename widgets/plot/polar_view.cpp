#include "widgets/plot/polar_view.h"

#include <QKeyEvent>
#include <QMenu>
#include <QMouseEvent>
#include <QPainter>
#include <QPdfWriter>
#include <QSvgGenerator>
#include <algorithm>
#include <cmath>

#include "widgets/core/language.h"
#include "widgets/plot/polar_painter.h"

namespace lathelier::plot {
namespace {

/// Whether the plot shows another reference circle of the same part.
bool sizesAgree(double a_mm, double b_mm)
{
    return std::abs(a_mm - b_mm) <= 0.01 * std::max(std::abs(a_mm), std::abs(b_mm));
}

const report::PolarPlot::Trace* firstTrace(const PolarPicturePtr& picture)
{
    if (!picture) return nullptr;
    for (const report::PolarPlot::Trace& trace : picture->plot.traces)
        if (!trace.thin) return &trace;
    return picture->plot.traces.empty() ? nullptr : &picture->plot.traces.front();
}

}  // namespace

PolarView::PolarView(QWidget* parent) : PlotWidget(parent), tag_(new PointerTag(this))
{
    setMouseTracking(true);
    setFocusPolicy(Qt::StrongFocus);
    setCursor(Qt::CrossCursor);
}

void PolarView::setPicture(const PolarPicturePtr& picture)
{
    const bool same = picture_ && picture && picture_->plot.title == picture->plot.title &&
                      sizesAgree(picture_->plot.base_radius_mm, picture->plot.base_radius_mm);
    picture_ = picture;
    if (!same) chosen_.reset();
    forgetPixmap();
}

double PolarView::magnification() const
{
    if (chosen_) return *chosen_;
    if (!picture_) return 1;
    return picture_->plot.magnification.value_or(fittingMagnification(*picture_));
}

void PolarView::setMagnification(std::optional<double> magnification)
{
    chosen_ = magnification;
    forgetPixmap();
    emit magnificationChanged(PolarView::magnification());
}

void PolarView::setAsked(const std::string& key)
{
    if (asked_ == key) return;
    asked_ = key;
    forgetPixmap();
}

void PolarView::setMarker(std::optional<double> angle_deg)
{
    marker_ = angle_deg;
    setAccessibleDescription(readout());
    update();
}

void PolarView::forgetPixmap()
{
    pixmap_ = QPixmap();
    if (picture_) setAccessibleName(chartText(picture_->plot.title));
    setAccessibleDescription(readout());
    update();
}

QString PolarView::angleReadout(double angle_deg) const
{
    const report::PolarPlot::Trace* first = firstTrace(picture_);
    if (!first) return {};
    const auto nearest = nearestSample(*first, angle_deg);
    QStringList parts{screenNumber(nearest ? first->angle_deg[*nearest] : angle_deg, 1) + "°"};
    for (std::size_t t = 0; t < picture_->readoutTraces(); ++t) {
        const report::PolarPlot::Trace& trace = picture_->plot.traces[t];
        if (trace.thin) continue;
        const auto sample = nearestSample(trace, angle_deg);
        if (!sample) continue;
        const double value_um = trace.deviation_um[*sample];
        QString text = screenQuantity(value_um, micrometre, 2, true);
        text.replace('-', QChar(0x2212));
        const QString name = chartText(trace.name);
        parts << (name.isEmpty() ? text : name + " " + text);
    }
    return parts.join(QStringLiteral("   "));
}

QString PolarView::readout() const
{
    if (pointer_) return angleReadout(*pointer_);
    return marker_ ? angleReadout(*marker_) : QString();
}

QPointF PolarView::pixelAt(double angle_deg, double deviation_um) const
{
    if (!picture_) return {};
    const PlotStyle style(palette(), font());
    return PolarPainter(*picture_, magnification(), rect(), font(), style, locale(), asked_)
        .scale()
        .at(angle_deg, deviation_um);
}

QRectF PolarView::discRect() const
{
    if (!picture_) return {};
    const PlotStyle style(palette(), font());
    const PolarScale scale = PolarPainter(*picture_, magnification(), rect(), font(), style, locale(), asked_).scale();
    const QPointF reach(scale.room_px(), scale.room_px());
    return {scale.centre() - reach, scale.centre() + reach};
}

void PolarView::paintEvent(QPaintEvent*)
{
    const PlotStyle style(palette(), font());
    QPainter painter(this);
    painter.fillRect(rect(), style.background);
    if (!picture_) return;
    const PolarPainter plot(*picture_, magnification(), rect(), font(), style, locale(), asked_);
    const QSize size = this->size() * devicePixelRatioF();
    if (pixmap_.size() != size) {
        pixmap_ = QPixmap(size);
        pixmap_.setDevicePixelRatio(devicePixelRatioF());
        pixmap_.fill(style.background);
        QPainter still(&pixmap_);
        plot.paint(still);
    }
    painter.drawPixmap(0, 0, pixmap_);
    if (marker_) plot.paintAngle(painter, *marker_, style.marker, true);
    if (pointer_) plot.paintAngle(painter, *pointer_, style.text, false);
    const QString words = readout();
    if (!words.isEmpty()) plot.paintReadout(painter, words);
}

QImage PolarView::picture(double scale)
{
    const QPalette paper = paperPalette();
    const PlotStyle style(paper, font());
    QImage image(size() * scale, QImage::Format_RGB32);
    image.setDevicePixelRatio(scale);
    image.fill(style.background);
    if (!picture_) return image;
    QPainter painter(&image);
    PolarPainter(*picture_, magnification(), rect(), font(), style, locale(), asked_).paint(painter);
    return image;
}

bool PolarView::saveVector(const QString& path)
{
    if (!picture_) return false;
    const QPalette paper = paperPalette();
    const PlotStyle style(paper, font());
    const PolarPainter plot(*picture_, magnification(), rect(), font(), style, locale(), asked_);
    const auto paintOn = [&](QPaintDevice& device) {
        QPainter painter;
        if (!painter.begin(&device)) return false;
        const double scale = device.width() / static_cast<double>(width());
        if (path.endsWith(".pdf", Qt::CaseInsensitive)) painter.scale(scale, scale);
        plot.paint(painter);
        return painter.end();
    };
    if (path.endsWith(".pdf", Qt::CaseInsensitive)) {
        QPdfWriter writer(path);
        writer.setTitle(accessibleName());
        writer.setPageSize(QPageSize(QSizeF(width(), height()) * 0.75, QPageSize::Point));
        writer.setPageMargins({});
        return paintOn(writer);
    }
    QSvgGenerator generator;
    generator.setFileName(path);
    generator.setTitle(accessibleName());
    generator.setSize(size());
    generator.setViewBox(rect());
    return paintOn(generator);
}

QString PolarView::csv() const
{
    return picture_ ? toCsv(picture_->plot) : QString();
}

void PolarView::point(std::optional<double> angle_deg)
{
    pointer_ = angle_deg;
    update();
    if (angle_deg)
        emit pointed(*angle_deg);
    else
        emit pointerLeft();
}

void PolarView::mouseMoveEvent(QMouseEvent* event)
{
    if (!picture_) return;
    const PlotStyle style(palette(), font());
    const PolarPainter plot(*picture_, magnification(), rect(), font(), style, locale(), asked_);
    const QPointF arm = event->localPos() - plot.scale().centre();
    const bool inside = std::hypot(arm.x(), arm.y()) <= plot.scale().room_px();
    if (inside)
        point(plot.scale().angleOf(event->localPos()));
    else if (pointer_)
        point({});
    const report::PolarPlot::Trace* first = firstTrace(picture_);
    const auto sample = inside && first ? nearestSample(*first, *pointer_) : std::nullopt;
    PointerTag::Words words;
    if (sample) {
        const double value_um = first->deviation_um[*sample];
        words.value = screenQuantity(value_um, micrometre, 2, true);
        words.value.replace('-', QChar(0x2212));
        words.place = screenNumber(first->angle_deg[*sample], 1) + "°";
    }
    tag_->say(words, event->pos());
}

void PolarView::mousePressEvent(QMouseEvent* event)
{
    setFocus(Qt::MouseFocusReason);
    mouseMoveEvent(event);
    if (event->button() != Qt::LeftButton) return;
    before_ = marker_;
    pressed_ = true;
    if (pointer_) choose(pointer_);
}

void PolarView::mouseDoubleClickEvent(QMouseEvent* event)
{
    if (event->button() != Qt::LeftButton) return;
    if (pressed_ && marker_ != before_) choose(before_);  // the click was the first half of this double click
    pressed_ = false;
    resetView();
}

void PolarView::choose(std::optional<double> angle_deg)
{
    setMarker(angle_deg);
    if (angle_deg)
        emit clicked(*angle_deg);
    else
        emit unmarked();
}

void PolarView::addToMenu(QMenu& menu)
{
    if (marker_) menu.addAction(tr("Take the mark away"), this, [this] { choose({}); });
}

void PolarView::wheelEvent(QWheelEvent* event)
{
    wheel_ += event->angleDelta().y();
    const int steps = wheel_ / 120;
    wheel_ -= steps * 120;
    event->accept();
    if (steps != 0 && picture_) setMagnification(steppedMagnification(magnification(), steps));
}

void PolarView::step(int samples)
{
    const report::PolarPlot::Trace* first = firstTrace(picture_);
    if (!first || first->angle_deg.empty()) return;
    const auto count = static_cast<int>(first->angle_deg.size());
    const auto at = nearestSample(*first, marker_.value_or(0));
    const int next = ((at ? static_cast<int>(*at) : 0) + samples + count) % count;
    pointer_.reset();
    choose(first->angle_deg[static_cast<std::size_t>(next)]);
}

void PolarView::keyPressEvent(QKeyEvent* event)
{
    if (!picture_) return QWidget::keyPressEvent(event);
    switch (event->key()) {
        case Qt::Key_Left: return step(1);  // anticlockwise, in the sense of the angles
        case Qt::Key_Right: return step(-1);
        case Qt::Key_Plus: return setMagnification(steppedMagnification(magnification(), 1));
        case Qt::Key_Minus: return setMagnification(steppedMagnification(magnification(), -1));
        case Qt::Key_Home: return resetView();
        case Qt::Key_Escape:
            if (marker_) return choose({});
            return QWidget::keyPressEvent(event);
        default: QWidget::keyPressEvent(event);
    }
}

void PolarView::leaveEvent(QEvent* event)
{
    QWidget::leaveEvent(event);
    tag_->say({}, {});
    point({});
}

void PolarView::changeEvent(QEvent* event)
{
    QWidget::changeEvent(event);
    switch (event->type()) {
        case QEvent::PaletteChange:
        case QEvent::FontChange:
        case QEvent::StyleChange:
        case QEvent::LocaleChange:
        case QEvent::LanguageChange: forgetPixmap(); break;
        default: break;
    }
}

void PolarView::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    forgetPixmap();
}

}  // namespace lathelier::plot
