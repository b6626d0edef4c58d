// The parts of the project: which one is shown; adding, renaming and removing them.
#pragma once

#include <QWidget>

#include "widgets/core/session.h"

class QLabel;
class QListWidget;
class QListWidgetItem;
class QToolButton;

namespace lathelier {

/// A click on a part shows it, F2 renames it in place.
class PartsBox : public QWidget {
    Q_OBJECT
public:
    explicit PartsBox(Session& session, QWidget* parent = nullptr);

    QString nameOf(std::size_t index) const;  ///< "Part 2" where it has no name

public slots:
    void addPart();
    void renameCurrent();
    void removeCurrent();

protected:
    void changeEvent(QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    void fill();
    void fitHeight();
    void retranslate();
    void show(QListWidgetItem* row);
    void takeName(QListWidgetItem* row);
    void askAt(const QPoint& place);

    Session& session_;
    QLabel* title_;
    QListWidget* list_;
    QToolButton* add_;
    QToolButton* rename_;
    QToolButton* remove_;
};

/// The list of parts with `below` under it.
QWidget* underParts(Session& session, QWidget* below);

}  // namespace lathelier
