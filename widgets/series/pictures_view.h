// Small deviation pictures of many parts on one scale: each the unrolled surface, with its file and verdict. A click
// chooses a part, Enter or a double click opens it; arrow keys go from part to part.
#pragma once

#include <QWidget>
#include <memory>
#include <string>
#include <vector>

#include "engine/series/small_picture.h"
#include "widgets/plot/colour_legend.h"

namespace lathelier::series_panel {

class PicturesView : public QWidget {
    Q_OBJECT

public:
    explicit PicturesView(QWidget* parent = nullptr);

    void setPictures(const std::vector<series::SmallPicture>& pictures, const std::string& chosen);
    std::size_t count() const { return tiles_.size(); }
    QRectF placeOf(std::size_t tile) const;  ///< of a picture with its caption, in this widget
    const std::string& chosen() const { return chosen_; }

    QSize minimumSizeHint() const override { return {160, 120}; }

signals:
    void partChosen(const std::string& uuid);
    void partOpened(const std::string& uuid);

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    bool event(QEvent* event) override;

private:
    struct Tile {
        series::SmallPicture picture;
        QImage image;  ///< one pixel for each cell
    };
    struct Grid {
        int columns = 1, rows = 1;
        QSizeF tile;
    };
    Grid grid() const;
    plot::Legend legend() const;
    double legendWidth() const;
    QRectF roomOfTiles() const;
    int tileAt(const QPointF& place) const;  ///< -1: none
    void paintTile(QPainter& painter, const QRectF& room, const Tile& tile) const;
    void choose(int tile);

    std::vector<Tile> tiles_;
    std::string chosen_;
};

}  // namespace lathelier::series_panel
