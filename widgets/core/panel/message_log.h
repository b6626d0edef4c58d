// The message log: errors and notes with their time, to read again and to copy.
#pragma once

#include <QTreeWidget>
#include <QWidget>
#include <vector>

#include "widgets/core/panel/message.h"

class QToolButton;

namespace lathelier {

/// Newest at the bottom; a message that repeats the last one of its panel is not added again.
class MessageLog : public QWidget {
    Q_OBJECT
public:
    explicit MessageLog(QWidget* parent = nullptr);

    void add(const Message& message);
    int count() const { return static_cast<int>(messages_.size()); }
    QString plainText() const;  ///< text for Copy: the selected lines, or all

protected:
    void changeEvent(QEvent* event) override;

private:
    void show(QTreeWidgetItem* item, const Message& message) const;
    void retranslate();
    void copy() const;

    std::vector<Message> messages_;
    QTreeWidget* list_;
    QToolButton* copy_;
    QToolButton* clear_;
};

}  // namespace lathelier
