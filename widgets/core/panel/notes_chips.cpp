#include "widgets/core/panel/notes_chips.h"

#include <QEvent>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QVBoxLayout>
#include <algorithm>

#include "engine/io/io_codes.h"
#include "engine/registration/registration_codes.h"
#include "widgets/core/icons.h"
#include "widgets/core/language.h"
#include "widgets/core/panel/message_line.h"

namespace lathelier {
namespace {

bool isWarning(const Note& note)
{
    return note.code.severity == Severity::Warning;
}

/// Whether a note concerns the origin of the data or the processing, not the quality of the answer.
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
    std::vector<std::string> files;  // files of each note of the result
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

NotesChips::NotesChips(QWidget* parent)
    : QWidget(parent),
      warnings_(new QToolButton),
      facts_(new QToolButton),
      popup_(new QFrame(this, Qt::Popup)),
      text_(new WrappingLabel("notes"))
{
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(4);
    for (QToolButton* chip : {warnings_, facts_}) {
        chip->setAutoRaise(false);
        layout->addWidget(chip);
        connect(chip, &QToolButton::clicked, this, &NotesChips::open);
    }
    warnings_->setObjectName("noteWarnings");
    facts_->setObjectName("noteFacts");
    popup_->setFrameShape(QFrame::StyledPanel);
    popup_->setObjectName("notesPopup");
    auto* inside = new QVBoxLayout(popup_);
    inside->addWidget(text_);
    refresh();
}

void NotesChips::setNotes(const Notes& notes)
{
    notes_ = arranged(notes);
    refresh();
}

void NotesChips::refresh()
{
    const auto warnings = std::count_if(notes_.begin(), notes_.end(), isWarning);
    const auto facts = static_cast<std::ptrdiff_t>(notes_.size()) - warnings;
    QStringList lines;
    for (const Note& note : notes_)
        lines << (isWarning(note) ? QStringLiteral("⚠ ") : QStringLiteral("· ")) + screenText(note);
    text_->say(lines.join('\n'));
    const auto show = [&](QToolButton* chip, std::ptrdiff_t count, const QString& symbol, const QString& name) {
        chip->setText(QString::number(count));
        chip->setIcon(icon(symbol));
        chip->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
        chip->setAccessibleName(name);
        chip->setToolTip(name + "\n" + lines.join('\n'));
        chip->setVisible(count > 0);
    };
    show(warnings_, warnings, "warning", tr("%n warning(s)", nullptr, static_cast<int>(warnings)));
    show(facts_, facts, "info", tr("%n note(s)", nullptr, static_cast<int>(facts)));
}

/// Under the chips, as wide as the panel allows.
void NotesChips::open()
{
    const int width = std::max(320, std::min(fontMetrics().averageCharWidth() * 90, window()->width() - 40));
    popup_->setFixedWidth(width);
    popup_->adjustSize();
    const QPoint corner = mapToGlobal(QPoint(this->width() - width, height() + 2));
    popup_->move(std::max(window()->geometry().left(), corner.x()), corner.y());
    popup_->show();
    popup_->setFixedHeight(popup_->heightForWidth(width));
}

void NotesChips::changeEvent(QEvent* event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange) refresh();
}

}  // namespace lathelier
