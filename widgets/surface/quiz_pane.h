// The question for a class: find the frequency of the picture with ruler and formula; the program checks it.
#pragma once

#include <QCheckBox>
#include <QLabel>
#include <QPushButton>
#include <QWidget>

#include "engine/surface/task/surface_question.h"
#include "widgets/core/form/number_edit.h"

namespace lathelier::surface_panel {

class QuizPane : public QWidget {
    Q_OBJECT

public:
    explicit QuizPane(QWidget* parent = nullptr);

    void setQuestion(const surface::SurfaceQuestion& question);  ///< announces nothing
    NumberEdit* answer() const { return answer_; }
    QPushButton* check() const { return check_; }
    void retranslate();

signals:
    void quizRequested(bool on);
    void answerRequested(double frequency_hz);
    void questionRequested(int number);

private:
    void showWords();

    QCheckBox* ask_;
    QWidget* body_;
    QLabel* words_;
    QLabel* name_;
    NumberEdit* answer_;
    QPushButton* check_;
    QPushButton* next_;
    surface::SurfaceQuestion question_;
};

}  // namespace lathelier::surface_panel
