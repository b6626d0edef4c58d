#include "widgets/core/form/form.h"

#include <QEvent>
#include <QFormLayout>
#include <QLabel>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>

#include "widgets/core/form/disconnect_children.h"
#include "widgets/core/form/field_editor.h"
#include "widgets/core/language.h"

namespace lathelier {

Form::Form(std::vector<FieldInfo> fields, QWidget* parent) : QWidget(parent)
{
    const auto makeLayout = [](QWidget* owner) {
        auto* layout = new QFormLayout(owner);
        layout->setContentsMargins(0, 0, 0, 0);
        layout->setRowWrapPolicy(QFormLayout::WrapAllRows);
        layout->setFieldGrowthPolicy(QFormLayout::ExpandingFieldsGrow);
        return layout;
    };
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    auto* plain = new QWidget(this);
    QFormLayout* plainLayout = makeLayout(plain);
    layout->addWidget(plain);
    Text group;
    for (const FieldInfo& info : fields)
        if (!info.advanced) addRow(info, plainLayout, group);

    if (std::any_of(fields.begin(), fields.end(), [](const FieldInfo& info) { return info.advanced; })) {
        fold_ = new QToolButton(this);
        fold_->setObjectName("advanced");
        fold_->setCheckable(true);
        fold_->setAutoRaise(true);
        fold_->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
        layout->addWidget(fold_, 0, Qt::AlignLeft);
        advanced_ = new QWidget(this);
        QFormLayout* advancedLayout = makeLayout(advanced_);
        layout->addWidget(advanced_);
        Text folded_group;
        for (const FieldInfo& info : fields)
            if (info.advanced) addRow(info, advancedLayout, folded_group);
        connect(fold_, &QToolButton::toggled, this, &Form::setUnfolded);
        setUnfolded(false);
    }
    retranslate();
    enableGroups();
}

Form::~Form()
{
    disconnectChildren(*this);
}

/// `group`: of the row before in this layout.
void Form::addRow(const FieldInfo& info, QFormLayout* layout, Text& group)
{
    if (!info.group.empty() && !(info.group == group)) {
        auto* heading = new QLabel(this);
        QFont bold = heading->font();
        bold.setBold(true);
        heading->setFont(bold);
        layout->addRow(heading);
        headings_.emplace_back(info.group, heading);
    }
    group = info.group;
    auto* label = new QLabel(this);
    FieldEditor* editor = makeFieldEditor(info, this);
    editor->input()->setObjectName(QString::fromStdString(info.key));
    label->setBuddy(editor->input());
    layout->addRow(label, editor);
    rows_.push_back({info, label, editor});
    connect(editor, &FieldEditor::changed, this, [this, key = info.key, editor] {
        enableGroups();
        emit valueChanged(key, editor->value(), gesture_);
    });
    connect(editor, &FieldEditor::finished, this, [this] { ++gesture_; });
}

Values Form::values() const
{
    Values result;
    for (const Row& row : rows_) result.emplace_back(row.info.key, row.editor->value());
    return result;
}

void Form::setValues(const Values& values)
{
    for (const Row& row : rows_)
        if (const Value* value = lathelier::find(values, row.info.key)) row.editor->setValue(*value);
    enableGroups();
}

void Form::enableGroups()
{
    for (const Row& row : rows_) {
        if (row.info.group_key.empty()) continue;
        const auto group = std::find_if(rows_.begin(), rows_.end(),
                                        [&row](const Row& other) { return other.info.key == row.info.group_key; });
        const bool there = group != rows_.end() && group->editor->value() == Value(true);
        for (QWidget* part : {static_cast<QWidget*>(row.label), static_cast<QWidget*>(row.editor)}) {
            part->setEnabled(there);
            part->setVisible(there);
        }
    }
}

void Form::setUnfolded(bool unfolded)
{
    if (!fold_) return;
    fold_->setChecked(unfolded);
    fold_->setArrowType(unfolded ? Qt::DownArrow : Qt::RightArrow);
    advanced_->setVisible(unfolded);
}

void Form::setShown(const std::string& key, bool shown)
{
    for (const Row& row : rows_) {
        if (row.info.key != key) continue;
        row.label->setVisible(shown);
        row.editor->setVisible(shown);
    }
}

std::vector<std::string> Form::unfolded() const
{
    std::vector<std::string> keys;
    for (const Row& row : rows_)
        if (!row.info.advanced) keys.push_back(row.info.key);
    return keys;
}

QWidget* Form::editor(const std::string& key) const
{
    for (const Row& row : rows_)
        if (row.info.key == key) return row.editor->input();
    return nullptr;
}

void Form::setUsed(const UsedValues& used)
{
    if (used == used_) return;
    used_ = used;
    showLabels();
}

/// Label, unit, and the value used where the field is empty. Assumed values are counted in the header of the folded
/// part.
void Form::showLabels()
{
    int folded = 0;
    for (const Row& row : rows_) {
        const QString unit = screenUnit(row.info.unit);
        const QString label = screenText(row.info.label);
        const QString plain = unit.isEmpty() ? label : tr("%1 (%2)").arg(label, unit);
        const auto used = std::find_if(used_.begin(), used_.end(), [&](const UsedValue& value) {
            return value.key == row.info.key && value.origin != ValueOrigin::Given;
        });
        row.label->setTextFormat(used == used_.end() ? Qt::PlainText : Qt::RichText);
        if (used == used_.end()) {
            row.label->setText(plain);
            continue;
        }
        const bool assumed = used->origin == ValueOrigin::Assumed;
        const QString value = screenText(shownValue(used->value, used->unit, screenLanguage()));
        const QString tag = assumed ? tr("assumed: %1").arg(value) : tr("from the file: %1").arg(value);
        const QString colours = assumed ? QStringLiteral("background-color:#ffe08a; color:#4a3200;")
                                        : QStringLiteral("background-color:#d6e4f0; color:#1f3a52;");
        row.label->setText(QStringLiteral("%1 <span style='%2'>&nbsp;%3&nbsp;</span>")
                               .arg(plain.toHtmlEscaped(), colours, tag.toHtmlEscaped()));
        folded += assumed && row.info.advanced;
    }
    if (fold_) fold_->setText(folded ? tr("More (%n assumed)", nullptr, folded) : tr("More"));
}

void Form::retranslate()
{
    showLabels();
    for (const auto& [text, heading] : headings_) heading->setText(screenText(text));
    for (const Row& row : rows_) {
        row.label->setToolTip(screenText(row.info.help));
        row.editor->retranslate(row.info);
    }
}

void Form::changeEvent(QEvent* event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange) retranslate();
}

}  // namespace lathelier
