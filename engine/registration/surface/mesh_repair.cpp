#include "engine/registration/surface/mesh_repair.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>

#include "engine/registration/neighbours/neighbours.h"
#include "engine/registration/senses.h"
#include "engine/registration/surface/mesh_hole.h"

namespace lathelier::registration {
namespace {

using Eigen::Vector3d;

constexpr double sameCornerShare = 1e-3;    // of the shortest rim edge at a corner
constexpr double smallHoleShare = 0.05;     // of the mesh's extent
constexpr double largestFilledShare = 0.4;  // of the area of the piece around it
constexpr std::size_t longestRim = 100;

class Repair {
public:
    Repair(const Scan& mesh, const Progress& progress) : mesh_(mesh), progress_(progress)
    {
        result_.corners = numberCorners(mesh.points_mm);
        result_.triangles = mesh.triangles;
    }

    RepairedMesh run()
    {
        findEdges();
        stitch();
        turn();
        progress_.report(0.6);
        fill();
        return std::move(result_);
    }

private:
    void findEdges()
    {
        progress_.check();
        std::vector<TriangleCorners> numbered;
        numbered.reserve(result_.triangles.size());
        for (const TriangleCorners& t : result_.triangles) numbered.push_back(result_.corners.of(t));
        edges_ = edgesOf(numbered);
        progress_.check();
    }

    const Vector3d& start(const MeshEdge& e) const { return mesh_.points_mm[result_.triangles[e.triangle][e.side]]; }
    const Vector3d& end(const MeshEdge& e) const
    {
        return mesh_.points_mm[result_.triangles[e.triangle][(e.side + 1U) % 3]];
    }

    double areaOf(const TriangleCorners& t) const
    {
        const Vector3d& p = mesh_.points_mm[t[0]];
        return (mesh_.points_mm[t[1]] - p).cross(mesh_.points_mm[t[2]] - p).norm() / 2;
    }

    std::vector<MeshEdge> rims() const
    {
        std::vector<MeshEdge> result;
        forEachEdge(edges_, [&](std::size_t first, std::size_t last) {
            if (last - first == 1) result.push_back(edges_[first]);
        });
        return result;
    }

    void stitch()
    {
        // Each corner on a rim, where it lies and how short its edges are.
        struct RimCorner {
            std::uint32_t number;
            Vector3d at_mm;
            double edge_mm;
        };
        std::vector<RimCorner> corners;
        for (const MeshEdge& e : rims()) {
            const double length = (end(e) - start(e)).norm();
            const std::uint32_t from = e.forward ? e.low() : e.high();
            const std::uint32_t to = e.forward ? e.high() : e.low();
            corners.push_back({from, start(e), length});
            corners.push_back({to, end(e), length});
        }
        if (corners.empty()) return;
        std::sort(corners.begin(), corners.end(), [](const RimCorner& a, const RimCorner& b) {
            return a.number != b.number ? a.number < b.number : a.edge_mm < b.edge_mm;
        });
        corners.erase(std::unique(corners.begin(), corners.end(),
                                  [](const RimCorner& a, const RimCorner& b) { return a.number == b.number; }),
                      corners.end());
        std::vector<Vector3d> places;
        places.reserve(corners.size());
        for (const RimCorner& c : corners) places.push_back(c.at_mm);
        const Neighbours index(places, progress_);
        Senses same(result_.corners.count);
        bool any = false;
        std::vector<Neighbours::Found> found;
        for (const RimCorner& c : corners) {
            const double near = sameCornerShare * c.edge_mm;
            index.nearest(c.at_mm, 4, near * near, found);
            for (const Neighbours::Found& f : found) {
                const RimCorner& other = corners[index.input(f.place)];
                if (other.number == c.number || f.squared_mm2 > std::pow(sameCornerShare * other.edge_mm, 2)) continue;
                same.join(c.number, other.number, false);
                any = true;
            }
        }
        if (!any) return;
        bool flipped = false;
        for (std::uint32_t& number : result_.corners.of_vertex) number = same.root(number, flipped);
        findEdges();
    }

