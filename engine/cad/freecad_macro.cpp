#include "engine/cad/freecad_macro.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "engine/core/units.h"
#include "engine/core/utf8.h"
#include "engine/shaft/shaft_contour.h"
#include "engine/shaft/shaft_rules.h"
#include "engine/shaft/turned_marks.h"

namespace lathelier::cad {
namespace {

using Eigen::Vector2d;

/// Disjoint sets of vertices that share a coordinate.
class Sets {
public:
    explicit Sets(std::size_t count) : parent_(count)
    {
        for (std::size_t i = 0; i < count; ++i) parent_[i] = i;
    }
    std::size_t of(std::size_t i) const
    {
        while (parent_[i] != i) i = parent_[i];
        return i;
    }
    /// False if they were already in one set.
    bool join(std::size_t a, std::size_t b)
    {
        a = of(a);
        b = of(b);
        parent_[std::max(a, b)] = std::min(a, b);
        return a != b;
    }

private:
    std::vector<std::size_t> parent_;
};

std::string number(double value)
{
    return fmt::format("{}", value == 0 ? 0.0 : value);
}

std::string pythonString(std::string_view utf8)
{
    std::string text = "'";
    for (std::size_t at = 0; at < utf8.size();) {
        const Utf8Character character = utf8At(utf8, at);
        at += std::max<std::size_t>(1, character.length);
        const char32_t code = character.length == 0 ? U'?' : character.code;
        if (code >= 0x20 && code < 0x7F && code != U'\'' && code != U'\\')
            text += static_cast<char>(code);
        else
            text += fmt::format("\\U{:08x}", static_cast<std::uint32_t>(code));
    }
    return text + "'";
}

class Macro {
public:
    explicit Macro(const Shaft& shaft)
        : shaft_(shaft), closed_(closedLoop(shaft)), radii_(closed_.size()), heights_(closed_.size())
    {
    }

    std::string text()
    {
        head();
        geometry();
        shape();
        sizes();
        line("doc.recompute()");
        for (const std::string& expression : expressions_) line(expression);
        line("doc.recompute()");
        line("rev = body.newObject('PartDesign::Revolution', 'Revolution')");
        line("rev.Profile = sk");
        line("rev.ReferenceAxis = (sk, ['V_Axis'])");
        line("rev.Angle = 360");
        line("doc.recompute()");
        return std::move(text_);
    }

private:
    /// Adds the line on the axis that the contour omits.
    static Contour closedLoop(const Shaft& shaft)
    {
        Contour closed = closedContour(shaft);
        for (ContourPiece& piece : closed)
            for (Vector2d* end : {&piece.from_mm, &piece.to_mm})
                if (std::abs(end->y()) < meet_mm) end->y() = 0;
        if (!closed.empty() && (closed.back().to_mm - closed.front().from_mm).norm() > meet_mm)
            closed.push_back({closed.back().to_mm, closed.front().from_mm, 0});
        return closed;
    }

    void line(const std::string& content) { text_ += content + '\n'; }
    std::size_t next(std::size_t i) const { return (i + 1) % closed_.size(); }
    bool isOnAxis(std::size_t i) const
    {
        return !closed_[i].isArc() && closed_[i].from_mm.y() == 0 && closed_[i].to_mm.y() == 0;
    }
    bool keepsRadius(std::size_t i) const
    {
        return !closed_[i].isArc() && std::abs(closed_[i].to_mm.y() - closed_[i].from_mm.y()) < meet_mm;
    }
    bool keepsHeight(std::size_t i) const
    {
        return !closed_[i].isArc() && std::abs(closed_[i].to_mm.x() - closed_[i].from_mm.x()) < meet_mm;
    }

    /// A vertex as Sketcher counts it: the begin of piece i; arcs run anticlockwise in (r, z).
    std::string vertex(std::size_t i) const
    {
        const bool backwards = closed_[i].isArc() && closed_[i].arc_radius_mm < 0;
        return fmt::format("G[{}],{}", i, backwards ? 2 : 1);
    }
    std::string vertexAtEnd(std::size_t i) const
    {
        const bool backwards = closed_[i].isArc() && closed_[i].arc_radius_mm < 0;
        return fmt::format("G[{}],{}", i, backwards ? 1 : 2);
    }

