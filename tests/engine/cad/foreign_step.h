// STEP files that the room's writer does not make: extruded outlines (box, faceted bar, shaft with a flat), and files
// turned into another pose. Written by hand, so that no kernel is needed.
#pragma once

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <cstdlib>
#include <regex>
#include <string>
#include <vector>

namespace lathelier::cad {

/// A corner of an outline (anticlockwise), and what leads to the next one: a line, or an arc about the origin.
struct Corner {
    double x = 0, y = 0;
    bool arc = false;
};

class ForeignStep {
public:
    explicit ForeignStep(Eigen::Isometry3d pose = Eigen::Isometry3d::Identity()) : pose_(pose) {}

    /// Adds the solid that the outline sweeps from z0 to z1.
    void extrude(const std::vector<Corner>& outline, double z0, double z1, double shift_x = 0)
    {
        const std::size_t n = outline.size();
        std::vector<int> vertices[2], rings[2], posts, faces;
        for (int level = 0; level < 2; ++level)
            for (const Corner& c : outline)
                vertices[level].push_back(add("VERTEX_POINT('',#{})", point(c.x + shift_x, c.y, level == 0 ? z0 : z1)));
        for (int level = 0; level < 2; ++level)
            for (std::size_t i = 0; i < n; ++i) {
                const double z = level == 0 ? z0 : z1;
                const Corner &a = outline[i], &b = outline[(i + 1) % n];
                const int curve =
                    a.arc ? add("CIRCLE('',#{},{:#.17G})", placement(shift_x, 0, z, {0, 0, 1}, {1, 0, 0}), radius(a))
                          : line(a.x + shift_x, a.y, z, {b.x - a.x, b.y - a.y, 0});
                rings[level].push_back(
                    add("EDGE_CURVE('',#{},#{},#{},.T.)", vertices[level][i], vertices[level][(i + 1) % n], curve));
            }
        for (std::size_t i = 0; i < n; ++i)
            posts.push_back(add("EDGE_CURVE('',#{},#{},#{},.T.)", vertices[0][i], vertices[1][i],
                                line(outline[i].x + shift_x, outline[i].y, z0, {0, 0, 1})));
        for (std::size_t i = 0; i < n; ++i) {
            const Corner &a = outline[i], &b = outline[(i + 1) % n];
            const Eigen::Vector3d outward(b.y - a.y, a.x - b.x, 0);
            const int surface = a.arc ? add("CYLINDRICAL_SURFACE('',#{},{:#.17G})",
                                            placement(shift_x, 0, z0, {0, 0, 1}, {1, 0, 0}), radius(a))
                                      : add("PLANE('',#{})", placement(a.x + shift_x, a.y, z0, outward, {0, 0, 1}));
            faces.push_back(face(
                surface, {{rings[0][i], true}, {posts[(i + 1) % n], true}, {rings[1][i], false}, {posts[i], false}}));
        }
        std::vector<std::pair<int, bool>> bottom, top;
        for (std::size_t i = 0; i < n; ++i) {
            bottom.emplace_back(rings[0][n - 1 - i], false);
            top.emplace_back(rings[1][i], true);
        }
        faces.push_back(face(add("PLANE('',#{})", placement(shift_x, 0, z0, {0, 0, -1}, {1, 0, 0})), bottom));
        faces.push_back(face(add("PLANE('',#{})", placement(shift_x, 0, z1, {0, 0, 1}, {1, 0, 0})), top));
        solids_.push_back(add("MANIFOLD_SOLID_BREP('',#{})", add("CLOSED_SHELL('',({}))", list(faces))));
    }

    std::string text()
    {
        const int application = add("APPLICATION_CONTEXT('mechanical design')");
        add("APPLICATION_PROTOCOL_DEFINITION('international standard','automotive_design',2000,#{})", application);
        const int product =
            add("PRODUCT('foreign','foreign','',(#{}))", add("PRODUCT_CONTEXT('',#{},'mechanical')", application));
        const int definition =
            add("PRODUCT_DEFINITION('design','',#{},#{})", add("PRODUCT_DEFINITION_FORMATION('','',#{})", product),
                add("PRODUCT_DEFINITION_CONTEXT('part definition',#{},'design')", application));
        const int length = add("(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT(.MILLI.,.METRE.))");
        const int angle = add("(NAMED_UNIT(*)PLANE_ANGLE_UNIT()SI_UNIT($,.RADIAN.))");
        const int solid = add("(NAMED_UNIT(*)SI_UNIT($,.STERADIAN.)SOLID_ANGLE_UNIT())");
        const int accuracy =
            add("UNCERTAINTY_MEASURE_WITH_UNIT(LENGTH_MEASURE(1.E-07),#{},'distance_accuracy_value','')", length);
        const int context =
            add("(GEOMETRIC_REPRESENTATION_CONTEXT(3)GLOBAL_UNCERTAINTY_ASSIGNED_CONTEXT((#{}))"
                "GLOBAL_UNIT_ASSIGNED_CONTEXT((#{},#{},#{}))REPRESENTATION_CONTEXT('',''))",
                accuracy, length, angle, solid);
        const int shape = add("ADVANCED_BREP_SHAPE_REPRESENTATION('',({}),#{})", list(solids_), context);
        add("SHAPE_DEFINITION_REPRESENTATION(#{},#{})", add("PRODUCT_DEFINITION_SHAPE('','',#{})", definition), shape);
        return "ISO-10303-21;\nHEADER;\nFILE_DESCRIPTION((''),'2;1');\nFILE_NAME('','',(''),(''),'','','');\n"
               "FILE_SCHEMA(('AUTOMOTIVE_DESIGN { 1 0 10303 214 1 1 1 1 }'));\nENDSEC;\nDATA;\n" +
               records_ + "ENDSEC;\nEND-ISO-10303-21;\n";
    }

private:
    template <class... Values>
    int add(const char* pattern, const Values&... values)
    {
        records_ += fmt::format("#{} = ", ++last_) + fmt::format(fmt::runtime(pattern), values...) + ";\n";
        return last_;
    }

