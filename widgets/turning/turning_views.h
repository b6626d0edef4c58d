// The views of a turning program, linked: the contour with its stock and what runs along it; the text beside its path;
// operations, speeds with their reason, what stays and what is met, the set-up sheet. Below all of them a scrubber
// moves the tool along the program.
#pragma once

#include <QButtonGroup>
#include <QWidget>
#include <memory>
#include <optional>

#include "widgets/core/panel/copy_table.h"
#include "widgets/core/panel/hero_views.h"
#include "widgets/plot/chart_view.h"
#include "widgets/turning/operations_table.h"
#include "widgets/turning/tool_scrubber.h"
#include "widgets/turning/turning_charts.h"
#include "widgets/turning/turning_picture.h"

namespace lathelier::program_common {
class ProgramEditor;
}

namespace lathelier::turning_panel {

class TurningViews : public QWidget {
    Q_OBJECT

public:
    explicit TurningViews(QWidget* parent = nullptr);
    ~TurningViews() override;

    void setPicture(const std::shared_ptr<const TurningPicture>& picture);

    HeroViews* heroes() const { return heroes_; }
    plot::ChartView* contour() const { return contour_; }
    plot::ChartView* course() const { return course_; }
    plot::ChartView* why() const { return why_; }
    program_common::ProgramEditor* editor() const { return editor_; }
    OperationsTable* operations() const { return operations_; }
    CopyTable* sections() const { return sections_; }
    CopyTable* rest() const { return rest_; }
    CopyTable* findings() const { return findings_; }
    ToolScrubber* scrubber() const { return scrubber_; }

    std::size_t clamping() const { return clamping_; }  ///< that is shown, from 0
    void setClamping(std::size_t clamping);
    Course courseShown() const { return shown_; }
    void setCourse(Course course);

    void goToLine(std::int64_t line);                   ///< the tool stands at the end of this block
    std::int64_t line() const { return line_; }         ///< that runs at the scrubber's place; 0: none
    const StockShown& stock() const { return stock_; }  ///< as the contour has it
    void showStretch(const Interval& z_mm);             ///< of the part as drawn
    void setPresenting(bool presenting);                ///< without the scrubber
    void retranslate();

signals:
    /// An operation is switched on or off.
    void operationSwitched(const lathelier::cam::SkippedOperation& operation, bool on);
    void notWritten(const QString& path);  ///< the system refused to write a picture

private:
    QWidget* makeContourSide();
    void connectParts();
    void connectTables();
    void show();
    void showTables();
    void showStock(const StockShown& shown, bool again);
    void showCourse();
    void showWhy(int section);
    void moveTool(int place);
    void pointOutTool(const QPointF& tip, int number);
    void pick(plot::ChartView* chart, double z_mm, double x_mm);
    const ClampingPicture* shownClamping() const;

    std::shared_ptr<const TurningPicture> picture_;
    std::size_t clamping_ = 0;
    Course shown_ = Course::Speed;
    StockShown stock_;
    std::int64_t line_ = 0;
    HeroViews* heroes_;
    plot::ChartView* contour_;
    plot::ChartView* course_;
    plot::ChartView* path_;
    plot::ChartView* why_;
    QButtonGroup* courses_;
    program_common::ProgramEditor* editor_;
    OperationsTable* operations_;
    CopyTable* sections_;
    CopyTable* rest_;
    CopyTable* findings_;
    CopyTable* sheet_;
    CopyTable* tools_;
    ToolScrubber* scrubber_;
};

}  // namespace lathelier::turning_panel
