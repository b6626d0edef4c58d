// The bar at the top of the window: the questions in the order of the work, each with its own answer; a box is the tab
// of its panels. Behind a gap those that stand beside the chain.
#pragma once

#include <QWidget>
#include <string>
#include <vector>

#include "widgets/core/panel/panel_facts.h"
#include "widgets/core/shell/question_box.h"

namespace lathelier {

class QuestionBar : public QWidget {
    Q_OBJECT
public:
    explicit QuestionBar(const std::vector<Question>& questions, QWidget* parent = nullptr);

    /// What the box of a question says; an unknown question is ignored.
    void setAnswer(const std::string& question, const QuestionAnswer& answer);
    void setCurrent(const std::string& question);         ///< checks its box
    QuestionBox* box(const std::string& question) const;  ///< nullptr: unknown

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

signals:
    void questionRequested(const std::string& id);
    void menuRequested(const std::string& id, const QPoint& global);  ///< context menu of a box

protected:
    void resizeEvent(QResizeEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    void arrange();
    void retranslate();
    std::vector<int> widths() const;

    std::vector<Question> questions_;
    std::vector<QuestionBox*> boxes_;
};

}  // namespace lathelier
