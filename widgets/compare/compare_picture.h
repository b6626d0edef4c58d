// What the worker of the comparison panel computes: the engine's result with the scans it came from, ready to be drawn.
#pragma once

#include <memory>
#include <mutex>
#include <vector>

#include "engine/features/shaft_comparison.h"
#include "engine/registration/compare.h"
#include "engine/report/document.h"
#include "widgets/core/files/scan_store.h"
#include "widgets/core/files/stores.h"
#include "widgets/part_common/taken_part.h"
#include "widgets/scene/scene_data.h"

namespace lathelier::compare_panel {

/// The reference, where it is a drawing.
struct DrawnShaft {
    part_common::TakenPart part;  ///< file or item
    LoadedScanPtr mesh;           ///< of its surface, in the place of a scan
};

struct ComparePicture {
    LoadedScanPtr reference;                                    ///< file and content; of a drawing its mesh
    LoadedScanPtr copy;                                         ///< file and content
    std::shared_ptr<const registration::CompareResult> result;  ///< never null in a picture that find() gave
    std::shared_ptr<const DrawnShaft> drawn;                    ///< null: the reference is a scan
    std::shared_ptr<const features::ShaftComparison> sizes;     ///< `result` is its surface; null likewise
    /// For each point of the copy the mean of its surroundings; NaN where the data carry none (surface_form.h).
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

/// Is the reference a drawing: an item, or a file that was found to be a STEP file or a SHAFT.json? Looks at its head.
bool isDrawn(const project::Source& source);

/// The last registration. A change of the tolerance alone is judged anew from it, in milliseconds.
class LastComparison {
public:
    /// The picture for this state. Loads, registers and evaluates only what is not there yet; safe from any thread.
    /// Errors: those of readScan(), takePart(), checkShaft() and compare().
    ComparePicture find(const project::PanelState& state, Stores& stores, const Progress& progress);

private:
    std::mutex mutex_;
    ComparePicture last_;
};

/// A place of the part in all coordinates that the views speak.
struct ComparePlace {
    Eigen::Vector3d reference_mm = Eigen::Vector3d::Zero();  ///< in the reference's frame
    std::optional<double> z_mm;                              ///< along the axis from its first data
    std::optional<double> angle_deg;                         ///< about the axis from its x, 0…360
    std::optional<std::size_t> point;                        ///< of the copy, a cloud
    std::optional<scene::PickedPlace> surface;               ///< of the copy, a mesh
    std::optional<double> deviation_mm;                      ///< signed; none where the place does not count
    std::optional<double> local_mean_mm;                     ///< mean deviation of its surroundings, where it is sure
};

/// A point of the copy (or, with `of_reference`, of the reference).
ComparePlace placeOfPoint(const ComparePicture& picture, std::size_t point, bool of_reference = false);

/// A place on the surface of the copy (or of the reference), which is a mesh. Its deviation is that of the corners in
/// proportion, as drawn.
ComparePlace placeOnMesh(const ComparePicture& picture, const scene::PickedPlace& surface, bool of_reference = false);

/// Rings at the ends of the smooth stretches of the original and lines along them, in its frame: its right shape,
/// beside a copy that is drawn in its wrong one. Empty without an axis.
std::vector<std::vector<Eigen::Vector3d>> outlineOf(const registration::CompareResult& result);

/// The place on the reference's meridian; body of revolution only.
ComparePlace placeOnSurface(const ComparePicture& picture, double z_mm, double angle_deg);

}  // namespace lathelier::compare_panel
