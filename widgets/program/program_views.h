// The views of a program: text and path, linked; errors; passes; tools.
#pragma once

#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSplitter>
#include <QTimer>
#include <QToolButton>
#include <QWidget>
#include <memory>

#include "engine/deflection/toolpath_task.h"
#include "widgets/core/panel/copy_table.h"
#include "widgets/core/panel/primary_views.h"
#include "widgets/plot/chart_view.h"

namespace lathelier::program_common {
class ProgramEditor;
}

namespace lathelier::program_panel {

using program_common::ProgramEditor;

class ProgramViews : public QWidget {
    Q_OBJECT

public:
    explicit ProgramViews(QWidget* parent = nullptr);
    ~ProgramViews() override;

    /// Shows an outcome; its text only with `takesText`, so that pending input is kept.
    void setOutcome(const std::shared_ptr<const deflection::ToolpathOutcome>& outcome, bool takesText);

    PrimaryViews* primaryViews() const { return primaryViews_; }
    ProgramEditor* editor() const { return editor_; }
    plot::ChartView* path() const { return path_; }
    CopyTable* remarks() const { return remarks_; }
    CopyTable* passes() const { return passes_; }
    CopyTable* tools() const { return tools_; }

    void goToLine(std::int64_t line);
    /// Shows the stock after this pass; none: after all passes.
    void setPass(std::optional<std::size_t> pass);
    std::optional<std::size_t> pass() const { return pass_; }

    void retranslate();

signals:
    void edited();                         ///< the text differs from that of the outcome
    void saveRequested();                  ///< request to save under a new name
    void discardRequested();               ///< request to discard the edits
    void notWritten(const QString& path);  ///< an image could not be written

protected:
    void changeEvent(QEvent* event) override;

private:
    QWidget* makeTextSide();
    void connectParts();
    void show();
    void showPath();
    void drawPathAgain();
    void pointOutLine(std::int64_t line);
    void pick(double z_mm, double x_mm);
    QString whereText(std::int64_t line) const;
    std::vector<QPolygonF> toolAt(const QPointF& tip, int number) const;
    void findNext(bool forward);

    std::shared_ptr<const deflection::ToolpathOutcome> outcome_;
    std::optional<std::size_t> pass_;
    PrimaryViews* primaryViews_;
    plot::ChartView* path_;
    ProgramEditor* editor_;
    QLabel* where_;  ///< description of the block at the caret
    QLineEdit* search_;
    QToolButton* earlier_;
    QToolButton* later_;
    QLabel* state_;  ///< changed or as on disk
    QPushButton* save_;
    QPushButton* discard_;
    CopyTable* remarks_;
    CopyTable* passes_;
    CopyTable* tools_;
    QTimer redraw_;      ///< delays the redraw of a large path
    QRectF drawnRange_;  ///< visible range of the last redraw
};

}  // namespace lathelier::program_panel
