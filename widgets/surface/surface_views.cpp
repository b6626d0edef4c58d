#include "widgets/surface/surface_views.h"

#include <QHBoxLayout>
#include <QSignalBlocker>
#include <QSplitter>
#include <QVBoxLayout>
#include <QVariant>
#include <algorithm>

#include "engine/stability/stability_plots.h"
#include "engine/surface/surface_plots.h"
#include "widgets/core/language.h"
#include "widgets/core/panel/view_frame.h"

namespace lathelier::surface_panel {
namespace {

constexpr const char* chosenKey = "picture";
constexpr const char* feedKey = "feed_marks";
constexpr const char* chatterKey = "chatter_marks";
constexpr const char* slidesKey = "under_slider";
constexpr const char* shareKey = "slider";
constexpr const char* tableKey = "table";

template <class T>
T kept(const Values& values, const char* key, T otherwise)
{
    const Value* const value = lathelier::find(values, key);
    const T* const there = value ? std::get_if<T>(value) : nullptr;
    return there ? *there : otherwise;
}

}  // namespace

SurfaceViews::SurfaceViews(QWidget* parent)
    : QWidget(parent),
      primaryViews_(new PrimaryViews),
      marks_(new PictureView),
      showFeed_(new QToolButton),
      showChatter_(new QToolButton),
      measure_(new QToolButton),
      spectrum_(new plot::ChartView),
      lines_(new plot::ChartView),
      comparison_(new ComparisonView),
      photograph_(new PhotographView),
      unrolled_(new PictureView),
      words_(new QTextBrowser),
      model_(new plot::ChartView),
      tabs_(new QTabWidget),
      numbers_(new CopyTable),
      speeds_(new CopyTable),
      generator_(new GeneratorPane),
      bar_(new SurfaceBar)
{
    marks_->setObjectName("surfaceMarks");
    spectrum_->setObjectName("surfaceSpectrum");
    lines_->setObjectName("surfaceLines");
    unrolled_->setObjectName("surfaceUnrolled");
    words_->setObjectName("surfaceWords");
    model_->setObjectName("surfaceModel");
    numbers_->setObjectName("surfaceNumbers");
    speeds_->setObjectName("surfaceSpeeds");
    generator_->setObjectName("surfaceGenerator");
    words_->setFrameShape(QFrame::NoFrame);
    tabs_->setDocumentMode(true);
    tabs_->addTab(numbers_, {});
    tabs_->addTab(speeds_, {});
    auto* spectra = new QSplitter(Qt::Vertical);
    spectra->addWidget(spectrum_);
    spectra->addWidget(lines_);
    spectra->setStretchFactor(0, 3);
    spectra->setStretchFactor(1, 2);
    spectra->setChildrenCollapsible(false);
    lines_->setProperty(ViewFrame::onlyLarge, true);
    primaryViews_->add("marks", makeMarksSide());
    primaryViews_->add("spectrum", spectra);
    primaryViews_->add("comparison", comparison_);
    primaryViews_->add("photograph", photograph_);
    primaryViews_->add("unrolled", unrolled_);
    primaryViews_->add("words", words_);
    primaryViews_->add("model", model_);
    primaryViews_->add("tables", tabs_);
    auto* split = new QSplitter(Qt::Horizontal);
    split->addWidget(primaryViews_);
    split->addWidget(generator_);
    split->setStretchFactor(0, 1);
    split->setChildrenCollapsible(false);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(4);
    layout->addWidget(bar_);
    layout->addWidget(split, 1);
    generator_->hide();
    connectParts();
    retranslate();
}

QWidget* SurfaceViews::makeMarksSide()
{
    auto* side = new QWidget;
    auto* column = new QVBoxLayout(side);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(2);
    auto* tools = new QWidget;
    tools->setProperty(ViewFrame::onlyLarge, true);
    auto* row = new QHBoxLayout(tools);
    row->setContentsMargins(0, 0, 0, 0);
    showFeed_->setObjectName("showFeedMarks");
    showChatter_->setObjectName("showChatterMarks");
    for (QToolButton* button : {showFeed_, showChatter_}) {
        button->setCheckable(true);
        button->setChecked(true);
        row->addWidget(button);
    }
    measure_->setObjectName("measureMarks");
    measure_->setCheckable(true);
    row->addWidget(measure_);
    row->addStretch(1);
    column->addWidget(tools);
    column->addWidget(marks_, 1);
    return side;
}

void SurfaceViews::connectParts()
{
    connect(bar_, &SurfaceBar::imageChosen, this, &SurfaceViews::choose);
    connect(bar_, &SurfaceBar::sendRequested, this, &SurfaceViews::sendRequested);
    connect(bar_, &SurfaceBar::candidateRequested, this, &SurfaceViews::candidateRequested);
    for (QToolButton* button : {showFeed_, showChatter_})
        connect(button, &QToolButton::toggled, this, &SurfaceViews::showMarks);
    connect(spectrum_, &plot::PlotCanvas::clicked, this, [this](double x, double y) {
        const surface::ImageMarks* const image = marksShown();
        if (!image) return;
        const int picked = surface::lineAt(*image, x, y);
        chooseLine(picked == line_ ? -1 : picked);
    });
    connect(photograph_, &PhotographView::regionRequested, this,
            [this](const std::optional<QRectF>& region) { emit regionRequested(chosen_, region); });
    connect(measure_, &QToolButton::toggled, this, [this](bool on) {
        for (PictureView* view : {marks_, unrolled_})
            view->setTool(on ? PictureView::Tool::Length : PictureView::Tool::None);
    });
    connect(photograph_, &PhotographView::scaleRequested, this,
            [this](double pixels, double mm) { emit scaleRequested(chosen_, pixels, mm); });
    connect(photograph_, &PhotographView::directionRequested, this,
            [this](double direction_deg) { emit directionRequested(chosen_, direction_deg); });
    connect(photograph_, &PhotographView::alikeRequested, this, &SurfaceViews::alikeRequested);
    connect(comparison_, &ComparisonView::layRequested, this, &SurfaceViews::layRequested);
    connect(generator_, &GeneratorPane::valueRequested, this, &SurfaceViews::madeRequested);
    connect(comparison_, &ComparisonView::notWritten, this, &SurfaceViews::notWritten);
    for (plot::PlotWidget* plot :
         {static_cast<plot::PlotWidget*>(marks_), static_cast<plot::PlotWidget*>(unrolled_),
          static_cast<plot::PlotWidget*>(photograph_->view()), static_cast<plot::PlotWidget*>(spectrum_),
          static_cast<plot::PlotWidget*>(lines_), static_cast<plot::PlotWidget*>(model_)})
        connect(plot, &plot::PlotWidget::notWritten, this, &SurfaceViews::notWritten);
}

void SurfaceViews::setOutcome(const std::shared_ptr<const ShownOutcome>& outcome)
{
    outcome_ = outcome;
    if (chosen_ >= static_cast<int>(outcome->shown.size())) chosen_ = 0;
    const surface::ImageMarks* const image = marksShown();
    if (!image || line_ >= static_cast<int>(image->view.lines.size())) line_ = -1;
    show();
}

const surface::ImageMarks* SurfaceViews::marksShown() const
{
    return outcome_ && outcome_->result ? &outcome_->result->images.at(static_cast<std::size_t>(chosen_)) : nullptr;
}

void SurfaceViews::choose(int image)
{
    if (!outcome_ || image < 0 || image >= static_cast<int>(outcome_->shown.size())) image = 0;
    if (image != chosen_) line_ = -1;
    chosen_ = image;
    show();
}

void SurfaceViews::chooseLine(int line)
{
    line_ = line;
    showMarks();
    showSpectrum();
}

/// Makes views with content available; for an open question only those without results.
void SurfaceViews::chooseViews()
{
    const bool there = outcome_->result != nullptr, told = there && !outcome_->asks();
    primaryViews_->setAvailable("marks", there);
    for (const char* key : {"spectrum", "words", "tables"}) primaryViews_->setAvailable(key, told);
    primaryViews_->setAvailable("comparison", !outcome_->before.isNull());
    primaryViews_->setAvailable("unrolled", there && marksShown()->unrolled);
    primaryViews_->setAvailable("model", told && outcome_->model != nullptr);
    showChatter_->setVisible(!outcome_->asks());
}

void SurfaceViews::show()
{
    if (!outcome_) return;
    chooseViews();
    bar_->setOutcome(*outcome_, chosen_);
    bar_->setVisible(!presenting_);
    showPhotograph();
    showGenerator();
    if (!outcome_->result) return;
    showMarks();
    showSpectrum();
    showComparison();
    showWords();
    showTables();
    if (!outcome_->model) return;
    report::Plot plot = chatterFrequencyPlot(*outcome_->model);
    if (outcome_->marks) drawMarksFrequency(plot, *outcome_->marks, screenLanguage());
    model_->setData(std::move(plot));
}

Values SurfaceViews::view() const
{
    return {{chosenKey, std::int64_t{chosen_}},      {feedKey, showFeed_->isChecked()},
            {chatterKey, showChatter_->isChecked()}, {slidesKey, comparison_->hasSlider()},
            {shareKey, comparison_->share()},        {tableKey, std::int64_t{tabs_->currentIndex()}}};
}

void SurfaceViews::restoreView(const Values& values)
{
    const QSignalBlocker quiet_feed(showFeed_), quiet_chatter(showChatter_);  // all is shown at the end
    showFeed_->setChecked(kept(values, feedKey, true));
    showChatter_->setChecked(kept(values, chatterKey, true));
    comparison_->setSlides(kept(values, slidesKey, false));
    comparison_->setShare(kept(values, shareKey, 0.5));
    tabs_->setCurrentIndex(static_cast<int>(std::clamp<std::int64_t>(kept<std::int64_t>(values, tableKey, 0), 0, 1)));
    const int chosen = kept<std::int64_t>(values, chosenKey, 0) == 1 ? 1 : 0;
    if (outcome_)
        choose(chosen);  // one that there is
    else
        chosen_ = chosen;
}

void SurfaceViews::setPresenting(bool presenting)
{
    presenting_ = presenting;
    bar_->setVisible(!presenting);
    if (outcome_) showGenerator();
}

void SurfaceViews::retranslate()
{
    primaryViews_->setTitle("marks", tr("Marks"));
    primaryViews_->setTitle("spectrum", tr("Spectrum"));
    primaryViews_->setTitle("comparison", tr("Before and after"));
    primaryViews_->setTitle("photograph", tr("Photograph"));
    primaryViews_->setTitle("unrolled", tr("Unrolled"));
    primaryViews_->setTitle("words", tr("What the picture says"));
    primaryViews_->setTitle("model", tr("Model"));
    primaryViews_->setTitle("tables", tr("Tables"));
    showFeed_->setText(tr("Feed marks"));
    showFeed_->setToolTip(tr("Draw the crests of the feed marks over the picture"));
    showChatter_->setText(tr("Chatter marks"));
    showChatter_->setToolTip(tr("Draw the crests of the chatter marks over the picture"));
    measure_->setText(tr("Measure"));
    measure_->setToolTip(tr("Two clicks show their distance, along the axis and round the part"));
    bar_->retranslate();
    marks_->setAccessibleName(tr("Picture without its uneven light, with its marks"));
    unrolled_->setAccessibleName(tr("Picture with the circumference laid flat"));
    spectrum_->setAccessibleName(tr("Spectrum"));
    spectrum_->setToolTip(tr("A click on a ring draws its stripes over the picture"));
    lines_->setAccessibleName(tr("Lines over the noise"));
    model_->setAccessibleName(tr("Chatter frequency of the model"));
    words_->setAccessibleName(tr("What the picture says"));
    const QStringList names{tr("Numbers"), tr("What speed next")};
    for (int i = 0; i < names.size(); ++i) {
        tabs_->setTabText(i, names[i]);
        tabs_->widget(i)->setAccessibleName(names[i]);
    }
    comparison_->retranslate();
    photograph_->retranslate();
    generator_->retranslate();
    show();
}

}  // namespace lathelier::surface_panel
