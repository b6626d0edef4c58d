#include "widgets/turning/turning_views.h"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QSignalBlocker>
#include <QSplitter>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "engine/cam/check/check_report.h"
#include "engine/cam/plan_report.h"
#include "widgets/core/language.h"
#include "widgets/program_common/program_editor.h"
#include "widgets/turning/tool_shapes.h"

namespace lathelier::turning_panel {
namespace {

using program_common::LineRemark;
using program_common::ProgramEditor;

constexpr int places = ToolScrubber::places;
constexpr int leastPixels = 200;

QToolButton* choice(QButtonGroup* group, int id, const char* name)
{
    auto* button = new QToolButton;
    button->setObjectName(name);
    button->setCheckable(true);
    group->addButton(button, id);
    return button;
}

QSplitter* stacked(std::initializer_list<QWidget*> parts)
{
    auto* splitter = new QSplitter(Qt::Vertical);
    for (QWidget* part : parts) splitter->addWidget(part);
    splitter->setChildrenCollapsible(false);
    return splitter;
}

void fill(CopyTable* table, const report::Table& rows)
{
    const QSignalBlocker quiet(table);
    table->setTable(rows);
}

}  // namespace

TurningViews::TurningViews(QWidget* parent)
    : QWidget(parent),
      heroes_(new HeroViews),
      contour_(new plot::ChartView),
      course_(new plot::ChartView),
      path_(new plot::ChartView),
      why_(new plot::ChartView),
      courses_(new QButtonGroup(this)),
      editor_(new ProgramEditor),
      operations_(new OperationsTable),
      sections_(new CopyTable),
      rest_(new CopyTable),
      findings_(new CopyTable),
      sheet_(new CopyTable),
      tools_(new CopyTable),
      scrubber_(new ToolScrubber)
{
    contour_->setObjectName("turningContour");
    course_->setObjectName("turningCourse");
    path_->setObjectName("turningPath");
    why_->setObjectName("turningWhy");
    editor_->setObjectName("turningText");
    operations_->setObjectName("turningOperations");
    sections_->setObjectName("turningSections");
    rest_->setObjectName("turningRest");
    findings_->setObjectName("turningFindings");
    sheet_->setObjectName("turningSheet");
    tools_->setObjectName("turningTools");
    editor_->setReadOnly(true);
    auto* program = new QSplitter(Qt::Horizontal);
    program->addWidget(editor_);
    program->addWidget(path_);
    program->setChildrenCollapsible(false);
    program->setStretchFactor(0, 2);
    program->setStretchFactor(1, 3);
    program->setSizes({400, 600});  // shares: the hint of a text is narrow
    heroes_->add("contour", makeContourSide());
    heroes_->add("program", program);
    heroes_->add("operations", operations_);
    heroes_->add("sections", stacked({sections_, why_}));
    heroes_->add("rest", stacked({rest_, findings_}));
    heroes_->add("sheet", stacked({sheet_, tools_}));
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(heroes_, 1);
    layout->addWidget(scrubber_);
    connectParts();
    connectTables();
    retranslate();
}

TurningViews::~TurningViews() = default;

/// The contour, and one of the courses below it over the same z.
QWidget* TurningViews::makeContourSide()
{
    auto* row = new QHBoxLayout;
    row->setContentsMargins(0, 0, 0, 0);
    row->addWidget(choice(courses_, static_cast<int>(Course::Speed), "courseSpeed"));
    row->addWidget(choice(courses_, static_cast<int>(Course::CuttingSpeed), "courseCuttingSpeed"));
    row->addWidget(choice(courses_, static_cast<int>(Course::Frequency), "courseFrequency"));
    row->addWidget(choice(courses_, static_cast<int>(Course::Roughness), "courseRoughness"));
    row->addStretch(1);
    courses_->button(0)->setChecked(true);
    auto* lower = new QWidget;
    auto* column = new QVBoxLayout(lower);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(2);
    column->addLayout(row);
    column->addWidget(course_, 1);
    course_->followX(contour_);
    QSplitter* both = stacked({contour_, lower});
    both->setStretchFactor(0, 5);
    both->setStretchFactor(1, 3);
    return both;
}

void TurningViews::connectParts()
{
    connect(courses_, &QButtonGroup::idClicked, this, [this](int id) { setCourse(static_cast<Course>(id)); });
    connect(scrubber_, &ToolScrubber::clampingChosen, this,
            [this](int id) { setClamping(static_cast<std::size_t>(id)); });
    connect(scrubber_, &ToolScrubber::moved, this, &TurningViews::moveTool);
    // The editor may say so while it is painted: charts must not be drawn anew then.
    connect(
        editor_, &ProgramEditor::lineReached, this,
        [this] {
            if (editor_->line() != line_) goToLine(editor_->line());
        },
        Qt::QueuedConnection);
    for (plot::ChartView* chart : {contour_, path_})
        connect(chart, &plot::PlotCanvas::clicked, this,
                [this, chart](double z_mm, double x_mm) { pick(chart, z_mm, x_mm); });
    for (plot::ChartView* chart : {contour_, course_, path_, why_})
        connect(chart, &plot::PlotWidget::notWritten, this, &TurningViews::notWritten);
}

void TurningViews::connectTables()
{
    const auto onRow = [this](CopyTable* table, auto chosen) {
        connect(table, &QTableWidget::currentCellChanged, this, [this, chosen](int row, int, int before, int) {
            if (picture_ && row >= 0 && row != before) chosen(static_cast<std::size_t>(row));
        });
    };
    onRow(sections_, [this](std::size_t row) { showWhy(static_cast<int>(row)); });
    onRow(rest_, [this](std::size_t row) {
        if (row >= picture_->plan->rest.size()) return;
        const cam::RestInterval& rest = picture_->plan->rest[row];
        if (rest.line > 0 && picture_->plan->setups.size() == 1) goToLine(rest.line);
        showStretch({rest.z_start_mm, rest.z_end_mm});
    });
    onRow(findings_, [this](std::size_t row) {
        const auto& found = picture_->plan->setups[clamping_].check.findings;
        if (row < found.size()) goToLine(found[row].line);
    });
    connect(operations_, &OperationsTable::lineChosen, this, &TurningViews::goToLine);
    connect(operations_, &OperationsTable::switched, this, &TurningViews::operationSwitched);
}

void TurningViews::setPicture(const std::shared_ptr<const TurningPicture>& picture)
{
    scrubber_->setPlaying(false);
    picture_ = picture;
    if (clamping_ >= picture->clampings.size()) clamping_ = 0;
    show();
}

const ClampingPicture* TurningViews::shownClamping() const
{
    return picture_ ? &picture_->clampings[clamping_] : nullptr;
}

void TurningViews::setClamping(std::size_t clamping)
{
    if (picture_ && clamping >= picture_->clampings.size()) clamping = 0;
    if (clamping == clamping_) return;
    scrubber_->setPlaying(false);
    clamping_ = clamping;
    line_ = 0;
    show();
}

void TurningViews::setCourse(Course course)
{
    shown_ = course;
    courses_->button(static_cast<int>(course))->setChecked(true);
    showCourse();
}

void TurningViews::show()
{
    if (!picture_) return;
    const cam::SetupPlan& setup = picture_->plan->setups[clamping_];
    scrubber_->setClampings(picture_->clampings.size(), clamping_);
    {
        editor_->setReadOnly(false);
        editor_->setProgram(QByteArray::fromStdString(setup.text), QString("clamping %1").arg(clamping_ + 1),
                            setup.check.program.dialect);
        editor_->setReadOnly(true);
        std::vector<LineRemark> remarks;
        for (const cam::CheckFinding& found : setup.check.findings)
            remarks.push_back({found.line, 0, true,
                               tr("%1, %2 deep")
                                   .arg(screenText(cam::nameOf(found.kind)),
                                        screenQuantity(found.depth_mm, LT_TEXT("Engine", "mm"), 3))});
        editor_->setRemarks(std::move(remarks));
    }
    showTables();
    showCourse();
    showStock(stock_, true);
    scrubber_->setPlace(places);
    moveTool(places);
}

void TurningViews::showTables()
{
    const cam::TurningPlan& plan = *picture_->plan;
    const cam::SetupPlan& setup = plan.setups[clamping_];
    operations_->setPicture(*picture_, clamping_);
    fill(sections_, cam::sectionTable(plan));
    fill(rest_, cam::restTable(plan));
    fill(findings_, cam::findingTable(setup.check));
    report::Document sheet;
    sheet.sections.push_back({{}, {sheetOf(*picture_, clamping_)}});
    sheet_->setQuantities(sheet);
    fill(tools_, cam::toolTable(plan));
    rest_->setVisible(!plan.rest.empty());
    findings_->setVisible(!setup.check.findings.empty());
    heroes_->setAvailable("rest", !plan.rest.empty() || !setup.check.findings.empty());
    heroes_->setAvailable("sections", !plan.sections.empty());
    showWhy(std::max(0, sections_->currentRow()));
}

/// Draws contour and path where the stock is another one, or `again`.
void TurningViews::showStock(const StockShown& shown, bool again)
{
    if (!picture_ || (shown == stock_ && !again)) return;
    stock_ = shown;
    report::Plot plot =
        contourPlot(*picture_, clamping_, shown, std::max(leastPixels, contour_->width()), screenLanguage());
    report::Plot path = plot;
    path.marks.clear();  // said in the other view; text and path have little room
    contour_->setData(std::move(plot));
    path_->setData(std::move(path));
}

void TurningViews::showCourse()
{
    if (picture_) course_->setData(coursePlot(*picture_, clamping_, shown_));
}

void TurningViews::showWhy(int section)
{
    if (!picture_) return;
    report::Plot plot = whyPlot(*picture_, static_cast<std::size_t>(section), screenLanguage());
    why_->setVisible(!plot.curves.empty());
    if (!plot.curves.empty()) why_->setData(std::move(plot));
}

/// The tool at a place of the scrubber: its outline, the stock by then, its block in the text.
void TurningViews::moveTool(int place)
{
    const ClampingPicture* clamping = shownClamping();
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
    if (editor_->line() != line_) editor_->goToLine(line_);
    StockShown shown;
    if (place < places) shown = stockAt(*picture_, clamping_, line_, !drawn.isRapid(at));
    showStock(shown, false);
    pointOutTool(tip, place < places ? drawn.toolOf(at) : 0);
    scrubber_->say(tr("Line %1 · %2 · tool %3 · Ø %4 · Z %5")
                       .arg(QString::number(line_), drawn.isRapid(at) ? tr("rapid") : tr("feed"),
                            QString::number(drawn.toolOf(at)), screenQuantity(2 * tip.y(), LT_TEXT("Engine", "mm"), 3),
                            screenQuantity(clamping->z_zero_mm - tip.x(), LT_TEXT("Engine", "mm"), 3)));
}

void TurningViews::goToLine(std::int64_t line)
{
    const ClampingPicture* clamping = shownClamping();
    if (!clamping) return;
    const auto pieces = clamping->drawn.piecesOf(line);
    if (pieces.empty()) {
        line_ = line;
        editor_->goToLine(line);
        scrubber_->say(tr("Line %1: no move").arg(line));
        return;
    }
    const double way = clamping->travelled_mm[pieces.back()], whole = clamping->length_mm();
    scrubber_->setPlace(whole > 0 ? static_cast<int>(std::floor(way / whole * places)) : 0);
    moveTool(std::min(scrubber_->place(), places - 1));
    // The place that the slider can show may belong to the block before.
    line_ = line;
    editor_->goToLine(line);
    const stock::Corner& end = clamping->drawn.corner(pieces.back());
    pointOutTool({end.z_mm, end.x_mm}, clamping->drawn.toolOf(pieces.back()));
}

/// 0: the place alone.
void TurningViews::pointOutTool(const QPointF& tip, int number)
{
    plot::PointedOut out;
    out.place = tip;
    if (number > 0) out.shapes = toolShapes(*shownClamping(), tip, number);
    for (plot::ChartView* chart : {contour_, path_}) chart->pointOut(out);
}

void TurningViews::showStretch(const Interval& z_mm)
{
    if (!picture_) return;
    const Interval at = inStock(*picture_, clamping_, z_mm);
    for (plot::ChartView* chart : {contour_, course_}) chart->setMarker((at.from + at.to) / 2);
}

void TurningViews::pick(plot::ChartView* chart, double z_mm, double x_mm)
{
    const ClampingPicture* clamping = shownClamping();
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
    heroes_->setTitle("contour", tr("Contour and stock"));
    heroes_->setTitle("program", tr("Program and path"));
    heroes_->setTitle("operations", tr("Operations"));
    heroes_->setTitle("sections", tr("Speeds and why"));
    heroes_->setTitle("rest", tr("What stays, findings"));
    heroes_->setTitle("sheet", tr("Set-up sheet"));
    courses_->button(0)->setText(tr("N"));
    courses_->button(0)->setToolTip(tr("Speed of the spindle along the part"));
    courses_->button(1)->setText(tr("v_c"));
    courses_->button(1)->setToolTip(tr("Cutting speed along the part"));
    courses_->button(2)->setText(tr("f_m"));
    courses_->button(2)->setToolTip(tr("Frequency of chatter of each section; needs a spindle"));
    courses_->button(3)->setText(tr("Rz"));
    courses_->button(3)->setToolTip(tr("Ideal roughness along the part"));
    scrubber_->retranslate();
    contour_->setAccessibleName(tr("Contour and stock"));
    course_->setAccessibleName(tr("Along the part"));
    path_->setAccessibleName(tr("Path of the tool"));
    why_->setAccessibleName(tr("Why this speed"));
    editor_->setAccessibleName(tr("Text of the program"));
    operations_->setAccessibleName(tr("Operations"));
    operations_->setToolTip(tr("The box switches an operation off: what it would take off stays"));
    sections_->setAccessibleName(tr("Speeds of the finish"));
    sections_->setToolTip(tr("A row shows the stability lobes of the part at that moment"));
    rest_->setAccessibleName(tr("What stays on the drawing"));
    findings_->setAccessibleName(tr("What the tool meets"));
    sheet_->setAccessibleName(tr("Set-up sheet"));
    tools_->setAccessibleName(tr("Tools"));
    show();
}

}  // namespace lathelier::turning_panel
