#include "widgets/plot/pointer_tag.h"

#include <QPainter>
#include <algorithm>

namespace lathelier::plot {
namespace {

constexpr int air_px = 6;
constexpr int aside_px = 14;
constexpr double valueSize = 1.35;  // font size of the value relative to the text

}  // namespace

PointerTag::PointerTag(QWidget* parent) : QWidget(parent)
{
    setObjectName("pointerTag");
    setAttribute(Qt::WA_TransparentForMouseEvents);
    setFocusPolicy(Qt::NoFocus);
    hide();
}

QFont PointerTag::large() const
{
    QFont face = font();
    face.setPointSizeF(face.pointSizeF() * valueSize);
    face.setWeight(QFont::DemiBold);
    return face;
}

void PointerTag::say(const Words& words, const QPoint& pointer)
{
    words_ = words;
    setVisible(!words.value.isEmpty());
    if (words.value.isEmpty()) return;
    const QFontMetrics value(large());
    const QFontMetrics place(font());
    resize(2 * air_px + std::max(value.horizontalAdvance(words.value), place.horizontalAdvance(words.place)),
           air_px + value.height() + (words.place.isEmpty() ? 0 : place.height()));
    const QSize room = parentWidget()->size();
    QPoint corner = pointer + QPoint(aside_px, -aside_px - height());
    if (corner.x() + width() > room.width()) corner.setX(pointer.x() - aside_px - width());
    if (corner.y() < 0) corner.setY(pointer.y() + aside_px);
    corner.setX(std::clamp(corner.x(), 0, std::max(0, room.width() - width())));
    corner.setY(std::clamp(corner.y(), 0, std::max(0, room.height() - height())));
    move(corner);
    raise();
    update();
}

void PointerTag::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(palette().color(QPalette::Mid), 1));
    painter.setBrush(palette().color(QPalette::ToolTipBase));
    painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), 4, 4);
    painter.setPen(palette().color(QPalette::ToolTipText));
    const QFontMetrics value(large());
    painter.setFont(large());
    painter.drawText(QPointF(air_px, 0.5 * air_px + value.ascent()), words_.value);
    painter.setFont(font());
    painter.drawText(QPointF(air_px, 0.5 * air_px + value.height() + QFontMetrics(font()).ascent()), words_.place);
}

}  // namespace lathelier::plot
