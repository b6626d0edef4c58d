#include "widgets/core/form/field_editor.h"

#include <QCheckBox>
#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QWheelEvent>
#include <cmath>

#include "widgets/core/form/disconnect_children.h"
#include "widgets/core/form/intervals_edit.h"
#include "widgets/core/form/number_edit.h"
#include "widgets/core/form/rows_edit.h"
#include "widgets/core/language.h"

namespace lathelier {
namespace {

class FlagEditor : public FieldEditor {
public:
    explicit FlagEditor(QWidget* parent) : FieldEditor(parent), box_(new QCheckBox)
    {
        fill(box_);
        connect(box_, &QCheckBox::clicked, this, [this] {
            emit changed();
            emit finished();
        });
    }
    Value value() const override { return box_->isChecked(); }
    void setValue(const Value& value) override
    {
        if (const bool* flag = std::get_if<bool>(&value)) box_->setChecked(*flag);
    }
    void retranslate(const FieldInfo& info) override
    {
        box_->setAccessibleName(screenText(info.label));
        box_->setToolTip(screenText(info.help));
    }
    QWidget* input() override { return box_; }

private:
    QCheckBox* box_;
};

class NumberEditor : public FieldEditor {
public:
    NumberEditor(const FieldInfo& info, QWidget* parent)
        : FieldEditor(parent),
          edit_(new NumberEdit(info.minimum, info.maximum)),
          integer_(info.kind == FieldInfo::Kind::Integer)
    {
        edit_->setInteger(integer_);
        edit_->setUsual(info.usual);
        fill(edit_);
        connect(edit_, &NumberEdit::numberChanged, this, &FieldEditor::changed);
        connect(edit_, &NumberEdit::finished, this, &FieldEditor::finished);
    }
    Value value() const override
    {
        if (!edit_->number()) return {};
        if (integer_) return static_cast<std::int64_t>(*edit_->number());
        return *edit_->number();
    }
    void setValue(const Value& value) override
    {
        if (std::holds_alternative<std::monostate>(value))
            edit_->setNumber(std::nullopt);
        else if (const auto* whole = std::get_if<std::int64_t>(&value))
            edit_->setNumber(static_cast<double>(*whole));
        else if (const auto* number = std::get_if<double>(&value))
            edit_->setNumber(*number);
    }
    void retranslate(const FieldInfo& info) override
    {
        if (info.optional) edit_->setOptional(FieldEditor::tr("not given"));
        edit_->setAccessibleName(screenText(info.label));
        edit_->setFactor(screenFactor(info.unit));
        edit_->setHelp(screenText(info.help));
    }
    QWidget* input() override { return edit_; }

private:
    NumberEdit* edit_;
    bool integer_;
};

/// A combo box that reacts to the wheel only with focus, so that scrolling the column does not change it.
class CalmComboBox : public QComboBox {
protected:
    void wheelEvent(QWheelEvent* event) override
    {
        if (hasFocus())
            QComboBox::wheelEvent(event);
        else
            event->ignore();
    }
};

class ChoiceEditor : public FieldEditor {
public:
    ChoiceEditor(const FieldInfo& info, QWidget* parent) : FieldEditor(parent), box_(new CalmComboBox)
    {
        box_->setFocusPolicy(Qt::StrongFocus);
        box_->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
        box_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
        box_->setMinimumContentsLength(8);
        for (const FieldChoice& choice : info.choices) box_->addItem(QString(), QString::fromStdString(choice.key));
        fill(box_);
        connect(box_, qOverload<int>(&QComboBox::activated), this, [this] {
            emit changed();
            emit finished();
        });
    }
    Value value() const override { return box_->currentData().toString().toStdString(); }
    void setValue(const Value& value) override
    {
        if (const auto* key = std::get_if<std::string>(&value))
            if (const int index = box_->findData(QString::fromStdString(*key)); index >= 0)
                box_->setCurrentIndex(index);
    }
    void retranslate(const FieldInfo& info) override
    {
        for (int i = 0; i < box_->count(); ++i)
            box_->setItemText(i, screenText(info.choices[static_cast<std::size_t>(i)].label));
        box_->setAccessibleName(screenText(info.label));
        box_->setToolTip(screenText(info.help));
    }
    QWidget* input() override { return box_; }

private:
    QComboBox* box_;
};

class WordEditor : public FieldEditor {
public:
    explicit WordEditor(QWidget* parent) : FieldEditor(parent), edit_(new QLineEdit)
    {
        fill(edit_);
        connect(edit_, &QLineEdit::textEdited, this, &FieldEditor::changed);
        connect(edit_, &QLineEdit::editingFinished, this, &FieldEditor::finished);
    }
    Value value() const override { return edit_->text().toStdString(); }
    void setValue(const Value& value) override
    {
        if (const auto* word = std::get_if<std::string>(&value))
            if (value != this->value()) edit_->setText(QString::fromStdString(*word));
    }
    void retranslate(const FieldInfo& info) override
    {
        edit_->setAccessibleName(screenText(info.label));
        edit_->setToolTip(screenText(info.help));
    }
    QWidget* input() override { return edit_; }

private:
    QLineEdit* edit_;
};

class RangesEditor : public FieldEditor {
public:
    RangesEditor(const FieldInfo& info, QWidget* parent)
        : FieldEditor(parent), edit_(new IntervalsEdit(info.minimum, info.maximum))
    {
        fill(edit_);
        connect(edit_, &IntervalsEdit::intervalsChanged, this, &FieldEditor::changed);
        connect(edit_, &IntervalsEdit::finished, this, &FieldEditor::finished);
    }
    Value value() const override { return edit_->intervals(); }
    void setValue(const Value& value) override
    {
        if (const auto* intervals = std::get_if<std::vector<Interval>>(&value)) edit_->setIntervals(*intervals);
    }
    void retranslate(const FieldInfo& info) override
    {
        edit_->setFactor(screenFactor(info.unit));
        edit_->setNames(screenText(info.label), screenText(info.help));
        edit_->setToolTip(screenText(info.help));
    }
    QWidget* input() override { return edit_; }

private:
    IntervalsEdit* edit_;
};

class TableEditor : public FieldEditor {
public:
    TableEditor(const FieldInfo& info, QWidget* parent) : FieldEditor(parent), edit_(new RowsEdit(info))
    {
        fill(edit_);
        connect(edit_, &RowsEdit::rowsChanged, this, [this] {
            emit changed();
            emit finished();
        });
    }
    Value value() const override { return edit_->rows(); }
    void setValue(const Value& value) override
    {
        if (const Rows* rows = std::get_if<Rows>(&value))
            edit_->setRows(*rows);
        else
            edit_->setRows({});  // empty list in the project file
    }
    void retranslate(const FieldInfo& info) override { edit_->setNames(screenText(info.label), screenText(info.help)); }
    QWidget* input() override { return edit_; }

private:
    RowsEdit* edit_;
};

}  // namespace

FieldEditor::~FieldEditor()
{
    disconnectChildren(*this);
}

void FieldEditor::fill(QWidget* content)
{
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(content);
    setFocusProxy(content);
}

FieldEditor* makeFieldEditor(const FieldInfo& info, QWidget* parent)
{
    switch (info.kind) {
        case FieldInfo::Kind::Flag:
        case FieldInfo::Kind::Group: return new FlagEditor(parent);
        case FieldInfo::Kind::Integer:
        case FieldInfo::Kind::Number: return new NumberEditor(info, parent);
        case FieldInfo::Kind::Choice: return new ChoiceEditor(info, parent);
        case FieldInfo::Kind::Word: return new WordEditor(parent);
        case FieldInfo::Kind::Intervals: return new RangesEditor(info, parent);
        case FieldInfo::Kind::Rows: return new TableEditor(info, parent);
    }
    return nullptr;
}

}  // namespace lathelier