    void turn()
    {
        const auto agrees = [&](std::size_t first) { return edges_[first].forward != edges_[first + 1].forward; };
        bool all_agree = true;
        Senses senses(result_.triangles.size());
        forEachEdge(edges_, [&](std::size_t first, std::size_t last) {
            if (last - first != 2) return;
            all_agree = all_agree && agrees(first);
            senses.join(edges_[first].triangle, edges_[first + 1].triangle, !agrees(first));
        });
        std::vector<double> turned_area(result_.triangles.size(),
                                        0);  // of each piece: area of the turned facets minus that of the others
        std::vector<std::uint8_t> flips(result_.triangles.size());
        pieces_.resize(result_.triangles.size());
        pieceArea_.assign(result_.triangles.size(), 0);
        for (std::uint32_t t = 0; t < result_.triangles.size(); ++t) {
            bool flipped = false;
            pieces_[t] = senses.root(t, flipped);
            flips[t] = flipped;
            const double area = areaOf(result_.triangles[t]);
            pieceArea_[pieces_[t]] += area;
            turned_area[pieces_[t]] += flipped ? area : -area;
        }
        if (all_agree) return;
        for (std::uint32_t t = 0; t < result_.triangles.size(); ++t) {
            if ((flips[t] != 0) == (turned_area[pieces_[t]] > 0)) continue;
            std::swap(result_.triangles[t][1], result_.triangles[t][2]);
            ++result_.facets_turned;
        }
        findEdges();
    }

    void fill()
    {
        // The rim runs against its triangles: from the end of their side to its start.
        const std::vector<MeshEdge> rim = rims();
        constexpr auto none = std::numeric_limits<std::uint32_t>::max();
        constexpr auto several = none - 1;
        std::vector<std::uint32_t> next(result_.corners.count, none);
        for (std::uint32_t i = 0; i < rim.size(); ++i) {
            std::uint32_t& from = next[rim[i].forward ? rim[i].high() : rim[i].low()];
            from = from == none ? i : several;
        }
        Eigen::AlignedBox3d all;
        for (const Vector3d& p : mesh_.points_mm) all.extend(p);
        std::vector<bool> seen(rim.size(), false);
        for (std::uint32_t first = 0; first < rim.size(); ++first) {
            std::vector<Vector3d> places;
            std::vector<std::uint32_t> vertices;
            Eigen::AlignedBox3d box;
            std::uint32_t i = first;
            while (i < several && !seen[i]) {
                seen[i] = true;
                const MeshEdge& e = rim[i];
                vertices.push_back(result_.triangles[e.triangle][(e.side + 1U) % 3]);
                places.push_back(end(e));
                box.extend(end(e));
                i = next[e.forward ? e.low() : e.high()];
            }
            if (i != first || places.size() < 3 || places.size() > longestRim) continue;
            const double extent = box.diagonal().norm();
            if (places.size() > 3 && extent > smallHoleShare * all.diagonal().norm()) continue;
            progress_.check();
            const std::vector<TriangleCorners> patch = fillHole(places);
            const std::size_t before = result_.triangles.size();
            double area = 0;
            for (const TriangleCorners& t : patch) {
                result_.triangles.push_back({vertices[t[0]], vertices[t[1]], vertices[t[2]]});
                area += areaOf(result_.triangles.back());
            }
            // The boundary of a small open piece is no hole: its filling would be as large as the piece.
            if (patch.empty() || area > largestFilledShare * pieceArea_[pieces_[rim[first].triangle]]) {
                result_.triangles.resize(before);
                continue;
            }
            ++result_.holes_filled;
            result_.largest_hole_mm = std::max(result_.largest_hole_mm, extent);
        }
    }

    const Scan& mesh_;
    const Progress& progress_;
    RepairedMesh result_;
    std::vector<MeshEdge> edges_;
    std::vector<std::uint32_t> pieces_;  ///< of each triangle of the mesh: the connected piece it belongs to
    std::vector<double> pieceArea_;
};

}  // namespace

RepairedMesh repairMesh(const Scan& mesh, const Progress& progress)
{
    return Repair(mesh, progress).run();
}

}  // namespace lathelier::registration
