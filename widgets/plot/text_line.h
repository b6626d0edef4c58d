// One line of text in a QCustomPlot layout that is elided and never widens the plot. Included by .cpp files only.
#pragma once

#include <qcustomplot.h>

namespace lathelier::plot {

class TextLine : public QCPLayoutElement {
public:
    explicit TextLine(QCustomPlot* plot) : QCPLayoutElement(plot) {}

    void set(const QString& text, const QString& aside = {})
    {
        text_ = text;
        aside_ = aside;
    }
    QString text() const { return text_; }
    void setShown(bool shown) { shown_ = shown; }  ///< false: takes no space
    void leaveRoom(int atRight) { room_ = atRight; }

    /// Replaces `title` while it has a text; not part of the layout.
    void coverTitle(const TextLine* title) { title_ = title; }
    void setBackground(const QColor& colour) { background_ = colour; }
    void setLook(const QFont& font, const QColor& colour, Qt::Alignment alignment)
    {
        font_ = font;
        colour_ = colour;
        alignment_ = alignment;
    }
    QSize minimumOuterSizeHint() const override { return {0, height()}; }
    QSize maximumOuterSizeHint() const override { return {QWIDGETSIZE_MAX, height()}; }

protected:
    void draw(QCPPainter* painter) override
    {
        if (text_.isEmpty() || !shown_) return;
        const QFontMetrics metrics(font_);
        const QRect place =
            title_ ? title_->rect().adjusted(0, 0, -title_->room_, 0) : rect().adjusted(0, 0, -room_, 0);
        const QRect room = place.adjusted(6, 0, -6, 0);
        painter->setFont(font_);
        painter->setPen(colour_);
        if (title_) return drawOver(painter, place, room, title_->aside_);
        const QString shown = metrics.elidedText(text_, Qt::ElideRight, room.width());
        painter->drawText(room, static_cast<int>(alignment_ | Qt::AlignVCenter), shown);
        if (aside_.isEmpty() || shown != text_) return;
        QFont small = font_;
        small.setBold(false);
        painter->setFont(small);
        const QRect rest = room.adjusted(metrics.horizontalAdvance(text_) + metrics.height(), 0, 0, 0);
        painter->drawText(rest, Qt::AlignLeft | Qt::AlignVCenter,
                          metrics.elidedText(aside_, Qt::ElideRight, rest.width()));
    }

private:
    /// The title's remark, such as a magnification, stays visible.
    void drawOver(QCPPainter* painter, const QRect& place, const QRect& room, const QString& remark) const
    {
        const QFontMetrics metrics(font_);
        painter->fillRect(place, background_);
        const QString kept = metrics.elidedText(remark, Qt::ElideRight, room.width() / 2);
        const int width = kept.isEmpty() ? 0 : metrics.horizontalAdvance(kept) + metrics.height();
        painter->drawText(room, Qt::AlignRight | Qt::AlignVCenter, kept);
        painter->drawText(room, static_cast<int>(alignment_ | Qt::AlignVCenter),
                          metrics.elidedText(text_, Qt::ElideRight, room.width() - width));
    }

    int height() const { return shown_ ? QFontMetrics(font_).height() + 2 : 0; }

    QString text_;
    QString aside_;
    bool shown_ = true;
    int room_ = 0;
    const TextLine* title_ = nullptr;
    QColor background_;
    QFont font_;
    QColor colour_;
    Qt::Alignment alignment_ = Qt::AlignLeft;
};

}  // namespace lathelier::plot
