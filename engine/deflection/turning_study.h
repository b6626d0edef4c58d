// Complete evaluation of one job: prediction, uncertainty, what-if, measured diameters, correction. Used by the panel
// Deflection, the command line and the setter's sheet.
#pragma once

#include <optional>
#include <vector>

#include "engine/deflection/corrected_program.h"
#include "engine/deflection/deflection_report.h"
#include "engine/deflection/feed_adjustment.h"
#include "engine/deflection/static_compliance.h"
#include "engine/deflection/triage.h"
#include "engine/stock/stock_check.h"

namespace lathelier::deflection {

struct StudyParameters {
    std::optional<double> tolerance_um;      ///< symmetric limit of the diameter error; none: no verdict
    bool band = false;                       ///< 95 % of samples of springs, forces and modulus
    bool sensitivities = false;              ///< effect of ±10 % of each influence
    bool map = false;                        ///< largest error over depth and feed of the last pass
    bool check_stock = true;                 ///< check for collisions
    bool feed = false;                       ///< the feed along z that keeps the last pass within the tolerance
    bool correction = false;                 ///< compute a corrected program
    std::vector<MeasuredDiameter> measured;  ///< on the finished part; used to identify the springs
    friend bool operator==(const StudyParameters&, const StudyParameters&) = default;
};

/// Without `correction`: the command line has an option for its file.
const std::vector<Field<StudyParameters>>& fieldsOf(const StudyParameters*);

/// Parameters of the parts.
struct StudyDetails {
    BandParameters band;
    MapParameters map;
    FeedParameters feed;  ///< its tolerance is that of the study
    IdentificationParameters identification;
    CompensationParameters compensation;
    friend bool operator==(const StudyDetails&, const StudyDetails&) = default;
};

struct TurningStudy {
    StudyParameters parameters;
    DeflectionResult prediction;     ///< of the program as it is
    std::optional<Verdict> verdict;  ///< of the largest error against the tolerance
    StaticCompliance compliance;     ///< of the stock on its springs
    std::optional<stock::StockResult> stock;
    std::optional<ErrorBand> band;
    std::optional<std::vector<Sensitivity>> swings;
    std::optional<FeedResult> feed;  ///< none without a tolerance
    std::optional<DeflectionMap> map;
    std::optional<IdentificationResult> identified;  ///< none: not enough measured diameters
    std::optional<TriageResult> triage;              ///< none: fewer than two measured diameters
    std::optional<CorrectedProgram> corrected;
    Notes notes;
};

/// Parameters of the stock check from a set-up: insert, chuck, tailstock, zero.
stock::StockParameters stockParameters(const TurningSetup& setup);

/// With fewer measured diameters than unknown springs: only the triage, with the note tooFewForStiffness. Errors: those
/// of the parts. Throws Cancelled.
TurningStudy studyTurning(const TurningJob& job, const StudyParameters& parameters, const StudyDetails& details = {},
                          const Progress& progress = {});

/// Keys of the prediction, `verdict`, `static_compliance`; those of the stock check (`findings` null if not requested);
/// `band`, `sensitivities`, `feed_adjustment`, `map`, `identification`, `triage` (null if not requested); with a
/// correction its keys.
Json toJson(const TurningStudy& study);

/// The largest error with its uncertainty against the tolerance; up to three findings: collisions, position of the
/// largest error, strongest influence, residual of a correction.
report::Answer answer(const TurningStudy& study, const Language& language = {});

/// Of the corrected program, which has to be there.
report::Answer correctionAnswer(const TurningStudy& study, const Language& language = {});

report::Table findingsTable(const stock::StockResult& result);

/// Answer, figures and notes.
report::Section studySummary(const TurningStudy& study, const Language& language = {});

/// The setter's sheet.
report::Document studyReport(const TurningStudy& study, const Language& language = {});

}  // namespace lathelier::deflection
