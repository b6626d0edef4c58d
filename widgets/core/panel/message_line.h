// What went wrong, above the views of a panel; and a label whose lines are never cut.
#pragma once

#include <QFrame>
#include <QLabel>
#include <QWidget>

#include "engine/core/error.h"

namespace lathelier {

/// Text as wide as there is room and always as high as its lines: a layout in need of room must not cut them.
class WrappingLabel : public QLabel {
    Q_OBJECT
public:
    explicit WrappingLabel(const char* name);
    void say(const QString& text);

protected:
    void resizeEvent(QResizeEvent* event) override;
    void changeEvent(QEvent* event) override;
    void showEvent(QShowEvent* event) override;

private:
    void keepLines();
};

/// What happened, where, and what to do; stays until the next answer.
class MessageLine : public QFrame {
    Q_OBJECT
public:
    explicit MessageLine(QWidget* parent = nullptr);
    void setError(const Error& error);
    void setHint(const QString& text);  ///< something to know, not an error
    void clear();

private:
    void show(const QString& icon, const QString& text);

    QLabel* symbol_;
    WrappingLabel* text_;
};

}  // namespace lathelier
