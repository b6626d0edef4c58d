#include "widgets/core/input_box.h"

#include <QDragEnterEvent>
#include <QFileInfo>
#include <QGridLayout>
#include <QLocale>
#include <QMimeData>
#include <QUrl>

#include "widgets/core/form.h"
#include "widgets/core/icons.h"
#include "widgets/core/language.h"

namespace lathelier {
namespace {

bool settledByImport(ErrorCode code)
{
    return code == ErrorCode::UnitUnknown || code == ErrorCode::NumberAmbiguous || code == ErrorCode::Malformed;
}

/// "ply_binary_little_endian": what a person wants to know of it, "PLY binary".
QString formatText(const std::string& format)
{
    const QStringList words = QString::fromStdString(format).split('_');
    const QString kind = words.value(1) == "binary" ? InputBox::tr("binary")
                         : words.value(1) == "text" ? InputBox::tr("text")
                                                    : words.value(1).toUpper();
    return (words.front().toUpper() + " " + kind).trimmed();
}

QToolButton* button(const char* name, const QString& picture)
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
      open_(button("openInput", "open")),
      clear_(button("clearInput", "remove")),
      how_(button("howToRead", "import")),
      import_(new Form(infos<ImportOptions>()))
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
    layout->addWidget(open_, 0, 2);
    layout->addWidget(clear_, 0, 3);
    layout->addWidget(file_, 1, 0, 1, 4);
    layout->addWidget(facts_, 2, 0, 1, 4);
    layout->addWidget(import_, 3, 0, 1, 4);
    layout->setColumnStretch(0, 1);
    how_->setCheckable(true);
    import_->hide();
    connect(open_, &QToolButton::clicked, this, &InputBox::openWanted);
    connect(clear_, &QToolButton::clicked, this, &InputBox::clearWanted);
    connect(how_, &QToolButton::toggled, import_, &QWidget::setVisible);
    connect(import_, &Form::valueChanged, this, [this] { emit importChanged(import_->values()); });
    retranslate();
}

void InputBox::setSource(const std::optional<Source>& source)
{
    source_ = source;
    import_->setValues(toValues(fromValues<ImportOptions>(source ? source->import : Values())));
    refresh();
}

void InputBox::setUnderstood(const LoadedScanPtr& scan)
{
    scan_ = scan;
    refresh();
}

void InputBox::setProblem(const Error* error)
{
    problem_ = error != nullptr;
    if (error && settledByImport(error->code())) how_->setChecked(true);
    refresh();
}

QString InputBox::understoodText() const
{
    const FileFacts& facts = scan_->file.facts;
    const Scan& scan = scan_->file.scan;
    QStringList parts;
    parts << formatText(facts.format);
    parts << (scan.isMesh() ? tr("%L1 triangles").arg(scan.triangles.size())
                            : tr("%L1 points").arg(scan.points_mm.size()));
    const QString unit = QString::fromStdString(facts.unit);
    if (facts.unit_source == "guessed")
        parts << tr("unit %1 (assumed)").arg(unit);
    else
        parts << tr("unit %1").arg(unit);
    if (facts.decimal == "comma") parts << tr("decimal comma");
    if (!facts.skipped.empty()) parts << tr("rows skipped: %L1").arg(facts.skipped.size());
    return parts.join(QStringLiteral(" · "));
}

void InputBox::refresh()
{
    const QString path = source_ ? QString::fromStdString(source_->path) : QString();
    clear_->setVisible(source_.has_value());
    how_->setVisible(source_.has_value());
    if (!source_) how_->setChecked(false);
    const QString name = source_ ? QFileInfo(path).fileName() : screenText(role_.hint);
    file_->setText(file_->fontMetrics().elidedText(name, Qt::ElideMiddle, std::max(width() - 4, 40)));
    file_->setToolTip(source_ ? path : screenText(role_.hint));
    file_->setAccessibleName(name);
    file_->setEnabled(source_.has_value());
    QStringList facts;
    if (problem_)
        facts << tr("⚠ This file could not be read.");
    else if (source_ && scan_)
        facts << understoodText();
    if (source_ && source_->synthetic) facts << tr("Synthetic data");
    facts_->setText(facts.join('\n'));
    facts_->setVisible(!facts.isEmpty());
}

void InputBox::retranslate()
{
    const QString label = screenText(role_.label);
    title_->setText(label);
    title_->setToolTip(screenText(role_.hint));
    open_->setToolTip(tr("Open a file as “%1”").arg(label));
    open_->setAccessibleName(open_->toolTip());
    clear_->setToolTip(tr("Take “%1” away").arg(label));
    clear_->setAccessibleName(clear_->toolTip());
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
    if (event->mimeData()->hasUrls() && event->mimeData()->urls().size() == 1) event->acceptProposedAction();
}

void InputBox::dropEvent(QDropEvent* event)
{
    const QString path = event->mimeData()->urls().value(0).toLocalFile();
    if (path.isEmpty()) return;
    event->acceptProposedAction();
    emit fileDropped(path);
}

}  // namespace lathelier
