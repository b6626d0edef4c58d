// The meridian as a model: runs of lines and arcs between planes across the axis, with exact junctions.
//
// Junctions: line and line meet in their intersection; a line and an arc that is tied to it in the foot of the
// perpendicular from the arc's centre, else in the nearer intersection; anything ends at a plane where the plane is.
// An arc has a centre and a radius less one parameter for each tie: tangent to the neighbouring line, or touching the
// neighbouring plane (the centre lies one radius from it), or a centre on the axis (the run ends at the pole). The
// value that a wall is compared with is the mean of the meridian over the spot of the scanner and the spread of the
// wall's points in z (3 × 3 Gauss points).
#pragma once

#include <cstddef>
#include <vector>

#include "engine/features/walls/walls.h"

namespace lathelier::features {

/// Axis: the centre lies on the axis, and the run ends at the arc's pole.
enum class Tie { Free, Tangent, Plane, Axis };

struct Element {
    bool arc = false;                           ///< an arc, else a line
    bool cylinder = false;                      ///< a line whose slope stays 0
    double level_mm = 0, slope = 0, at_mm = 0;  ///< line: r = level + slope·(z - at); `at` stays
    bool flat = false;  ///< arc of a radius far beyond its length: given by level and slope at `at` in place of its
                        ///< centre, which the radius would move by as much
    double centre_z_mm = 0, centre_r_mm = 0,
           log_radius = 0;                   ///< arc; values determined by its ties follow from the neighbours
    bool convex = false;                     ///< arc: material bulges, r = r_c + √…; else r = r_c - √…
    Tie start = Tie::Free, end = Tie::Free;  ///< of an arc
    bool rough = false;                      ///< a thread or knurl: a cylinder that no selection changes
    double root_mm = 0;                      ///< of a rough one: radius that nearly all of its points lie above
    double level_sigma_mm = 0;               ///< of a rough one: standard uncertainty of the radius of its crests

    double radius_mm() const;
    double radiusAt_mm(double z_mm) const;
    double slopeAt(double z_mm) const;
};

/// Is it part of a ball, with its centre on the axis?
bool isOnAxis(const Element& arc);

/// A plane across the axis, or the limit of the data.
struct Plane {
    double z_mm = 0;                   ///< along the axis
    double seen_mm = 0, sigma_mm = 1;  ///< where it was observed: one datum of the fit
    bool data_end = false;             ///< no face: the data end here
    bool pole = false;                 ///< no face: an arc with Tie::Axis ends here and places it
    double lean = 0;        ///< distance within which the lower wall does not count, since inclined rays miss it there
    int low_side = 0;       ///< of a shoulder: the lower wall lies before it, -1, or behind it, 1; else 0
    bool is_clear = false;  ///< of a shoulder: high enough that no wall mixes points of both sides
};

/// Elements from one plane to another.
struct Run {
    std::size_t left = 0, right = 0;  ///< indices of planes
    std::vector<Element> elements;    ///< in order of z
    std::vector<double> nodes_mm;     ///< z of the junctions: one more than elements
    double violation = 0;             ///< squared penalties of junctions that do not exist or are out of order
    std::vector<Wall> walls;          ///< data of the run, in order of z
};

struct Model {
    std::vector<Plane> planes;  ///< in order of z
    std::vector<Run> runs;      ///< in order of z
    double spot_mm = 0;         ///< width of the blur of an edge
    double sigma_mm = 0.01;     ///< noise of single points
    double edge_mm = 0.04;      ///< besides half the spot, walls nearer to a plane do not count
    double corner_mm = 0;       ///< nor those nearer to a sharp corner: scans that see no point near edges
};

/// Computes centres of tied arcs and all nodes of the run. Penalties go into `violation`.
void resolve(const Model& model, Run& run);

/// Frees ties of arcs that have no partner: no line, or no plane beside them.
void releaseLostTies(Run& run);

/// Radius of the run at z, of the element that holds there.
double radiusAt_mm(const Run& run, double z_mm);

/// The mean that the wall is compared with; beside a clear shoulder the spot ends there, since points beyond belong to
/// the other wall. Precondition: resolve().
double predicted_mm(const Model& model, const Run& run, const Wall& wall);

/// Does the wall count: is it far enough from planes and, with `corner_mm`, from corners? Beside a clear shoulder: all
/// of it on its own side.
bool counts(const Model& model, const Run& run, const Wall& wall);

/// Standard uncertainty of the wall's radius.
double sigmaOf(const Model& model, const Wall& wall);

/// Radius at the run's start and end, at its planes.
double startRadius_mm(const Run& run);
double endRadius_mm(const Run& run);

}  // namespace lathelier::features
