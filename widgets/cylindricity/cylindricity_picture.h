// What the worker of the cylindricity panel computes: the cylinders with the points they were fitted to.
#pragma once

#include <memory>
#include <mutex>
#include <vector>

#include "engine/form/cylinder/cylinder_surface.h"
#include "widgets/core/files/scan_store.h"

namespace lathelier::cylindricity_panel {

struct CylindricityPicture {
    LoadedScanPtr points;                                    ///< file and content
    std::shared_ptr<const form::CylindricityResult> result;  ///< never null in a picture that find() gave
    std::shared_ptr<const form::CylinderSurface> surface;    ///< about the minimum-zone cylinder; never null there
    std::vector<InputFile> inputs;                           ///< the file
    Notes notes;                                             ///< of the file and of the result
    bool synthetic = false;                                  ///< the source is marked as synthetic

    const Scan& scan() const { return points->file.scan; }
};

/// The last fit: a change of tolerance or decision rule is judged anew from it.
class LastCylinder {
public:
    /// Loads and fits only what is not there yet; safe from any thread. Errors: those of readScan(), cylindricity().
    CylindricityPicture find(const project::PanelState& state, ScanStore& scans, const Progress& progress);

private:
    std::mutex mutex_;
    CylindricityPicture last_;
};

}  // namespace lathelier::cylindricity_panel
