#include "widgets/program/program_views.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QShortcut>
#include <QSignalBlocker>
#include <QVBoxLayout>
#include <cmath>

#include "engine/core/units.h"
#include "engine/stock/tool_outline.h"
#include "widgets/core/icons.h"
#include "widgets/core/language.h"
#include "widgets/program_common/program_editor.h"

namespace lathelier::program_panel {
namespace {

constexpr int redrawPause_ms = 60;
constexpr std::size_t largePath = 20000;  // largest number of corners drawn in full; beyond, drawing depends on the
                                          // visible range
constexpr int mostPiecesPointedOut = 5000;

report::Table remarkTable(const std::vector<stock::Remark>& remarks)
{
    report::Table table{LT_TEXT("Engine", "Remarks"),
                        {LT_TEXT("Engine", "Line"), LT_TEXT("Engine", "Severity"), LT_TEXT("Engine", "Remark"),
                         LT_TEXT("Engine", "Block")},
                        {},
                        {0}};
    for (const stock::Remark& remark : remarks)
        table.rows.push_back({remark.line, remark.is_error ? LT_TEXT("Engine", "error") : LT_TEXT("Engine", "warning"),
                              remark.text, remark.block});
    return table;
}

/// The tool of this number in the check.
Tool toolOf(const stock::StockParameters& parameters, int number)
{
    for (const int wanted : {number, 0})
        for (const Tool& tool : parameters.tools)
            if (tool.number == wanted) return tool;
    return {};
}

}  // namespace

ProgramViews::ProgramViews(QWidget* parent)
    : QWidget(parent),
      primaryViews_(new PrimaryViews),
      path_(new plot::ChartView),
      editor_(new ProgramEditor),
      where_(new QLabel),
      search_(new QLineEdit),
      earlier_(new QToolButton),
      later_(new QToolButton),
      state_(new QLabel),
      save_(new QPushButton),
      discard_(new QPushButton),
      remarks_(new CopyTable),
      passes_(new CopyTable),
      tools_(new CopyTable)
{
    path_->setObjectName("programPath");
    editor_->setObjectName("programText");
    where_->setObjectName("programWhere");
    search_->setObjectName("programSearch");
    state_->setObjectName("programState");
    save_->setObjectName("programSave");
    discard_->setObjectName("programDiscard");
    remarks_->setObjectName("programRemarks");
    passes_->setObjectName("programPasses");
    tools_->setObjectName("programTools");
    where_->setMinimumWidth(1);  // allows elision of long text
    auto* both = new QSplitter(Qt::Vertical);
    both->addWidget(path_);
    both->addWidget(makeTextSide());
    both->setChildrenCollapsible(false);
    both->setStretchFactor(0, 2);
    both->setStretchFactor(1, 3);
    primaryViews_->add("program", both);
    primaryViews_->add("remarks", remarks_);
    primaryViews_->add("passes", passes_);
    primaryViews_->add("tools", tools_);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(primaryViews_, 1);
    redraw_.setSingleShot(true);
    redraw_.setInterval(redrawPause_ms);
    connectParts();
    retranslate();
}

ProgramViews::~ProgramViews() = default;

QWidget* ProgramViews::makeTextSide()
{
    for (QToolButton* button : {earlier_, later_}) button->setAutoRaise(true);
    earlier_->setArrowType(Qt::UpArrow);
    later_->setArrowType(Qt::DownArrow);
    search_->setClearButtonEnabled(true);
    auto* row = new QHBoxLayout;
    row->setContentsMargins(0, 0, 0, 0);
    row->addWidget(search_, 1);
    row->addWidget(earlier_);
    row->addWidget(later_);
    row->addWidget(state_);
    row->addWidget(discard_);
    row->addWidget(save_);
    auto* side = new QWidget;
    auto* column = new QVBoxLayout(side);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(3);
    column->addWidget(where_);
    column->addWidget(editor_, 1);
    column->addLayout(row);
    return side;
}

void ProgramViews::connectParts()
{
    connect(editor_, &ProgramEditor::edited, this, &ProgramViews::edited);
    connect(editor_, &ProgramEditor::lineReached, this, &ProgramViews::pointOutLine);
    connect(path_, &plot::PlotCanvas::clicked, this, &ProgramViews::pick);
    connect(path_, &plot::ChartView::rangeChanged, this, [this] {
        if (outcome_ && outcome_->check->drawn.corners() > largePath) redraw_.start();
    });
    connect(path_, &plot::PlotWidget::notWritten, this, &ProgramViews::notWritten);
    connect(&redraw_, &QTimer::timeout, this, &ProgramViews::drawPathAgain);
    connect(save_, &QPushButton::clicked, this, &ProgramViews::saveRequested);
    connect(discard_, &QPushButton::clicked, this, &ProgramViews::discardRequested);
    connect(search_, &QLineEdit::returnPressed, this, [this] { findNext(true); });
    connect(later_, &QToolButton::clicked, this, [this] { findNext(true); });
    connect(earlier_, &QToolButton::clicked, this, [this] { findNext(false); });
    auto* find = new QShortcut(QKeySequence::Find, this);
    find->setContext(Qt::WidgetWithChildrenShortcut);
    connect(find, &QShortcut::activated, this, [this] {
        if (editor_->hasSelectedText()) search_->setText(editor_->selectedText());
        search_->setFocus(Qt::ShortcutFocusReason);
        search_->selectAll();
    });
    for (CopyTable* table : {remarks_, passes_, tools_})
        connect(table, &QTableWidget::currentCellChanged, this, [this, table](int row, int, int before, int) {
            if (!outcome_ || row < 0 || row == before) return;
            if (table == passes_) setPass(static_cast<std::size_t>(row));
            const QTableWidgetItem* cell = table->item(row, table == tools_ ? 1 : 0);
            if (cell) goToLine(cell->data(Qt::UserRole).toLongLong());
        });
}

void ProgramViews::setOutcome(const std::shared_ptr<const deflection::ToolpathOutcome>& outcome, bool takesText)
{
    const bool is_other = !outcome_ || outcome_->file != outcome->file;
    outcome_ = outcome;
    if (is_other) pass_.reset();
    if (takesText)
        editor_->setProgram(QByteArray::fromStdString(outcome->text), QString::fromStdString(outcome->file),
                            outcome->check->program.control);
    show();
    pointOutLine(editor_->line());
}

void ProgramViews::show()
{
    if (!outcome_) return;
    const stock::ProgramCheck& check = *outcome_->check;
    const std::vector<stock::Remark> remarks = stock::remarksOf(check, screenLanguage());
    std::vector<program_common::LineRemark> marks;
    marks.reserve(remarks.size());
    for (const stock::Remark& remark : remarks)
        marks.push_back({remark.line, remark.column, remark.is_error, QString::fromStdString(remark.text)});
    editor_->setRemarks(std::move(marks));
    const auto fill = [](CopyTable* table, const report::Table& rows, std::size_t line_column) {
        const QSignalBlocker quiet(table);
        table->setTable(rows);
        for (int row = 0; row < table->rowCount() && row < static_cast<int>(rows.rows.size()); ++row)
            table->item(row, static_cast<int>(line_column))
                ->setData(Qt::UserRole,
                          qlonglong{std::get<std::int64_t>(rows.rows[static_cast<std::size_t>(row)][line_column])});
    };
    fill(remarks_, remarkTable(remarks), 0);
    fill(passes_, stock::passTable(check), 0);
    fill(tools_, stock::toolTable(check), 1);
    primaryViews_->setAvailable("remarks", !remarks.empty());
    primaryViews_->setAvailable("passes", check.stock && !check.stock->passes.empty());
    primaryViews_->setAvailable("tools", !check.times.tools.empty());
    state_->setText(outcome_->isDraft() ? tr("changed, not saved") : tr("as on the disk"));
    discard_->setVisible(outcome_->isDraft());
    showPath();
}

/// Draws the whole path; a large one at screen resolution.
void ProgramViews::showPath()
{
    if (!outcome_) return;
    const stock::DrawnPath& drawn = outcome_->check->drawn;
    stock::StockPlotParts parts;
    parts.pass = pass_;
    parts.window = drawn.whole(std::max(200, path_->width()));
    report::Plot plot = stock::meridianPlot(*outcome_->check, parts, screenLanguage());
    if (drawn.corners() > largePath) {
        plot.x.range = report::shownX(plot);
        plot.y.range = report::shownY(plot);
    }
    drawnRange_ = {};
    path_->setData(std::move(plot));
    if (drawn.corners() > largePath) redraw_.start();
}

/// Draws the visible part of a large path at screen resolution.
void ProgramViews::drawPathAgain()
{
    if (!outcome_ || path_->data().curves.empty()) return;
    const QRectF shown = path_->visibleRange();
    const bool is_same = std::abs(shown.x() - drawnRange_.x()) + std::abs(shown.y() - drawnRange_.y()) +
                             std::abs(shown.width() - drawnRange_.width()) <
                         0.01 * std::abs(shown.width());
    if (is_same || shown.isEmpty()) return;
    drawnRange_ = shown;
    stock::StockPlotParts parts;
    parts.pass = pass_;
    parts.window = {{shown.left(), shown.left() + shown.width()},
                    {shown.top(), shown.top() + shown.height()},
                    shown.width() / std::max(1, path_->width()),
                    shown.height() / std::max(1, path_->height())};
    report::Plot plot = stock::meridianPlot(*outcome_->check, parts, screenLanguage());
    plot.x.range = path_->data().x.range;
    plot.y.range = path_->data().y.range;
    path_->setData(std::move(plot));
}

void ProgramViews::setPass(std::optional<std::size_t> pass)
{
    if (pass == pass_) return;
    pass_ = pass;
    showPath();
}

void ProgramViews::goToLine(std::int64_t line)
{
    editor_->goToLine(line);
    pointOutLine(line);
}

/// The moves of a block, and the tool at its end.
void ProgramViews::pointOutLine(std::int64_t line)
{
    plot::PointedOut out;
    if (outcome_) {
        const stock::DrawnPath& drawn = outcome_->check->drawn;
        const auto pieces = drawn.piecesOf(line);
        const auto at = [&](std::size_t corner) {
            return QPointF(drawn.corner(corner).z_mm, drawn.corner(corner).x_mm);
        };
        int count = 0;
        for (const std::uint32_t piece : pieces) {
            if (++count > mostPiecesPointedOut) break;
            if (!drawn.isPiece(piece)) continue;
            if (out.lines.empty() || out.lines.back().last() != at(piece - 1))
                out.lines.push_back(QPolygonF() << at(piece - 1));
            out.lines.back() << at(piece);
        }
        if (!pieces.empty()) {
            out.place = at(pieces.back());
            out.shapes = toolAt(*out.place, drawn.toolOf(pieces.back()));
        }
        where_->setText(whereText(line));
    }
    path_->pointOut(std::move(out));
}

QString ProgramViews::whereText(std::int64_t line) const
{
    const stock::DrawnPath& drawn = outcome_->check->drawn;
    const auto pieces = drawn.piecesOf(line);
    if (pieces.empty()) return tr("Line %1: no move").arg(line);
    const stock::Corner end = drawn.corner(pieces.back());
    return tr("Line %1: %2 to Ø %3, Z %4 · tool %5")
        .arg(QString::number(line), drawn.isRapid(pieces.back()) ? tr("rapid") : tr("feed"),
             screenQuantity(2 * end.x_mm, unit::mm, 3),
             screenQuantity(outcome_->check->z_zero_mm - end.z_mm, unit::mm, 3),
             QString::number(drawn.toolOf(pieces.back())));
}

std::vector<QPolygonF> ProgramViews::toolAt(const QPointF& tip, int number) const
{
    std::vector<QPolygonF> shapes;
    try {
        const stock::ToolOutline outline = stock::outlineOf(toolOf(outcome_->parameters, number));
        std::vector<stock::ConvexPolygon> bodies = outline.holders;
        bodies.push_back(outline.insert);
        for (const stock::ConvexPolygon& body : bodies) {
            QPolygonF& shape = shapes.emplace_back();
            for (const stock::Corner& corner : body) shape << tip + QPointF(corner.z_mm, corner.x_mm);
        }
    } catch (const Error&) {
        shapes.clear();  // already shown by the check
    }
    return shapes;
}

/// The block whose path lies nearest to a click.
void ProgramViews::pick(double z_mm, double x_mm)
{
    if (!outcome_) return;
    const QRectF shown = path_->visibleRange();
    const stock::PathPiece piece = outcome_->check->drawn.nearest(
        {z_mm, x_mm}, shown.width() / std::max(1, path_->width()), shown.height() / std::max(1, path_->height()));
    if (piece != stock::DrawnPath::none) goToLine(outcome_->check->drawn.lineOf(piece));
}

void ProgramViews::findNext(bool forward)
{
    const bool found = search_->text().isEmpty() || editor_->find(search_->text(), forward);
    search_->setToolTip(found ? tr("Find in the program") : tr("Not found"));
    QPalette look = palette();
    if (!found) look.setColor(QPalette::Text, Qt::red);
    search_->setPalette(look);
}

void ProgramViews::changeEvent(QEvent* event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::PaletteChange) search_->setPalette(palette());
}

void ProgramViews::retranslate()
{
    primaryViews_->setTitle("program", tr("Program and path"));
    primaryViews_->setTitle("remarks", tr("Remarks"));
    primaryViews_->setTitle("passes", tr("Passes"));
    primaryViews_->setTitle("tools", tr("Tools"));
    search_->setPlaceholderText(tr("Find"));
    search_->setToolTip(tr("Find in the program"));
    search_->setAccessibleName(tr("Find in the program"));
    earlier_->setToolTip(tr("Find the one before"));
    later_->setToolTip(tr("Find the next one"));
    save_->setText(tr("Save as…"));
    save_->setToolTip(tr("Save the program as a new file"));
    discard_->setText(tr("Discard changes"));
    discard_->setToolTip(tr("Take the program of the file again"));
    editor_->setAccessibleName(tr("Text of the program"));
    path_->setAccessibleName(tr("Path of the tool"));
    remarks_->setAccessibleName(tr("Remarks"));
    passes_->setAccessibleName(tr("Passes"));
    tools_->setAccessibleName(tr("Tools"));
    show();
    if (outcome_) pointOutLine(editor_->line());
}

}  // namespace lathelier::program_panel
