// Outcome of the panel Cylindricity: the cylinders with the fitted points.
#pragma once

#include <memory>
#include <mutex>
#include <vector>

#include "engine/form/cylinder/cylinder_surface.h"
#include "widgets/core/files/scan_store.h"

namespace lathelier::cylindricity_panel {

struct CylindricityOutcome {
    LoadedScanPtr points;                                    ///< scan file and content
    std::shared_ptr<const form::CylindricityResult> result;  ///< never null in an outcome of find()
    std::shared_ptr<const form::CylinderSurface> surface;    ///< about the minimum-zone cylinder; never null in an
                                                             ///< outcome of find()
    std::vector<InputFile> inputs;                           ///< the scan file
    Notes notes;                                             ///< of the file and of the result
    bool synthetic = false;                                  ///< the source is marked as synthetic

    const Scan& scan() const { return points->file.scan; }
};

/// Cache of the last fit: a change of tolerance or decision rule only repeats the decision.
class LastCylinder {
public:
    /// Loads and fits only what is not cached; thread-safe. Errors: those of readScan(), cylindricity().
    CylindricityOutcome find(const project::PanelState& state, ScanStore& scans, const Progress& progress);

private:
    std::mutex mutex_;
    CylindricityOutcome last_;
};

}  // namespace lathelier::cylindricity_panel
