#include "engine/cad/step_reader.h"

#include <algorithm>
#include <cmath>

#include "engine/cad/cad_codes.h"
#include "engine/cad/canonical_surface.h"
#include "engine/cad/meridian_shaft.h"
#include "engine/cad/part21.h"
#include "engine/cad/step/face_shape.h"
#include "engine/cad/step/hole_marks.h"
#include "engine/cad/step/step_marks.h"
#include "engine/cad/step/step_refusal.h"
#include "engine/cad/step_faces.h"
#include "engine/cad/step_meridian.h"
#include "engine/core/utf8.h"
#include "engine/shaft/contour_distance.h"
#include "engine/shaft/shaft_contour.h"
#include "engine/shaft/shaft_rules.h"

namespace lathelier::cad {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

/// When a table is the part that the solid is.
struct Acceptance {
    double plain_volume = 1e-6;    ///< |V_solid / V_table - 1| below this: a pure body of revolution
    double inexact_volume = 1e-4;  ///< the same limit for files with coarse tolerances
    double spline_volume = 1e-5;   ///< the same limit for splines: the kernel's integral over them is no better
    double least_volume = 0.9;     ///< smallest V_solid / V_table where faces of free form cut the part
    double least_named = 0.6;      ///< the same where every face is named: a square has 0.637 of its circle
    double cut_volume = 0.03;      ///< of the volume cut, by which that of the named cuts may differ: rounds of edges
    double beyond_mm = 1e-3;       ///< tolerance of points beyond the turned body
};

constexpr Acceptance accepted;

/// Splines that are exactly simpler surfaces become these. True if there are splines.
bool recogniseSplines(std::vector<StepFace>& faces)
{
    bool has_spline = false;
    for (StepFace& face : faces) {
        has_spline |= face.kind == SurfaceKind::Other;
        if (face.kind != SurfaceKind::Other) continue;
        const auto found = canonicalSurface(face.spots, face.inner_mm);
        if (!found) continue;
        face.kind = found->kind;
        face.axis_point_mm = found->axis_point_mm;
        face.axis = found->axis;
        face.radius_mm = found->radius_mm;
        face.circle_centre_mm = found->circle_centre_mm;
    }
    return has_spline;
}

/// UTF-8 of a text as ISO 10303-21 writes it, as far as the kernel has not decoded it.
std::string decoded(const std::string& text)
{
    std::string result;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t width = text.compare(at, 4, "\\X2\\") == 0 ? 4 : text.compare(at, 4, "\\X4\\") == 0 ? 8 : 0;
        const std::size_t end = width == 0 ? std::string::npos : text.find("\\X0\\", at);
        if (end == std::string::npos) {
            const Utf8Character character = utf8At(text, at);
            result += character.length == 0 ? "?" : text.substr(at, character.length);
            at += std::max<std::size_t>(1, character.length);
            continue;
        }
        for (at += 4; at + width <= end; at += width) {
            char32_t code = 0;
            for (const char c : text.substr(at, width))
                code = code * 16 + static_cast<char32_t>(c >= 'A' && c <= 'F'   ? c - 'A' + 10
                                                         : c >= '0' && c <= '9' ? c - '0'
                                                                                : 0);
            if (code >= 0x20 && code <= 0x10FFFF && !(code >= 0xD800 && code <= 0xDFFF)) appendUtf8(result, code);
        }
        at = end + 4;
    }
    return result;
}

/// Before the kernel builds anything: checks that there is a solid of limited size.
void checkKinds(const Part21& checked)
{
    const auto count = [&](const char* kind) {
        const auto found = checked.count_of_kind.find(kind);
        return found == checked.count_of_kind.end() ? std::int64_t{0} : found->second;
    };
    if (count("MANIFOLD_SOLID_BREP") + count("BREP_WITH_VOIDS") + count("FACETED_BREP") == 0)
        throw Error(errors::noSolid, {});
    const std::int64_t faces = count("ADVANCED_FACE") + count("FACE_SURFACE") + count("FACE");
    if (faces > mostStepFaces)
        throw Error(errors::stepTooLarge,
                    {{"found", faces}, {"items", std::string("faces")}, {"maximum", mostStepFaces}});
}

/// A table with the frame of its axis.
struct Turned {
    Line3 axis;
    Meridian meridian;
    Shaft shaft;
    double free_end_mm = 0;  ///< along the axis
};

