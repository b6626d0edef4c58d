#include "widgets/scene/scene_outline.h"

#include <vtkCellArray.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkProperty.h>

namespace lathelier::scene {

SceneOutline::SceneOutline(vtkRenderer* renderer, const std::vector<std::vector<Eigen::Vector3d>>& lines_mm,
                           const Eigen::Vector3d& origin)
    : renderer_(renderer)
{
    vtkNew<vtkPoints> points;
    vtkNew<vtkCellArray> cells;
    for (const std::vector<Eigen::Vector3d>& line : lines_mm) {
        cells->InsertNextCell(static_cast<int>(line.size()));
        for (const Eigen::Vector3d& place : line) {
            const Eigen::Vector3d local = place - origin;
            cells->InsertCellPoint(points->InsertNextPoint(local.data()));
        }
    }
    vtkNew<vtkPolyData> data;
    data->SetPoints(points);
    data->SetLines(cells);
    mapper_->SetInputData(data);
    actor_->SetMapper(mapper_);
    actor_->PickableOff();
    actor_->GetProperty()->SetColor(0.25, 0.28, 0.32);
    actor_->GetProperty()->SetLighting(false);
    actor_->GetProperty()->SetLineWidth(1.2F);
    renderer_->AddActor(actor_);
}

SceneOutline::~SceneOutline()
{
    renderer_->RemoveActor(actor_);
}

void SceneOutline::setSection(vtkPlane* plane)
{
    mapper_->RemoveAllClippingPlanes();
    if (plane) mapper_->AddClippingPlane(plane);
}

}  // namespace lathelier::scene
