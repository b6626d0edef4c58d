#include "engine/cad/step_reader.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/cad/cad_codes.h"
#include "engine/cad/canonical_surface.h"
#include "engine/cad/meridian_shaft.h"
#include "engine/cad/part21.h"
#include "engine/cad/step_faces.h"
#include "engine/cad/step_meridian.h"
#include "engine/core/utf8.h"
#include "engine/registration/registration_codes.h"
#include "engine/shaft/shaft_codes.h"
#include "engine/shaft/shaft_rules.h"

namespace lathelier::cad {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double plainVolume = 1e-6;    ///< |V_solid / V_table - 1| below this: a pure body of revolution
constexpr double inexactVolume = 1e-4;  ///< the same limit for files with coarse tolerances
constexpr double leastVolume = 0.9;     ///< smallest V_solid / V_table
constexpr double beyondPart_mm = 1e-3;  ///< tolerance beyond the largest circle
constexpr std::size_t worstFaces = 4;   ///< largest number of faces named in an error

const Text notRound = LT_TEXT("Engine", "its sections are not round");
const Text noSingleAxis = LT_TEXT("Engine", "no single axis fits");
const Text freeForm = LT_TEXT("Engine",
                              "its faces are free-form surfaces that are exactly no plane, cylinder, cone, sphere or "
                              "torus");
const Text faceted = LT_TEXT("Engine", "all its faces are planes");

Text nameOf(SurfaceKind kind)
{
    switch (kind) {
        case SurfaceKind::Plane: return LT_TEXT("Engine", "plane");
        case SurfaceKind::Cylinder: return LT_TEXT("Engine", "cylinder");
        case SurfaceKind::Cone: return LT_TEXT("Engine", "cone");
        case SurfaceKind::Torus: return LT_TEXT("Engine", "torus");
        case SurfaceKind::Sphere: return LT_TEXT("Engine", "sphere");
        case SurfaceKind::RevolvedLine:
        case SurfaceKind::RevolvedArc: return LT_TEXT("Engine", "surface of revolution");
        case SurfaceKind::Other: return LT_TEXT("Engine", "free-form surface");
    }
    return {};
}

struct Range {
    double low = std::numeric_limits<double>::infinity(), high = -std::numeric_limits<double>::infinity();
    void add(double value)
    {
        low = std::min(low, value);
        high = std::max(high, value);
    }
};

/// Range of the boundary of a face in z and r.
struct Extent {
    Range z, r;
};

Extent extentOf(const StepFace& face, const Line3& axis)
{
    Extent extent;
    const auto add = [&](const Vector3d& point) {
        const Vector2d zr = axis.meridianOf(point);
        extent.z.add(zr.x());
        extent.r.add(zr.y());
    };
    for (const Vector3d& vertex : face.vertices_mm) add(vertex);
    for (const auto& edge : face.edges_mm)
        for (const Vector3d& point : edge) add(point);
    if (extent.z.low > extent.z.high) add(face.inner_mm);
    return extent;
}

/// Through the middle of the part along its longest side, for the description of a part without an axis.
Line3 longestSide(const std::vector<StepFace>& faces)
{
    Vector3d low = Vector3d::Constant(std::numeric_limits<double>::infinity()), high = -low;
    for (const StepFace& face : faces)
        for (const Vector3d& vertex : face.vertices_mm) {
            low = low.cwiseMin(vertex);
            high = high.cwiseMax(vertex);
        }
    if (!low.allFinite() || !high.allFinite()) return {};
    Eigen::Index longest = 0;
    (high - low).maxCoeff(&longest);
    return {(low + high) / 2, Vector3d::Unit(longest)};
}

/// The largest first.
std::vector<OtherFace> describeFaces(const StepSolid& solid, const std::vector<std::size_t>& which, const Line3& axis,
                                     double free_end_mm)
{
    std::vector<OtherFace> result;
    for (const std::size_t i : which) {
        const Extent extent = extentOf(solid.faces[i], axis);
        result.push_back({nameOf(solid.faces[i].kind), solid.faces[i].area_mm2, extent.z.low - free_end_mm,
                          extent.z.high - free_end_mm});
    }
    std::stable_sort(result.begin(), result.end(),
                     [](const OtherFace& a, const OtherFace& b) { return a.area_mm2 > b.area_mm2; });
    return result;
}

[[noreturn]] void refusePart(const StepSolid& solid, const std::vector<std::size_t>& which, const Line3& axis,
                             const char* reason, Text why)
{
    double residual_mm = 0;
    for (const std::size_t i : which) {
        const Extent extent = extentOf(solid.faces[i], axis);
        residual_mm = std::max(residual_mm, extent.r.high - extent.r.low);
    }
    Rows faces;
    for (const OtherFace& face : describeFaces(solid, which, axis, 0)) {
        if (faces.rows.size() == worstFaces) break;
        faces.rows.push_back({{{"kind", face.kind}, {"area_mm2", face.area_mm2}}});
    }
    throw Error(errors::notABodyOfRevolution, {{"role", std::string("part")},
                                               {"reason", std::string(reason)},
                                               {"why", why},
                                               {"residual_mm", residual_mm},
                                               {"faces", faces}});
}

/// Splines that are exactly simpler surfaces become these.
void recogniseSplines(std::vector<StepFace>& faces)
{
    for (StepFace& face : faces) {
        if (face.kind != SurfaceKind::Other) continue;
        const auto found = canonicalSurface(face.spots, face.inner_mm);
        if (!found) continue;
        face.kind = found->kind;
        face.axis_point_mm = found->axis_point_mm;
        face.axis = found->axis;
        face.radius_mm = found->radius_mm;
        face.circle_centre_mm = found->circle_centre_mm;
    }
}

/// Whether most of the surface that is not plane is free-form.
bool isFreeForm(const std::vector<StepFace>& faces)
{
    double free_mm2 = 0, curved_mm2 = 0;
    for (const StepFace& face : faces) {
        if (face.kind != SurfaceKind::Plane) curved_mm2 += face.area_mm2;
        if (face.kind == SurfaceKind::Other) free_mm2 += face.area_mm2;
    }
    return 2 * free_mm2 > curved_mm2;
}

std::vector<std::size_t> everyFace(const StepSolid& solid)
{
    std::vector<std::size_t> all(solid.faces.size());
    for (std::size_t i = 0; i < all.size(); ++i) all[i] = i;
    return all;
}

/// Adds marks for faces that are not of revolution, merging those that overlap along z.
void addMarks(Shaft& shaft, std::vector<OtherFace> faces)
{
    std::sort(faces.begin(), faces.end(),
              [](const OtherFace& a, const OtherFace& b) { return a.z_start_mm < b.z_start_mm; });
    for (const OtherFace& face : faces) {
        if (!shaft.marks.empty() && face.z_start_mm <= *shaft.marks.back().z_end_mm) {
            double& end = *shaft.marks.back().z_end_mm;
            end = std::max(end, face.z_end_mm);
            continue;
        }
        ShaftMark mark{MarkKind::FreeForm};
        mark.z_start_mm = face.z_start_mm;
        mark.z_end_mm = face.z_end_mm;
        shaft.marks.push_back(mark);
    }
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
    recogniseSplines(solid.faces);

    if (std::all_of(solid.faces.begin(), solid.faces.end(),
                    [](const StepFace& face) { return face.kind == SurfaceKind::Plane; }))
        refusePart(solid, everyFace(solid), longestSide(solid.faces), "faceted", faceted);
    const std::optional<Line3> axis = commonAxis(solid.faces);
    if (!axis && isFreeForm(solid.faces))
        refusePart(solid, everyFace(solid), longestSide(solid.faces), "free_form", freeForm);
    if (!axis) refusePart(solid, everyFace(solid), longestSide(solid.faces), "no_single_axis", noSingleAxis);

    const Meridian meridian = meridianOf(solid.faces, *axis, progress);
    StepPart part;
    part.shaft = shaftOf(meridian.closed);
    part.shaft.name = decoded(solid.product);
    part.volume_mm3 = solid.volume_mm3;
    part.axis = axis->direction;
    Range z;
    double largest_mm = 0, curved_mm2 = 0, coaxial_mm2 = 0, total_mm2 = 0, other_mm2 = 0;
    for (const ContourPiece& piece : meridian.closed)
        for (const Vector2d& end : {piece.from_mm, piece.to_mm}) z.add(end.x());
    // The largest circle may be within an arc.
    for (const ContourPiece& piece : meridian.closed) {
        largest_mm = std::max({largest_mm, piece.from_mm.y(), piece.to_mm.y()});
        if (piece.isArc()) largest_mm = std::max(largest_mm, piece.centre_mm().y() + std::abs(piece.arc_radius_mm));
    }
    std::vector<bool> is_other(solid.faces.size());
    for (const std::size_t i : meridian.other_faces) is_other[i] = true;
    bool fills = true;  // no part of the solid lies beyond the turned body
    for (std::size_t i = 0; i < solid.faces.size(); ++i) {
        const StepFace& face = solid.faces[i];
        const Extent extent = extentOf(face, *axis);
        fills = fills && extent.r.high <= largest_mm + beyondPart_mm && extent.z.low >= z.low - beyondPart_mm &&
                extent.z.high <= z.high + beyondPart_mm;
        total_mm2 += face.area_mm2;
        if (is_other[i]) other_mm2 += face.area_mm2;
        if (face.kind == SurfaceKind::Plane) continue;
        curved_mm2 += face.area_mm2;
        if (!is_other[i]) coaxial_mm2 += face.area_mm2;
    }
    const auto refuseIt = [&] {
        const bool turned = coaxial_mm2 >= curved_mm2 / 2;
        const auto& worst = meridian.other_faces;
        refusePart(solid, worst.empty() ? everyFace(solid) : worst, *axis, turned ? "not_round" : "no_single_axis",
                   turned ? notRound : noSingleAxis);
    };
    if (!fills || part.shaft.segments.empty()) refuseIt();
    Notes remarks;
    double ratio = 0;
    try {
        remarks = checkShaft(part.shaft);
        ratio = part.volume_mm3 / volume_mm3(part.shaft);
    } catch (const Error&) {
        refuseIt();  // a contour that the table of a shaft cannot represent
    }
    if (!(ratio >= leastVolume && ratio <= 1 + plainVolume)) refuseIt();
    // No face explains the difference of the volumes: the file is inconsistent.
    if (meridian.other_faces.empty() && std::abs(ratio - 1) > inexactVolume) refuseIt();
    part.free_end_mm = axis->point_mm + z.low * axis->direction;
    part.other_faces = describeFaces(solid, meridian.other_faces, *axis, z.low);
    if (!part.other_faces.empty() || std::abs(ratio - 1) > plainVolume) {
        notes.push_back({notes::notOfRevolution,
                         {{"count", static_cast<std::int64_t>(part.other_faces.size())},
                          {"area_mm2", other_mm2},
                          {"total_mm2", total_mm2},
                          {"volume_percent", 100 * ratio}}});
        addMarks(part.shaft, part.other_faces);
    }
    notes.insert(notes.end(), remarks.begin(), remarks.end());
    progress.report(1);
    return part;
}

}  // namespace lathelier::cad