    static std::string list(const std::vector<int>& numbers)
    {
        std::string text;
        for (const int number : numbers) text += (text.empty() ? "#" : ",#") + std::to_string(number);
        return text;
    }

    static double radius(const Corner& c) { return std::hypot(c.x, c.y); }

    int point(double x, double y, double z)
    {
        const Eigen::Vector3d p = pose_ * Eigen::Vector3d(x, y, z);
        return add("CARTESIAN_POINT('',({:#.17G},{:#.17G},{:#.17G}))", p.x(), p.y(), p.z());
    }

    int direction(const Eigen::Vector3d& unposed)
    {
        const Eigen::Vector3d d = (pose_.linear() * unposed).normalized();
        return add("DIRECTION('',({:#.17G},{:#.17G},{:#.17G}))", d.x(), d.y(), d.z());
    }

    int placement(double x, double y, double z, const Eigen::Vector3d& axis, const Eigen::Vector3d& reference)
    {
        const int at = point(x, y, z), along = direction(axis), side = direction(reference);
        return add("AXIS2_PLACEMENT_3D('',#{},#{},#{})", at, along, side);
    }

    int line(double x, double y, double z, const Eigen::Vector3d& along)
    {
        const int at = point(x, y, z);
        return add("LINE('',#{},#{})", at, add("VECTOR('',#{},1.)", direction(along)));
    }

    int face(int surface, const std::vector<std::pair<int, bool>>& edges)
    {
        std::vector<int> oriented;
        for (const auto& [edge, forward] : edges)
            oriented.push_back(add("ORIENTED_EDGE('',*,*,#{},{})", edge, forward ? ".T." : ".F."));
        const int bound = add("FACE_OUTER_BOUND('',#{},.T.)", add("EDGE_LOOP('',({}))", list(oriented)));
        return add("ADVANCED_FACE('',(#{}),#{},.T.)", bound, surface);
    }

    Eigen::Isometry3d pose_;
    std::string records_;
    std::vector<int> solids_;
    int last_ = 0;
};

inline std::vector<Corner> box(double width, double height)
{
    return {{-width / 2, -height / 2}, {width / 2, -height / 2}, {width / 2, height / 2}, {-width / 2, height / 2}};
}

inline std::vector<Corner> polygon(int sides, double radius)
{
    std::vector<Corner> corners;
    for (int i = 0; i < sides; ++i) {
        const double angle = 2 * std::acos(-1.0) * i / sides;
        corners.push_back({radius * std::cos(angle), radius * std::sin(angle)});
    }
    return corners;
}

/// A circle cut off at `distance` from its centre.
inline std::vector<Corner> flattened(double radius, double distance)
{
    const double half = std::sqrt(radius * radius - distance * distance);
    return {{half, distance, false}, {-half, distance, true}, {0, -radius, true}};
}

/// Every point and direction of a file of ours turned and moved, but for the three of its own frame, which come first
/// and which readers undo.
inline std::string posed(const std::string& text, const Eigen::Isometry3d& pose)
{
    const std::regex record(R"re((CARTESIAN_POINT|DIRECTION)\('',\(\s*([^,()]+),\s*([^,()]+),\s*([^,()]+)\)\))re");
    std::string result;
    auto last = text.cbegin();
    int number = 0;
    for (std::sregex_iterator at(text.begin(), text.end(), record), end; at != end; ++at) {
        if (++number <= 3) continue;
        const Eigen::Vector3d v(std::atof(at->str(2).c_str()), std::atof(at->str(3).c_str()),
                                std::atof(at->str(4).c_str()));
        const Eigen::Vector3d w = at->str(1) == "DIRECTION" ? Eigen::Vector3d(pose.linear() * v) : pose * v;
        result.append(last, (*at)[0].first);
        result += fmt::format("{}('',({:#.17G},{:#.17G},{:#.17G}))", at->str(1), w.x(), w.y(), w.z());
        last = (*at)[0].second;
    }
    return result.append(last, text.cend());
}

}  // namespace lathelier::cad
