#include "engine/features/nominal/row_chain.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace lathelier::features {
namespace {

constexpr double sameDiameter_mm = 1e-4;
constexpr double joinGap_mm = 1e-3, leastRelief_mm = 1e-6;

double inMillimetres(const std::optional<double>& value_um)
{
    return value_um.value_or(0) / 1000;
}

bool isSeen(const Recognition& recognition, std::size_t end)
{
    return recognition.ends.size() <= end || recognition.ends[end].closed_by != "data";
}

}  // namespace

RowChain::RowChain(const Recognition& recognition) : rows_(&recognition.segments)
{
    startsAtEnd_ = isSeen(recognition, 0);
    endsAtEnd_ = isSeen(recognition, 1);
    if (!recognition.ends.empty()) endUncertainty_mm_ = recognition.ends.front().uncertainty_mm;
    if (recognition.ends.size() > 1) farEndUncertainty_mm_ = recognition.ends[1].uncertainty_mm;
    findJoints();
}

RowChain::RowChain(const Recognition& recognition, std::size_t bore) : rows_(&recognition.bores[bore]), sign_(-1)
{
    const double length =
        recognition.segments.empty() ? recognition.length_mm.value_or(0) : recognition.segments.back().z_end_mm;
    const RecognizedRow &first = rows_->front(), &last = rows_->back();
    const double to_free = std::min(first.z_start_mm, first.z_end_mm);
    const double to_chuck = length - std::max(last.z_start_mm, last.z_end_mm);
    // Rows run from the mouth inward; a single row belongs to the end that it is nearer to, or that its order of z
    // gives.
    const bool falls =
        size() > 1 ? first.z_start_mm + first.z_end_mm > last.z_start_mm + last.z_end_mm : to_chuck < to_free;
    const bool from_chuck = falls || first.z_start_mm > first.z_end_mm;
    sense_ = from_chuck ? -1 : 1;
    origin_mm_ = from_chuck ? length : 0;
    if (recognition.ends.size() > (from_chuck ? 1U : 0U))
        endUncertainty_mm_ = recognition.ends[from_chuck ? 1 : 0].uncertainty_mm;
    startsAtEnd_ = isSeen(recognition, from_chuck ? 1 : 0);
    constexpr double throughTolerance_mm = 0.1;
    endsAtEnd_ = end_mm(size() - 1) > length - throughTolerance_mm;
    findJoints();
}

void RowChain::findJoints()
{
    joints_.assign(size() + 1, Joint::End);
    for (std::size_t i = 1; i < size(); ++i) {
        const double ahead = start_mm(i) - end_mm(i - 1);
        const double step = std::abs(row(i).start_diameter_mm - row(i - 1).end_diameter_mm);
        joints_[i] = ahead > joinGap_mm        ? Joint::Gap
                     : ahead < -leastRelief_mm ? Joint::Relieved
                     : step <= sameDiameter_mm ? Joint::Joined
                                               : Joint::Plane;
    }
}

bool RowChain::isRoughSeam(std::size_t boundary) const
{
    constexpr double roughSeamStep_mm = 0.1;
    const auto isRough = [](const RecognizedRow& row) { return row.role == "thread" || row.role == "knurl"; };
    if (joint(boundary) != Joint::Plane) return false;
    const RecognizedRow &before = row(boundary - 1), &after = row(boundary);
    return isRough(before) != isRough(after) &&
           std::abs(before.end_diameter_mm - after.start_diameter_mm) / 2 <= roughSeamStep_mm;
}

double RowChain::angle_deg(std::size_t i) const
{
    return std::atan2(std::abs(endHeight_mm(i) - startHeight_mm(i)) / 2, std::abs(length_mm(i))) * 180 /
           std::numbers::pi;
}

ContourPiece RowChain::piece(std::size_t i) const
{
    return {{start_mm(i), row(i).start_diameter_mm / 2},
            {end_mm(i), row(i).end_diameter_mm / 2},
            row(i).arc_radius_mm.value_or(0)};
}

double RowChain::boundaryUncertainty_mm(std::size_t boundary) const
{
    double own_mm = 0;
    if (boundary > 0) own_mm = inMillimetres(row(boundary - 1).uncertainty.z_end_um);
    if (own_mm == 0 && boundary < size()) own_mm = inMillimetres(row(boundary).uncertainty.z_start_um);
    if (own_mm == 0 && boundary == size()) own_mm = farEndUncertainty_mm_;
    return std::hypot(own_mm, endUncertainty_mm_);
}

