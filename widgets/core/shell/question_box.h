// One box of the question bar: icon and name over its own answer. State and verdict are said by sign and word; colour
// repeats them.
#pragma once

#include <QAbstractButton>

#include "widgets/core/shell/question_answer.h"

namespace lathelier {

class QuestionBox : public QAbstractButton {
    Q_OBJECT
public:
    explicit QuestionBox(QWidget* parent = nullptr);

    void setTitle(const QString& title);
    void setAnswer(const QuestionAnswer& answer);
    const QuestionAnswer& answer() const { return answer_; }
    QString answerText() const;  ///< with its sign, as drawn when there is room: "✓ 126.8 mm"
    void setCompact(bool compact);
    bool isCompact() const { return compact_; }  ///< the icon and the sign alone

    int neededWidth() const;  ///< for icon and whole name
    int compactWidth() const;
    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

signals:
    void stepRequested(int by);  ///< an arrow key: to the next box or an earlier one
    void menuRequested(const QPoint& global);

protected:
    void paintEvent(QPaintEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void contextMenuEvent(QContextMenuEvent* event) override;
    void enterEvent(QEvent* event) override;
    void leaveEvent(QEvent* event) override;

private:
    QString stateWords() const;
    QColor answerColour() const;
    int iconSize() const { return fontMetrics().height(); }
    void describe();
    void paintFrame(QPainter& painter) const;

    QuestionAnswer answer_;
    bool compact_ = false;
};

}  // namespace lathelier
