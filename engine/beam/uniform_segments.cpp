#include "engine/beam/uniform_segments.h"

#include <algorithm>
#include <cmath>

#include "engine/beam/beam_codes.h"
#include "engine/beam/segment_contour.h"
#include "engine/shaft/shaft_codes.h"

namespace lathelier::beam {
namespace {

constexpr int slicesOfCone = 16;             // slices of the 45° zone beside a step
constexpr int fewestPieces = 4;              // least number of pieces of a taper or arc
constexpr double fullTaper = 0.1;            // relative change of diameter from which all pieces are used
constexpr double shortestPieceShare = 0.01;  // least piece length as share of the diameter

/// A uniform piece with the radii of the contour at its ends: which define the steps.
struct Piece {
    double length_mm;        ///< > 0
    double outer_mm;         ///< diameter at its middle
    double bore_mm;          ///< bore diameter
    double start_radius_mm;  ///< of the contour, toward the free end
    double end_radius_mm;    ///< of the contour, toward the chuck
};

[[noreturn]] void reject(std::size_t index, Text quantity, double found_mm, Text expected)
{
    throw Error(errors::shaftSegmentUnusable, {{"segment", static_cast<std::int64_t>(index) + 1},
                                               {"quantity", quantity},
                                               {"found_mm", found_mm},
                                               {"expected", expected}});
}

void checkDiameter(std::size_t index, Text quantity, double diameter_mm, double bore_mm)
{
    if (!(diameter_mm > 0) || !std::isfinite(diameter_mm))
        reject(index, quantity, diameter_mm, LT_TEXT("Engine", "more than 0"));
    if (bore_mm >= diameter_mm)
        reject(index, LT_TEXT("Engine", "the bore"), bore_mm, LT_TEXT("Engine", "less than the outer diameter"));
}

void checkSegment(std::size_t index, const ShaftSegment& s)
{
    if (!(s.length_mm >= 0) || !std::isfinite(s.length_mm))
        reject(index, LT_TEXT("Engine", "the length"), s.length_mm, LT_TEXT("Engine", "0 or more"));
    if (s.length_mm == 0) return;
    if (!(s.bore_diameter_mm >= 0))
        reject(index, LT_TEXT("Engine", "the bore"), s.bore_diameter_mm, LT_TEXT("Engine", "0 or more"));
    checkDiameter(index, LT_TEXT("Engine", "the start diameter"), s.start_diameter_mm, s.bore_diameter_mm);
    checkDiameter(index, LT_TEXT("Engine", "the end diameter"), s.end_diameter_mm, s.bore_diameter_mm);
    const double chord_mm = std::hypot(s.length_mm, (s.end_diameter_mm - s.start_diameter_mm) / 2);
    if (s.arc_radius_mm && !(std::abs(*s.arc_radius_mm) >= chord_mm / 2))
        reject(index, LT_TEXT("Engine", "the arc radius"), *s.arc_radius_mm,
               LT_TEXT("Engine", "at least half the chord"));
}

int piecesOf(const SegmentContour& contour, const ShaftSegment& s, int most)
{
    double least = contour.radiusAt_mm(0);
    double largest = least;
    for (int i = 1; i <= most; ++i) {
        const double radius = contour.radiusAt_mm(s.length_mm * i / most);
        least = std::min(least, radius);
        largest = std::max(largest, radius);
    }
    if (!(least > 0)) return most;
    const double by_taper = std::ceil(most * std::min(1.0, (largest / least - 1) / fullTaper));
    const double by_length = std::ceil(s.length_mm / (shortestPieceShare * 2 * largest));
    return std::clamp(static_cast<int>(std::min({by_taper, by_length, static_cast<double>(most)})),
                      std::min(fewestPieces, most), most);
}

void appendPieces(std::size_t index, const ShaftSegment& s, int most, std::vector<Piece>& pieces)
{
    const SegmentContour contour(s);
    if (contour.isCylinder()) {
        const double radius = s.start_diameter_mm / 2;
        pieces.push_back({s.length_mm, s.start_diameter_mm, s.bore_diameter_mm, radius, radius});
        return;
    }
    const int count = piecesOf(contour, s, most);
    for (int i = 0; i < count; ++i) {
        const double outer_mm = 2 * contour.radiusAt_mm(s.length_mm * (i + 0.5) / count);
        checkDiameter(index, LT_TEXT("Engine", "the diameter of the arc"), outer_mm, s.bore_diameter_mm);
        pieces.push_back({s.length_mm / count, outer_mm, s.bore_diameter_mm,
                          contour.radiusAt_mm(s.length_mm * i / count),
                          contour.radiusAt_mm(s.length_mm * (i + 1) / count)});
    }
}

/// The largest radius that the pieces before each allow at its start, if the radius grows by 45° at most.
template <class Pieces, class EndRadius>
std::vector<double> allowed(const Pieces& pieces, const EndRadius& endRadius)
{
    std::vector<double> result;
    double limit = HUGE_VAL;
    for (const Piece& piece : pieces) {
        result.push_back(limit);
        limit = std::min(endRadius(piece), limit + piece.length_mm);
    }
    return result;
}

void appendCorrected(const Piece& piece, double from_start_mm, double from_end_mm, std::vector<UniformSegment>& result)
{
    const auto add = [&](double length_mm, double middle_mm) {
        const double limit =
            std::min({piece.outer_mm / 2, from_start_mm + middle_mm, from_end_mm + piece.length_mm - middle_mm});
        const double stiff_mm = std::max(2 * limit, piece.bore_mm + 1e-3 * (piece.outer_mm - piece.bore_mm));
        result.push_back({length_mm, piece.outer_mm, piece.bore_mm, stiff_mm});
    };
    if (piece.start_radius_mm != piece.end_radius_mm) return add(piece.length_mm, piece.length_mm / 2);
    double first_mm = std::clamp(piece.outer_mm / 2 - from_start_mm, 0.0, piece.length_mm);
    double last_mm = std::clamp(piece.outer_mm / 2 - from_end_mm, 0.0, piece.length_mm);
    if (first_mm + last_mm > piece.length_mm) {  // the two 45° zones overlap
        first_mm = std::clamp((piece.length_mm + from_end_mm - from_start_mm) / 2, 0.0, piece.length_mm);
        last_mm = piece.length_mm - first_mm;
    }
    const double middle_mm = piece.length_mm - first_mm - last_mm;
    const auto slices = [&add](double begin_mm, double length_mm) {
        for (int i = 0; length_mm > 0 && i < slicesOfCone; ++i)
            add(length_mm / slicesOfCone, begin_mm + length_mm * (i + 0.5) / slicesOfCone);
    };
    slices(0, first_mm);
    if (middle_mm > 0) add(middle_mm, first_mm + middle_mm / 2);
    slices(piece.length_mm - last_mm, last_mm);
}

}  // namespace

std::vector<UniformSegment> uniformSegments(const Shaft& shaft, const SegmentOptions& options)
{
    std::vector<Piece> pieces;
    for (std::size_t i = 0; i < shaft.segments.size(); ++i) {
        checkSegment(i, shaft.segments[i]);
        if (shaft.segments[i].length_mm > 0) appendPieces(i, shaft.segments[i], options.taper_pieces, pieces);
    }
    if (pieces.empty()) throw Error(errors::shaftEmpty, {});
    std::vector<UniformSegment> result;
    if (!options.step_correction) {
        for (const Piece& piece : pieces)
            result.push_back({piece.length_mm, piece.outer_mm, piece.bore_mm, piece.outer_mm});
        return result;
    }
    const std::vector<double> from_start = allowed(pieces, [](const Piece& piece) { return piece.end_radius_mm; });
    std::vector<Piece> backward(pieces.rbegin(), pieces.rend());
    std::vector<double> from_end = allowed(backward, [](const Piece& piece) { return piece.start_radius_mm; });
    std::reverse(from_end.begin(), from_end.end());
    for (std::size_t i = 0; i < pieces.size(); ++i) appendCorrected(pieces[i], from_start[i], from_end[i], result);
    return result;
}

}  // namespace lathelier::beam
