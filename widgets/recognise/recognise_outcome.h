// Outcome of the panel Recognise: the rows of a scan, and its points by kind of row.
#pragma once

#include <array>
#include <memory>
#include <mutex>
#include <vector>

#include "engine/core/texts.h"
#include "engine/drawing/drawing.h"
#include "engine/features/accepted_sizes.h"
#include "engine/features/row_change.h"
#include "engine/project/project.h"
#include "engine/shaft/shaft_item.h"
#include "widgets/core/files/scan_store.h"

namespace lathelier::recognise_panel {

inline constexpr const char* scanRole = "scan";
inline constexpr const char* changesKey = "row_changes";       ///< features::textOf() of them; not in the form
inline constexpr const char* changesOfKey = "row_changes_of";  ///< path of the scan of the changes; not in the form
inline constexpr const char* acceptedKey = "accepted_sizes";   ///< features::textOf() of them; not in the form

/// The scan divided by kind of row: cylinders, cones, arcs, none.
using ScanByKind = std::array<ScanPtr, 4>;

struct RecogniseOutcome {
    LoadedScanPtr points;                                 ///< scan file and content
    std::shared_ptr<const features::Recognition> found;   ///< result before the user's changes; equal to `result`
                                                          ///< without changes
    std::vector<features::RowChange> changes;             ///< changes of rows by the user
    std::shared_ptr<const features::Recognition> result;  ///< never null in an outcome of find()
    std::vector<features::AcceptedSize> accepted;         ///< suggestions accepted by the user
    Shaft shaft;                                          ///< with the accepted sizes, named after the file
    std::vector<ShaftStep> steps;     ///< steps of the published method, or rows converted to its table
    std::vector<std::size_t> beside;  ///< rows (from 0) not representable in the table
    ScanByKind by_kind;               ///< never null in an outcome of find()
    std::vector<InputFile> inputs;    ///< the scan file
    Notes notes;                      ///< of the file and of the result
    bool synthetic = false;           ///< the source is marked as synthetic
};

/// The shaft with measured values and U of every row of the outside.
Shaft measuredRows(const RecogniseOutcome& outcome);

RecoveredFrom recoveredFrom(const RecogniseOutcome& outcome);

/// The workshop drawing: measured values with U, accepted nominal sizes, the scan in the title block.
drawing::Drawing drawingOf(const RecogniseOutcome& outcome, const Language& language);

/// Cache of the last recognition: an accepted size changes only the shaft.
class LastRecognition {
public:
    /// Loads, recognises and fits only what is not cached; thread-safe. Errors: those of readScan(), recognize(),
    /// refit().
    RecogniseOutcome find(const project::PanelState& state, ScanStore& scans, const Progress& progress);

private:
    std::mutex mutex_;
    RecogniseOutcome last_;
};

}  // namespace lathelier::recognise_panel
