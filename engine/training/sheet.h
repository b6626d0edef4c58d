// The results of a class: answered exercises of each pupil with points. An entry holds only kind and seed, from which
// the exercise is regenerated and graded, so that the sheet is verifiable.
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
    ExerciseKind kind = ExerciseKind::SafeSpeed;  ///< kind of exercise; identifies it together with the seed
    std::uint32_t seed = 0;
    double answer = 0;    ///< in the unit of the exercise; NaN: none was given
    double needed_s = 0;  ///< time from question to answer
};

struct SheetRow {
    Answered answered;
    Exercise exercise;
    Grade grade;
};

struct PupilTotal {
    std::string pupil;
    int answers = 0;
    int correct = 0;  ///< of these
    double points = 0;
    double most_points = 0;  ///< largest possible points
    double needed_s = 0;
};

struct Sheet {
    std::vector<SheetRow> rows;      ///< in the order of the answers
    std::vector<PupilTotal> totals;  ///< in the order in which the names first appear
    PupilTotal whole;                ///< of the class; its name is empty
};

/// `count` exercises (at most 100), every kind in turn, with seeds derived from one seed, so that a test is
/// reproducible.
std::vector<Exercise> makeTest(std::uint32_t seed, int count);

/// Regenerates and grades every exercise. Throws Cancelled.
Sheet sheetOf(std::span<const Answered> answers, const Progress& progress = {});

const std::vector<QuantityOf<SheetRow>>& quantitiesOf(const SheetRow*);
const std::vector<QuantityOf<PupilTotal>>& quantitiesOf(const PupilTotal*);

/// pupil, exercise, seed, answer, expected, correct, points, needed_s; decimal point, comma.
std::string sheetCsv(const Sheet& sheet);

report::Document sheetReport(const Sheet& sheet);

}  // namespace lathelier::training
