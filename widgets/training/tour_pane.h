// A guided tour: one idea a step, a task at its end that the program checks.
#pragma once

#include <QLabel>
#include <QPushButton>
#include <QTextBrowser>
#include <QWidget>
#include <optional>
#include <vector>

#include "engine/training/lesson.h"

namespace lathelier::training_panel {

class TourPane : public QWidget {
    Q_OBJECT

public:
    explicit TourPane(QWidget* parent = nullptr);

    /// Another lesson, at its first step. An empty path: that of the program, in the language of the screen.
    void open(const QString& path);  ///< throws Error
    QString path() const { return path_; }

    int step() const { return step_; }  ///< from 0; -1: not begun
    int steps() const { return static_cast<int>(lesson_.steps.size()); }
    void goTo(int step);  ///< emits the settings and views of the step
    bool isDone() const { return done_; }

    /// What the program knows now: fills the numbers of the text, and checks the task.
    void setState(const training::LessonState& state);
    void retranslate();  ///< the program's own lesson is read again in the language of the screen

signals:
    void settingRequested(const lathelier::training::Setting& setting);
    void viewsRequested(const QStringList& keys);
    void stepBegun();  ///< seconds heard and points count from here
    void lessonRequested();

private:
    void show();

    training::Lesson lesson_;
    QString path_;
    int step_ = -1;
    bool done_ = false;
    std::vector<bool> doneSteps_;
    training::LessonState state_;
    QLabel* place_;
    QTextBrowser* text_;
    QLabel* task_;
    QLabel* hint_;
    QPushButton* back_;
    QPushButton* help_;
    QPushButton* next_;
    QPushButton* other_;
};

}  // namespace lathelier::training_panel
