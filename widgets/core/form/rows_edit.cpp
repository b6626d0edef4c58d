#include "widgets/core/form/rows_edit.h"

#include <QApplication>
#include <QClipboard>
#include <QEvent>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QKeyEvent>
#include <QSignalBlocker>
#include <QStyle>
#include <QTableWidget>
#include <QToolButton>
#include <QVBoxLayout>
#include <memory>
#include <set>

#include "engine/core/error.h"
#include "widgets/core/language.h"

Q_DECLARE_METATYPE(std::shared_ptr<const lathelier::Row>)

namespace lathelier {
namespace {

constexpr int leastRowsShown = 4;
constexpr int mostRowsShown = 10;
constexpr int digitsShown = 10, digitsConverted = 7;  // significant digits of exact and of converted numbers
/// Item data of a number cell: its original text, and the exact number, which the displayed digits do not restore.
constexpr int shownRole = Qt::UserRole, exactRole = Qt::UserRole + 1;
/// Item data of the first cell of a row: the original row, for its hidden columns.
constexpr int foldedRole = Qt::UserRole + 2;

/// Rows of older files under the keys of today. Rows that state a value twice are left to the panel, which refuses
/// them.
Rows underTodaysKeys(Rows rows, const std::vector<FieldInfo>& columns)
{
    for (Row& row : rows.rows) {
        Values cells = row.cells;
        try {
            for (const FieldInfo& column : columns) takeFormer(column, cells);
            row.cells = std::move(cells);
        } catch (const Error&) {
            continue;
        }
    }
    return rows;
}

/// Text for editing: numbers in the user's locale without binary rounding noise, choices by their label.
QString typedCellText(const FieldInfo& column, const Value& value)
{
    if (const auto* number = std::get_if<double>(&value)) {
        QLocale locale;
        locale.setNumberOptions(QLocale::OmitGroupSeparator);
        const double factor = screenFactor(column.unit);
        return locale.toString(*number * factor, 'g', factor == 1 ? digitsShown : digitsConverted);
    }
    if (const auto* key = std::get_if<std::string>(&value))
        for (const FieldChoice& choice : column.choices)
            if (choice.key == *key) return screenText(choice.label);
    return screenText(value);
}

/// Typed text converted for parse(): a decimal point, keys of choices, "yes" and "no".
std::string plainNumberText(const FieldInfo& column, const QString& typed)
{
    const QString text = typed.trimmed();
    switch (column.kind) {
        case FieldInfo::Kind::Number:
        case FieldInfo::Kind::Integer: {
            QString plain = text;
            plain.replace(',', '.').replace(QChar(0x2212), '-');
            const double factor = screenFactor(column.unit);
            bool is_number = false;
            const double shown = QLocale::c().toDouble(plain, &is_number);
            if (factor != 1 && is_number) plain = QLocale::c().toString(shown / factor, 'g', 12);
            return plain.toStdString();
        }
        case FieldInfo::Kind::Choice:
            for (const FieldChoice& choice : column.choices)
                if (screenText(choice.label).compare(text, Qt::CaseInsensitive) == 0) return choice.key;
            return text.toStdString();
        case FieldInfo::Kind::Flag:
            for (const bool flag : {true, false})
                if (screenText(Value(flag)).compare(text, Qt::CaseInsensitive) == 0) return flag ? "yes" : "no";
            return text.toStdString();
        default: return text.toStdString();
    }
}

}  // namespace

RowsEdit::RowsEdit(const FieldInfo& info, QWidget* parent)
    : QWidget(parent), info_(info), table_(new QTableWidget(this))
{
    const auto button = [this](const char* name, const QString& sign, auto action) {
        auto* result = new QToolButton(this);
        result->setObjectName(name);
        result->setText(sign);
        result->setAutoRaise(true);
        connect(result, &QToolButton::clicked, this, action);
        return result;
    };
    add_ = button("addRow", QStringLiteral("+"), &RowsEdit::addRow);
    remove_ = button("removeRow", QStringLiteral("−"), &RowsEdit::removeRow);
    paste_ = button("pasteRows", QString(), &RowsEdit::paste);
    auto* buttons = new QHBoxLayout;
    for (QToolButton* one : {add_, remove_, paste_}) buttons->addWidget(one);
    buttons->addStretch();
    for (std::size_t c = 0; c < info_.columns.size(); ++c)
        if (!info_.columns[c].advanced) shown_.push_back(c);
    table_->setColumnCount(static_cast<int>(shown_.size()));
    table_->horizontalHeader()->setHighlightSections(false);
    table_->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);  // headings have variable length
    table_->horizontalHeader()->setStretchLastSection(true);
    table_->horizontalHeader()->setMinimumSectionSize(fontMetrics().horizontalAdvance(QStringLiteral("0000000")));
    table_->verticalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    table_->setSelectionMode(QAbstractItemView::ExtendedSelection);
    table_->installEventFilter(this);
    connect(table_, &QTableWidget::itemChanged, this, &RowsEdit::check);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(table_);
    layout->addLayout(buttons);
    setFocusProxy(table_);
    retranslate();
}