double RowChain::closing_mm(std::size_t i) const
{
    return joint(i + 1) == Joint::Relieved ? start_mm(i + 1) : end_mm(i);
}

double diameterUncertainty_mm(const RecognizedRow& row)
{
    return std::max(inMillimetres(row.uncertainty.start_diameter_um), inMillimetres(row.uncertainty.end_diameter_um));
}

double lengthUncertainty_mm(const RecognizedRow& row)
{
    if (row.uncertainty.length_um) return *row.uncertainty.length_um / 1000;
    return std::hypot(inMillimetres(row.uncertainty.z_start_um), inMillimetres(row.uncertainty.z_end_um));
}

std::optional<UndercutRows> undercutRowsAt(const RowChain& chain, std::size_t first)
{
    constexpr double runOutTolerance_deg = 2, deepestUndercut_mm = 1.5, widestUndercut_mm = 10, beyondFace_mm = 0.05;
    UndercutRows found;
    found.first = first;
    const std::size_t n = chain.size();
    const auto isRelievedFace = [&](std::size_t i) {
        return i < n && chain.row(i).kind == RowKind::Cone && chain.length_mm(i) < 0;
    };
    const auto isArc = [&](std::size_t i) { return i < n && chain.row(i).kind == RowKind::Arc && chain.isConcave(i); };
    bool relieved = false;
    if (chain.row(first).kind == RowKind::Cone && chain.length_mm(first) > 0) {
        found.run_out = first;
        found.bottom = first + 1;
        found.arc = found.last = first + 2;
        if (!isArc(found.arc)) return {};
        relieved = isRelievedFace(found.last + 1);
        if (relieved) ++found.last;
        if (first == 0 || found.last + 1 >= n || chain.joint(first) != Joint::Joined) return {};
        const Joint face = chain.joint(found.last + 1);
        if (face != Joint::Plane && face != Joint::Relieved && !relieved) return {};
        if (!(chain.startHeight_mm(found.last + 1) > chain.endHeight_mm(found.arc))) return {};
        found.measured.width.value_mm = chain.closing_mm(found.last) - chain.start_mm(first);
        relieved = relieved || face == Joint::Relieved;
    } else {
        found.before_face = false;
        found.arc = isRelievedFace(first) ? first + 1 : first;
        found.bottom = found.arc + 1;
        found.run_out = found.last = found.arc + 2;
        if (!isArc(found.arc) || first == 0 || found.last + 1 >= n) return {};
        if (chain.joint(found.last + 1) != Joint::Joined) return {};
        const Joint face = chain.joint(first);
        if (face != Joint::Plane && face != Joint::Relieved) return {};
        if (!(chain.endHeight_mm(first - 1) > chain.startHeight_mm(found.arc))) return {};
        found.measured.width.value_mm = chain.end_mm(found.last) - chain.end_mm(first - 1);
        relieved = found.arc != first || face == Joint::Relieved;
    }
    const RecognizedRow &cone = chain.row(found.run_out), &bottom = chain.row(found.bottom),
                        &arc = chain.row(found.arc);
    if (cone.kind != RowKind::Cone || bottom.kind != RowKind::Cylinder) return {};
    const double falls = chain.startHeight_mm(found.run_out) - chain.endHeight_mm(found.run_out);
    const double rises = chain.endHeight_mm(found.arc) - chain.startHeight_mm(found.arc);
    if (found.before_face != (falls > 0) || found.before_face != (rises > 0)) return {};
    const double window = runOutTolerance_deg + cone.uncertainty.angle_deg.value_or(0);
    if (std::abs(chain.angle_deg(found.run_out) - undercutRunOut_deg) > window) return {};
    MeasuredUndercut& measured = found.measured;
    // The circle of form F reaches t2, at least 0.1 mm, beyond the face; where it ends there it is cut off.
    const double face_at = found.before_face ? chain.closing_mm(found.last) : chain.end_mm(first - 1);
    const double reach = std::abs(chain.piece(found.arc).centre_mm().x() - face_at);
    const bool beyond = std::abs(*arc.arc_radius_mm) - reach > beyondFace_mm;
    measured.form = relieved || beyond || !arc.fully_visible ? UndercutForm::F : UndercutForm::E;
    measured.shaft_mm =
        std::abs(found.before_face ? chain.startHeight_mm(found.run_out) : chain.endHeight_mm(found.run_out));
    measured.depth = {std::abs(falls) / 2,
                      std::hypot(diameterUncertainty_mm(cone), diameterUncertainty_mm(bottom)) / 2};
    const double free = inMillimetres(found.before_face ? cone.uncertainty.z_start_um : cone.uncertainty.z_end_um);
    const double face = inMillimetres(found.before_face ? arc.uncertainty.z_end_um : arc.uncertainty.z_start_um);
    measured.width.U_mm = std::hypot(free, face);
    measured.radius = {std::abs(*arc.arc_radius_mm), inMillimetres(arc.uncertainty.arc_radius_um)};
    if (measured.depth.value_mm > deepestUndercut_mm || measured.width.value_mm > widestUndercut_mm) return {};
    return found;
}

