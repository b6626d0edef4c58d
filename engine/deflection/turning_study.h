// All that is asked of one job at once: prediction, uncertainty, what-if, measured diameters, correction. What the
// panel Deflection, the command line and the setter's sheet show.
#pragma once

#include <optional>
#include <vector>

#include "engine/deflection/deflection_report.h"
#include "engine/deflection/feed_adjustment.h"
#include "engine/deflection/static_compliance.h"
#include "engine/deflection/triage.h"
#include "engine/deflection/turning_job.h"
#include "engine/stock/stock_check.h"

namespace lathelier::deflection {

struct StudyParameters {
    std::optional<double> tolerance_um;      ///< of the diameter error, to both sides; none: no verdict
    bool band = false;                       ///< 95 % of samples of springs, forces and modulus
    bool sensitivities = false;              ///< what 10 % of each influence do
    bool map = false;                        ///< largest error over depth and feed of the last pass
    bool check_stock = true;                 ///< where rapid moves and the tool meet what they must not
    bool feed = false;                       ///< the feed along z that keeps the last pass within the tolerance
    bool correction = false;                 ///< write the program anew
    std::vector<MeasuredDiameter> measured;  ///< on the finished part; springs are sought from them
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
    StudyParameters parameters;                      ///< as asked
    DeflectionResult prediction;                     ///< of the program as it is
    std::optional<Verdict> verdict;                  ///< of the largest error against the tolerance
    StaticCompliance compliance;                     ///< of the stock on its springs
    std::optional<stock::StockResult> stock;         ///< as asked
    std::optional<ErrorBand> band;                   ///< as asked
    std::optional<std::vector<Sensitivity>> swings;  ///< as asked
    std::optional<FeedResult> feed;                  ///< as asked, where there is a tolerance
    std::optional<DeflectionMap> map;                ///< as asked
    std::optional<IdentificationResult> identified;  ///< where diameters were measured, enough for it
    std::optional<TriageResult> triage;              ///< where two diameters or more were measured
    std::optional<CorrectedProgram> corrected;       ///< as asked
    Notes notes;                                     ///< of all parts
};

/// What the check against the stock knows of a set-up: insert, chuck, tailstock, zero.
stock::StockParameters stockParameters(const TurningSetup& setup);

/// Fewer measured diameters than springs that are sought: only the triage, with the note tooFewForStiffness. Errors:
/// those of the parts. Throws Cancelled.
TurningStudy studyTurning(const TurningJob& job, const StudyParameters& parameters, const StudyDetails& details = {},
                          const Progress& progress = {});

/// Keys of the prediction, `verdict`, `static_compliance`; those of the stock check (`findings` null where not asked);
/// `band`, `sensitivities`, `feed_adjustment`, `map`, `identification`, `triage` (null where not asked); with a
/// correction its keys.
Json toJson(const TurningStudy& study);

/// The largest error with its uncertainty against the tolerance; up to three findings: what the tool meets, where the
/// error is largest, what it hangs on most, what a correction leaves.
report::Answer answer(const TurningStudy& study, const Language& language = {});

report::Table findingsTable(const stock::StockResult& result);

/// Answer, figures and notes.
report::Section studySummary(const TurningStudy& study, const Language& language = {});

/// The setter's sheet.
report::Document studyReport(const TurningStudy& study, const Language& language = {});

}  // namespace lathelier::deflection