void RowsEdit::setRows(const Rows& stated)
{
    const Rows rows = underTodaysKeys(stated, info_.columns);
    if (rows == announced_ && sound_ && table_->rowCount() == static_cast<int>(rows.rows.size())) return;
    announced_ = rows;
    fill();
}

void RowsEdit::fill()
{
    const QSignalBlocker quiet(table_);
    table_->setRowCount(0);
    for (const Row& row : announced_.rows) insertRow(table_->rowCount(), row);
    check();
}

void RowsEdit::setNames(const QString& name, const QString& help)
{
    table_->setAccessibleName(name);
    table_->setToolTip(help);
}

void RowsEdit::addRow()
{
    const int from = table_->currentRow();
    const int to = from < 0 ? table_->rowCount() : from + 1;
    Row cells;
    if (from >= 0 && from < static_cast<int>(announced_.rows.size()))
        cells = announced_.rows[static_cast<std::size_t>(from)];
    {
        const QSignalBlocker quiet(table_);
        insertRow(to, cells);
    }
    table_->setCurrentCell(to, 0);
    check();
}

void RowsEdit::removeRow()
{
    std::set<int, std::greater<>> rows;
    for (const QModelIndex& index : table_->selectionModel()->selectedIndexes()) rows.insert(index.row());
    if (rows.empty() && table_->currentRow() >= 0) rows.insert(table_->currentRow());
    for (const int row : rows) table_->removeRow(row);
    check();
}

void RowsEdit::paste()
{
    const QStringList lines = QApplication::clipboard()->text().split('\n', Qt::SkipEmptyParts);
    const int top = std::max(0, table_->currentRow());
    const int left = std::max(0, table_->currentColumn());
    {
        const QSignalBlocker quiet(table_);
        for (int line = 0; line < lines.size(); ++line) {
            if (top + line >= table_->rowCount()) insertRow(table_->rowCount(), {});
            const QStringList cells = QString(lines[line]).remove('\r').split('\t');
            for (int c = 0; c < cells.size() && left + c < table_->columnCount(); ++c)
                setCell(top + line, left + c, cells[c].trimmed());
        }
    }
    check();
}

bool RowsEdit::eventFilter(QObject* watched, QEvent* event)
{
    if (watched == table_ && event->type() == QEvent::KeyPress) {
        const auto* key = static_cast<QKeyEvent*>(event);
        if (key->matches(QKeySequence::Paste)) {
            paste();
            return true;
        }
    }
    return QWidget::eventFilter(watched, event);
}

void RowsEdit::changeEvent(QEvent* event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange) retranslate();
}

