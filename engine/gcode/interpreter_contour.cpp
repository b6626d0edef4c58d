// Lines and arcs: what states their end and shapes it.
#include <algorithm>
#include <cmath>

#include "engine/core/units.h"
#include "engine/gcode/gcode_codes.h"
#include "engine/gcode/interpreter.h"

namespace lathelier::gcode {
namespace {

constexpr double tightEnd_mm =
    0.0127;  ///< limits of the interpreter of LinuxCNC for the radius error at the end of an arc
constexpr double looseEnd_mm = 0.127;
constexpr double relativeEnd = 0.001;
constexpr double remarkedEnd_mm = 0.003;  ///< exceeds the rounding error of three decimals

}  // namespace

Corner Interpreter::cornerOf(BlockWords& words)
{
    if (words.has('c')) return {CornerKind::Legs, std::abs(length_mm(words, 'c'))};
    if (words.has('r')) return {CornerKind::Round, std::abs(length_mm(words, 'r'))};
    for (const auto& [name, kind] :
         {std::pair{Name::ChamferChord, CornerKind::Chord}, std::pair{Name::ChamferLeg, CornerKind::Legs},
          std::pair{Name::Round, CornerKind::Round}})
        if (isKnown(words.valueOf(name))) return {kind, words.valueOf(name)};
    if (modal_.round_mm > 0) return {CornerKind::Round, modal_.round_mm};
    if (modal_.motion != G::Line || !control_.has_drawing_words) return {};
    if (words.has('R')) return {CornerKind::Round, std::abs(length_mm(words, 'R'))};
    if (isChamferC(words)) return {CornerKind::Legs, std::abs(length_mm(words, 'C'))};
    // I and K are the leg along the axis of the next line.
    const bool alongX = words.has('X') || words.has('U'), alongZ = words.has('Z') || words.has('W');
    if (alongZ && !alongX && words.has('I')) return {CornerKind::Legs, std::abs(length_mm(words, 'I'))};
    if (alongX && !alongZ && words.has('K')) return {CornerKind::Legs, std::abs(length_mm(words, 'K'))};
    return {};
}

/// Does C state a chamfer, and not an angle of the spindle? The words do not tell; that the program moves no C axis
/// does.
bool Interpreter::isChamferC(const BlockWords& words)
{
    if (!control_.has_drawing_words || modal_.motion != G::Line || !words.has('C') || !hasAxes(words)) return false;
    if (!usesCAxis_) {
        usesCAxis_ = std::any_of(program_.blocks.begin(), program_.blocks.end(), [this](const Block& block) {
            bool hasC = false, hasAxis = false, isOther = false;
            for (std::uint32_t i = 0; i < block.word_count; ++i) {
                const Word& word = program_.words[block.first_word + i];
                hasC = hasC || word.letter == 'C' || word.letter == 'H';
                hasAxis = hasAxis || std::string_view("XZUW").find(word.letter) != std::string_view::npos;
                if (word.letter != 'G' || word.kind != WordKind::Number) continue;
                const G meaning = meaningOfG(control_, static_cast<int>(std::lround(word.value * 10)));
                isOther = isOther || meaning == G::Rapid || meaning == G::Home || isDrilling(meaning);
                if (meaning == G::MillOn) return true;
            }
            return hasC && (isOther || !hasAxis);
        });
        if (!*usesCAxis_) assume("C", LT_TEXT("Engine", "chamfer"));
    }
    return !*usesCAxis_;
}

/// The angle of a line from +Z, counterclockwise with X upward.
std::optional<double> Interpreter::angleOf(BlockWords& words)
{
    if (isKnown(words.valueOf(Name::EndAngle))) return words.valueOf(Name::EndAngle);
    if (!control_.has_drawing_words) return std::nullopt;
    for (const char letter : {'a', 'A'})
        if (words.has(letter) && meaningOfLetter(control_, letter) == Letter::InBlock) return plain(words, letter);
    return std::nullopt;
}

void Interpreter::unclosedLine()
{
    const std::size_t here = pc_;
    pc_ = openLine_->block;
    openLine_.reset();
    error(errors::ncCycle, nullptr,
          {{"cycle", "A"}, {"reason", LT_TEXT("Engine", "the line behind it states no angle, X and Z")}});
    pc_ = here;
}

/// A straight feed move by its end, by its angle and one coordinate, or by two angles and the end of the second line.
void Interpreter::line(BlockWords& words)
{
    const std::optional<double> angle = angleOf(words);
    if ((angle || openLine_) && !modal_.whole.isStraight()) return leaveOut(words, nullptr);
    const Corner corner = cornerOf(words);
    const bool hasX = words.has('X') || words.has('U'), hasZ = words.has('Z') || words.has('W');
    const auto alongX = [](double deg) { return std::sin(deg * rad_per_deg); };
    const auto alongZ = [](double deg) { return std::cos(deg * rad_per_deg); };
    constexpr double parallel = 1e-9;
    if (angle && !hasX && !hasZ) {
        if (openLine_) return unclosedLine();
        openLine_ = OpenLine{pc_, *angle, corner};
        return;
    }
    Point to = target(words);
    const auto impossible = [&](const Text& reason) {
        error(errors::ncCycle, nullptr, {{"cycle", "A"}, {"reason", reason}});
    };
    if (openLine_) {
        if (!angle || !hasX || !hasZ) return unclosedLine();
        const OpenLine first = *openLine_;
        openLine_.reset();
        const double x1 = alongX(first.angle_deg), z1 = alongZ(first.angle_deg), x2 = alongX(*angle),
                     z2 = alongZ(*angle);
        const double across = x1 * z2 - z1 * x2;
        if (std::abs(across) < parallel) return impossible(LT_TEXT("Engine", "both lines are parallel"));
        const double dx = to.x_mm - modal_.at.x_mm, dz = to.z_mm - modal_.at.z_mm;
        const double along = (dx * z2 - dz * x2) / across;
        const std::size_t here = pc_;
        const Point meet{modal_.at.x_mm + along * x1, modal_.at.z_mm + along * z1};
        pc_ = first.block;
        emit(MoveKind::Feed, meet, first.corner);
        pc_ = here;
    } else if (angle && hasX != hasZ) {
        const double slope = hasX ? alongX(*angle) : alongZ(*angle);
        if (std::abs(slope) < parallel) return impossible(LT_TEXT("Engine", "the line never reaches its end"));
        const double along = (hasX ? to.x_mm - modal_.at.x_mm : to.z_mm - modal_.at.z_mm) / slope;
        if (hasX)
            to.z_mm = modal_.at.z_mm + along * alongZ(*angle);
        else
            to.x_mm = modal_.at.x_mm + along * alongX(*angle);
    } else if (angle && isKnown(to) && isKnown(modal_.at)) {
        constexpr double agreed_mm = 0.01;  // a drawing's angle is rounded
        const double off = (to.x_mm - modal_.at.x_mm) * alongZ(*angle) - (to.z_mm - modal_.at.z_mm) * alongX(*angle);
        if (std::abs(off) > agreed_mm) return impossible(LT_TEXT("Engine", "X and Z state another angle"));
    }
    emit(MoveKind::Feed, to, corner);
}

void Interpreter::arc(BlockWords& words, const Point& end)
{
    bool clockwise = modal_.motion == G::ArcCw;
    const Point from = modal_.at;
    const Frame& frame = modal_.whole;
    if (!frame.keepsArcs()) return leaveOut(words, nullptr);
    if (frame.isMirrored()) clockwise = !clockwise;
    const Corner corner = cornerOf(words);
    if (!isKnown(from)) warn(notes::ncPositionUnknown);
    Point centre;
    double radius = notANumber;
    if (modal_.motion == G::ArcThrough) {
        const double middle = words.valueOf(Name::ArcMiddleX);
        const Point by = ofWork({modal_.is_diameter ? middle / 2 : middle, words.valueOf(Name::ArcMiddleZ)});
        const auto found = isKnown(by) ? centreThrough(from, by, end) : std::nullopt;
        if (!found) return error(errors::ncArcIncomplete);
        centre = *found;
        const double side =
            (by.z_mm - from.z_mm) * (end.x_mm - from.x_mm) - (by.x_mm - from.x_mm) * (end.z_mm - from.z_mm);
        clockwise = side < 0;
        modal_.motion = clockwise != frame.isMirrored() ? G::ArcCw : G::ArcCcw;
        return emit(MoveKind::Arc, end, corner, centre, clockwise);
    }
    if (isKnown(words.valueOf(Name::ArcRadius)))
        radius = words.valueOf(Name::ArcRadius);
    else if (words.has('R'))
        radius = length_mm(words, 'R');
    else if (const double angle = words.valueOf(Name::ArcAngle); isKnown(angle)) {
        const double half = angle / 2 * std::acos(-1.0) / 180;
        radius = distance_mm(from, end) / (2 * std::sin(half)) * (angle > 180 ? -1 : 1);
    }
    if (isKnown(radius)) {
        if (isKnown(words.valueOf(Name::ArcRadius)) || words.has('R')) radius *= frame.scale();
        const auto found = centreOfRadius(from, end, radius, clockwise);
        if (!found && isKnown(from) && isKnown(end))
            return error(errors::ncArcRadius, nullptr,
                         {{"radius_mm", std::abs(radius)}, {"half_chord_mm", distance_mm(from, end) / 2}});
        return emit(MoveKind::Arc, end, corner, found.value_or(Point{}), clockwise);
    }
    if (!words.has('I') && !words.has('K')) return error(errors::ncArcIncomplete);
    const Point start = modal_.is_shifted ? ofProgram(from) : from;
    const auto offset = [&](char letter, double begin, bool isX) {
        if (!words.has(letter)) return modal_.arc_is_absolute ? notANumber : begin;
        const double value = length_mm(words, letter);
        // A coordinate by a word of its own counts as X does; by a mode it is a radius always.
        if ((words.absolute >> BlockWords::slot(letter) & 1U) != 0)
            return isX && modal_.is_diameter ? value / 2 : value;
        return modal_.arc_is_absolute ? value : begin + value;
    };
    centre = {offset('I', start.x_mm, true), offset('K', start.z_mm, false)};
    if (modal_.is_shifted) centre = ofWork(centre);
    if (!isKnown(centre))
        return isKnown(from) ? error(errors::ncArcIncomplete) : emit(MoveKind::Arc, end, corner, centre, clockwise);
    radius = distance_mm(from, centre);
    const double off = std::abs(distance_mm(end, centre) - radius);
    const Values values{{"distance_mm", off}, {"radius_mm", radius}};
    const bool isAccepted = off * um_per_mm <= parameters_.arc_tolerance_um && radius > 0;
    if (!isAccepted && (off > looseEnd_mm || (off > tightEnd_mm && off > relativeEnd * radius) || !(radius > 0)))
        error(errors::ncArcEnd, nullptr, values);
    else if (off > remarkedEnd_mm)
        warn(notes::ncArcOffCircle, nullptr, values);
    emit(MoveKind::Arc, end, corner, centre, clockwise);
}

}  // namespace lathelier::gcode
