// The operator's screen beside a lathe: the recommended speed in large type, the input values, and keys to type them.
#pragma once

#include <QLabel>
#include <QPushButton>
#include <QWidget>
#include <optional>
#include <vector>

#include "engine/core/fields.h"

namespace lathelier::speed_panel {

class OperatorKeys : public QWidget {
    Q_OBJECT

public:
    /// `asked`: the values to type, in their order; `symbols`: as the operator knows them, "D", "v_c".
    OperatorKeys(std::vector<FieldInfo> asked, QStringList symbols, QWidget* parent = nullptr);

    void setValues(const Values& values);  ///< values by key; pending input is kept
    /// Above the keys: "2154", "1/min", and a line under it. `good` false: no stable speed.
    void setReading(const QString& value, const QString& unit, const QString& line, bool good);

    QString entry() const { return entry_.value_or(QString()); }  ///< pending entry
    std::size_t chosen() const { return chosen_; }                ///< value being edited

signals:
    void valueEntered(const QString& key, double value);
    void valueCleared(const QString& key);

protected:
    void keyPressEvent(QKeyEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    QPushButton* makeKey(const QString& name, int row, int column);
    void choose(std::size_t which);
    void type(QChar sign);
    void erase();
    void clear();
    void enter();
    void relabel();
    void showReadingLine();
    void setTypeSizes();

    std::vector<FieldInfo> asked_;
    QStringList symbols_;
    std::vector<Value> values_;
    std::size_t chosen_ = 0;
    std::optional<QString> entry_;  ///< pending entry; none: nothing typed for the chosen value
    bool refused_ = false;          ///< the entry is out of range
    QString readingLine_;           ///< under the reading, while nothing is refused
    bool good_ = true;              ///< the reading is a speed
    QLabel* reading_;
    QLabel* line_;
    std::vector<QPushButton*> rows_;
    std::vector<QPushButton*> keys_;
    QPushButton* point_ = nullptr;
    QWidget* pad_;
};

}  // namespace lathelier::speed_panel
