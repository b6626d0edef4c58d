// One editor for each kind of field; used by Form only.
#pragma once

#include <QWidget>

#include "engine/core/fields.h"

namespace lathelier {

class FieldEditor : public QWidget {
    Q_OBJECT
public:
    using QWidget::QWidget;
    ~FieldEditor() override;

    virtual Value value() const = 0;
    virtual void setValue(const Value& value) = 0;  ///< sets the value without a signal
    virtual void retranslate(const FieldInfo& info) = 0;
    virtual QWidget* input() = 0;  ///< the widget for the keyboard focus

signals:
    void changed();   ///< emitted when the user enters a valid value
    void finished();  ///< end of the gesture

protected:
    void fill(QWidget* content);
};

FieldEditor* makeFieldEditor(const FieldInfo& info, QWidget* parent);

}  // namespace lathelier