void RowsEdit::setCell(int row, int c, const QString& text)
{
    if (!table_->item(row, c)) table_->setItem(row, c, new QTableWidgetItem);
    table_->item(row, c)->setText(text);
    const bool number = column(c).kind == FieldInfo::Kind::Number || column(c).kind == FieldInfo::Kind::Integer;
    table_->item(row, c)->setTextAlignment(
        static_cast<int>((number ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter));
}

void RowsEdit::insertRow(int row, const Row& cells)
{
    table_->insertRow(row);
    for (int c = 0; c < table_->columnCount(); ++c) {
        const Value* value = lathelier::find(cells.cells, column(c).key);
        setCell(row, c, value ? typedCellText(column(c), *value) : QString());
        const double* const number = value ? std::get_if<double>(value) : nullptr;
        if (!number) continue;
        table_->item(row, c)->setData(shownRole, table_->item(row, c)->text());
        table_->item(row, c)->setData(exactRole, *number);
    }
    if (table_->columnCount() > 0)
        table_->item(row, 0)->setData(foldedRole, QVariant::fromValue(std::make_shared<const Row>(cells)));
}

std::optional<Value> RowsEdit::understand(int row, int c, QString& problem) const
{
    const QTableWidgetItem* item = table_->item(row, c);
    const QString typed = item ? item->text() : QString();
    if (typed.trimmed().isEmpty() && column(c).optional) return Value();
    if (item && item->data(shownRole).isValid() && item->data(shownRole).toString() == typed)
        return item->data(exactRole).toDouble();
    try {
        return parse(column(c), plainNumberText(column(c), typed));
    } catch (const Error& error) {
        problem = screenText(error);
        return std::nullopt;
    }
}

/// Marks invalid cells; reports a change when all cells are valid.
void RowsEdit::check()
{
    Rows typed;
    bool sound = true;
    const bool quiet = table_->signalsBlocked();
    {
        const QSignalBlocker marking(table_);
        for (int row = 0; row < table_->rowCount(); ++row) {
            Row cells;
            const QTableWidgetItem* const first = table_->item(row, 0);
            const auto folded = first ? first->data(foldedRole).value<std::shared_ptr<const Row>>() : nullptr;
            int c = -1;
            for (std::size_t all = 0; all < info_.columns.size(); ++all) {
                if (info_.columns[all].advanced) {
                    const Value* kept = folded ? lathelier::find(folded->cells, info_.columns[all].key) : nullptr;
                    if (kept) cells.cells.emplace_back(info_.columns[all].key, *kept);
                    continue;
                }
                ++c;
                QString problem;
                const std::optional<Value> value = understand(row, c, problem);
                sound &= value.has_value();
                if (!table_->item(row, c)) table_->setItem(row, c, new QTableWidgetItem);
                QTableWidgetItem* item = table_->item(row, c);
                item->setIcon(value ? QIcon() : style()->standardIcon(QStyle::SP_MessageBoxWarning));
                item->setToolTip(problem);
                if (value) cells.cells.emplace_back(column(c).key, *value);
            }
            typed.rows.push_back(std::move(cells));
        }
        const double count = static_cast<double>(typed.rows.size());
        sound &= count >= info_.minimum && count <= info_.maximum;
    }
    remove_->setEnabled(table_->rowCount() > static_cast<int>(info_.minimum));
    const int shown = std::clamp(table_->rowCount() + 1, leastRowsShown, mostRowsShown);
    table_->setFixedHeight(shown * table_->verticalHeader()->minimumSectionSize() +
                           table_->horizontalHeader()->sizeHint().height());
    sound_ = sound;
    if (!sound || typed == announced_) return;
    announced_ = typed;
    if (!quiet) emit rowsChanged();
}

void RowsEdit::retranslate()
{
    QStringList head;
    for (const std::size_t shown : shown_) {
        const FieldInfo& one = info_.columns[shown];
        const QString unit = screenUnit(one.unit);
        head << (unit.isEmpty() ? screenText(one.label)
                                // line break, since columns are narrow
                                : QStringLiteral("%1\n(%2)").arg(screenText(one.label), unit));
    }
    table_->setHorizontalHeaderLabels(head);
    for (int c = 0; c < table_->columnCount(); ++c)
        table_->horizontalHeaderItem(c)->setToolTip(screenText(column(c).help));
    add_->setToolTip(tr("Add a row"));
    remove_->setToolTip(tr("Remove the selected rows"));
    paste_->setText(tr("Paste"));
    paste_->setToolTip(tr("Paste rows from a spreadsheet, from the current cell on"));
    for (QToolButton* one : {add_, remove_, paste_}) one->setAccessibleName(one->toolTip());
    if (sound_) fill();  // numbers and choices in the new language; invalid input is kept as typed
}

}  // namespace lathelier
