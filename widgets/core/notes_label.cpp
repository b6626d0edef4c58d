#include "widgets/core/notes_label.h"

#include <QEvent>
#include <QFileInfo>
#include <QHBoxLayout>
#include <algorithm>

#include "engine/io/io_codes.h"
#include "engine/registration/registration_codes.h"
#include "widgets/core/answer_parts.h"
#include "widgets/core/language.h"

namespace lathelier {
namespace {

constexpr std::size_t alwaysSeen = 3;
constexpr std::size_t seenWhilePresenting = 2;
constexpr int lowPanel_lines = 42;

bool isWarning(const Note& note)
{
    return note.code.severity == Severity::Warning;
}

/// Says where the data come from or what was done, not how good the answer is.
bool isAside(const NoteCode& code)
{
    return code == notes::syntheticData || code == notes::methodChosen || code == notes::rowsSkipped;
}

int rank(const Note& note)
{
    return (isWarning(note) ? 0 : 2) + (isAside(note.code) ? 1 : 0);
}

std::string takePath(Note& note)
{
    const Value* path = find(note.values, "path");
    const auto* whole = path ? std::get_if<std::string>(path) : nullptr;
    if (!whole) return {};
    const QString name = QFileInfo(QString::fromStdString(*whole)).fileName();
    set(note.values, "path", std::string());
    return name.toStdString();
}

}  // namespace

Notes arranged(const Notes& notes)
{
    Notes result;
    std::vector<std::string> files;  // of each note of the result
    for (Note note : notes) {
        const std::string file = takePath(note);
        const auto same = std::find_if(result.begin(), result.end(), [&](const Note& known) {
            return known.code == note.code && known.values == note.values;
        });
        if (same == result.end()) {
            result.push_back(note);
            files.push_back(file);
            continue;
        }
        std::string& names = files[static_cast<std::size_t>(same - result.begin())];
        if (names != file) names += ", " + file;
    }
    for (std::size_t i = 0; i < result.size(); ++i)
        if (!files[i].empty()) set(result[i].values, "path", files[i]);
    std::stable_sort(result.begin(), result.end(), [](const Note& a, const Note& b) { return rank(a) < rank(b); });
    return result;
}

NotesLabel::NotesLabel(QWidget* parent) : QWidget(parent), text_(new WrappingLabel("notes")), fold_(new QToolButton)
{
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(text_, 1);
    layout->addWidget(fold_, 0, Qt::AlignTop);
    fold_->setObjectName("moreNotes");
    fold_->setCheckable(true);
    fold_->setAutoRaise(true);
    connect(fold_, &QToolButton::toggled, this, &NotesLabel::refresh);
    refresh();
}

void NotesLabel::setNotes(const Notes& notes)
{
    notes_ = arranged(notes);
    refresh();
}

void NotesLabel::setPresenting(bool presenting)
{
    presenting_ = presenting;
    refresh();
}

void NotesLabel::setRoom(int height_px)
{
    const bool low = height_px < lowPanel_lines * fontMetrics().height();
    if (low == low_) return;
    low_ = low;
    refresh();
}

void NotesLabel::refresh()
{
    std::size_t few = presenting_ ? seenWhilePresenting : alwaysSeen;
    if (low_) {
        const auto warnings = static_cast<std::size_t>(std::count_if(notes_.begin(), notes_.end(), isWarning));
        few = std::clamp<std::size_t>(warnings, 1, few);
    }
    const bool foldable = notes_.size() > few;
    const std::size_t seen = foldable && !fold_->isChecked() ? few : notes_.size();
    const bool hidden = std::any_of(notes_.begin() + static_cast<std::ptrdiff_t>(seen), notes_.end(), isWarning);
    QStringList lines;
    for (std::size_t i = 0; i < seen; ++i)
        lines << (isWarning(notes_[i]) ? QStringLiteral("⚠ ") : QStringLiteral("· ")) + screenText(notes_[i]);
    text_->say(lines.join('\n'));
    fold_->setVisible(foldable);
    fold_->setText((hidden ? QStringLiteral("⚠ ") : QString()) +
                   (fold_->isChecked() ? tr("Fewer notes") : tr("%1 more").arg(notes_.size() - few)));
    setVisible(!notes_.empty());
}

void NotesLabel::changeEvent(QEvent* event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange) refresh();
}

}  // namespace lathelier
