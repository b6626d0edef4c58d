// One object of the scene in VTK: the full set, a decimated one for motion, and their colours. Included by .cpp files
// only.
#pragma once

#include <vtkActor.h>
#include <vtkFloatArray.h>
#include <vtkLookupTable.h>
#include <vtkNew.h>
#include <vtkPlane.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkRenderer.h>
#include <vtkUnsignedCharArray.h>

#include <Eigen/Geometry>
#include <optional>
#include <vector>

#include "engine/report/colours.h"
#include "widgets/scene/scene_data.h"

namespace lathelier::scene {

class SceneActor {
public:
    /// Uploads geometry relative to `origin`, so that single precision in OpenGL is sufficient.
    SceneActor(vtkRenderer* renderer, const SceneObject& object, const Eigen::Vector3d& origin,
               const std::optional<SceneAxis>& axis);
    ~SceneActor();
    SceneActor(const SceneActor&) = delete;
    SceneActor& operator=(const SceneActor&) = delete;

    const SceneObject& object() const { return object_; }
    bool sameGeometry(const SceneObject& other) const;

    /// Applies colour, values and visibility.
    void update(const SceneObject& object, const report::DeviationColours& colours,
                const std::optional<SceneAxis>& axis);
    void setMoving(bool moving);
    /// How many points are drawn while moving; meshes of moderate size are drawn whole.
    void setBudget(std::size_t points);
    bool isThinned() const { return thinned_; }
    std::size_t thinnedCount() const { return order_.size(); }
    void setSection(vtkPlane* plane);

private:
    struct Layer {
        vtkNew<vtkPolyData> data;              ///< points relative to the origin, and which of them are drawn
        vtkNew<vtkPolyDataMapper> mapper;      ///< draws `data` in `colours`
        vtkNew<vtkActor> actor;                ///< actor in the renderer
        vtkNew<vtkUnsignedCharArray> colours;  ///< red, green, blue of each point
    };
    void colourBetweenCorners(const std::optional<report::DeviationColours>& colours);
    void prepare(Layer& layer, double pointSize);
    void show();

    vtkRenderer* renderer_;
    SceneObject object_;
    bool thinned_ = false;
    bool moving_ = false;
    std::vector<std::uint32_t> order_;
    Layer full_;
    Layer thin_;
    std::shared_ptr<const std::vector<float>> split_for_;  ///< values that tell known from unknown triangles
    Layer unknown_;                 ///< triangles of a mesh with a corner whose value is not known
    vtkNew<vtkFloatArray> values_;  ///< of the corners of a mesh
    vtkNew<vtkLookupTable> scale_;  ///< from value to colour, applied between the corners
};

}  // namespace lathelier::scene