Turned turnedOf(const StepSolid& solid, const Line3& axis, const Progress& progress)
{
    Turned turned{axis, meridianOf(solid.faces, axis, progress), {}, 0};
    turned.shaft = shaftOf(turned.meridian.closed);
    bool first = true;
    for (const ContourPiece& piece : turned.meridian.closed)
        for (const double z : {piece.from_mm.x(), piece.to_mm.x()}) {
            turned.free_end_mm = first ? z : std::min(turned.free_end_mm, z);
            first = false;
        }
    return turned;
}

/// Does no part of the solid lie beyond the turned body?
bool isWithin(const StepSolid& solid, const Turned& turned, const Progress& progress)
{
    const ContourDistance surface(closedContour(turned.shaft), 1e3 * accepted.beyond_mm);
    const double length = turned.shaft.length_mm();
    double largest_mm = 0;
    for (const ContourPiece& piece : turned.meridian.closed) {
        largest_mm = std::max({largest_mm, piece.from_mm.y(), piece.to_mm.y()});
        // The largest circle may be within an arc.
        if (piece.isArc()) largest_mm = std::max(largest_mm, piece.centre_mm().y() + std::abs(piece.arc_radius_mm));
    }
    const auto isIn = [&](const Vector3d& point) {
        const Vector2d zr = turned.axis.meridianOf(point);
        const double z = zr.x() - turned.free_end_mm;
        if (z < -accepted.beyond_mm || z > length + accepted.beyond_mm || zr.y() > largest_mm + accepted.beyond_mm)
            return false;
        const auto foot = surface.footOf(z, zr.y());
        return foot ? foot->distance_mm < accepted.beyond_mm
                    : zr.y() < outerRadius_mm(turned.shaft, z) + accepted.beyond_mm;
    };
    for (const StepFace& face : solid.faces) {
        progress.check();
        if (!std::all_of(face.vertices_mm.begin(), face.vertices_mm.end(), isIn)) return false;
        for (const auto& edge : face.edges_mm)
            if (!std::all_of(edge.begin(), edge.end(), isIn)) return false;
    }
    return true;
}

/// Is every stretch of the outside that no face shows the round of a hexagon or a square?
bool areGapsNamed(const Turned& turned, const std::vector<ShaftMark>& marks)
{
    return std::all_of(turned.meridian.gaps.begin(), turned.meridian.gaps.end(), [&](const ContourPiece& gap) {
        const double start = gap.from_mm.x() - turned.free_end_mm, end = gap.to_mm.x() - turned.free_end_mm;
        return std::abs(gap.from_mm.y() - gap.to_mm.y()) < accepted.beyond_mm && isPrism(marks, start, end);
    });
}

/// Marks of the spherical ends.
void addSpheres(Shaft& shaft)
{
    double z_mm = 0;
    for (std::size_t i = 0; i < shaft.segments.size(); ++i) {
        const ShaftSegment& row = shaft.segments[i];
        const double start = z_mm;
        z_mm += row.length_mm;
        const bool is_end = (i == 0 && row.start_diameter_mm < samePlace_mm) ||
                            (i + 1 == shaft.segments.size() && row.end_diameter_mm < samePlace_mm);
        if (!is_end || row.arc_radius_mm.value_or(0) <= 0) continue;
        const ContourPiece arc{{start, row.start_diameter_mm / 2}, {z_mm, row.end_diameter_mm / 2}, *row.arc_radius_mm};
        if (std::abs(arc.centre_mm().y()) > samePlace_mm) continue;
        ShaftMark mark{MarkKind::Sphere, start, z_mm};
        mark.diameter_mm = 2 * *row.arc_radius_mm;
        shaft.marks.push_back(mark);
    }
}