    void head()
    {
        line("# FreeCAD macro written by Lathelier: the drawn shaft as a parametric body. Units mm.");
        line("import FreeCAD as App, Part, Sketcher");
        line("doc = App.newDocument('Shaft')");
        line("doc.Label = " + pythonString(shaft_.name.empty() ? "Shaft" : shaft_.name));
        line("body = doc.addObject('PartDesign::Body', 'Shaft')");
        line("sk = body.newObject('Sketcher::SketchObject', 'Meridian')");
        line("plane = body.Origin.OriginFeatures[4]");
        line("if hasattr(sk, 'AttachmentSupport'): sk.AttachmentSupport = [(plane, '')]");
        line("else: sk.Support = (plane, [''])");
        line("sk.MapMode = 'FlatFace'");
        line("V = App.Vector");
        line("G = []");
    }

    void geometry()
    {
        for (const ContourPiece& piece : closed_) {
            const auto point = [](const Vector2d& zr) {
                return fmt::format("V({},{},0)", number(zr.y()), number(zr.x()));
            };
            if (!piece.isArc()) {
                line(fmt::format("G.append(sk.addGeometry(Part.LineSegment({},{}),False))", point(piece.from_mm),
                                 point(piece.to_mm)));
                continue;
            }
            // An angle t from z toward r is 90° - t from r toward z.
            auto [start, end] = piece.arcAngles();
            double first = std::numbers::pi / 2 - start, second = std::numbers::pi / 2 - end;
            if (piece.arc_radius_mm < 0) std::swap(first, second);
            while (first < 0) first += 2 * std::numbers::pi, second += 2 * std::numbers::pi;
            line(fmt::format("G.append(sk.addGeometry(Part.ArcOfCircle(Part.Circle({},V(0,0,1),{}),{},{}),False))",
                             point(piece.centre_mm()), number(std::abs(piece.arc_radius_mm)), number(first),
                             number(second)));
        }
        line("C = sk.addConstraint; K = Sketcher.Constraint");
        for (std::size_t i = 0; i < closed_.size(); ++i)
            line(fmt::format("C(K('Coincident',{},{}))", vertexAtEnd(i), vertex(next(i))));
    }

    void shape()
    {
        for (std::size_t i = 0; i < closed_.size(); ++i) {
            if (isOnAxis(i)) {
                radii_.join(i, next(i));
                line(fmt::format("C(K('Vertical',G[{}]))  # on the axis", i));
            } else if (keepsRadius(i)) {
                if (radii_.join(i, next(i))) line(fmt::format("C(K('Vertical',G[{}]))", i));
            } else if (keepsHeight(i)) {
                if (heights_.join(i, next(i))) line(fmt::format("C(K('Horizontal',G[{}]))", i));
            }
        }
        given_.assign(closed_.size(), false);
        for (std::size_t i = 0; i < closed_.size(); ++i) {
            const std::size_t set = radii_.of(i);
            if (closed_[i].from_mm.y() != 0 || given_[set]) continue;
            given_[set] = true;
            line(fmt::format("C(K('PointOnObject',{},-2))", vertex(i)));
        }
        for (std::size_t i = 0; i < closed_.size(); ++i)
            if (std::abs(closed_[i].from_mm.x()) < meet_mm) {
                line(fmt::format("C(K('PointOnObject',{},-1))", vertex(i)));
                break;
            }
        line("T = doc.addObject('Spreadsheet::Sheet', 'Table')");
    }

