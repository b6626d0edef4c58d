// What stands above the views of a panel: the headline, its notes, and what went wrong.
#pragma once

#include <QFrame>
#include <QLabel>
#include <QToolButton>
#include <QWidget>

#include "engine/core/error.h"
#include "engine/report/document.h"

namespace lathelier {

/// The answer in large type, and its verdict as a symbol and a word on a coloured plate.
class HeadlineLabel : public QWidget {
    Q_OBJECT
public:
    explicit HeadlineLabel(QWidget* parent = nullptr);
    void setHeadline(const Headline& headline);
    void clear();
    QString text() const;  ///< with the verdict's word

protected:
    void changeEvent(QEvent* event) override;

private:
    void applyFonts();

    QLabel* text_;
    QLabel* verdict_;
};

/// The notes of a result, warnings first; the first two are always seen, the rest unfolds.
class NotesLabel : public QWidget {
    Q_OBJECT
public:
    explicit NotesLabel(QWidget* parent = nullptr);
    void setNotes(const Notes& notes);
    void setPresenting(bool presenting);  ///< only the first one is seen, to leave room for the views

protected:
    void changeEvent(QEvent* event) override;

private:
    void refresh();

    QLabel* text_;
    QToolButton* fold_;
    Notes notes_;
    bool presenting_ = false;
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
    QLabel* text_;
};

}  // namespace lathelier
