// The photograph as it is in its file, with the tools that say what is in it: a region, a length that is known, the
// direction of feed.
#pragma once

#include <QButtonGroup>
#include <QCheckBox>
#include <QLabel>
#include <QPushButton>
#include <QWidget>

#include "widgets/core/form/number_edit.h"
#include "widgets/surface/picture_view.h"

namespace lathelier::surface_panel {

class PhotographView : public QWidget {
    Q_OBJECT

public:
    explicit PhotographView(QWidget* parent = nullptr);

    /// `diameter_mm`: offered as the length between two edges; none: not known.
    void setPicture(const QImage& image, double mm_per_px, const std::optional<double>& diameter_mm);
    void setTools(bool usable);             ///< false: a generated picture can be measured, but has no import settings
    void setAlike(bool shown, bool alike);  ///< the tick: scale and direction go for both pictures
    PictureView* view() const { return view_; }
    NumberEdit* length() const { return length_; }
    void retranslate();

signals:
    void regionRequested(const std::optional<QRectF>& region);  ///< in pixels of the file; none: the whole picture
    void scaleRequested(double pixels, double mm);
    void directionRequested(double direction_deg);
    void alikeRequested(bool alike);

private:
    void chooseTool(int id);
    void takeLength(double pixels);
    void showLength();

    PictureView* view_;
    QWidget* bar_;
    QButtonGroup* tools_;
    QPushButton* whole_;
    QLabel* measured_;
    NumberEdit* length_;
    QPushButton* set_;
    QPushButton* isDiameter_;
    QCheckBox* alike_;
    QLabel* hint_;
    bool usable_ = true;
    double pixels_ = 0;  ///< between the two clicks; 0: not clicked
    std::optional<double> diameter_mm_;
};

}  // namespace lathelier::surface_panel
