#include "widgets/core/form/input_box.h"

#include <QDragEnterEvent>
#include <QFileInfo>
#include <QGridLayout>
#include <QLocale>
#include <QMenu>
#include <QMimeData>
#include <QUrl>

#include "engine/io/frf/frf_codes.h"
#include "engine/io/io_codes.h"
#include "widgets/core/form/form.h"
#include "widgets/core/icons.h"
#include "widgets/core/language.h"

namespace lathelier {
namespace {

std::vector<FieldInfo> readingOf(const InputRole& role)
{
    std::vector<FieldInfo> fields = infos<io::ImportOptions>();
    for (const io::FileKind* kind : role.kinds) fields.insert(fields.end(), kind->reading.begin(), kind->reading.end());
    return fields;
}

/// "ply_binary_little_endian": shown as "PLY binary".
QString formatText(const std::string& format)
{
    const QStringList words = QString::fromStdString(format).split('_');
    const QString kind = words.value(1) == "binary" ? InputBox::tr("binary")
                         : words.value(1) == "text" ? InputBox::tr("text")
                                                    : words.value(1).toUpper();
    return (words.front().toUpper() + " " + kind).trimmed();
}

QToolButton* inputButton(const char* name, const QString& picture)
{
    auto* result = new QToolButton;
    result->setObjectName(name);
    result->setIcon(icon(picture));
    result->setAutoRaise(true);
    result->setFocusPolicy(Qt::StrongFocus);
    return result;
}

}  // namespace

InputBox::InputBox(const InputRole& role, QWidget* parent)
    : QWidget(parent),
      role_(role),
      title_(new QLabel),
      file_(new QLabel),
      facts_(new QLabel),
      open_(inputButton("openInput", "open")),
      clear_(inputButton("clearInput", "remove")),
      item_(inputButton("itemInput", "item")),
      how_(inputButton("howToRead", "import")),
      import_(new Form(readingOf(role)))
{
    setObjectName(QString::fromStdString("input_" + role.role));
    setAcceptDrops(true);
    auto* layout = new QGridLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setHorizontalSpacing(2);
    layout->setVerticalSpacing(2);
    QFont bold = title_->font();
    bold.setBold(true);
    title_->setFont(bold);
    facts_->setWordWrap(true);
    facts_->setForegroundRole(QPalette::PlaceholderText);
    file_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    layout->addWidget(title_, 0, 0);
    layout->addWidget(how_, 0, 1);
    layout->addWidget(item_, 0, 2);
    layout->addWidget(open_, 0, 3);
    layout->addWidget(clear_, 0, 4);
    layout->addWidget(file_, 1, 0, 1, 5);
    layout->addWidget(facts_, 2, 0, 1, 5);
    layout->addWidget(import_, 3, 0, 1, 5);
    item_->setPopupMode(QToolButton::InstantPopup);
    item_->setMenu(new QMenu(item_));
    layout->setColumnStretch(0, 1);
    how_->setCheckable(true);
    import_->hide();
    connect(open_, &QToolButton::clicked, this, &InputBox::openRequested);
    connect(clear_, &QToolButton::clicked, this, &InputBox::clearRequested);
    connect(how_, &QToolButton::toggled, import_, &QWidget::setVisible);
    connect(import_, &Form::valueChanged, this, [this] { emit importChanged(import_->values()); });
    retranslate();
}

void InputBox::setSources(const std::vector<project::Source>& sources)
{
    sources_ = sources;
    Values values = toValues(io::ImportOptions{});
    for (const io::FileKind* kind : role_.kinds)
        for (const auto& [name, value] : kind->reading_defaults) lathelier::set(values, name, value);
    if (!sources.empty())
        for (const auto& [name, value] : sources.front().import) lathelier::set(values, name, value);
    import_->setValues(values);
    refresh();
}

void InputBox::setItems(const std::vector<ItemOffer>& items)
{
    items_ = items;
    item_->menu()->clear();
    for (const ItemOffer& item : items_)
        item_->menu()->addAction(item.name, this, [this, name = item.name] { emit itemRequested(name); });
    refresh();
}

void InputBox::setTaken(const walk::Taken* taken)
{
    taken_ = taken ? std::optional(*taken) : std::nullopt;
    refresh();
}

void InputBox::setUnderstood(const QString& text)
{
    understood_ = text;
    refresh();
}

void InputBox::setProblem(const Error* error)
{
    problem_ = error != nullptr;
    if (error &&
        (asksHowToRead(error->code()) || error->code() == errors::malformed || error->code() == errors::columnsUnknown))
        how_->setChecked(true);
    refresh();
}

bool asksHowToRead(const ErrorCode& code)
{
    return code == errors::unitUnknown || code == errors::numberAmbiguous || code == errors::frfUnitMissing ||
           code == errors::frfUnitUnknown || code == errors::frequencyUnitMissing ||
           code == errors::frfVariablesUnknown;
}

QString understoodText(const io::FileFacts& facts, const QString& amount)
{
    QStringList parts;
    parts << formatText(facts.format);
    if (!amount.isEmpty()) parts << amount;
    const QString unit = facts.unit == "um" ? QStringLiteral("µm") : QString::fromStdString(facts.unit);
    if (facts.unit_source == "guessed")
        parts << InputBox::tr("unit %1 (assumed)").arg(unit);
    else if (!unit.isEmpty())
        parts << InputBox::tr("unit %1").arg(unit);
    if (facts.decimal == "comma") parts << InputBox::tr("decimal comma");
    if (!facts.skipped.empty()) parts << InputBox::tr("rows skipped: %L1").arg(facts.skipped.size());
    return parts.join(QStringLiteral(" · "));
}

void InputBox::refresh()
{
    const bool there = !sources_.empty();
    const QString label = screenText(role_.label);
    title_->setText(role_.required && !there ? tr("%1 (required)").arg(label) : label);
    QStringList names, paths;
    for (const project::Source& source : sources_) {
        const QString item = QString::fromStdString(source.item);
        paths << (item.isEmpty() ? QString::fromStdString(source.path) : tr("“%1” of this project").arg(item));
        names << (item.isEmpty() ? screenFileName(paths.back()) : paths.back());
    }
    if (taken_ && there)
        names = paths = QStringList{taken_->is_assumed ? tr("from the shop (assumed)")
                                                       : tr("from “%1”").arg(screenText(taken_->from))};
    item_->setVisible(!items_.empty());
    clear_->setVisible(there && !taken_);
    how_->setVisible(there && sources_.front().item.empty());
    if (!there) how_->setChecked(false);
    QString name = there ? names.front() : QString();
    if (names.size() > 1) name = tr("%1 and %n more", nullptr, static_cast<int>(names.size() - 1)).arg(name);
    file_->setText(file_->fontMetrics().elidedText(name, Qt::ElideMiddle, std::max(width() - 4, 40)));
    file_->setToolTip(paths.join('\n'));
    file_->setAccessibleName(name);
    file_->setVisible(there);
    QStringList facts;
    if (!there)
        facts << screenText(role_.hint);
    else if (problem_ && understood_.isEmpty())
        facts << tr("⚠ This file could not be read.");
    else if (!understood_.isEmpty())
        facts << understood_;
    for (const ItemOffer& item : items_) {
        if (!there || item.name.toStdString() != sources_.front().item) continue;
        if (!item.origin.isEmpty()) facts << tr("Made in %1").arg(item.origin);
        if (item.outdated)
            facts << tr("⚠ %1 has another state by now: keep it there again to use it.").arg(item.origin);
    }
    if (there && sources_.front().synthetic) facts << tr("Synthetic data");
    facts_->setText(facts.join('\n'));
    facts_->setMinimumHeight(facts.isEmpty() ? 0 : facts_->heightForWidth(std::max(width(), 40)));  // no clipped line
    facts_->setVisible(!facts.isEmpty());
}

void InputBox::retranslate()
{
    const QString label = screenText(role_.label);
    title_->setToolTip(screenText(role_.hint));
    open_->setToolTip(tr("Open a file as “%1”").arg(label));
    open_->setAccessibleName(open_->toolTip());
    clear_->setToolTip(tr("Take “%1” away").arg(label));
    clear_->setAccessibleName(clear_->toolTip());
    item_->setToolTip(tr("Use what another panel made as “%1”").arg(label));
    item_->setAccessibleName(item_->toolTip());
    how_->setToolTip(tr("How to read this file: unit, decimal mark, columns"));
    how_->setAccessibleName(how_->toolTip());
    refresh();
}

void InputBox::changeEvent(QEvent* event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange) retranslate();
}

void InputBox::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    refresh();
}

void InputBox::dragEnterEvent(QDragEnterEvent* event)
{
    const auto files = event->mimeData()->urls().size();
    if (files == 1 || (files > 1 && role_.several)) event->acceptProposedAction();
}

void InputBox::dropEvent(QDropEvent* event)
{
    QStringList paths;
    for (const QUrl& url : event->mimeData()->urls())
        if (url.isLocalFile()) paths << url.toLocalFile();
    if (paths.isEmpty()) return;
    event->acceptProposedAction();
    emit filesDropped(paths);
}

}  // namespace lathelier
