#include "widgets/drawing/drawing_views.h"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QVBoxLayout>

#include "widgets/core/language.h"

namespace lathelier::drawing_panel {

DrawingViews::DrawingViews(QWidget* parent)
    : QWidget(parent),
      heroes_(new HeroViews),
      sheet_(new SheetView),
      rows_(new CopyTable),
      remarks_(new CopyTable),
      buttons_(new QWidget),
      shaft_(new QToolButton),
      fit_(new QToolButton)
{
    sheet_->setObjectName("sheet");
    rows_->setObjectName("rows");
    remarks_->setObjectName("remarks");
    shaft_->setObjectName("useShaft");
    fit_->setObjectName("wholeSheet");
    heroes_->add("sheet", sheet_);
    heroes_->add("rows", rows_);
    heroes_->add("remarks", remarks_);
    remarks_->setWordWrap(true);
    auto* row = new QHBoxLayout(buttons_);
    row->setContentsMargins(0, 0, 0, 0);
    row->addWidget(shaft_);
    row->addStretch();
    row->addWidget(fit_);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(4);
    layout->addWidget(buttons_);
    layout->addWidget(heroes_, 1);
    connect(shaft_, &QToolButton::clicked, this, &DrawingViews::shaftWanted);
    connect(fit_, &QToolButton::clicked, sheet_, &SheetView::fit);
    retranslate();
}

void DrawingViews::setPicture(const std::shared_ptr<const DrawingPicture>& picture)
{
    picture_ = picture;
    show();
}

void DrawingViews::show()
{
    if (!picture_) return;
    drawing_ = drawingOf(*picture_, screenLanguage());
    sheet_->setDrawing(drawing_);
    sheet_->setAccessibleName(QString::fromStdString(drawing_.title));
    rows_->setTable(rowsTable(*picture_, screenLanguage()));
    remarks_->setTable(remarksTable(*picture_, screenLanguage()));
    remarks_->resizeRowsToContents();
}

void DrawingViews::setPresenting(bool presenting)
{
    buttons_->setVisible(!presenting);
}

void DrawingViews::retranslate()
{
    heroes_->setTitle("sheet", tr("Drawing"));
    heroes_->setTitle("rows", tr("Rows"));
    heroes_->setTitle("remarks", tr("Remarks"));
    rows_->setAccessibleName(tr("Rows"));
    remarks_->setAccessibleName(tr("Remarks"));
    shaft_->setText(tr("Use this shaft"));
    shaft_->setToolTip(tr("Keep it in the project, where other panels take it as an input"));
    fit_->setText(tr("Whole sheet"));
    fit_->setToolTip(tr("The wheel enlarges the drawing, dragging moves it, a double click shows the whole sheet"));
    show();
}

}  // namespace lathelier::drawing_panel