/// Adds the marks of the faces that cut the turned body. False: they do not explain the solid.
bool addMarks(StepPart& part, const StepSolid& solid, const Turned& turned, const Progress& progress)
{
    const double table_mm3 = volume_mm3(part.shaft), ratio = part.volume_mm3 / table_mm3;
    if (!(ratio >= accepted.least_named && ratio <= 1 + accepted.plain_volume)) return false;
    MarkedCuts found = marksOf(solid.faces, turned.meridian.other_faces, frameOf(turned.axis, turned.free_end_mm),
                               part.shaft, progress);
    if (!areGapsNamed(turned, found.marks)) return false;
    part.cut_mm3 = table_mm3 - part.volume_mm3;
    part.named_mm3 = cutVolume_mm3(found.cuts, part.shaft, progress);
    const double tolerance = accepted.cut_volume * part.cut_mm3 + accepted.plain_volume * table_mm3;
    const bool complete = found.unnamed.empty() && !found.has_spline;
    const bool consistent =
        part.named_mm3 <= part.cut_mm3 + tolerance && (!complete || part.named_mm3 >= part.cut_mm3 - tolerance);
    // Marks that cut another volume than the solid lacks are no explanation.
    if (!consistent && !turned.meridian.gaps.empty()) return false;
    if (!consistent)
        found =
            freeForms(solid.faces, turned.meridian.other_faces, frameOf(turned.axis, turned.free_end_mm), part.shaft);
    if (!found.unnamed.empty() && ratio < accepted.least_volume) return false;
    part.shaft.marks = std::move(found.marks);
    return true;
}

void noteOthers(const StepPart& part, const StepSolid& solid, Notes& notes)
{
    double other_mm2 = 0, total_mm2 = 0;
    for (const StepFace& face : solid.faces) total_mm2 += face.area_mm2;
    for (const OtherFace& face : part.other_faces) other_mm2 += face.area_mm2;
    notes.push_back({notes::notOfRevolution,
                     {{"count", static_cast<std::int64_t>(part.other_faces.size())},
                      {"area_mm2", other_mm2},
                      {"total_mm2", total_mm2},
                      {"volume_percent", 100 * part.volume_mm3 / volume_mm3(part.shaft)}}});
}

}  // namespace

bool looksLikeStep(std::string_view head)
{
    if (head.substr(0, 3) == "\xEF\xBB\xBF") head.remove_prefix(3);
    const std::size_t first = head.find_first_not_of(" \t\r\n");
    return first != std::string_view::npos && head.substr(first).starts_with("ISO-10303-21");
}

StepPart readStep(std::string_view bytes, Notes& notes, const Progress& progress)
{
    const Part21 checked = checkPart21(bytes, progress.part(0, 0.1));
    checkKinds(checked);
    StepSolid solid = readStepFaces(bytes, checked, progress.part(0.1, 0.9));
    const bool has_spline = recogniseSplines(solid.faces);
    refusePlanes(solid);
    const std::optional<Line3> axis = commonAxis(solid.faces);
    if (!axis) refuseWithoutAxis(solid);

    const Turned turned = turnedOf(solid, *axis, progress);
    const std::vector<std::size_t>& others = turned.meridian.other_faces;
    StepPart part;
    part.shaft = turned.shaft;
    part.shaft.name = decoded(solid.product);
    part.volume_mm3 = solid.volume_mm3;
    part.axis = axis->direction;
    part.free_end_mm = axis->point_mm + turned.free_end_mm * axis->direction;
    part.other_faces = describeFaces(solid, others, *axis, turned.free_end_mm);
    if (part.shaft.segments.empty()) refuseSolid(solid, turned.meridian, *axis);
    Notes remarks;
    double difference = 0;
    bool is_part = false;
    try {
        remarks = checkShaft(part.shaft);
        difference = std::abs(part.volume_mm3 / volume_mm3(part.shaft) - 1);
        is_part = isWithin(solid, turned, progress);
    } catch (const Error&) {
        refuseSolid(solid, turned.meridian, *axis);  // a contour that the table of a shaft cannot represent
    }
    // No face explains a difference of the volumes: the file is inconsistent.
    if (others.empty())
        is_part = is_part && turned.meridian.gaps.empty() && difference <= accepted.inexact_volume;
    else
        is_part = is_part && addMarks(part, solid, turned, progress);
    // All its splines are exactly turned surfaces, so that the table is the exact solid.
    if (is_part && others.empty() && has_spline && difference <= accepted.spline_volume) {
        part.volume_mm3 = volume_mm3(part.shaft);
        difference = 0;
    }
    if (!is_part) refuseSolid(solid, turned.meridian, *axis);
    if (!others.empty() || !(difference <= accepted.plain_volume)) noteOthers(part, solid, notes);
    addSpheres(part.shaft);
    notes.insert(notes.end(), remarks.begin(), remarks.end());
    progress.report(1);
    return part;
}

}  // namespace lathelier::cad
