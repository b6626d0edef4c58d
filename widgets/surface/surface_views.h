// The views of photographs of a surface: the flattened picture with its marks, spectrum, before and after, photograph
// with tools, the unrolled picture, sentences, the model's frequencies, tables; and the generator beside them.
#pragma once

#include <QTabWidget>
#include <QTextBrowser>
#include <QToolButton>
#include <QWidget>
#include <memory>

#include "widgets/core/panel/copy_table.h"
#include "widgets/core/panel/primary_views.h"
#include "widgets/plot/chart_view.h"
#include "widgets/surface/comparison_view.h"
#include "widgets/surface/generator_pane.h"
#include "widgets/surface/photograph_view.h"
#include "widgets/surface/shown_outcome.h"
#include "widgets/surface/surface_bar.h"

namespace lathelier::surface_panel {

class SurfaceViews : public QWidget {
    Q_OBJECT

public:
    explicit SurfaceViews(QWidget* parent = nullptr);

    void setOutcome(const std::shared_ptr<const ShownOutcome>& outcome);
    PrimaryViews* primaryViews() const { return primaryViews_; }
    PictureView* marks() const { return marks_; }
    plot::ChartView* spectrum() const { return spectrum_; }
    ComparisonView* comparison() const { return comparison_; }
    PhotographView* photograph() const { return photograph_; }
    GeneratorPane* generator() const { return generator_; }
    QTextBrowser* words() const { return words_; }
    QPushButton* sendButton() const { return bar_->sendButton(); }

    int chosen() const { return chosen_; }  ///< shown picture, from 0
    void choose(int image);
    int line() const { return line_; }  ///< line of the spectrum drawn over the picture; -1: none
    void chooseLine(int line);

    Values view() const;
    void restoreView(const Values& kept);
    void setPresenting(bool presenting);
    void retranslate();

signals:
    void alikeRequested(bool alike);
    void layRequested(const QPointF& further_px);
    void sendRequested();
    void candidateRequested(double frequency_hz);
    void regionRequested(int image, const std::optional<QRectF>& region);
    void scaleRequested(int image, double pixels, double mm);
    void directionRequested(int image, double direction_deg);
    void madeRequested(const std::string& key, const lathelier::Value& value, int gesture);
    void notWritten(const QString& path);

private:
    QWidget* makeMarksSide();
    void connectParts();
    void chooseViews();
    void show();
    void showMarks();
    void showSpectrum();
    void showPhotograph();
    void showComparison();
    void showWords();
    void showTables();
    void showGenerator();
    const surface::ImageMarks* marksShown() const;

    std::shared_ptr<const ShownOutcome> outcome_;
    int chosen_ = 0;
    int line_ = -1;
    bool presenting_ = false;
    PrimaryViews* primaryViews_;
    PictureView* marks_;
    QToolButton* showFeed_;
    QToolButton* showChatter_;
    QToolButton* measure_;
    plot::ChartView* spectrum_;
    plot::ChartView* lines_;
    ComparisonView* comparison_;
    PhotographView* photograph_;
    PictureView* unrolled_;
    QTextBrowser* words_;
    plot::ChartView* model_;
    QTabWidget* tabs_;
    CopyTable* numbers_;
    CopyTable* speeds_;
    GeneratorPane* generator_;
    SurfaceBar* bar_;
};

}  // namespace lathelier::surface_panel
