// Exercises with a hidden machine: listen, look, answer, and the points for it.
#pragma once

#include <QComboBox>
#include <QElapsedTimer>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSpinBox>
#include <QTextBrowser>
#include <QWidget>
#include <memory>
#include <optional>
#include <vector>

#include "engine/training/exercise.h"
#include "engine/training/sheet.h"
#include "widgets/core/form/number_edit.h"

namespace lathelier::training_panel {

class ExercisePane : public QWidget {
    Q_OBJECT

public:
    explicit ExercisePane(QWidget* parent = nullptr);

    void begin(training::ExerciseKind kind, std::uint32_t seed);
    const std::optional<training::Exercise>& exercise() const { return exercise_; }
    int cutsLeft() const { return cutsLeft_; }
    void listen(double speed_rpm);     ///< one of the cuts that may be heard
    void submitAnswer(double answer);  ///< grades the answer, once per exercise
    const std::optional<training::Grade>& grade() const { return grade_; }
    const std::vector<training::Answered>& answers() const { return answers_; }  ///< since the program began
    void retranslate();

signals:
    void begun();
    void cutHeard(std::shared_ptr<const lathelier::stability::SimulationResult> cut);
    void blowHeard(const lathelier::training::Decay& blow);
    void graded(double points);
    void refused(const lathelier::Error& error);
    void sheetRequested();

private:
    void show();
    QString explained(Text pattern, const std::vector<training::NamedNumber>& numbers) const;
    QString expected() const;

    std::optional<training::Exercise> exercise_;
    std::optional<training::Grade> grade_;
    int cutsLeft_ = 0;
    QElapsedTimer since_;
    std::vector<training::Answered> answers_;
    double points_ = 0;  ///< of all answers
    QComboBox* kind_;
    QSpinBox* seed_;
    QPushButton* begin_;
    QLineEdit* pupil_;
    QLabel* question_;
    NumberEdit* speed_;
    QPushButton* listen_;
    NumberEdit* answer_;
    QComboBox* choice_;
    QPushButton* submit_;
    QTextBrowser* result_;  ///< scrolls: an explanation may be longer than its room
    QLabel* total_;
    QPushButton* sheet_;
    QLabel *kindLabel_, *seedLabel_, *pupilLabel_, *speedLabel_, *answerLabel_;
};

}  // namespace lathelier::training_panel
