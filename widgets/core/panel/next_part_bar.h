// States that a dropped file was used as the next part, and offers the other role.
#pragma once

#include <QFrame>

class QToolButton;

namespace lathelier {

class WrappingLabel;

class NextPartBar : public QFrame {
    Q_OBJECT
public:
    explicit NextPartBar(QWidget* parent = nullptr);

    /// `file` became the input `taken`; `other` is offered instead. Labels in the user's language.
    void offer(const QString& file, const QString& taken, const QString& other);

signals:
    void otherRequested();  ///< request to use the file in the other role

private:
    WrappingLabel* text_;
    QToolButton* use_;
    QToolButton* close_;
};

}  // namespace lathelier
