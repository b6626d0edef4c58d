#include "widgets/scene/scene_actor.h"

#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkIdTypeArray.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkProperty.h>

#include <array>
#include <cmath>
#include <numeric>

#include "engine/core/parallel.h"
#include "widgets/scene/scene_camera.h"

namespace lathelier::scene {
namespace {

constexpr std::size_t mostThinned = 200000;
constexpr std::size_t mostTrianglesMoving = 200000;
constexpr std::size_t grain = 65536;
constexpr report::Rgb noValue{150, 150, 150};

vtkSmartPointer<vtkPoints> upload(std::size_t count, const std::function<Eigen::Vector3d(std::size_t)>& place)
{
    vtkNew<vtkFloatArray> array;
    array->SetNumberOfComponents(3);
    array->SetNumberOfTuples(static_cast<vtkIdType>(count));
    float* out = array->GetPointer(0);
    parallelFor(count, grain, {}, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const Eigen::Vector3f p = place(i).cast<float>();
            std::copy(p.data(), p.data() + 3, out + 3 * i);
        }
    });
    auto points = vtkSmartPointer<vtkPoints>::New();
    points->SetData(array);
    return points;
}

/// One cell with all vertices: a cell for each would be ten times slower.
void setVertices(vtkPolyData* data, std::size_t count)
{
    vtkNew<vtkIdTypeArray> ids;
    ids->SetNumberOfTuples(static_cast<vtkIdType>(count));
    std::iota(ids->GetPointer(0), ids->GetPointer(0) + count, vtkIdType{0});
    vtkNew<vtkCellArray> cells;
    cells->InsertNextCell(static_cast<vtkIdType>(count), ids->GetPointer(0));
    data->SetVerts(cells);
}

void setTriangles(vtkPolyData* data, const std::vector<std::array<std::uint32_t, 3>>& triangles)
{
    vtkNew<vtkCellArray> cells;
    cells->AllocateExact(static_cast<vtkIdType>(triangles.size()), static_cast<vtkIdType>(3 * triangles.size()));
    for (const auto& t : triangles) cells->InsertNextCell({vtkIdType{t[0]}, vtkIdType{t[1]}, vtkIdType{t[2]}});
    data->SetPolys(cells);
}

void setNormals(vtkPolyData* data, const Scan& scan, const Eigen::Isometry3d& scene_T_scan)
{
    vtkNew<vtkFloatArray> normals;
    normals->SetNumberOfComponents(3);
    normals->SetNumberOfTuples(static_cast<vtkIdType>(scan.normals.size()));
    float* out = normals->GetPointer(0);
    const Eigen::Matrix3f turn = scene_T_scan.linear().cast<float>();
    for (const Eigen::Vector3f& normal : scan.normals) {
        const Eigen::Vector3f turned = turn * normal;
        out = std::copy(turned.data(), turned.data() + 3, out);
    }
    data->GetPointData()->SetNormals(normals);
}

/// Shading factor of a surface with this normal, so that the shape of a uniformly coloured cloud is visible.
double shade(const Eigen::Vector3d& normal)
{
    static const Eigen::Vector3d light = Eigen::Vector3d(0.3, 0.45, 0.84).normalized();
    return normal.dot(light);
}

/// Outward direction at a point in the scene: the scan's normal, else along the axis or away from it, else none (zero).
Eigen::Vector3d outward(const SceneObject& object, const std::optional<SceneAxis>& axis, std::size_t i)
{
    const Scan& scan = *object.scan;
    if (scan.hasNormals()) return object.scene_T_scan.linear() * scan.normals[i].cast<double>();
    if (!axis) return Eigen::Vector3d::Zero();
    if (object.along_axis && i < object.along_axis->size() && (*object.along_axis)[i] != 0)
        return (*object.along_axis)[i] * axis->direction;
    const Eigen::Vector3d arm = object.scene_T_scan * scan.points_mm[i] - axis->point_mm;
    const Eigen::Vector3d radial = arm - arm.dot(axis->direction) * axis->direction;
    return radial.normalized();
}

}  // namespace

