#include "widgets/scene/scene_flags.h"

#include <QPainter>
#include <algorithm>

namespace lathelier::scene {

SceneFlags::SceneFlags(QWidget* parent) : QWidget(parent)
{
    setAttribute(Qt::WA_TransparentForMouseEvents);
}

void SceneFlags::setFlags(std::vector<SceneFlag> flags)
{
    flags_ = std::move(flags);
    QStringList words;
    for (const SceneFlag& flag : flags_) words << flag.words;
    setAccessibleName(words.join("; "));
    update();
}

void SceneFlags::setCamera(const SceneCamera& camera)
{
    camera_ = camera;
    update();
}

std::optional<QPointF> SceneFlags::pixelOf(const SceneFlag& flag) const
{
    const auto place = camera_.project(flag.place_mm);
    if (!place) return std::nullopt;
    const QPointF pixel((place->x() + 1) / 2 * width(), (1 - place->y()) / 2 * height());
    return QRectF(rect()).contains(pixel) ? std::optional(pixel) : std::nullopt;
}

std::vector<QRectF> SceneFlags::labels() const
{
    const double line = fontMetrics().height();
    std::vector<QRectF> labels(flags_.size());
    for (std::size_t i = 0; i < flags_.size(); ++i) {
        const auto pixel = pixelOf(flags_[i]);
        if (!pixel) continue;
        const QSizeF size(fontMetrics().horizontalAdvance(flags_[i].words) + line, 1.4 * line);
        QRectF label(QPointF(0, 0), size);
        label.moveCenter(*pixel - QPointF(0, 3.5 * line));
        label.moveLeft(std::clamp(label.left(), 2.0, std::max(2.0, width() - size.width() - 2)));
        const auto is_taken = [&] {
            return std::any_of(labels.begin(), labels.begin() + static_cast<std::ptrdiff_t>(i),
                               [&label](const QRectF& other) { return other.intersects(label); });
        };
        // Upward from the place as far as there is room, then downward.
        while (label.top() >= 2 && is_taken()) label.translate(0, -1.1 * size.height());
        if (label.top() < 2) label.moveTop(pixel->y() + 2 * line);
        while (label.bottom() < height() && is_taken()) label.translate(0, 1.1 * size.height());
        labels[i] = label;
    }
    return labels;
}

void SceneFlags::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const std::vector<QRectF> labels = this->labels();
    for (std::size_t i = 0; i < labels.size(); ++i) {
        if (labels[i].isEmpty()) continue;
        const QPointF pixel = *pixelOf(flags_[i]);
        painter.setPen(QPen(flags_[i].colour, 1.5));
        painter.drawLine(pixel, QPointF(pixel.x(), pixel.y() < labels[i].top() ? labels[i].top() : labels[i].bottom()));
        painter.setBrush(flags_[i].colour);
        painter.drawEllipse(pixel, 3, 3);
    }
    for (std::size_t i = 0; i < labels.size(); ++i) {  // over all lines
        if (labels[i].isEmpty()) continue;
        painter.setPen(QPen(flags_[i].colour, 1.5));
        painter.setBrush(palette().color(QPalette::Base));
        painter.drawRoundedRect(labels[i], 3, 3);
        painter.setPen(palette().color(QPalette::Text));
        painter.drawText(labels[i], Qt::AlignCenter, flags_[i].words);
    }
}

}  // namespace lathelier::scene
