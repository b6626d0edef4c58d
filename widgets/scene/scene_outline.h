// Thin lines in the scene. Included by .cpp files only, because it shows VTK.
#pragma once

#include <vtkActor.h>
#include <vtkNew.h>
#include <vtkPlane.h>
#include <vtkPolyDataMapper.h>
#include <vtkRenderer.h>

#include <Eigen/Core>
#include <vector>

namespace lathelier::scene {

class SceneOutline {
public:
    /// Uploads the lines relative to `origin`.
    SceneOutline(vtkRenderer* renderer, const std::vector<std::vector<Eigen::Vector3d>>& lines_mm,
                 const Eigen::Vector3d& origin);
    ~SceneOutline();
    SceneOutline(const SceneOutline&) = delete;
    SceneOutline& operator=(const SceneOutline&) = delete;

    void setSection(vtkPlane* plane);

private:
    vtkRenderer* renderer_;
    vtkNew<vtkPolyDataMapper> mapper_;
    vtkNew<vtkActor> actor_;
};

}  // namespace lathelier::scene
