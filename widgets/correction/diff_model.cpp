#include "widgets/correction/diff_model.h"

#include <QColor>
#include <QFontDatabase>
#include <QLocale>
#include <algorithm>
#include <cmath>

#include "engine/core/texts.h"
#include "widgets/core/language.h"

namespace lathelier::correction_panel {
namespace {

bool isKept(const std::vector<Interval>& kept, std::int64_t line)
{
    const auto number = static_cast<double>(line);
    return std::any_of(kept.begin(), kept.end(),
                       [&](const Interval& lines) { return lines.from <= number && number <= lines.to; });
}

const double* zOf(const deflection::ProgramChange& change)
{
    const Value* value = lathelier::find(change.values, "z_mm");
    return value ? std::get_if<double>(value) : nullptr;
}

/// Tints with sufficient contrast to text in both themes.
const QColor goneTint(200, 60, 40, 50);
const QColor writtenTint(40, 140, 80, 50);

}  // namespace

void DiffModel::setOutcome(const std::shared_ptr<const DeflectionOutcome>& outcome)
{
    outcome_ = outcome;
    rebuild();
}

void DiffModel::setOnlyChanges(bool only)
{
    onlyChanges_ = only;
    rebuild();
}

void DiffModel::retranslate()
{
    if (rowCount() > 0) emit dataChanged(index(0, 0), index(rowCount() - 1, ColumnCount - 1));
    emit headerDataChanged(Qt::Horizontal, 0, ColumnCount - 1);
}

void DiffModel::rebuild()
{
    beginResetModel();
    rows_.clear();
    if (outcome_ && outcome_->study->corrected) {
        const std::vector<deflection::ProgramChange>& changes = outcome_->study->corrected->changes;
        const std::vector<Interval>& kept = outcome_->question.compensation.kept_lines;
        std::size_t next = 0;
        const auto lines = static_cast<std::int64_t>(outcome_->job->program.blocks.size());
        for (std::int64_t line = 1; line <= lines; ++line) {
            const bool is_kept = isKept(kept, line);
            bool is_first = true;
            // An added block may follow an unchanged one.
            if (next >= changes.size() || changes[next].line != line || !changes[next].before) {
                const bool goes_on = next < changes.size() && changes[next].line == line;
                if (!onlyChanges_ || is_kept || goes_on) rows_.push_back({line, -1, goes_on || is_kept, is_kept});
                is_first = !goes_on;
            }
            for (; next < changes.size() && changes[next].line == line; ++next) {
                rows_.push_back({line, static_cast<int>(next), is_first && zOf(changes[next]), false});
                is_first = false;
            }
        }
    }
    endResetModel();
}

int DiffModel::rowCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(rows_.size());
}

int DiffModel::columnCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : ColumnCount;
}

const deflection::ProgramChange* DiffModel::changeOf(const Row& row) const
{
    return row.change < 0 ? nullptr : &outcome_->study->corrected->changes[static_cast<std::size_t>(row.change)];
}

QString DiffModel::textOf(const Row& row) const
{
    const gcode::Program& program = outcome_->job->program;
    const std::string_view text = program.textOf(program.blocks[static_cast<std::size_t>(row.line - 1)]);
    const auto size = static_cast<int>(text.size());
    return program.is_utf8 ? QString::fromUtf8(text.data(), size) : QString::fromLatin1(text.data(), size);
}

QVariant DiffModel::data(const QModelIndex& index, int role) const
{
    if (!index.isValid() || !outcome_) return {};
    const Row& row = rows_[static_cast<std::size_t>(index.row())];
    const deflection::ProgramChange* change = changeOf(row);
    const bool is_added = change && !change->before;
    if (role == Qt::CheckStateRole && index.column() == Take && row.is_first)
        return row.is_kept ? Qt::Unchecked : Qt::Checked;
    if (role == Qt::FontRole && (index.column() == Program || index.column() == Corrected))
        return QFontDatabase::systemFont(QFontDatabase::FixedFont);
    if (role == Qt::BackgroundRole && change) {
        if (index.column() == Program && !is_added) return goneTint;
        if (index.column() == Corrected) return writtenTint;
    }
    if (role == Qt::TextAlignmentRole && index.column() == Line) return int(Qt::AlignRight | Qt::AlignVCenter);
    if (role == Qt::ToolTipRole && index.column() == Reason) return data(index, Qt::DisplayRole);
    if (role != Qt::DisplayRole) return {};
    switch (index.column()) {
        case Line: return is_added ? QString("+") : QLocale().toString(static_cast<qlonglong>(row.line));
        case Program: return is_added ? QString() : textOf(row);
        case Corrected: return change ? QString::fromStdString(change->after) : textOf(row);
        case Reason:
            if (row.is_kept) return tr("kept as it was");
            return change ? QString::fromStdString(
                                fill(text(change->reason, screenLanguage()), change->values, screenLanguage()))
                          : QString();
        default: return {};
    }
}

bool DiffModel::setData(const QModelIndex& index, const QVariant& value, int role)
{
    if (role != Qt::CheckStateRole || index.column() != Take) return false;
    emit taken(rows_[static_cast<std::size_t>(index.row())].line, value.toInt() == Qt::Checked);
    return true;
}

Qt::ItemFlags DiffModel::flags(const QModelIndex& index) const
{
    Qt::ItemFlags flags = QAbstractTableModel::flags(index);
    if (index.isValid() && index.column() == Take && rows_[static_cast<std::size_t>(index.row())].is_first)
        flags |= Qt::ItemIsUserCheckable;
    return flags;
}

QVariant DiffModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation != Qt::Horizontal || role != Qt::DisplayRole) return {};
    switch (section) {
        case Take: return tr("Take");
        case Line: return tr("Line");
        case Program: return tr("Program");
        case Corrected: return tr("Corrected");
        case Reason: return tr("Reason");
        default: return {};
    }
}

int DiffModel::firstChange() const
{
    const auto first = std::find_if(rows_.begin(), rows_.end(), [](const Row& row) { return row.change >= 0; });
    return first == rows_.end() ? -1 : static_cast<int>(first - rows_.begin());
}

std::optional<double> DiffModel::placeOf(int row) const
{
    if (row < 0 || row >= rowCount()) return std::nullopt;
    const deflection::ProgramChange* change = changeOf(rows_[static_cast<std::size_t>(row)]);
    const double* z_mm = change ? zOf(*change) : nullptr;
    return z_mm ? std::optional(*z_mm) : std::nullopt;
}

int DiffModel::rowAt(double z_mm) const
{
    int nearest = -1;
    double least = HUGE_VAL;
    for (int row = 0; row < rowCount(); ++row)
        if (const auto place = placeOf(row); place && std::abs(*place - z_mm) < least) {
            least = std::abs(*place - z_mm);
            nearest = row;
        }
    return nearest;
}

}  // namespace lathelier::correction_panel
