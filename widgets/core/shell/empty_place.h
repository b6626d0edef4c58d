// What the window shows where all panels of the open question are closed or float.
#pragma once

#include <QLabel>
#include <QPushButton>
#include <QWidget>

namespace lathelier {

class EmptyPlace : public QWidget {
    Q_OBJECT
public:
    explicit EmptyPlace(QWidget* parent = nullptr);
    void setQuestion(const QString& title);

signals:
    void panelsRequested();  ///< request to bring the panels back

private:
    QLabel* sentence_;
    QPushButton* back_;
};

}  // namespace lathelier
