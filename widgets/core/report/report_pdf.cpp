#include "widgets/core/report/report_pdf.h"

#include <QBuffer>
#include <QGuiApplication>
#include <QPainter>
#include <QPdfWriter>
#include <QSvgRenderer>
#include <QTextDocument>
#include <algorithm>
#include <cmath>

#include "engine/core/texts.h"
#include "engine/core/version.h"
#include "widgets/core/report/report_pieces.h"

namespace lathelier {
namespace {

// Layout in px of 1/96 inch, drawn at the printer's resolution.
constexpr int resolution_dpi = 600;
constexpr double margin_mm = 15;
constexpr double pieceGap_px = 12;
constexpr double columnGap_px = 24;
constexpr double footer_px = 24;
constexpr int text_px = 12;
constexpr std::size_t shortTable = 12;  // rows; shorter tables are kept on one page if possible

/// Places pieces from top to bottom on pages. Without a painter only the pages are counted.
class Sheet {
public:
    Sheet(QPdfWriter& writer, QPainter* painter, const QString& title, int pages)
        : writer_(writer),
          painter_(painter),
          title_(title),
          pages_(pages),
          width_(writer.width() / scale()),
          height_(writer.height() / scale() - footer_px)
    {
        finishPage();
    }

    int pages() const { return page_; }

    void print(const std::vector<Piece>& pieces)
    {
        for (std::size_t i = 0; i < pieces.size(); ++i) {
            const Piece& piece = pieces[i];
            if (piece.kind == Piece::Kind::Rows) {
                rows(piece);
            } else if (piece.narrow && i + 1 < pieces.size() && pieces[i + 1].narrow) {
                const double column = (width_ - columnGap_px) / 2;
                const double height = std::max(heightOf(piece, column), heightOf(pieces[i + 1], column));
                makeRoom(height);
                draw(piece, 0, column);
                draw(pieces[i + 1], column + columnGap_px, column);
                y_ += height + pieceGap_px;
                ++i;
            } else {
                const double width = piece.narrow ? (width_ - columnGap_px) / 2 : piece.share * width_;
                double needed = heightOf(piece, width);
                const double own = needed;
                // A heading is kept with the following block, which may begin with another heading.
                for (std::size_t k = i; pieces[k].keep_with_next && k + 1 < pieces.size(); ++k)
                    needed += pieceGap_px + headHeight(pieces[k + 1]);
                makeRoom(needed);
                draw(piece, 0, width);
                y_ += own + (piece.keep_with_next ? 2 : pieceGap_px);
            }
        }
    }

private:
    static double scale() { return resolution_dpi / 96.0; }

    std::unique_ptr<QTextDocument> laidOut(const QString& html, double width) const
    {
        auto text = std::make_unique<QTextDocument>();
        QTextOption wrapping;
        wrapping.setWrapMode(QTextOption::WordWrap);  // no break within a word of a heading
        QFont font = QGuiApplication::font();
        font.setPixelSize(text_px);
        text->setDefaultFont(font);
        text->setDocumentMargin(0);
        text->setDefaultTextOption(wrapping);
        text->setHtml(html);
        text->setTextWidth(width);
        return text;
    }

    static QSizeF naturalSize(const Piece& piece)
    {
        if (piece.kind == Piece::Kind::Svg) return QSvgRenderer(QByteArray::fromStdString(piece.data)).defaultSize();
        return QImage::fromData(QByteArray::fromStdString(piece.data)).size();
    }

    double pictureHeight(const Piece& piece, double width) const
    {
        const QSizeF size = naturalSize(piece);
        return size.width() > 0 ? std::min(width * size.height() / size.width(), height_ * 0.8) : 0;
    }

    double heightOf(const Piece& piece, double width) const
    {
        const double text = piece.html.isEmpty() ? 0 : laidOut(piece.html, width)->size().height();
        return piece.kind == Piece::Kind::RichText ? text : text + pictureHeight(piece, width);
    }

    /// Height that must fit on the page of a preceding heading.
    double headHeight(const Piece& piece) const
    {
        if (piece.kind == Piece::Kind::Rows)
            return laidOut(piece.html + tableEnd, width_)->size().height() + 3 * text_px;
        return std::min(heightOf(piece, piece.narrow ? (width_ - columnGap_px) / 2 : width_), height_ * 0.8);
    }

