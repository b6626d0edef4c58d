// The results of a class: who answered which exercise, and the points. An entry holds kind and seed only, from which
// the exercise is made and graded again: the sheet can be checked by anyone.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "engine/core/progress.h"
#include "engine/core/quantities.h"
#include "engine/report/document.h"
#include "engine/training/exercise.h"

namespace lathelier::training {

/// One exercise that a pupil answered.
struct Answered {
    std::string pupil;                            ///< name; may be empty
    ExerciseKind kind = ExerciseKind::SafeSpeed;  ///< with the seed: which exercise
    std::uint32_t seed = 0;
    double answer = 0;    ///< in the unit of the exercise; NaN: none was given
    double needed_s = 0;  ///< from the question to the answer
};

struct SheetRow {
    Answered answered;
    Exercise exercise;
    Grade grade;
};

struct PupilTotal {
    std::string pupil;       ///< name
    int answers = 0;         ///< exercises answered
    int correct = 0;         ///< of these
    double points = 0;       ///< of all
    double most_points = 0;  ///< that could be had
    double needed_s = 0;     ///< in all
};

struct Sheet {
    std::vector<SheetRow> rows;      ///< in the order of the answers
    std::vector<PupilTotal> totals;  ///< in the order in which the names first appear
    PupilTotal whole;                ///< of the class; its name is empty
};

/// So many exercises (at most 100), every kind in turn, with seeds that follow from one seed: the same test for
/// everyone who has it.
std::vector<Exercise> makeTest(std::uint32_t seed, int count);

/// Makes and grades every exercise again. Throws Cancelled.
Sheet sheetOf(std::span<const Answered> answers, const Progress& progress = {});

const std::vector<QuantityOf<SheetRow>>& quantitiesOf(const SheetRow*);
const std::vector<QuantityOf<PupilTotal>>& quantitiesOf(const PupilTotal*);

/// pupil, exercise, seed, answer, expected, correct, points, needed_s; decimal point, comma.
std::string sheetCsv(const Sheet& sheet);

report::Document sheetReport(const Sheet& sheet);

}  // namespace lathelier::training
