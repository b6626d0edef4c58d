// The views of a series: chart, deviation pictures, values, the part in detail, the characteristics to choose from.
#pragma once

#include <QPushButton>
#include <QWidget>
#include <memory>
#include <string>

#include "engine/series/series_task.h"
#include "widgets/core/panel/copy_table.h"
#include "widgets/core/panel/primary_views.h"
#include "widgets/plot/chart_view.h"
#include "widgets/series/pictures_view.h"

namespace lathelier::series_panel {

class SeriesViews : public QWidget {
    Q_OBJECT

public:
    explicit SeriesViews(QWidget* parent = nullptr);

    void setOutcome(const std::shared_ptr<const series::SeriesOutcome>& outcome);
    PrimaryViews* primaryViews() const { return primaryViews_; }
    plot::ChartView* chart() const { return chart_; }
    PicturesView* pictures() const { return pictures_; }
    CopyTable* values() const { return values_; }
    CopyTable* characteristics() const { return characteristics_; }
    QPushButton* openButton() const { return open_; }
    void retranslate();

signals:
    void partChosen(const std::string& uuid);
    void partOpened(const std::string& uuid);
    void characteristicChosen(const std::string& task, const std::string& key);
    void notWritten(const QString& path);  ///< the file could not be written

private:
    QWidget* makeDetail();
    void connectViews();
    void show();
    void choosePoint(std::size_t number);

    std::shared_ptr<const series::SeriesOutcome> outcome_;
    bool filling_ = false;  ///< the tables are being filled: what they select is nobody's choice
    PrimaryViews* primaryViews_;
    plot::ChartView* chart_;
    PicturesView* pictures_;
    CopyTable* values_;
    CopyTable* characteristics_;
    CopyTable* facts_;
    CopyTable* numbers_;
    QPushButton* open_;
};

}  // namespace lathelier::series_panel
