// Points on the round surface through the vertices of a mesh.
//
// The triangles of a mesh cut the corners of a round surface by the sagitta of their chords. Its vertices lie on the
// measured or designed surface. Between them a point is interpolated in cylindrical coordinates about the axis of the
// part: points of a cylinder or a cone then lie on it exactly. Planes across the axis, and triangles that span more of
// the circle than the others (flats, floors of keyways), keep their points.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "engine/core/progress.h"
#include "engine/core/scan.h"
#include "engine/registration/revolution/revolution_axis.h"
#include "engine/registration/surface/surface_samples.h"

namespace lathelier::features {

/// The places of the samples on the flat triangles.
std::vector<Eigen::Vector3d> flatPoints(const Scan& mesh, const std::vector<registration::SurfaceSample>& samples,
                                        const Progress& progress = {});

/// The places of the samples on the round surface about the axis of `fit`, and the 90 % quantile of the facets'
/// sagitta. Below a sagitta of 0.5 µm `points` is empty: use the flat ones.
struct RoundedPoints {
    std::vector<Eigen::Vector3d> points;
    double sagitta_mm = 0;
};
RoundedPoints roundedPoints(const Scan& mesh, const std::vector<registration::SurfaceSample>& samples,
                            const registration::RevolutionFit& fit, const Progress& progress = {});

}  // namespace lathelier::features
