// The task recognize: a turned part in its scan, with the changes of a person; its shaft, drawing and CAD. The verb and
// the panel Recognise.
#pragma once

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "engine/cad/task/part_files.h"
#include "engine/core/scan.h"
#include "engine/features/nominal/accepted_sizes.h"
#include "engine/features/recognition.h"
#include "engine/features/refit/row_change.h"
#include "engine/io/cloud/scan_input.h"
#include "engine/shaft/shaft_item.h"
#include "engine/shaft/shaft_step.h"
#include "engine/task/task.h"

namespace lathelier::cad {

inline constexpr const char* scanRole = "scan";
inline constexpr const char* changesKey = "row_changes";       ///< features::textOf() of them; kept in a window
inline constexpr const char* changesOfKey = "row_changes_of";  ///< path of the scan of the changes; likewise
inline constexpr const char* acceptedKey = "accepted_sizes";   ///< features::textOf() of them

struct RecognizeQuestion {
    features::RecognitionParameters recognition;
    TitleQuestion title;     ///< of the drawing
    CadQuestion cad;         ///< kinds of the files that are written
    std::string changes;     ///< of rows, by a person
    std::string changes_of;  ///< path of the scan that they are of
    std::string accepted;    ///< suggested sizes that a person accepted
};

const std::vector<Field<RecognizeQuestion>>& fieldsOf(const RecognizeQuestion*);

/// The scan divided by kind of row: cylinders, cones, arcs, none.
using ScanByKind = std::array<ScanPtr, 4>;

struct RecognizeOutcome : task::Answered {
    RecognizeQuestion question;                           ///< the parameters as a value
    std::shared_ptr<const Loaded<io::ScanFile>> points;   ///< scan file and content
    std::shared_ptr<const features::Recognition> found;   ///< before the changes; equal to `result` without any
    std::vector<features::RowChange> changes;             ///< changes of rows
    std::shared_ptr<const features::Recognition> result;  ///< never null
    std::vector<features::AcceptedSize> accepted;         ///< suggestions that were accepted
    Shaft shaft;                                          ///< with the accepted sizes, named after the file
    std::vector<ShaftStep> steps;                         ///< of the published method, or rows converted to its table
    std::vector<std::size_t> beside;                      ///< rows (from 0) that the table cannot hold
    ScanByKind by_kind{};                                 ///< for a scene: partedByKind(); empty where none is shown
};

/// Another accepted size recognises nothing anew, another change fits only. Errors: those of readScan(), recognize(),
/// refit(). Throws Cancelled.
RecognizeOutcome answerRecognize(const project::PanelState& state, Stores& stores, task::Sources& sources,
                                 const Progress& progress);

/// The points, or the triangles, by the row that they lie on.
ScanByKind partedByKind(const Scan& scan, const features::Recognition& result);

/// Error shaftIncomplete.
void requireComplete(const features::Recognition& result);

/// The workshop drawing: measured values with U, accepted nominal sizes, the scan in the title block.
drawing::Drawing drawingOf(const RecognizeOutcome& outcome, const Language& language);

task::Outcome outcomeOf(const std::shared_ptr<const RecognizeOutcome>& outcome);

inline constexpr const char* meridianExport = "meridian-csv";
inline constexpr const char* meridianPicture = "meridian-svg";
inline constexpr const char* residualPicture = "residuals-svg";

const task::Task& recognizeTask();

}  // namespace lathelier::cad
