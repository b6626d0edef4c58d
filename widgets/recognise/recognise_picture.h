// What the worker of the panel "Recognise" computes: the rows of a scan, and its points by the kind of their row.
#pragma once

#include <array>
#include <memory>
#include <mutex>
#include <vector>

#include "engine/core/shaft_item.h"
#include "engine/core/texts.h"
#include "engine/drawing/drawing.h"
#include "engine/features/accepted_sizes.h"
#include "engine/features/row_change.h"
#include "engine/project/project.h"
#include "widgets/core/files/scan_store.h"

namespace lathelier::recognise_panel {

inline constexpr const char* scanRole = "scan";
inline constexpr const char* changesKey = "row_changes";      ///< features::textOf() of them; is in no form
inline constexpr const char* changesOfKey = "row_changes_of";  ///< path of the scan that they are of; is in no form
inline constexpr const char* acceptedKey = "accepted_sizes";  ///< features::textOf() of them; is in no form

/// The scan in pieces: on cylinders, cones, arcs, and on no row.
using ScanByKind = std::array<ScanPtr, 4>;

struct RecognisePicture {
    LoadedScanPtr points;                                 ///< file and content
    std::shared_ptr<const features::Recognition> found;   ///< before the user's changes; the same where there are none
    std::vector<features::RowChange> changes;             ///< of the rows, by the user
    std::shared_ptr<const features::Recognition> result;  ///< never null in a picture that find() gave
    std::vector<features::AcceptedSize> accepted;         ///< of the suggestions, by the user
    Shaft shaft;                                          ///< with the accepted sizes, named after the file
    std::vector<ShaftStep> steps;                         ///< of the published method, or as its table shows the rows
    std::vector<std::size_t> beside;                      ///< rows (from 0) that the table has no place for
    ScanByKind by_kind;                                   ///< never null there
    std::vector<InputFile> inputs;                        ///< the file
    Notes notes;                                          ///< of the file and of the result
    bool synthetic = false;                               ///< the source is marked as synthetic
};

/// The shaft with what was measured and U beside the values of every row of the outside.
Shaft measuredRows(const RecognisePicture& picture);

RecoveredFrom recoveredFrom(const RecognisePicture& picture);

/// The workshop drawing: measured values with U, accepted nominal sizes, the scan in the title block.
drawing::Drawing drawingOf(const RecognisePicture& picture, const Language& language);

/// The last recognition: a size that is accepted changes the shaft alone.
class LastRecognition {
public:
    /// Loads, recognises and fits again only what is not there yet; safe from any thread. Errors: those of readScan(),
    /// recognize(), refit().
    RecognisePicture find(const project::PanelState& state, ScanStore& scans, const Progress& progress);

private:
    std::mutex mutex_;
    RecognisePicture last_;
};

}  // namespace lathelier::recognise_panel
