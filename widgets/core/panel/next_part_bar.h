// Says that a dropped file was taken as the next part, and offers the other role for it.
#pragma once

#include <QFrame>

class QToolButton;

namespace lathelier {

class WrappingLabel;

class NextPartBar : public QFrame {
    Q_OBJECT
public:
    explicit NextPartBar(QWidget* parent = nullptr);

    /// `file` became the input `taken`; offered is `other` in place of it. Labels in the language of the screen.
    void offer(const QString& file, const QString& taken, const QString& other);

signals:
    void otherWanted();  ///< the user wants the file in the other role

private:
    WrappingLabel* text_;
    QToolButton* use_;
    QToolButton* close_;
};

}  // namespace lathelier
