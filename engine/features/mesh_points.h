// Points of a mesh that stand for the surface its corners lie on.
//
// The triangles of a mesh cut the corners of a round surface by the sagitta of their chords. Its vertices are what was
// measured or designed. Between them a point is interpolated in cylindrical coordinates about the axis of the part:
// what is on a cylinder or a cone then lies on it exactly. Planes across the axis, and triangles that span more of the
// circle than the others (flats, floors of keyways), keep their points.
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

/// The places of the samples on the round surface about the axis of `fit`, and how far nine tenths of the facets lie
/// inside it at most. Below a sagitta of 0.5 µm `points` are empty: the flat ones do.
struct RoundedPoints {
    std::vector<Eigen::Vector3d> points;
    double sagitta_mm = 0;
};
RoundedPoints roundedPoints(const Scan& mesh, const std::vector<registration::SurfaceSample>& samples,
                            const registration::RevolutionFit& fit, const Progress& progress = {});

}  // namespace lathelier::features
