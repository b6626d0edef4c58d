// The views of a drawing: the sheet, the table of its rows, and what there is to remark.
#pragma once

#include <QToolButton>
#include <QWidget>
#include <memory>

#include "widgets/core/panel/copy_table.h"
#include "widgets/core/panel/hero_views.h"
#include "widgets/drawing/drawing_picture.h"
#include "widgets/drawing/sheet_view.h"

namespace lathelier::drawing_panel {

class DrawingViews : public QWidget {
    Q_OBJECT

public:
    explicit DrawingViews(QWidget* parent = nullptr);

    void setPicture(const std::shared_ptr<const DrawingPicture>& picture);
    HeroViews* heroes() const { return heroes_; }
    SheetView* sheet() const { return sheet_; }
    const drawing::Drawing& drawing() const { return drawing_; }  ///< on the sheet
    void setPresenting(bool presenting);                          ///< without the buttons
    void retranslate();

signals:
    void shaftWanted();  ///< keep it in the project

private:
    void show();

    std::shared_ptr<const DrawingPicture> picture_;
    drawing::Drawing drawing_;
    HeroViews* heroes_;
    SheetView* sheet_;
    CopyTable* rows_;
    CopyTable* remarks_;
    QWidget* buttons_;
    QToolButton* shaft_;
    QToolButton* fit_;
};

}  // namespace lathelier::drawing_panel