SceneActor::SceneActor(vtkRenderer* renderer, const SceneObject& object, const Eigen::Vector3d& origin,
                       const std::optional<SceneAxis>& axis)
    : renderer_(renderer), object_(object)
{
    const Scan& scan = *object.scan;
    const Eigen::Isometry3d local = Eigen::Translation3d(-origin) * object.scene_T_scan;
    const bool displaced = object.outward_mm && object.outward_mm->size() == scan.points_mm.size();
    const auto place = [&](std::size_t i) -> Eigen::Vector3d {
        if (!displaced || std::isnan((*object.outward_mm)[i])) return local * scan.points_mm[i];
        return local * scan.points_mm[i] + static_cast<double>((*object.outward_mm)[i]) * outward(object, axis, i);
    };
    full_.data->SetPoints(upload(scan.points_mm.size(), place));
    if (scan.isMesh() && scan.hasNormals() && !displaced) setNormals(full_.data, scan, object.scene_T_scan);
    if (!scan.isMesh()) setVertices(full_.data, scan.points_mm.size());
    prepare(full_, 2);
    if (scan.isMesh()) {
        unknown_.data->SetPoints(full_.data->GetPoints());
        unknown_.data->GetPointData()->SetNormals(full_.data->GetPointData()->GetNormals());
        prepare(unknown_, 2);
        unknown_.mapper->ScalarVisibilityOff();
        const double grey = noValue.red / 255.0;
        unknown_.actor->GetProperty()->SetColor(grey, grey, grey);
    }

    thinned_ = scan.isMesh() ? scan.triangles.size() > mostTrianglesMoving : scan.points_mm.size() > 20000;
    if (!thinned_) return;
    order_ = thinnedOrder(scan.points_mm.size(), mostThinned);
    thin_.data->SetPoints(upload(order_.size(), [&](std::size_t i) { return place(order_[i]); }));
    prepare(thin_, 3);
}

SceneActor::~SceneActor()
{
    renderer_->RemoveActor(full_.actor);
    renderer_->RemoveActor(thin_.actor);
    renderer_->RemoveActor(unknown_.actor);
}

void SceneActor::prepare(Layer& layer, double pointSize)
{
    layer.colours->SetNumberOfComponents(3);
    layer.colours->SetNumberOfTuples(layer.data->GetNumberOfPoints());
    layer.data->GetPointData()->SetScalars(layer.colours);
    layer.mapper->SetInputData(layer.data);
    layer.mapper->SetColorModeToDirectScalars();
    layer.mapper->StaticOn();
    layer.actor->SetMapper(layer.mapper);
    layer.actor->GetProperty()->SetPointSize(static_cast<float>(pointSize));
    if (!object_.scan->isMesh()) layer.actor->GetProperty()->LightingOff();
    layer.actor->GetProperty()->SetAmbient(0.45);
    layer.actor->GetProperty()->SetDiffuse(0.6);
    layer.actor->VisibilityOff();
    renderer_->AddActor(layer.actor);
}

bool SceneActor::sameGeometry(const SceneObject& other) const
{
    return other.scan == object_.scan && other.scene_T_scan.matrix() == object_.scene_T_scan.matrix() &&
           other.outward_mm == object_.outward_mm && other.along_axis == object_.along_axis;
}

void SceneActor::update(const SceneObject& object, const report::DeviationColours& colours,
                        const std::optional<SceneAxis>& axis)
{
    object_ = object;
    const Scan& scan = *object.scan;
    const std::size_t count = scan.points_mm.size();
    const bool valued = object.values && object.values->size() == count;
    unsigned char* out = full_.colours->GetPointer(0);
    const auto store = [&](std::size_t i, report::Rgb c) {
        out[3 * i] = c.red;
        out[3 * i + 1] = c.green;
        out[3 * i + 2] = c.blue;
    };
    // Clouds are not lit by VTK: they are shaded here by their normals, with values only slightly, so that the legend's
    // colours are preserved.
    const auto brightness = [&](std::size_t i) {
        if (scan.isMesh()) return 1.0;
        const double facing = shade(outward(object, axis, i));
        return valued ? 0.9 + 0.1 * facing : 0.72 + 0.28 * facing;
    };
    const auto shaded = [&](report::Rgb c, double b) {
        const auto part = [&](int v) { return static_cast<std::uint8_t>(std::clamp(std::lround(b * v), 0L, 255L)); };
        return report::Rgb{part(c.red), part(c.green), part(c.blue)};
    };
    const report::Rgb plain{static_cast<std::uint8_t>(object.colour.red()),
                            static_cast<std::uint8_t>(object.colour.green()),
                            static_cast<std::uint8_t>(object.colour.blue())};
    // A table spares evaluating the colour rule (powers and roots) a million times.
    constexpr int steps = 4096;
    const double least = colours.least(), range = colours.limit - least;
    std::vector<report::Rgb> table(steps + 1);
    for (int i = 0; i <= steps; ++i) table[static_cast<std::size_t>(i)] = colours(least + range * i / steps);
    // Of a valued mesh only the points that stand for it while it moves need colours of their own.
    const std::size_t coloured = scan.isMesh() && valued && !thinned_ ? 0 : count;
    parallelFor(coloured, grain, {}, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            report::Rgb c = plain;
            if (valued) {
                const double value = static_cast<double>((*object.values)[i]);
                const double at = std::clamp((value - least) / range, 0.0, 1.0);
                c = std::isnan(value) ? noValue : table[static_cast<std::size_t>(std::lround(at * steps))];
            }
            store(i, shaded(c, brightness(i)));
        }
    });
    full_.colours->Modified();
    if (thinned_) {
        unsigned char* thin = thin_.colours->GetPointer(0);
        for (std::size_t i = 0; i < order_.size(); ++i)
            std::copy(out + 3 * std::size_t{order_[i]}, out + 3 * std::size_t{order_[i]} + 3, thin + 3 * i);
        thin_.colours->Modified();
    }
    if (scan.isMesh()) colourBetweenCorners(valued ? std::optional(colours) : std::nullopt);
    full_.data->Modified();
    thin_.data->Modified();
    show();
}