    void draw(const Piece& piece, double x, double width)
    {
        if (!painter_) return;
        painter_->save();
        painter_->translate(x, y_);
        if (piece.kind != Piece::Kind::RichText) {
            const double height = pictureHeight(piece, width);
            const QSizeF size = naturalSize(piece);
            const double drawn = size.height() > 0 ? std::min(width, height * size.width() / size.height()) : width;
            const QRectF frame(0, 0, drawn, height);
            if (piece.kind == Piece::Kind::Svg)
                QSvgRenderer(QByteArray::fromStdString(piece.data)).render(painter_, frame);
            else
                painter_->drawImage(frame, QImage::fromData(QByteArray::fromStdString(piece.data)));
            painter_->translate(0, height);
        }
        if (!piece.html.isEmpty()) laidOut(piece.html, width)->drawContents(painter_);
        painter_->restore();
    }

    /// A table: as many rows as fit, the header again on the next page.
    void rows(const Piece& piece)
    {
        if (piece.rows.size() <= shortTable) {
            QString html = piece.html;
            for (const QString& row : piece.rows) html += row;
            makeRoom(laidOut(html + tableEnd, width_)->size().height());
        }
        std::size_t next = 0;
        do {
            const auto upTo = [&](std::size_t end) {
                QString html = piece.html;
                for (std::size_t i = next; i < end; ++i) html += piece.rows[i];
                return html + tableEnd;
            };
            const double room = height_ - y_;
            std::size_t end = piece.rows.size();
            while (end > next + 1 && laidOut(upTo(end), width_)->size().height() > (y_ > 0 ? room : height_))
                end = next + std::max<std::size_t>(1, (end - next) * 9 / 10);
            Piece part;
            part.html = upTo(end);
            const double height = heightOf(part, width_);
            if (y_ > 0 && height > room) {  // not even one row fits
                finishPage();
                continue;
            }
            draw(part, 0, width_);
            y_ += height + pieceGap_px;
            next = end;
        } while (next < piece.rows.size());
    }

    void makeRoom(double height)
    {
        if (y_ > 0 && y_ + height > height_) finishPage();
    }

    /// Begins a page.
    void finishPage()
    {
        if (painter_ && page_ > 0) {
            painter_->restore();
            writer_.newPage();
        }
        ++page_;
        y_ = 0;
        if (!painter_) return;
        painter_->save();
        painter_->scale(scale(), scale());
        QFont font = QGuiApplication::font();
        font.setPixelSize(10);
        painter_->setFont(font);
        painter_->setPen(QColor("#52606d"));
        const QRectF line(0, height_ + footer_px - 16, width_, 16);
        painter_->drawText(line, Qt::AlignLeft | Qt::AlignVCenter, title_);
        painter_->drawText(line, Qt::AlignRight | Qt::AlignVCenter, QString("%1 / %2").arg(page_).arg(pages_));
        painter_->setPen(Qt::black);
    }

    QPdfWriter& writer_;
    QPainter* painter_;
    QString title_;
    int pages_;
    double width_;
    double height_;
    double y_ = 0;
    int page_ = 0;
};

}  // namespace

std::string toPdf(const report::Document& document, const Language& language)
{
    const std::vector<Piece> pieces = piecesOf(document, language);
    const QString title = QString::fromStdString(report::captionText(document.title, language));
    QBuffer buffer;
    buffer.open(QIODevice::WriteOnly);
    QPdfWriter writer(&buffer);
    writer.setTitle(title);
    writer.setCreator(QStringLiteral("Lathelier ") + programVersion);
    writer.setResolution(resolution_dpi);
    writer.setPageSize(QPageSize(QPageSize::A4));
    writer.setPageMargins(QMarginsF(margin_mm, margin_mm, margin_mm, margin_mm), QPageLayout::Millimeter);

    Sheet counting(writer, nullptr, title, 0);
    counting.print(pieces);

    QPainter painter(&writer);
    Sheet sheet(writer, &painter, title, counting.pages());
    sheet.print(pieces);
    painter.restore();
    painter.end();
    return buffer.data().toStdString();
}

}  // namespace lathelier
