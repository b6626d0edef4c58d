// The views of a shaft: its drawing with ends to drag, mode shapes that swing, its response and frequencies.
#pragma once

#include <QPushButton>
#include <QTimer>
#include <QToolButton>
#include <QWidget>
#include <memory>

#include "widgets/core/panel/copy_table.h"
#include "widgets/core/panel/hero_views.h"
#include "widgets/plot/chart_view.h"
#include "widgets/shaft/shaft_picture.h"

namespace lathelier::shaft_panel {

class ShaftViews : public QWidget {
    Q_OBJECT

public:
    explicit ShaftViews(QWidget* parent = nullptr);

    void setPicture(const std::shared_ptr<const ShaftPicture>& picture);
    HeroViews* heroes() const { return heroes_; }
    plot::ChartView* drawing() const { return drawing_; }
    plot::ChartView* shapes() const { return shapes_; }
    void setPresenting(bool presenting);  ///< without the buttons
    void retranslate();

signals:
    void endMoved(std::size_t segment, double z_mm, double radius_mm, bool dropped);
    void shaftWanted();                    ///< keep it in the project
    void responseWanted();                 ///< give it to another panel
    void notWritten(const QString& path);  ///< the system refused to write this file

private:
    void show();
    void play(bool on);
    void swing();

    std::shared_ptr<const ShaftPicture> picture_;
    HeroViews* heroes_;
    plot::ChartView* drawing_;
    plot::ChartView* shapes_;
    plot::ChartView* magnitude_;
    plot::ChartView* parts_;
    CopyTable* frequencies_;
    QWidget* buttons_;
    QToolButton* play_;
    QPushButton* shaft_;
    QPushButton* response_;
    QTimer clock_;
    int tick_ = 0;  ///< of the swing
};

}  // namespace lathelier::shaft_panel
