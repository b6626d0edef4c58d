// Error line above the views of a panel; and a label whose lines are never clipped.
#pragma once

#include <QFrame>
#include <QLabel>
#include <QWidget>

#include "engine/core/error.h"

namespace lathelier {

/// Text of the available width and always of the height of its lines, which a tight layout must not clip.
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

/// Error with place and remedy; shown until the next answer.
class MessageLine : public QFrame {
    Q_OBJECT
public:
    explicit MessageLine(QWidget* parent = nullptr);
    void setError(const Error& error);
    void setHint(const QString& text);  ///< information, not an error
    void clear();

private:
    void show(const QString& icon, const QString& text);

    QLabel* symbol_;
    WrappingLabel* text_;
};

}  // namespace lathelier
