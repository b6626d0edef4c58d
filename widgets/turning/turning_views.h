// The views of a turning program, linked: the part as it is cut; the contour with its stock, and what runs along it;
// the text, which can be changed, beside its path; operations, speeds with reasons, remaining material and collisions,
// set-up sheet. Below all of them a scrubber moves the tool along the program.
#pragma once

#include <QLabel>
#include <QToolButton>
#include <QWidget>
#include <memory>
#include <optional>

#include "engine/cam/drawn/drawn_plan.h"
#include "engine/cam/drawn/plan_charts.h"
#include "widgets/core/panel/copy_table.h"
#include "widgets/core/panel/primary_views.h"
#include "widgets/plot/chart_view.h"
#include "widgets/scene/scene_view.h"
#include "widgets/turning/course_charts.h"
#include "widgets/turning/operations_pane.h"
#include "widgets/turning/program_bar.h"
#include "widgets/turning/tool_scrubber.h"

namespace lathelier::program_common {
class ProgramEditor;
}

namespace lathelier::turning_panel {

class TurningViews : public QWidget {
    Q_OBJECT

public:
    explicit TurningViews(QWidget* parent = nullptr);
    ~TurningViews() override;

    /// `takes_text`: the editor shows the texts of the outcome; else it keeps pending input.
    void setOutcome(const std::shared_ptr<const cam::TurningOutcome>& outcome, bool takes_text);

    PrimaryViews* primaryViews() const { return primaryViews_; }
    scene::SceneView* cut() const { return cut_; }
    plot::ChartView* contour() const { return contour_; }
    CourseCharts* courses() const { return courses_; }
    plot::ChartView* why() const { return why_; }
    program_common::ProgramEditor* editor() const { return editor_; }
    ProgramBar* bar() const { return bar_; }
    OperationsPane* order() const { return operations_; }
    OperationsTable* operations() const { return operations_->table(); }
    CopyTable* sections() const { return sections_; }
    QLabel* sentence() const { return sentence_; }  ///< in place of speeds, where there is no dynamics
    QToolButton* openLobes() const { return lobes_; }
    CopyTable* rest() const { return rest_; }
    CopyTable* findings() const { return findings_; }
    ToolScrubber* scrubber() const { return scrubber_; }

    std::size_t clamping() const { return clamping_; }  ///< shown clamping, from 0
    void setClamping(std::size_t clamping);

    void goToLine(std::int64_t line);                        ///< the tool stands at the end of this block
    std::int64_t line() const { return line_; }              ///< that runs at the scrubber's place; 0: none
    const cam::StockShown& stock() const { return stock_; }  ///< as the contour has it
    void showStretch(const Interval& z_mm);                  ///< of the part as drawn
    void showRest(std::size_t rest);                         ///< index: in its clamping, at its block
    void setPresenting(bool presenting);                     ///< without the scrubber
    void retranslate();

signals:
    /// An operation is switched on or off.
    void operationSwitched(const lathelier::cam::SkippedOperation& operation, bool on);
    void programEdited(int clamping, const std::string& utf8);  ///< from 0
    void checkRequested(int clamping);                          ///< of the text that stands there
    void takeBackRequested(int clamping);                       ///< the changes by hand
    void useRequested(int clamping);                            ///< the program, in other panels
    void lobesRequested(int section);                           ///< in the panel of lobes, at that moment of the part
    void notWritten(const QString& path);                       ///< the system refused to write a picture

private:
    QWidget* makeContourSide();
    QWidget* makeProgramSide();
    QWidget* makeSectionsSide();
    void connectParts();
    void connectTables();
    void show();
    void showText();
    void showTables();
    void showSections();
    void showStock(const cam::StockShown& shown, bool again);
    void showCut();
    void showWhy(int section);
    void moveTool(int place, bool moves_caret = true);
    void pointOutTool(const QPointF& tip, int number);
    void pick(plot::ChartView* chart, double z_mm, double x_mm);
    const cam::ClampingOutcome* shownClamping() const;

    std::shared_ptr<const cam::TurningOutcome> outcome_;
    std::size_t clamping_ = 0;
    bool takesText_ = true;
    cam::StockShown stock_;
    std::int64_t line_ = 0;
    PrimaryViews* primaryViews_;
    scene::SceneView* cut_;
    std::vector<scene::SceneObject> stockShown_;  ///< of `stock_`, in the scene
    QPointF tip_;                                 ///< of the tool: z of the stock, radius
    int tool_ = 0;                                ///< its number; 0: none is shown
    plot::ChartView* contour_;
    CourseCharts* courses_;
    plot::ChartView* path_;
    plot::ChartView* why_;
    program_common::ProgramEditor* editor_;
    ProgramBar* bar_;
    OperationsPane* operations_;
    CopyTable* sections_;
    QLabel* sentence_;
    QToolButton* lobes_;
    CopyTable* rest_;
    CopyTable* findings_;
    CopyTable* sheet_;
    CopyTable* tools_;
    ToolScrubber* scrubber_;
};

}  // namespace lathelier::turning_panel