std::optional<GrooveRows> grooveRowsAt(const RowChain& chain, std::size_t first)
{
    constexpr std::size_t mostGrooveRows = 5;
    constexpr double narrowestGroove_mm = 0.2, widestGroove_mm = 8, widestGrooveShare = 0.5, shallowestGroove_mm = 0.1,
                     leastFlank_deg = 10, sameEnd_mm = 0.002;
    if (first == 0) return {};
    const auto meets = [&](std::size_t b) { return chain.joint(b) == Joint::Plane || chain.joint(b) == Joint::Joined; };
    const double left = chain.endHeight_mm(first - 1);
    GrooveRows found;
    found.first = first;
    bool rising = false;
    double lowest = left;
    for (std::size_t i = first; i < chain.size() && i < first + mostGrooveRows && meets(i); ++i) {
        const RecognizedRow& row = chain.row(i);
        if (!row.role.empty() || chain.length_mm(i) < 0) return {};
        const double start = chain.startHeight_mm(i), end = chain.endHeight_mm(i);
        const double before = chain.endHeight_mm(i - 1);
        // Heights fall to the bottom and rise again, once.
        if (i > first && chain.joint(i) == Joint::Plane) return {};
        if (i == first && start > before + sameEnd_mm) return {};
        if (end > start + sameEnd_mm) rising = true;
        if (rising && end < start - sameEnd_mm) return {};
        if (row.kind == RowKind::Cylinder) {
            if (found.bottom || rising) return {};
            found.bottom = i;
        }
        if (row.kind == RowKind::Cone && chain.angle_deg(i) < leastFlank_deg) return {};
        if (row.kind == RowKind::Arc && !chain.isConcave(i)) return {};
        lowest = std::min({lowest, start, end});
        if (i + 1 >= chain.size() || !meets(i + 1)) return {};
        const double right = chain.startHeight_mm(i + 1), rim = std::min(left, right);
        const double width = chain.end_mm(i) - chain.start_mm(first);
        if (width > widestGroove_mm) return {};
        const bool closed = chain.joint(i + 1) == Joint::Plane ? right > end : std::abs(end - right) <= sameEnd_mm;
        const bool next_rises = i + 1 < chain.size() && chain.joint(i + 1) == Joint::Joined &&
                                chain.endHeight_mm(i + 1) > right + sameEnd_mm;
        if (!closed || rim - lowest < shallowestGroove_mm || next_rises) continue;
        if (width < narrowestGroove_mm || width > widestGrooveShare * std::abs(rim)) return {};
        found.last = i;
        found.between_planes = chain.joint(first) == Joint::Plane && chain.joint(i + 1) == Joint::Plane;
        // A flank on one side and a plane on the other is a step with a fillet or a run-out, not a groove.
        if (!found.between_planes && (chain.joint(first) == Joint::Plane || chain.joint(i + 1) == Joint::Plane))
            return {};
        found.width = {width, std::hypot(inMillimetres(chain.row(first).uncertainty.z_start_um),
                                         inMillimetres(row.uncertainty.z_end_um))};
        if (const auto length_um = row.uncertainty.length_um; length_um && first == i)
            found.width.U_mm = *length_um / 1000;
        const std::size_t shaft = left < right ? first - 1 : i + 1;
        found.shaft = {std::abs(rim), diameterUncertainty_mm(chain.row(shaft))};
        return found;
    }
    return {};
}

}  // namespace lathelier::features
