// The views of photographs of a surface: the flattened picture with its marks, spectrum, before and after, photograph
// with tools, the unrolled picture, sentences, the model's frequencies, tables; and the generator beside them.
#pragma once

#include <QTabWidget>
#include <QTextBrowser>
#include <QToolButton>
#include <QWidget>
#include <memory>

#include "widgets/core/panel/copy_table.h"
#include "widgets/core/panel/hero_views.h"
#include "widgets/plot/chart_view.h"
#include "widgets/surface/comparison_view.h"
#include "widgets/surface/generator_pane.h"
#include "widgets/surface/photograph_view.h"
#include "widgets/surface/surface_bar.h"
#include "widgets/surface/surface_picture.h"

namespace lathelier::surface_panel {

class SurfaceViews : public QWidget {
    Q_OBJECT

public:
    explicit SurfaceViews(QWidget* parent = nullptr);

    void setPicture(const std::shared_ptr<const SurfacePicture>& picture);
    HeroViews* heroes() const { return heroes_; }
    PictureView* marks() const { return marks_; }
    plot::ChartView* spectrum() const { return spectrum_; }
    ComparisonView* comparison() const { return comparison_; }
    PhotographView* photograph() const { return photograph_; }
    GeneratorPane* generator() const { return generator_; }
    QTextBrowser* words() const { return words_; }
    QPushButton* sendButton() const { return bar_->sendButton(); }

    int chosen() const { return chosen_; }  ///< picture that is shown, from 0
    void choose(int image);
    int line() const { return line_; }  ///< of the spectrum, that is drawn over the picture; -1: none
    void chooseLine(int line);

    Values view() const;
    void restoreView(const Values& kept);
    void setPresenting(bool presenting);
    void retranslate();

signals:
    void alikeWanted(bool alike);
    void layWanted(const QPointF& further_px);
    void sendWanted();
    void candidateWanted(double frequency_hz);
    void regionWanted(int image, const std::optional<QRectF>& region);
    void scaleWanted(int image, double pixels, double mm);
    void directionWanted(int image, double direction_deg);
    void madeWanted(const std::string& key, const lathelier::Value& value, int gesture);
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

    std::shared_ptr<const SurfacePicture> picture_;
    int chosen_ = 0;
    int line_ = -1;
    bool presenting_ = false;
    HeroViews* heroes_;
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
