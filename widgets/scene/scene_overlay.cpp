#include "widgets/scene/scene_overlay.h"

#include <QLocale>
#include <QPainter>
#include <algorithm>
#include <array>
#include <cmath>

#include "widgets/core/language.h"

namespace lathelier::scene {

SceneRuler::SceneRuler(QWidget* parent) : QWidget(parent)
{
    setAttribute(Qt::WA_TransparentForMouseEvents);
    setAccessibleName(tr("Directions and length scale"));
}

QSize SceneRuler::sizeHint() const
{
    const int line = fontMetrics().height();
    return {13 * line, 5 * line};
}

void SceneRuler::setCamera(const SceneCamera& camera, int pictureHeight_px)
{
    camera_ = camera;
    const double perPixel = 2 * camera.half_height_mm / std::max(1, pictureHeight_px);
    const double factor = screenFactor(millimetre);
    const double longest = perPixel * 7 * fontMetrics().height() * factor;
    const double decade = std::pow(10.0, std::floor(std::log10(longest)));
    length_mm_ = decade;
    for (const double step : {2.0, 5.0})
        if (step * decade <= longest) length_mm_ = step * decade;
    length_mm_ /= factor;
    length_px_ = length_mm_ / perPixel;
    update();
}

void SceneRuler::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const double line = fontMetrics().height();
    const QColor ink = palette().color(QPalette::WindowText);

    struct Arm {
        Eigen::Vector3d view;
        QString name;
        QColor colour;
    };
    const bool dark = palette().color(QPalette::Window).lightness() < 128;
    std::array<Arm, 3> arms{
        Arm{camera_.view_T_scene.linear().col(0), "X", dark ? QColor(255, 140, 120) : QColor(190, 40, 20)},
        Arm{camera_.view_T_scene.linear().col(1), "Y", dark ? QColor(110, 220, 130) : QColor(0, 120, 50)},
        Arm{camera_.view_T_scene.linear().col(2), "Z", dark ? QColor(130, 180, 255) : QColor(20, 70, 190)}};
    std::sort(arms.begin(), arms.end(), [](const Arm& a, const Arm& b) { return a.view.z() < b.view.z(); });
    const QPointF root(2.2 * line, height() - 2.2 * line);
    QFont bold = font();
    bold.setBold(true);
    for (const Arm& arm : arms) {
        const QPointF way(arm.view.x(), -arm.view.y());
        painter.setPen(QPen(arm.colour, std::max(2.0, line / 8)));
        painter.drawLine(root, root + 1.25 * line * way);
        painter.setFont(bold);
        const QPointF tip = root + 1.75 * line * way;
        if (std::hypot(way.x(), way.y()) > 0.15)
            painter.drawText(QRectF(tip.x() - line, tip.y() - line, 2 * line, 2 * line), Qt::AlignCenter, arm.name);
    }
    const double left = 4.8 * line, level = height() - 0.7 * line;
    painter.setPen(QPen(ink, std::max(2.0, line / 9)));
    painter.drawLine(QPointF(left, level), QPointF(left + length_px_, level));
    for (const double x : {left, left + length_px_})
        painter.drawLine(QPointF(x, level - line / 3), QPointF(x, level + line / 3));
    painter.setFont(font());
    painter.drawText(QRectF(left, level - 1.5 * line, std::max(length_px_, 5 * line), 1.2 * line),
                     Qt::AlignLeft | Qt::AlignVCenter,
                     locale().toString(length_mm_ * screenFactor(millimetre), 'g', 6) + ' ' + screenUnit(millimetre));
}

SceneLabel::SceneLabel(QWidget* parent) : QLabel(parent)
{
    setAttribute(Qt::WA_TransparentForMouseEvents);
    setAutoFillBackground(true);
    setMargin(4);
    setFrameShape(QFrame::Box);
    setTextFormat(Qt::PlainText);
    hide();
}

}  // namespace lathelier::scene
