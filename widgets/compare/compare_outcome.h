// Outcome of the panel Compare: the engine's result with its scans, prepared for display.
#pragma once

#include <memory>
#include <mutex>
#include <vector>

#include "engine/features/shaft_comparison.h"
#include "engine/registration/compare.h"
#include "engine/report/document.h"
#include "engine/task/stores.h"
#include "widgets/core/files/scan_store.h"
#include "widgets/part_common/part_input.h"
#include "widgets/scene/scene_data.h"

namespace lathelier::compare_panel {

/// A drawing as the reference.
struct DrawnShaft {
    part_common::PartInput part;
    LoadedScanPtr mesh;  ///< mesh of its surface, used in place of a scan
};

struct CompareOutcome {
    LoadedScanPtr reference;                                    ///< reference scan; for a drawing its mesh
    LoadedScanPtr copy;                                         ///< scan of the copy
    std::shared_ptr<const registration::CompareResult> result;  ///< never null in an outcome of find()
    std::shared_ptr<const DrawnShaft> drawn;                    ///< null: the reference is a scan
    std::shared_ptr<const features::ShaftComparison> sizes;     ///< comparison of sizes; `result` is its surface; null:
                                                                ///< the reference is a scan
    /// By point of the copy: local mean deviation; NaN where it is not significant (surface_form.h).
    std::shared_ptr<const std::vector<float>> local_mean_mm;
    /// For each point of the copy: 1 or -1 on a face across the axis that faces along it or against it, else 0; null
    /// where there are no faces.
    std::shared_ptr<const std::vector<std::int8_t>> along_axis;
    std::shared_ptr<const std::vector<float>> map_mean_mm;  ///< the same for the unrolled map; null where there is none
    std::vector<InputFile> inputs;                          ///< of the reference, then of the copy
    Notes notes;                                            ///< of both files and of the comparison
    bool synthetic = false;                                 ///< either source is marked as synthetic

    const Scan& copyScan() const { return copy->file.scan; }
};

inline constexpr const char* referenceRole = "reference";

/// Whether the reference is a drawing: an item, or a STEP or SHAFT.json file by its head.
bool isDrawn(const project::Source& source);

/// Cache of the last registration. A change of the tolerance alone only repeats the decision, in milliseconds.
class LastComparison {
public:
    /// The outcome for this state. Loads, registers and evaluates only what is not cached; thread-safe. Errors: those
    /// of readScan(), takePart(), checkShaft() and compare().
    CompareOutcome find(const project::PanelState& state, Stores& stores, const Progress& progress);

private:
    std::mutex mutex_;
    CompareOutcome last_;
};

/// A place of the part in the coordinates of all views.
struct ComparePlace {
    Eigen::Vector3d reference_mm = Eigen::Vector3d::Zero();  ///< in the reference's frame
    std::optional<double> z_mm;                              ///< along the axis from its first data
    std::optional<double> angle_deg;                         ///< about the axis from its x, 0…360
    std::optional<std::size_t> point;                        ///< of the copy, a cloud
    std::optional<scene::PickedPlace> surface;               ///< of the copy, a mesh
    std::optional<double> deviation_mm;                      ///< signed; none where the place is excluded
    std::optional<double> local_mean_mm;                     ///< local mean deviation, where significant
};

/// A point of the copy (or, with `of_reference`, of the reference).
ComparePlace placeOfPoint(const CompareOutcome& outcome, std::size_t point, bool of_reference = false);

/// A place on the surface of the copy (or of the reference), which is a mesh. Its deviation is that of the corners in
/// proportion, as drawn.
ComparePlace placeOnMesh(const CompareOutcome& outcome, const scene::PickedPlace& surface, bool of_reference = false);

/// Wireframe of the original (rings at the ends of its smooth sections and lines along them) in its frame, shown with a
/// copy drawn with magnified error. Empty without an axis.
std::vector<std::vector<Eigen::Vector3d>> outlineOf(const registration::CompareResult& result);

/// The place on the reference's meridian; body of revolution only.
ComparePlace placeOnSurface(const CompareOutcome& outcome, double z_mm, double angle_deg);

}  // namespace lathelier::compare_panel