/// The steps of the scale end where the value does, between the corners too. None: the plain colour.
void SceneActor::colourBetweenCorners(const std::optional<report::DeviationColours>& colours)
{
    if (!colours) {
        split_for_.reset();
        setTriangles(full_.data, object_.scan->triangles);
        setTriangles(unknown_.data, {});
        full_.data->GetPointData()->SetScalars(full_.colours);
        full_.mapper->SetColorModeToDirectScalars();
        full_.mapper->InterpolateScalarsBeforeMappingOff();
        return;
    }
    constexpr int steps = 2048;
    const double least = colours->least(), range = colours->limit - least;
    scale_->SetNumberOfTableValues(steps);
    scale_->SetTableRange(least, colours->limit);
    const auto share = [](int part) { return part / 255.0; };
    for (int i = 0; i < steps; ++i) {
        const report::Rgb c = (*colours)(least + range * (i + 0.5) / steps);
        scale_->SetTableValue(i, share(c.red), share(c.green), share(c.blue));
    }
    if (split_for_ == object_.values) return;  // another scale of the same values
    split_for_ = object_.values;
    const std::vector<float>& values = *object_.values;
    values_->SetNumberOfTuples(static_cast<vtkIdType>(values.size()));
    std::copy(values.begin(), values.end(), values_->GetPointer(0));
    values_->Modified();
    // Colours between a known and an unknown corner would be those of neither.
    std::vector<std::array<std::uint32_t, 3>> known, unknown;
    known.reserve(object_.scan->triangles.size());
    for (const auto& corners : object_.scan->triangles) {
        const bool is_known = std::none_of(corners.begin(), corners.end(),
                                           [&values](std::uint32_t corner) { return std::isnan(values[corner]); });
        (is_known ? known : unknown).push_back(corners);
    }
    setTriangles(full_.data, known);
    setTriangles(unknown_.data, unknown);
    full_.data->GetPointData()->SetScalars(values_);
    full_.mapper->SetLookupTable(scale_);
    full_.mapper->UseLookupTableScalarRangeOn();
    full_.mapper->SetColorModeToMapScalars();
    full_.mapper->InterpolateScalarsBeforeMappingOn();
}

void SceneActor::setMoving(bool moving)
{
    moving_ = moving;
    show();
}

void SceneActor::setBudget(std::size_t points)
{
    if (thinned_) setVertices(thin_.data, std::min(points, order_.size()));
}

void SceneActor::show()
{
    const bool thin = moving_ && thinned_;
    full_.actor->SetVisibility(object_.visible && !thin);
    unknown_.actor->SetVisibility(object_.visible && !thin && object_.scan->isMesh());
    thin_.actor->SetVisibility(object_.visible && thin);
}

void SceneActor::setSection(vtkPlane* plane)
{
    for (Layer* layer : {&full_, &thin_, &unknown_}) {
        layer->mapper->RemoveAllClippingPlanes();
        if (plane) layer->mapper->AddClippingPlane(plane);
    }
}

}  // namespace lathelier::scene