    /// Rows of the outside in their order, then those of the bores from their mouths.
    void sizes()
    {
        std::vector<std::size_t> order;
        for (std::size_t i = 0; i < closed_.size(); ++i)
            if (closed_[i].row != ContourPiece::none) order.push_back(i);
        std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
            const ContourPiece &p = closed_[a], &q = closed_[b];
            return p.bore != q.bore ? p.bore < q.bore : p.row < q.row;
        });
        // Diameters of cylinders are named after them.
        names_.assign(closed_.size(), "");
        for (const std::size_t i : order)
            if (keepsRadius(i) && names_[radii_.of(i)].empty()) names_[radii_.of(i)] = nameOf(closed_[i]);
        for (const std::size_t i : order) {
            const ContourPiece& piece = closed_[i];
            const std::string name = nameOf(piece);
            // A bore from the free end runs against the contour.
            const bool against = piece.bore != ContourPiece::none && piece.to_mm.x() < piece.from_mm.x() &&
                                 runsBack(static_cast<std::size_t>(piece.bore));
            radius(against ? next(i) : i, name);
            if (heights_.join(i, next(i))) {
                const bool up = piece.to_mm.x() > piece.from_mm.x();
                const double length = std::abs(statedLength(piece));
                bind(fmt::format("K('DistanceY',{},{},{})", up ? vertex(i) : vertexAtEnd(i),
                                 up ? vertexAtEnd(i) : vertex(i), number(length)),
                     "L" + name, "Len_" + name, length, false);
            }
            if (piece.isArc())
                bind(fmt::format("K('Radius',G[{}],{})", i, number(std::abs(piece.arc_radius_mm))), "A" + name,
                     "Rad_" + name, std::abs(piece.arc_radius_mm), false);
            radius(against ? i : next(i), "e" + name);
        }
    }

    /// The length stated by the row, as differences of z have rounding errors.
    double statedLength(const ContourPiece& piece) const
    {
        const auto row = static_cast<std::size_t>(piece.row);
        if (piece.bore == ContourPiece::none) return shaft_.segments[row].length_mm;
        const auto bore = static_cast<std::size_t>(piece.bore);
        return bore < shaft_.bores.size() ? shaft_.bores[bore].segments[row].length_mm
                                          : piece.to_mm.x() - piece.from_mm.x();
    }

    static std::string nameOf(const ContourPiece& piece)
    {
        return piece.bore == ContourPiece::none ? fmt::format("{}", piece.row + 1)
                                                : fmt::format("b{}_{}", piece.bore + 1, piece.row + 1);
    }

    bool runsBack(std::size_t bore) const
    {
        return bore >= shaft_.bores.size() || shaft_.bores[bore].from == ShaftEnd::Free;
    }

    /// The radius of a vertex, unless its set is already dimensioned.
    void radius(std::size_t i, const std::string& otherwise)
    {
        const std::size_t set = radii_.of(i);
        if (given_[set]) return;
        given_[set] = true;
        const std::string name = names_[set].empty() ? otherwise : names_[set];
        const double radius_mm = closed_[i].from_mm.y();
        bind(fmt::format("K('DistanceX',-1,1,{},{})", vertex(i), number(radius_mm)), "R" + name, "Dia_" + name,
             2 * radius_mm, true);
    }

    void bind(const std::string& constraint, const std::string& name, const std::string& alias, double value_mm,
              bool halved)
    {
        ++cells_;
        line(
            fmt::format("sk.renameConstraint(C({}), '{}'); T.set('A{}', '{}'); T.set('B{}', '{} mm'); "
                        "T.setAlias('B{}', '{}')",
                        constraint, name, cells_, alias, cells_, number(value_mm), cells_, alias));
        expressions_.push_back(
            fmt::format("sk.setExpression('Constraints.{}', 'Table.{}{}')", name, alias, halved ? " / 2" : ""));
    }

    const Shaft& shaft_;
    Contour closed_;
    Sets radii_, heights_;  ///< of vertices: i is the begin of piece i
    std::vector<bool> given_;
    std::vector<std::string> names_;  ///< of sets of radii
    std::string text_;
    std::vector<std::string> expressions_;
    int cells_ = 0;
};

}  // namespace

std::string freecadMacro(const Shaft& shaft)
{
    checkShaft(shaft);
    requireSolidOfRows(shaft);
    return Macro(shaft).text();
}

}  // namespace lathelier::cad
