#include "engine/cam/threads.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <numbers>
#include <utility>

#include "engine/cam/job_bodies.h"
#include "engine/core/units.h"

namespace lathelier::cam {
namespace {

constexpr double depthPerPitch = 0.6134;  // ISO 724, with a rounded root of P/8
constexpr double leastDepthPerPitch = 0.45, mostDepthPerPitch = 0.8;
constexpr double diameterErrorPerPitch = 0.3;  // largest difference of drawn and nominal diameter
constexpr double firstThreadPass_mm = 0.2;
constexpr int leastThreadPasses = 4, mostThreadPasses = 30;
constexpr double runInPitches = 3;
constexpr double returnAbove_mm = 2;  // height of return moves over the crest
constexpr double beforeShoulder_mm = 0.5;
constexpr double threadSpeedShare = 0.5;  // over the cutting speed of roughing
constexpr double tan30 = 0.57735;

/// ISO 261, coarse pitches.
std::optional<double> coarsePitch_mm(double diameter_mm)
{
    static constexpr std::pair<double, double> all[]{
        {3, 0.5},  {4, 0.7},  {5, 0.8},  {6, 1},  {8, 1.25}, {10, 1.5}, {12, 1.75}, {14, 2}, {16, 2},
        {18, 2.5}, {20, 2.5}, {22, 2.5}, {24, 3}, {27, 3},   {30, 3.5}, {33, 3.5},  {36, 4}, {39, 4},
        {42, 4.5}, {45, 4.5}, {48, 5},   {52, 5}, {56, 5.5}, {60, 5.5}, {64, 6},    {68, 6}};
    for (const auto& [diameter, pitch] : all)
        if (std::abs(diameter - diameter_mm) < same_mm) return pitch;
    return {};
}

/// Parses a number at `at` and advances `at` behind it.
std::optional<double> numberAt(const std::string& text, std::size_t& at)
{
    std::size_t end = at;
    while (end < text.size() &&
           (std::isdigit(static_cast<unsigned char>(text[end])) || text[end] == '.' || text[end] == ','))
        ++end;
    if (end == at) return {};
    std::string number = text.substr(at, end - at);
    std::replace(number.begin(), number.end(), ',', '.');
    at = end;
    double value = 0, unit = 1;
    bool is_fraction = false;
    for (const char c : number) {
        if (c == '.') {
            if (is_fraction) return {};
            is_fraction = true;
            continue;
        }
        value = 10 * value + (c - '0');
        if (is_fraction) unit *= 10;
    }
    return value / unit;
}

DrawnThread threadNamed(const std::string& designation)
{
    DrawnThread thread;
    thread.designation = designation;
    std::string text;
    for (std::size_t i = 0; i < designation.size(); ++i) {
        const auto c = static_cast<unsigned char>(designation[i]);
        if (c == 0xC3 && i + 1 < designation.size() && static_cast<unsigned char>(designation[i + 1]) == 0x97) {
            text += 'x';  // ×
            ++i;
        } else if (!std::isspace(c)) {
            text += static_cast<char>(std::tolower(c));
        }
    }
    if (text.empty() || text[0] != 'm') return thread;
    std::size_t at = 1;
    const std::optional<double> diameter = numberAt(text, at);
    if (!diameter) return thread;
    thread.major_mm = diameter;
    if (at < text.size() && (text[at] == 'x' || text[at] == '*'))
        thread.pitch_mm = numberAt(text, ++at);
    else
        thread.pitch_mm = coarsePitch_mm(*diameter);
    if (thread.pitch_mm && !(*thread.pitch_mm > 0)) thread.pitch_mm.reset();
    const std::string rest = text.substr(std::min(at, text.size()));
    thread.is_plain = rest.find("lh") == std::string::npos && rest.find('(') == std::string::npos &&
                      rest.find('p') == std::string::npos;  // M16x4(P2), M16x4P2: several starts
    return thread;
}

/// Largest radius of the contour between two z; 0 without a contour.
double highest_mm(const HeightContour& contour, double from, double to)
{
    double highest = 0;
    for (const ContourPiece& piece : contour.pieces) {
        const double low = std::max(from, piece.from_mm.x()), high = std::min(to, piece.to_mm.x());
        if (low > high) continue;
        if (piece.to_mm.x() > piece.from_mm.x()) {
            highest = std::max({highest, piece.radiusAt_mm(low), piece.radiusAt_mm(high)});
            if (const Eigen::Vector2d centre = piece.isArc() ? piece.centre_mm() : Eigen::Vector2d(low, 0);
                piece.arc_radius_mm > 0 && centre.x() > low && centre.x() < high)
                highest = std::max(highest, centre.y() + piece.arc_radius_mm);
        }
    }
    return highest;
}

/// z where the tip stops: at most `side_mm` beyond the thread, with the flanks of the insert clear of contour above the
/// root.
double endOf(const HeightContour& contour, const JobTool& tool, double root_mm, double to_mm, double side_mm)
{
    const stock::ConvexPolygon insert = stock::outlineOf(turningTool(tool, {})).insert;
    double half = 0;  // of the insert's width
    for (const stock::Corner& corner : insert) half = std::max(half, corner.z_mm);
    const auto flank = [&](double height) {  // on a convex outline about its tip
        double reach = 0;
        for (std::size_t i = 0; i < insert.size(); ++i) {
            const stock::Corner &a = insert[i], &b = insert[(i + 1) % insert.size()];
            if (a.x_mm <= height) reach = std::max(reach, a.z_mm);
            if ((a.x_mm - height) * (b.x_mm - height) < 0)
                reach = std::max(reach, a.z_mm + (height - a.x_mm) / (b.x_mm - a.x_mm) * (b.z_mm - a.z_mm));
        }
        return reach;
    };
    double end = to_mm + side_mm;
    constexpr double wallProbe_mm = 0.05;
    const double last = std::min(contour.pieces.back().to_mm.x(), end + half + beforeShoulder_mm);
    for (double z = to_mm; z < last; z += wallProbe_mm)
        if (const double above = highest_mm(contour, z + same_mm, z + wallProbe_mm) - root_mm; above > same_mm)
            end = std::min(end, z - flank(above) - beforeShoulder_mm);
    return end;
}

Threading without(Text reason)
{
    Threading none;
    none.reason = reason;
    return none;
}

}  // namespace

std::vector<DrawnThread> threadsOf(const Shaft& part)
{
    std::vector<DrawnThread> threads;
    double begin = 0;
    for (const ShaftSegment& row : part.segments) {
        const double end = begin + row.length_mm;
        if (!row.thread.empty()) {
            DrawnThread thread = threadNamed(row.thread);
            thread.z_start_mm = begin;
            thread.z_end_mm = end;
            threads.push_back(std::move(thread));
        }
        begin = end;
    }
    for (const ShaftMark& mark : part.marks) {
        if (mark.kind != MarkKind::Thread) continue;
        DrawnThread thread = threadNamed(mark.designation);
        if (mark.pitch_mm) thread.pitch_mm = mark.pitch_mm;
        if (mark.major_mm) thread.major_mm = mark.major_mm;
        thread.minor_mm = mark.minor_mm;
        thread.is_plain = thread.is_plain && mark.hand.value_or(1) > 0 && mark.starts.value_or(1) <= 1;
        if (!mark.z_start_mm || !mark.z_end_mm) thread.pitch_mm.reset();
        thread.z_start_mm = mark.z_start_mm.value_or(0);
        thread.z_end_mm = mark.z_end_mm.value_or(0);
        const bool is_row = std::any_of(threads.begin(), threads.end(), [&](const DrawnThread& other) {
            return other.z_start_mm < thread.z_end_mm && other.z_end_mm > thread.z_start_mm;
        });
        if (!is_row) threads.push_back(std::move(thread));
    }
    return threads;
}

std::vector<DrawnThread> mirrored(std::vector<DrawnThread> threads, double length_mm)
{
    for (DrawnThread& thread : threads) {
        const double start = thread.z_start_mm;
        thread.z_start_mm = length_mm - thread.z_end_mm;
        thread.z_end_mm = length_mm - start;
    }
    return threads;
}

Threading threading(const WorkFrame& frame, const JobTool& tool, const DrawnThread& thread, double max_rpm)
{
    if (!thread.pitch_mm) return without(LT_TEXT("Engine", "its pitch or its place is not understood"));
    if (!thread.is_plain) return without(LT_TEXT("Engine", "it is left-handed or has several starts"));
    const double pitch = *thread.pitch_mm;
    const double from = thread.z_start_mm, to = std::min(thread.z_end_mm, frame.contour.length_mm);
    const double crest = highest_mm(frame.contour, from + same_mm, to - same_mm);
    if (thread.major_mm && std::abs(*thread.major_mm - 2 * crest) > diameterErrorPerPitch * pitch)
        return without(LT_TEXT("Engine", "its row has another diameter"));
    const double depth = thread.minor_mm ? crest - *thread.minor_mm / 2 : depthPerPitch * pitch, root = crest - depth;
    if (depth < leastDepthPerPitch * pitch || depth > mostDepthPerPitch * pitch)
        return without(LT_TEXT("Engine", "its root does not fit its pitch"));
    if (!(root > 0) || std::abs(lowestRadius_mm(frame.contour, from + same_mm, to - same_mm) - crest) > same_mm)
        return without(LT_TEXT("Engine", "its row is no cylinder that could carry it"));
    const double run_in = from - runInPitches * pitch, side = depth * tan30 + beforeShoulder_mm;
    if (highest_mm(frame.contour, run_in, from - same_mm) > crest + same_mm)
        return without(LT_TEXT("Engine", "what stands before it is higher"));
    const double end = endOf(frame.contour, tool, root, to, side);
    if (end - from < pitch) return without(LT_TEXT("Engine", "its row is too short"));
    Threading result;
    const double square = (depth / firstThreadPass_mm) * (depth / firstThreadPass_mm);
    result.passes = std::clamp(static_cast<int>(std::ceil(square)), leastThreadPasses, mostThreadPasses);
    result.depth_mm = depth;
    Operation operation{OperationKind::Thread,
                        tool.number,
                        threadSpeedShare * frame.job->cutting.rough.cutting_speed_m_min,
                        {},
                        {},
                        {}};
    operation.speed_rpm = std::max(
        1.0, std::min(max_rpm, std::floor(1000 * operation.cutting_speed_m_min / (2 * std::numbers::pi * crest))));
    operation.reason = thread.designation;
    const double above = crest + returnAbove_mm;
    MoveList moves(Eigen::Vector2d(0, 0));
    moves.rapid({run_in, frame.safe_x_mm});
    for (int i = 1; i <= result.passes + 1; ++i) {
        const double share = std::min(1.0, static_cast<double>(i) / result.passes);
        moves.rapidX(above);
        moves.rapidZ(run_in);
        moves.rapidX(crest - depth * std::sqrt(share));
        moves.thread({end, moves.at().y()}, pitch);
    }
    moves.rapidX(frame.safe_x_mm);
    operation.moves = moves.taken();
    result.operation = std::move(operation);
    return result;
}

}  // namespace lathelier::cam
