// A short list of ranges "from - to", one row each.
#pragma once

#include <QToolButton>
#include <QVBoxLayout>
#include <QWidget>
#include <vector>

#include "engine/core/value.h"
#include "widgets/core/form/number_edit.h"

namespace lathelier {

/// Edits ranges within [minimum, maximum]. A row is valid once both ends are given and from <= to; until then it is
/// shown and not reported.
class IntervalsEdit : public QWidget {
    Q_OBJECT
public:
    IntervalsEdit(double minimum, double maximum, QWidget* parent = nullptr);
    ~IntervalsEdit() override;

    std::vector<Interval> intervals() const;
    void setIntervals(const std::vector<Interval>& intervals);  ///< sets the ranges without a signal
    void setFactor(double factor);                              ///< see NumberEdit::setFactor()
    void setNames(const QString& name, const QString& help);    ///< accessible name of the ends, tooltip

signals:
    void intervalsChanged();  ///< emitted on a change by the user
    void finished();

protected:
    void changeEvent(QEvent* event) override;

private:
    struct Row {
        QWidget* widget;      ///< container of the others
        NumberEdit* from;     ///< lower end; may be empty
        NumberEdit* to;       ///< upper end; may be empty
        QToolButton* remove;  ///< button that takes the row away
    };
    void addRow(std::optional<Interval> interval);
    void removeRow(QWidget* widget);
    void announce();
    void retranslate();

    double minimum_;
    double maximum_;
    double factor_ = 1;  ///< display factor
    QString name_;
    QString help_;
    QVBoxLayout* rowsLayout_;
    QToolButton* add_;
    std::vector<Row> rows_;
    std::vector<Interval> announced_;
};

}  // namespace lathelier
