// The views of a program: its text under its path, each pointing at the other; what is wrong; passes; tools.
#pragma once

#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSplitter>
#include <QTimer>
#include <QToolButton>
#include <QWidget>
#include <memory>

#include "widgets/core/panel/copy_table.h"
#include "widgets/core/panel/hero_views.h"
#include "widgets/plot/chart_view.h"
#include "widgets/program/program_picture.h"

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

    /// Shows a picture; its text only when `takesText`: what is typed since it was asked for stays.
    void setPicture(const std::shared_ptr<const ProgramPicture>& picture, bool takesText);

    HeroViews* heroes() const { return heroes_; }
    ProgramEditor* editor() const { return editor_; }
    plot::ChartView* path() const { return path_; }
    CopyTable* remarks() const { return remarks_; }
    CopyTable* passes() const { return passes_; }
    CopyTable* tools() const { return tools_; }

    void goToLine(std::int64_t line);
    /// Shows the stock after this pass; none: after all.
    void setPass(std::optional<std::size_t> pass);
    std::optional<std::size_t> pass() const { return pass_; }

    void retranslate();

signals:
    void edited();                         ///< the text differs from that of the picture
    void saveWanted();                     ///< under a new name
    void discardWanted();                  ///< back to the file
    void notWritten(const QString& path);  ///< the system refused to write a picture

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

    std::shared_ptr<const ProgramPicture> picture_;
    std::optional<std::size_t> pass_;
    HeroViews* heroes_;
    plot::ChartView* path_;
    ProgramEditor* editor_;
    QLabel* where_;  ///< what the block at the caret does
    QLineEdit* search_;
    QToolButton* earlier_;
    QToolButton* later_;
    QLabel* state_;  ///< changed or as on the disk
    QPushButton* save_;
    QPushButton* discard_;
    CopyTable* remarks_;
    CopyTable* passes_;
    CopyTable* tools_;
    QTimer redraw_;       ///< a large path is thinned for what is shown
    QRectF drawn_range_;  ///< that it was thinned for
};

}  // namespace lathelier::program_panel
