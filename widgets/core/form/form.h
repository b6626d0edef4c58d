// The form of a parameter struct, built from its description.
#pragma once

#include <QString>
#include <QWidget>
#include <memory>
#include <utility>
#include <vector>

#include "engine/core/used_value.h"

class QFormLayout;
class QLabel;
class QToolButton;

namespace lathelier {

class FieldEditor;

/// One editor for each field: label with tooltip, unit behind the editor, advanced fields folded away; the fields of a
/// group under its heading, those of a group that is absent hidden. Programmatic setValues() emits no signal. Numbers
/// are shown in the user's locale.
class Form : public QWidget {
    Q_OBJECT
public:
    explicit Form(std::vector<FieldInfo> fields, QWidget* parent = nullptr);
    ~Form() override;

    Values values() const;
    void setValues(const Values& values);               ///< unknown names are ignored, missing ones keep their value
    void setUnfolded(bool unfolded);                    ///< shows the advanced fields
    void setShown(const std::string& key, bool shown);  ///< a field without a meaning at present is hidden
    std::vector<std::string> unfolded() const;          ///< keys of the fields before "More"
    void setUsed(const UsedValues& used);               ///< marks empty fields with the value used and its origin

    /// The widget that edits `key`, for the keyboard focus and for tests; nullptr when there is none.
    QWidget* editor(const std::string& key) const;

signals:
    /// The user entered a valid value into the field `key`. Changes with the same `gesture` (one drag, one turn of the
    /// wheel until the field is left) form one undo step.
    void valueChanged(const std::string& key, const lathelier::Value& value, int gesture);

protected:
    void changeEvent(QEvent* event) override;

private:
    struct Row {
        FieldInfo info;       ///< field of the row
        QLabel* label;        ///< left column
        FieldEditor* editor;  ///< right column
    };
    void addRow(const FieldInfo& info, QFormLayout* layout, Text& group);
    void enableGroups();
    void retranslate();
    void showLabels();

    std::vector<Row> rows_;
    UsedValues used_;
    std::vector<std::pair<Text, QLabel*>> headings_;
    QToolButton* fold_ = nullptr;
    QWidget* advanced_ = nullptr;
    int gesture_ = 0;
};

}  // namespace lathelier
