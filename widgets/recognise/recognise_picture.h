// What the worker of the panel "Recognise" computes: the rows of a scan, and its points by the kind of their row.
#pragma once

#include <array>
#include <memory>
#include <mutex>
#include <vector>

#include "engine/features/accepted_sizes.h"
#include "engine/project/project.h"
#include "widgets/core/files/scan_store.h"

namespace lathelier::recognise_panel {

inline constexpr const char* scanRole = "scan";
inline constexpr const char* acceptedKey = "accepted_sizes";  ///< features::textOf() of them; is in no form

/// The scan in pieces: on cylinders, cones, arcs, and on no row.
using ScanByKind = std::array<ScanPtr, 4>;

struct RecognisePicture {
    LoadedScanPtr points;                                 ///< file and content
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

/// The last recognition: a size that is accepted changes the shaft alone.
class LastRecognition {
public:
    /// Loads and recognises only what is not there yet; safe from any thread. Errors: those of readScan(), recognize().
    RecognisePicture find(const project::PanelState& state, ScanStore& scans, const Progress& progress);

private:
    std::mutex mutex_;
    RecognisePicture last_;
};

}  // namespace lathelier::recognise_panel
