#include "widgets/turning/turning_views.h"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QSplitter>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "engine/cam/drawn/stock_skin.h"
#include "engine/core/units.h"
#include "widgets/core/language.h"
#include "widgets/program_common/program_editor.h"
#include "widgets/turning/tool_shapes.h"

namespace lathelier::turning_panel {
namespace {

using program_common::LineRemark;
using program_common::ProgramEditor;

constexpr int places = ToolScrubber::places;
constexpr int leastPixels = 200;
const QColor steel(150, 160, 172), carbide(190, 150, 60);

QSplitter* stacked(std::initializer_list<QWidget*> parts)
{
    auto* splitter = new QSplitter(Qt::Vertical);
    for (QWidget* part : parts) splitter->addWidget(part);
    splitter->setChildrenCollapsible(false);
    return splitter;
}

}  // namespace

TurningViews::TurningViews(QWidget* parent)
    : QWidget(parent),
      primaryViews_(new PrimaryViews),
      cut_(new scene::SceneView),
      contour_(new plot::ChartView),
      courses_(new CourseCharts(contour_)),
      path_(new plot::ChartView),
      why_(new plot::ChartView),
      editor_(new ProgramEditor),
      bar_(new ProgramBar),
      operations_(new OperationsPane),
      sections_(new CopyTable),
      sentence_(new QLabel),
      lobes_(new QToolButton),
      rest_(new CopyTable),
      findings_(new CopyTable),
      sheet_(new CopyTable),
      tools_(new CopyTable),
      scrubber_(new ToolScrubber)
{
    cut_->setObjectName("turningCut");
    contour_->setObjectName("turningContour");
    path_->setObjectName("turningPath");
    why_->setObjectName("turningWhy");
    editor_->setObjectName("turningText");
    sections_->setObjectName("turningSections");
    rest_->setObjectName("turningRest");
    findings_->setObjectName("turningFindings");
    sheet_->setObjectName("turningSheet");
    tools_->setObjectName("turningTools");
    sentence_->setObjectName("turningSentence");
    lobes_->setObjectName("turningOpenLobes");
    primaryViews_->add("cut", cut_);
    primaryViews_->setAvailable("cut", cut_->canDraw());
    primaryViews_->add("contour", makeContourSide());
    primaryViews_->add("program", makeProgramSide());
    primaryViews_->add("operations", operations_);
    primaryViews_->add("sections", makeSectionsSide());
    primaryViews_->add("rest", stacked({rest_, findings_}));
    primaryViews_->add("sheet", stacked({sheet_, tools_}));
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(primaryViews_, 1);
    layout->addWidget(scrubber_);
    connectParts();
    connectTables();
    retranslate();
}

TurningViews::~TurningViews() = default;

/// The contour, and what runs along the part below it over the same z.
QWidget* TurningViews::makeContourSide()
{
    QSplitter* both = stacked({contour_, courses_});
    both->setStretchFactor(0, 5);
    both->setStretchFactor(1, 4);
    return both;
}

QWidget* TurningViews::makeProgramSide()
{
    auto* text = new QWidget;
    auto* column = new QVBoxLayout(text);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(2);
    column->addWidget(bar_);
    column->addWidget(editor_, 1);
    auto* program = new QSplitter(Qt::Horizontal);
    program->addWidget(text);
    program->addWidget(path_);
    program->setChildrenCollapsible(false);
    program->setStretchFactor(0, 2);
    program->setStretchFactor(1, 3);
    program->setSizes({400, 600});  // shares: the hint of a text is narrow
    return program;
}

/// Speeds with the lobes of the row that is chosen; without dynamics an explanatory sentence.
QWidget* TurningViews::makeSectionsSide()
{
    sentence_->setWordWrap(true);
    sentence_->setMargin(8);
    sentence_->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    auto* why = new QWidget;
    auto* column = new QVBoxLayout(why);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(2);
    column->addWidget(lobes_, 0, Qt::AlignLeft);
    column->addWidget(why_, 1);
    auto* side = new QWidget;
    auto* layout = new QVBoxLayout(side);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(sentence_);
    layout->addWidget(stacked({sections_, why}), 1);
    return side;
}

void TurningViews::connectParts()
{
    const auto at = [this] { return static_cast<int>(clamping_); };
    connect(editor_, &ProgramEditor::edited, this,
            [this, at] { emit programEdited(at(), editor_->program().toStdString()); });
    connect(bar_, &ProgramBar::checkRequested, this, [this, at] {
        editor_->takeOver();
        emit checkRequested(at());
    });
    connect(bar_, &ProgramBar::takeBackRequested, this, [this, at] {
        editor_->takeOver();  // commits pending input, which would otherwise be applied afterwards
        emit takeBackRequested(at());
    });
    connect(bar_, &ProgramBar::useRequested, this, [this, at] { emit useRequested(at()); });
    connect(lobes_, &QToolButton::clicked, this, [this] { emit lobesRequested(std::max(0, sections_->currentRow())); });
    connect(scrubber_, &ToolScrubber::clampingChosen, this,
            [this](int id) { setClamping(static_cast<std::size_t>(id)); });
    connect(scrubber_, &ToolScrubber::moved, this, [this](int place) { moveTool(place); });
    // The signal may be emitted during painting, when charts must not be redrawn.
    connect(
        editor_, &ProgramEditor::lineReached, this,
        [this] {
            if (editor_->line() != line_) goToLine(editor_->line());
        },
        Qt::QueuedConnection);
    for (plot::ChartView* chart : {contour_, path_})
        connect(chart, &plot::PlotCanvas::clicked, this,
                [this, chart](double z_mm, double x_mm) { pick(chart, z_mm, x_mm); });
    connect(courses_, &CourseCharts::notWritten, this, &TurningViews::notWritten);
    for (plot::ChartView* chart : {contour_, path_, why_})
        connect(chart, &plot::PlotWidget::notWritten, this, &TurningViews::notWritten);
}

void TurningViews::setOutcome(const std::shared_ptr<const cam::TurningOutcome>& outcome, bool takes_text)
{
    scrubber_->setPlaying(false);
    outcome_ = outcome;
    takesText_ = takes_text;
    if (clamping_ >= outcome->clampings.size()) clamping_ = 0;
    show();
}

const cam::ClampingOutcome* TurningViews::shownClamping() const
{
    return outcome_ ? &outcome_->clampings[clamping_] : nullptr;
}

void TurningViews::setClamping(std::size_t clamping)
{
    if (outcome_ && clamping >= outcome_->clampings.size()) clamping = 0;
    if (clamping == clamping_) return;
    scrubber_->setPlaying(false);
    editor_->takeOver();  // commits pending input to the previous clamping
    clamping_ = clamping;
    takesText_ = true;
    line_ = 0;
    show();
}

/// While the text is being changed, the tool stays at the line of the caret.
void TurningViews::show()
{
    if (!outcome_) return;
    scrubber_->setClampings(outcome_->clampings.size(), clamping_);
    const bool is_editing = editor_->hasFocus();
    showText();
    showTables();
    courses_->setOutcome(*outcome_, clamping_);
    tool_ = 0;  // that of the clamping before
    showStock(stock_, true);
    if (is_editing) return goToLine(editor_->line());
    scrubber_->setPlace(places);
    moveTool(places);
}

void TurningViews::showText()
{
    const cam::SetupPlan& setup = outcome_->plan->setups[clamping_];
    bar_->setOutcome(*outcome_, clamping_);
    if (takesText_)
        editor_->setProgram(QByteArray::fromStdString(setup.text), QString("clamping %1").arg(clamping_ + 1),
                            setup.check.program.control);
    std::vector<LineRemark> remarks;
    for (const gcode::Diagnostic& diagnostic : setup.check.path.diagnostics)
        if (diagnostic.error)
            remarks.push_back({diagnostic.line, diagnostic.column, true, screenText(*diagnostic.error)});
    for (const cam::CheckFinding& found : setup.check.findings)
        remarks.push_back(
            {found.line, 0, true,
             tr("%1, %2 deep").arg(screenText(cam::nameOf(found.kind)), screenQuantity(found.depth_mm, unit::mm, 3))});
    editor_->setRemarks(std::move(remarks));
}

/// Draws contour and path where the stock is another one, or `again`.
void TurningViews::showStock(const cam::StockShown& shown, bool again)
{
    if (!outcome_ || (shown == stock_ && !again)) return;
    stock_ = shown;
    report::Plot plot =
        contourPlot(*outcome_, clamping_, shown, std::max(leastPixels, contour_->width()), screenLanguage());
    report::Plot path = plot;
    path.marks.clear();  // shown in the other view
    for (report::Curve& curve : path.curves) curve.name = std::string();
    for (report::Region& region : path.regions) region.name = std::string();
    contour_->setData(std::move(plot));
    path_->setData(std::move(path));
    stockShown_.clear();
    if (!cut_->canDraw()) return;
    for (const Skin& skin : cam::stockSkins(*outcome_, clamping_, shown)) {
        scene::SceneObject& piece = stockShown_.emplace_back();
        piece.name = tr("Stock");
        piece.scan = std::make_shared<const Scan>(meshOf(skin, 1, Eigen::Isometry3d::Identity()));
        piece.colour = steel;
    }
    if (again) showCut();  // else the tool follows, which draws both
}

/// The stock and the tool in space, with what the check found.
void TurningViews::showCut()
{
    constexpr std::size_t mostFlags = 3;
    if (!cut_->canDraw()) return;
    std::vector<scene::SceneObject> objects = stockShown_;
    Scan tool = tool_ > 0 ? cam::toolMesh(*shownClamping(), tip_.x(), tip_.y(), tool_) : Scan();
    if (tool.isMesh()) {
        scene::SceneObject& object = objects.emplace_back();
        object.name = tr("Tool");
        object.scan = std::make_shared<const Scan>(std::move(tool));
        object.colour = carbide;
    }
    cut_->setLongAxis(scene::SceneAxis{Eigen::Vector3d::Zero(), Eigen::Vector3d::UnitZ()});
    cut_->setObjects(std::move(objects));
    std::vector<scene::SceneFlag> flags;
    if (const auto& stock = outcome_->plan->setups[clamping_].check.stock)
        for (const stock::StockFinding& found : stock->findings) {
            if (flags.size() == mostFlags) break;
            flags.push_back({Eigen::Vector3d(found.x_mm, 0, found.z_mm),
                             tr("line %1: %2").arg(found.line).arg(screenText(stock::nameOf(found.kind))),
                             plot::toQt(report::colourOf(report::ColourRole::Limit))});
        }
    cut_->setFlags(std::move(flags));
}

/// The tool at a place of the scrubber: its outline, the stock by then, its block in the text.
void TurningViews::moveTool(int place, bool moves_caret)
{
    const cam::ClampingOutcome* clamping = shownClamping();
    if (!clamping || clamping->drawn.corners() == 0) return;
    const double way = clamping->length_mm() * place / places;
    const auto& travelled = clamping->travelled_mm;
    std::size_t at =
        static_cast<std::size_t>(std::lower_bound(travelled.begin(), travelled.end(), way - 1e-9) - travelled.begin());
    at = std::min(at, travelled.size() - 1);
    const stock::DrawnPath& drawn = clamping->drawn;
    const stock::Corner& to = drawn.corner(at);
    QPointF tip(to.z_mm, to.x_mm);
    if (at > 0 && drawn.isPiece(at) && travelled[at] > travelled[at - 1]) {
        const stock::Corner& from = drawn.corner(at - 1);
        const double share = std::clamp((way - travelled[at - 1]) / (travelled[at] - travelled[at - 1]), 0.0, 1.0);
        tip = {std::lerp(from.z_mm, to.z_mm, share), std::lerp(from.x_mm, to.x_mm, share)};
    }
    line_ = drawn.lineOf(at);
    if (moves_caret && editor_->line() != line_) editor_->goToLine(line_);
    cam::StockShown shown;
    if (place < places) shown = stockAt(*outcome_, clamping_, line_, !drawn.isRapid(at));
    showStock(shown, false);
    pointOutTool(tip, place < places ? drawn.toolOf(at) : 0);
    scrubber_->say(tr("Line %1 · %2 · tool %3 · Ø %4 · Z %5")
                       .arg(QString::number(line_), drawn.isRapid(at) ? tr("rapid") : tr("feed"),
                            QString::number(drawn.toolOf(at)), screenQuantity(2 * tip.y(), unit::mm, 3),
                            screenQuantity(clamping->z_zero_mm - tip.x(), unit::mm, 3)));
}

void TurningViews::goToLine(std::int64_t line)
{
    const cam::ClampingOutcome* clamping = shownClamping();
    if (!clamping) return;
    const auto pieces = clamping->drawn.piecesOf(line);
    if (pieces.empty()) {
        line_ = line;
        if (editor_->line() != line) editor_->goToLine(line);
        scrubber_->say(tr("Line %1: no move").arg(line));
        return;
    }
    const double way = clamping->travelled_mm[pieces.back()], whole = clamping->length_mm();
    scrubber_->setPlace(whole > 0 ? static_cast<int>(std::floor(way / whole * places)) : 0);
    moveTool(std::min(scrubber_->place(), places - 1), false);
    // The place that the slider can show may belong to the block before.
    line_ = line;
    if (editor_->line() != line) editor_->goToLine(line);
    const stock::Corner& end = clamping->drawn.corner(pieces.back());
    pointOutTool({end.z_mm, end.x_mm}, clamping->drawn.toolOf(pieces.back()));
}

/// 0: the place alone.
void TurningViews::pointOutTool(const QPointF& tip, int number)
{
    tip_ = tip;
    tool_ = number;
    showCut();
    plot::PointedOut out;
    out.place = tip;
    if (number > 0) out.shapes = toolShapes(*shownClamping(), tip, number);
    for (plot::ChartView* chart : {contour_, path_}) chart->pointOut(out);
}

void TurningViews::showStretch(const Interval& z_mm)
{
    if (!outcome_) return;
    const Interval at = inStock(*outcome_, clamping_, z_mm);
    contour_->setMarker((at.from + at.to) / 2);
    courses_->setMarker((at.from + at.to) / 2);
}

void TurningViews::pick(plot::ChartView* chart, double z_mm, double x_mm)
{
    const cam::ClampingOutcome* clamping = shownClamping();
    if (!clamping) return;
    const QRectF shown = chart->visibleRange();
    const stock::PathPiece piece = clamping->drawn.nearest({z_mm, x_mm}, shown.width() / std::max(1, chart->width()),
                                                           shown.height() / std::max(1, chart->height()));
    if (piece != stock::DrawnPath::none) goToLine(clamping->drawn.lineOf(piece));
}

void TurningViews::setPresenting(bool presenting)
{
    if (presenting) scrubber_->setPlaying(false);
    scrubber_->setVisible(!presenting);
}

void TurningViews::retranslate()
{
    primaryViews_->setTitle("cut", tr("Part as it is cut"));
    primaryViews_->setTitle("contour", tr("Contour and stock"));
    primaryViews_->setTitle("program", tr("Program and path"));
    primaryViews_->setTitle("operations", tr("Operations"));
    primaryViews_->setTitle("sections", tr("Speeds and why"));
    primaryViews_->setTitle("rest", tr("What stays, findings"));
    primaryViews_->setTitle("sheet", tr("Set-up sheet"));
    courses_->retranslate();
    operations_->retranslate();
    bar_->retranslate();
    scrubber_->retranslate();
    contour_->setAccessibleName(tr("Contour and stock"));
    path_->setAccessibleName(tr("Path of the tool"));
    why_->setAccessibleName(tr("Why this speed"));
    editor_->setAccessibleName(tr("Text of the program"));
    lobes_->setText(tr("Open in Lobes"));
    lobes_->setToolTip(tr("The response of the part at that moment, in the panel of lobes"));
    sections_->setAccessibleName(tr("Speeds of the finish"));
    sections_->setToolTip(tr("A row shows the stability lobes of the part at that moment"));
    rest_->setAccessibleName(tr("What stays on the drawing"));
    findings_->setAccessibleName(tr("What the tool meets"));
    sheet_->setAccessibleName(tr("Set-up sheet"));
    tools_->setAccessibleName(tr("Tools"));
    show();
}

}  // namespace lathelier::turning_panel
