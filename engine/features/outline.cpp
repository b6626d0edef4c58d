#include "engine/features/outline.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/features/selection.h"

namespace lathelier::features {
namespace {

constexpr double kGap_mm = 1.2;  // a longer stretch without data is no edge
constexpr double kRoughLeast_mm = 2.5;
constexpr double kBend = 3.4 * std::numbers::pi / 180;
constexpr std::size_t kSmear = 3;  // walls at a chain's end that blur may have made

enum class Border { Shoulder, Step, Gap, Rough, End };

/// Elements between two borders, before planes are made of these.
struct Stretch {
    std::vector<Element> elements;
    std::vector<double> nodes_mm;   ///< guesses
    double from_mm = 0, to_mm = 0;  ///< of its walls
    Border after = Border::End;
    std::vector<Wall> coarse;  ///< walls that it was made from
};

double slopeAt(const std::vector<Wall>& walls, std::size_t i)
{
    const std::size_t a = i > 0 ? i - 1 : i, b = std::min(i + 1, walls.size() - 1);
    const double dz = walls[b].z_mm - walls[a].z_mm;
    return dz > 0 ? (walls[b].r_mm - walls[a].r_mm) / dz : 0;
}

/// Walls that scatter more than noise and slope explain, over 2.5 mm or more.
std::vector<std::pair<std::size_t, std::size_t>> roughStretches(const std::vector<Wall>& walls, double sigma_mm)
{
    std::vector<char> rough(walls.size(), 0);
    for (std::size_t i = 0; i < walls.size(); ++i) {
        const double slope = slopeAt(walls, i),
                     spread = slope * slope * (walls[i].width_mm * walls[i].width_mm + 0.0225) / 12;
        rough[i] = walls[i].sigma_mm > 2.5 * std::sqrt(sigma_mm * sigma_mm + spread);
    }
    std::vector<std::pair<std::size_t, std::size_t>> stretches;
    for (std::size_t i = 0; i < walls.size();) {
        if (!rough[i]) {
            ++i;
            continue;
        }
        std::size_t last = i, calm = 0;
        for (std::size_t j = i + 1; j < walls.size() && calm < 6; ++j) {
            calm = rough[j] ? 0 : calm + 1;
            if (rough[j]) last = j;
        }
        if (walls[last].z_mm - walls[i].z_mm >= kRoughLeast_mm) stretches.emplace_back(i, last + 1);
        i = last + 1;
    }
    return stretches;
}

/// Two levels that meet in no corner: a step of the radius.
bool isStep(const Element& a, const Element& b, double z, double error_mm)
{
    if (a.arc || b.arc) return false;
    const double jump = b.radiusAt_mm(z) - a.radiusAt_mm(z), bend = a.slope - b.slope;
    if (std::abs(jump) < 5 * error_mm) return false;
    return std::abs(bend) < 1e-9 || std::abs(jump / bend) > 0.4;
}

/// Largest deviation of means over five walls from a line over [from, to].
double deviationFrom(const Run& run, double from_mm, double to_mm, double level, double slope, double at)
{
    double largest = 0, sum = 0;
    int count = 0;
    for (const Wall& wall : run.walls) {
        if (wall.z_mm < from_mm + 0.1 || wall.z_mm > to_mm - 0.1) continue;
        sum += wall.r_mm - level - slope * (wall.z_mm - at);
        if (++count == 5) {
            largest = std::max(largest, std::abs(sum / 5));
            sum = count = 0;
        }
    }
    return largest;
}

/// Is the jump between two pieces a step of the part, and not wear? A jump within the form tolerance is one only
/// between pieces that are level as far as their walls tell.
bool isGenuine(const Piece& a, const Piece& b, double jump_mm, double form_mm)
{
    if (std::abs(jump_mm) > form_mm) return true;
    const auto level = [](const Piece& piece) { return !piece.arc && std::abs(piece.slope) < 4 * piece.slope_error; };
    return level(a) && level(b);
}

double radiusOf(const Piece& piece, double z)
{
    if (!piece.arc) return piece.level_mm + piece.slope * (z - piece.at_mm);
    const double off = z - piece.centre_z_mm;
    return piece.centre_r_mm +
           (piece.convex ? 1 : -1) * std::sqrt(std::max(0.0, piece.radius_mm * piece.radius_mm - off * off));
}

double slopeOf(const Piece& piece, double z)
{
    constexpr double h = 0.05;
    return (radiusOf(piece, z + h) - radiusOf(piece, z - h)) / (2 * h);
}

/// Pieces of a worn seat as one: neighbours that a cylinder or a cone describes within the form tolerance, without
/// bends and genuine steps between them.
void mergeWear(std::vector<Piece>& pieces, const std::vector<Wall>& walls, double form_mm,
               std::vector<MergedJunction>& merged)
{
    if (!(form_mm > 0)) return;
    const auto joins = [&](std::size_t k) {
        const double z = (walls[pieces[k].end - 1].z_mm + walls[pieces[k + 1].begin].z_mm) / 2;
        const double jump = radiusOf(pieces[k + 1], z) - radiusOf(pieces[k], z);
        const double bend = std::atan(slopeOf(pieces[k + 1], z)) - std::atan(slopeOf(pieces[k], z));
        return MergedJunction{z, 1e3 * jump, bend * 180 / std::numbers::pi};
    };
    for (std::size_t i = 0; i + 1 < pieces.size(); ++i)
        for (std::size_t j = pieces.size() - 1; j > i; --j) {
            bool possible = true;
            for (std::size_t k = i; k < j && possible; ++k) {
                const MergedJunction join = joins(k);
                const double small = 5e-3 * walls[pieces[k].end - 1].sigma_mm;  // no jump at all
                possible = std::abs(join.angle_deg) < kBend * 180 / std::numbers::pi &&
                           (std::abs(join.step_um) < small ||
                            !isGenuine(pieces[k], pieces[k + 1], 1e-3 * join.step_um, form_mm));
            }
            if (!possible) continue;
            Run seat;
            seat.walls.assign(walls.begin() + static_cast<std::ptrdiff_t>(pieces[i].begin),
                              walls.begin() + static_cast<std::ptrdiff_t>(pieces[j].end));
            double n = 0, sz = 0, sr = 0, szz = 0, szr = 0;
            for (const Wall& wall : seat.walls) {
                n += wall.points;
                sz += wall.points * wall.z_mm;
                sr += wall.points * wall.r_mm;
                szz += wall.points * wall.z_mm * wall.z_mm;
                szr += wall.points * wall.z_mm * wall.r_mm;
            }
            Piece one = pieces[i];
            one.end = pieces[j].end;
            one.arc = false;
            one.at_mm = sz / n;
            one.level_mm = sr / n;
            one.slope = 0;
            const double from = seat.walls.front().z_mm, to = seat.walls.back().z_mm;
            bool fits = deviationFrom(seat, from, to, one.level_mm, 0, one.at_mm) <= form_mm;
            if (!fits) {
                one.slope = (szr - sz * sr / n) / std::max(1e-12, szz - sz * sz / n);
                fits = deviationFrom(seat, from, to, one.level_mm, one.slope, one.at_mm) <= form_mm;
            }
            if (!fits) continue;
            for (std::size_t k = i; k < j; ++k) merged.push_back(joins(k));
            pieces.erase(pieces.begin() + static_cast<std::ptrdiff_t>(i) + 1,
                         pieces.begin() + static_cast<std::ptrdiff_t>(j) + 1);
            pieces[i] = one;
            break;
        }
}

/// Cuts walls of one chain into stretches at steps.
void addStretches(std::vector<Stretch>& stretches, const std::vector<Wall>& walls, bool trim_start, bool trim_end,
                  double form_mm, Border after, std::vector<MergedJunction>& merged, const Progress& progress)
{
    std::vector<Piece> pieces = cutIntoPieces(walls, progress);
    if (pieces.empty()) return;
    if (trim_start && pieces.size() > 1 && pieces.front().end - pieces.front().begin <= kSmear)
        pieces.erase(pieces.begin());
    if (trim_end && pieces.size() > 1 && pieces.back().end - pieces.back().begin <= kSmear) pieces.pop_back();
    mergeWear(pieces, walls, form_mm, merged);
    const std::vector<Element> elements = elementsOf(pieces, walls, form_mm);
    Stretch stretch;
    stretch.from_mm = walls.front().z_mm;
    stretch.nodes_mm = {walls.front().z_mm};
    for (std::size_t k = 0; k < elements.size(); ++k) {
        stretch.elements.push_back(elements[k]);
        const bool last = k + 1 == elements.size();
        const double z =
            last ? walls.back().z_mm : (walls[pieces[k].end - 1].z_mm + walls[pieces[k + 1].begin].z_mm) / 2;
        stretch.nodes_mm.push_back(z);
        const Wall& wall = walls[pieces[k].end - 1];
        const double few = static_cast<double>(
            std::min(pieces[k].end - pieces[k].begin, last ? std::size_t{1} : pieces[k + 1].end - pieces[k + 1].begin));
        const double error = 2 * wall.sigma_mm / std::sqrt(std::max(1.0, wall.points * few));
        if (!last && !isStep(elements[k], elements[k + 1], z, error)) continue;
        stretch.to_mm = z;
        stretch.after = last ? after : Border::Step;
        for (const Wall& one : walls)
            if (one.z_mm >= stretch.from_mm - 1e-9 && one.z_mm <= z + 1e-9) stretch.coarse.push_back(one);
        stretches.push_back(stretch);
        stretch = {};
        stretch.from_mm = z;
        stretch.nodes_mm = {z};
    }
}

/// First harmonic of the points' radii between two heights: mean, and how far off the axis their circle is.
struct Circle {
    double radius_mm = 0, offset_mm = 0, sigma_mm = 0;
    double crest_mm = 0;  ///< radius that the outermost eighth of the points has
    double root_mm = 0;   ///< radius that one in fifty lies below
};

Circle circleOf(const MeridianCloud& cloud, double from_mm, double to_mm, double about_mm)
{
    std::vector<std::pair<double, double>> points;
    for (std::size_t i = 0; i < cloud.z_mm.size(); ++i) {
        const double z = static_cast<double>(cloud.z_mm[i]), r = static_cast<double>(cloud.r_mm[i]);
        if (z > from_mm && z < to_mm && std::abs(r - about_mm) < std::max(2.0, 0.2 * about_mm))
            points.emplace_back(2 * std::numbers::pi * static_cast<double>(cloud.turn[i]), r);
    }
    Circle circle;
    if (points.size() < 30) return circle;
    Eigen::Vector3d found(about_mm, 0, 0);
    double limit = 1e9;
    for (int round = 0; round < 5; ++round) {
        Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
        Eigen::Vector3d right = Eigen::Vector3d::Zero();
        std::vector<double> offs;
        for (const auto& [angle, r] : points) {
            const Eigen::Vector3d row(1, std::cos(angle), std::sin(angle));
            const double off = r - row.dot(found);
            offs.push_back(std::abs(off));
            if (std::abs(off) > limit) continue;
            normal += row * row.transpose();
            right += row * r;
        }
        found = normal.ldlt().solve(right);
        std::nth_element(offs.begin(), offs.begin() + static_cast<std::ptrdiff_t>(offs.size() / 2), offs.end());
        circle.sigma_mm = 1.4826 * offs[offs.size() / 2];
        limit = 4 * circle.sigma_mm;
    }
    circle.radius_mm = found[0];
    circle.offset_mm = found.tail<2>().norm();
    std::vector<double> radii;
    for (const auto& point : points) radii.push_back(point.second);
    const auto crest = radii.begin() + static_cast<std::ptrdiff_t>(0.9375 * static_cast<double>(radii.size()));
    std::nth_element(radii.begin(), crest, radii.end());
    circle.crest_mm = *crest;
    const auto root = radii.begin() + static_cast<std::ptrdiff_t>(0.02 * static_cast<double>(radii.size()));
    std::nth_element(radii.begin(), root, radii.end());
    circle.root_mm = *root;
    return circle;
}

/// Chains of one side, those dropped that lie beside a longer one.
std::vector<const Chain*> chainsOf(const Walls& walls, bool bore)
{
    std::vector<const Chain*> chains;
    for (const Chain& chain : walls.chains)
        if (chain.bore == bore) chains.push_back(&chain);
    std::vector<const Chain*> kept;
    for (const Chain* one : chains) {
        const bool hidden = std::any_of(chains.begin(), chains.end(), [&](const Chain* other) {
            if (other == one || other->walls.size() <= one->walls.size()) return false;
            const double from = std::max(one->zFirst_mm(), other->zFirst_mm()),
                         to = std::min(one->zLast_mm(), other->zLast_mm());
            return to - from > 0.5 * (one->zLast_mm() - one->zFirst_mm());
        });
        if (!hidden) kept.push_back(one);
    }
    std::sort(kept.begin(), kept.end(), [](const Chain* a, const Chain* b) {
        return a->zFirst_mm() + a->zLast_mm() < b->zFirst_mm() + b->zLast_mm();
    });
    return kept;
}

std::vector<Stretch> stretchesOf(const OutlineInput& input, Outline& outline, const Progress& progress)
{
    const std::vector<const Chain*> chains = chainsOf(input.coarse, input.bore);
    std::vector<Stretch> stretches;
    for (std::size_t c = 0; c < chains.size(); ++c) {
        const std::vector<Wall>& walls = chains[c]->walls;
        Border after = Border::End;
        bool trim_end = false;
        if (c + 1 < chains.size()) {
            const double apart = chains[c + 1]->zFirst_mm() - walls.back().z_mm;
            after = apart > kGap_mm ? Border::Gap : Border::Shoulder;
            trim_end = after == Border::Shoulder;
        }
        const bool trim_start = !stretches.empty() && stretches.back().after == Border::Shoulder;
        std::size_t at = 0;
        for (const auto& [from, to] : roughStretches(walls, input.coarse.sigma_mm)) {
            if (from > at + 2)
                addStretches(stretches,
                             {walls.begin() + static_cast<std::ptrdiff_t>(at),
                              walls.begin() + static_cast<std::ptrdiff_t>(from)},
                             trim_start && at == 0, true, input.form_mm, Border::Rough, outline.merged, progress);
            Stretch rough;
            rough.from_mm = walls[from].z_mm;
            rough.to_mm = walls[to - 1].z_mm;
            rough.nodes_mm = {rough.from_mm, rough.to_mm};
            rough.coarse.assign(walls.begin() + static_cast<std::ptrdiff_t>(from),
                                walls.begin() + static_cast<std::ptrdiff_t>(to));
            double mean = 0;
            for (const Wall& wall : rough.coarse) mean += wall.r_mm / static_cast<double>(rough.coarse.size());
            const Circle circle = circleOf(input.cloud, rough.from_mm, rough.to_mm, mean);
            const bool eccentric =
                circle.sigma_mm > 0 && circle.sigma_mm < 1.6 * input.coarse.sigma_mm && circle.offset_mm > 0.05;
            Element cylinder;
            cylinder.cylinder = cylinder.rough = true;
            cylinder.at_mm = (rough.from_mm + rough.to_mm) / 2;
            cylinder.level_mm = eccentric ? circle.radius_mm : circle.crest_mm > 0 ? circle.crest_mm : mean;
            cylinder.root_mm = eccentric || circle.root_mm <= 0 ? cylinder.level_mm : circle.root_mm;
            rough.elements = {cylinder};
            rough.after = to < walls.size() ? Border::Rough : after;
            outline.rough.push_back({rough.from_mm, rough.to_mm, eccentric ? circle.offset_mm : 0});
            stretches.push_back(rough);
            at = to;
        }
        if (at + 2 < walls.size())
            addStretches(stretches, {walls.begin() + static_cast<std::ptrdiff_t>(at), walls.end()},
                         (trim_start && at == 0) || at > 0, trim_end, input.form_mm, after, outline.merged, progress);
        else if (!stretches.empty())
            stretches.back().after = after;
    }
    return stretches;
}

/// Walls of the fine bins that belong to the stretch: near the walls that it was made from.
std::vector<Wall> wallsOf(const OutlineInput& input, const Stretch& stretch)
{
    std::vector<Wall> walls;
    if (stretch.coarse.empty() || stretch.elements.front().rough) return walls;
    for (const Chain* chain : chainsOf(input.fine, input.bore))
        for (const Wall& wall : chain->walls) {
            if (wall.z_mm < stretch.from_mm - 0.5 || wall.z_mm > stretch.to_mm + 0.5) continue;
            const auto next = std::lower_bound(stretch.coarse.begin(), stretch.coarse.end(), wall.z_mm,
                                               [](const Wall& one, double z) { return one.z_mm < z; });
            const auto near = next == stretch.coarse.end() ? next - 1 : next;
            const auto index = static_cast<std::size_t>(near - stretch.coarse.begin());
            const double slope = std::abs(slopeAt(stretch.coarse, index));
            if (std::abs(wall.r_mm - near->r_mm) < 0.3 + 2 * slope * std::abs(wall.z_mm - near->z_mm) + slope * 0.2)
                walls.push_back(wall);
        }
    std::sort(walls.begin(), walls.end(), [](const Wall& a, const Wall& b) { return a.z_mm < b.z_mm; });
    return walls;
}

void makeModel(const OutlineInput& input, const std::vector<Stretch>& stretches, Outline& outline,
               std::vector<Border>& borders)
{
    Model& model = outline.model;
    model.sigma_mm = input.fine.sigma_mm;
    model.spot_mm = 0.1;
    const auto plane = [&](double z, double sigma, bool data_end, Border border) {
        Plane made;
        made.z_mm = made.seen_mm = z;
        made.sigma_mm = sigma;
        made.data_end = data_end;
        model.planes.push_back(made);
        borders.push_back(border);
        return model.planes.size() - 1;
    };
    std::size_t left = plane(stretches.front().from_mm - input.fine.bin_mm / 2, 0.05, false, Border::End);
    for (std::size_t s = 0; s < stretches.size(); ++s) {
        const Stretch& stretch = stretches[s];
        Run run;
        run.elements = stretch.elements;
        run.nodes_mm = stretch.nodes_mm;
        run.walls = wallsOf(input, stretch);
        run.left = left;
        if (s + 1 == stretches.size()) {
            run.right = plane(stretch.to_mm + input.fine.bin_mm / 2, 0.05, false, Border::End);
        } else if (stretch.after == Border::Gap) {
            run.right = plane(stretch.to_mm, 0.05, true, Border::Gap);
            left = plane(stretches[s + 1].from_mm, 0.05, true, Border::Gap);
            outline.gaps.push_back({stretch.to_mm, stretches[s + 1].from_mm});
        } else {
            const bool own_rough = stretch.elements.front().rough, next_rough = stretches[s + 1].elements.front().rough;
            const double z = own_rough                           ? stretch.to_mm
                             : next_rough                        ? stretches[s + 1].from_mm
                             : stretch.after == Border::Shoulder ? (stretch.to_mm + stretches[s + 1].from_mm) / 2
                                                                 : stretch.to_mm;
            run.right = left = plane(z, 0.1, false, stretch.after);
        }
        model.runs.push_back(std::move(run));
    }
    for (Run& run : model.runs) resolve(model, run);
}

/// Smallest and largest radius of a run within a distance of one of its planes.
std::pair<double, double> radiiNear(const Run& run, bool start, double reach_mm)
{
    const double from = start ? run.nodes_mm.front() : std::max(run.nodes_mm.front(), run.nodes_mm.back() - reach_mm);
    const double to = start ? std::min(run.nodes_mm.back(), run.nodes_mm.front() + reach_mm) : run.nodes_mm.back();
    double low = 1e300, high = -1e300;
    for (int k = 0; k <= 20; ++k) {
        const double r = radiusAt_mm(run, from + (to - from) * k / 20);
        low = std::min(low, r);
        high = std::max(high, r);
    }
    return {low, high};
}

/// A small step of the radius: the place that the points between the two levels change at.
void placeStep(const OutlineInput& input, Model& model, std::size_t p, const Run& a, const Run& b)
{
    Plane& plane = model.planes[p];
    const double before = endRadius_mm(a), after = startRadius_mm(b), jump = after - before;
    const double reach =
        std::min({3.0, 0.4 * (a.nodes_mm.back() - a.nodes_mm.front()), 0.4 * (b.nodes_mm.back() - b.nodes_mm.front())});
    std::vector<std::pair<double, double>> points;
    const double clip = 3 * model.sigma_mm;
    for (std::size_t i = 0; i < input.cloud.z_mm.size(); ++i) {
        const double z = static_cast<double>(input.cloud.z_mm[i]);
        if (std::abs(z - plane.z_mm) > reach) continue;
        const double off = static_cast<double>(input.cloud.r_mm[i]) - (before + after) / 2;
        if (std::abs(off) < 2 * clip) points.emplace_back(z, std::clamp(off, -clip, clip));
    }
    if (points.size() < 40 || jump == 0) return;
    std::sort(points.begin(), points.end());
    double sum = 0, best = 0, place = plane.z_mm;
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
        sum += points[i].second * (jump > 0 ? -1 : 1);
        if (sum > best) {
            best = sum;
            place = (points[i].first + points[i + 1].first) / 2;
        }
    }
    const double density = static_cast<double>(points.size()) / (2 * reach);
    plane.z_mm = plane.seen_mm = place;
    // Spread of the likeliest change point of a mean: about 5 σ²/(Δ²·density) (Hinkley 1970).
    plane.sigma_mm = std::max(0.005, 5 * model.sigma_mm * model.sigma_mm / (jump * jump * density));
}

/// Sees where the planes are, with the radii as the model has them now.
void placePlanes(const OutlineInput& input, Outline& outline, const std::vector<Border>& borders,
                 const Progress& progress)
{
    Model& model = outline.model;
    std::vector<registration::Edge> edges;
    std::vector<std::size_t> plane_of;
    double walls = 0, area = 0;
    for (const Run& run : model.runs)
        for (const Wall& wall : run.walls) {
            walls += wall.points;
            area += 2 * std::numbers::pi * wall.r_mm * input.fine.bin_mm;
        }
    const double density = area > 0 ? walls / area : 0;
    int faces = 0, sought = 0;
    const double lean = input.scanner ? std::hypot(input.scanner->direction.x(), input.scanner->direction.y()) /
                                            std::abs(input.scanner->direction.z())
                                      : 0;
    for (std::size_t r = 0; r + 1 < model.runs.size(); ++r) {
        const Run &a = model.runs[r], &b = model.runs[r + 1];
        if (a.right != b.left) continue;
        Plane& plane = model.planes[a.right];
        if (borders[a.right] == Border::Step) {
            placeStep(input, model, a.right, a, b);
            continue;
        }
        const double room = std::min(
            {1.0, 0.45 * (a.nodes_mm.back() - a.nodes_mm.front()), 0.45 * (b.nodes_mm.back() - b.nodes_mm.front())});
        const auto [a_low, a_high] = radiiNear(a, false, room);
        const auto [b_low, b_high] = radiiNear(b, true, room);
        const bool a_rough = a.elements.back().rough, b_rough = b.elements.front().rough;
        const double end = a_rough ? a.elements.back().root_mm : endRadius_mm(a);
        const double start = b_rough ? b.elements.front().root_mm : startRadius_mm(b);
        const bool rises = start > end;
        plane.lean = lean * std::abs(start - end);
        if (borders[a.right] == Border::Rough && std::abs(start - end) < 4 * model.sigma_mm) continue;
        ++sought;
        if (const auto face = seenFace(input.cloud, plane.z_mm, std::min(start, end), std::max(start, end),
                                       model.sigma_mm, density)) {
            plane.z_mm = plane.seen_mm = face->z_mm;
            plane.sigma_mm = face->sigma_mm;
            ++faces;
            continue;
        }
        registration::Edge edge;
        edge.z_mm = plane.z_mm;
        edge.sign = rises ? 1 : -1;
        edge.before_mm = rises ? a_low : end;
        edge.after_mm = rises ? start : b_low;
        edge.above_mm = std::max(0.0, rises ? b_high - start : a_high - end);
        edge.from_mm = plane.z_mm - room;
        edge.to_mm = plane.z_mm + room;
        if (std::abs(edge.after_mm - edge.before_mm) < 4 * model.sigma_mm) continue;
        edges.push_back(edge);
        plane_of.push_back(a.right);
    }
    if (!edges.empty() && !input.bore) {
        std::vector<double> spots;
        const auto rays = registration::findEdgeRays(input.points_mm, input.fit, edges, progress);
        for (std::size_t e = 0; e < edges.size(); ++e)
            if (const auto place = placeOf(rays[e])) {
                Plane& plane = model.planes[plane_of[e]];
                plane.z_mm = plane.seen_mm = place->z_mm;
                plane.sigma_mm = place->sigma_mm;
                spots.push_back(place->spot_mm);
            }
        if (!spots.empty()) {
            std::sort(spots.begin(), spots.end());
            model.spot_mm = spots[spots.size() / 2];
        }
    }
    // Ends.
    for (const bool start : {true, false}) {
        const std::size_t p = start ? model.runs.front().left : model.runs.back().right;
        Plane& plane = model.planes[p];
        const Run& run = start ? model.runs.front() : model.runs.back();
        const double radius = start ? startRadius_mm(run) : endRadius_mm(run);
        const auto part_end = std::find_if(input.part_ends.begin(), input.part_ends.end(),
                                           [&](const Plane& end) { return std::abs(end.z_mm - plane.z_mm) < 1; });
        if (part_end != input.part_ends.end()) {
            plane.z_mm = plane.seen_mm = part_end->z_mm;
            plane.sigma_mm = std::max(1e-4, part_end->sigma_mm);
            continue;
        }
        ++sought;
        if (const auto face = input.bore
                                  ? std::nullopt
                                  : seenFace(input.cloud, plane.z_mm, 0.55 * radius, radius, model.sigma_mm, density)) {
            plane.z_mm = plane.seen_mm = face->z_mm;
            plane.sigma_mm = face->sigma_mm;
            outline.face_seen[start ? 0 : 1] = true;
            ++faces;
        } else if (!run.elements.front().rough) {
            outline.ends[start ? 0 : 1] = endOf(input.cloud, model, run, start, input.scanner);
            if (const auto& end = outline.ends[start ? 0 : 1]) {
                plane.z_mm = plane.seen_mm = end->place.z_mm;
                plane.sigma_mm = end->place.sigma_mm;
            }
        }
    }
    outline.surface_scan = !input.scanner && faces > 0 && 2 * faces >= sought;
    if (outline.surface_scan || (input.bore && !input.scanner)) {
        model.corner_mm = model.edge_mm = 0.16;
        model.spot_mm = 0;
    }
    for (Run& run : model.runs) resolve(model, run);
}

}  // namespace

std::vector<MergedJunction> mergeWithinForm(Model& model, double form_mm)
{
    std::vector<MergedJunction> merged;
    if (!(form_mm > 0)) return merged;
    for (Run& run : model.runs)
        for (std::size_t i = 0; i < run.elements.size(); ++i)
            for (std::size_t j = run.elements.size() - 1; j + 1 > i; --j) {
                if (i == j && !run.elements[i].arc && run.elements[i].cylinder) break;
                if (std::any_of(run.elements.begin() + static_cast<std::ptrdiff_t>(i),
                                run.elements.begin() + static_cast<std::ptrdiff_t>(j) + 1,
                                [](const Element& e) { return e.rough; }))
                    continue;
                const double from = run.nodes_mm[i], to = run.nodes_mm[j + 1];
                // What bends is designed, whatever its size.
                bool bends = false;
                for (std::size_t k = i; k < j; ++k) {
                    const double z = run.nodes_mm[k + 1];
                    bends |= std::abs(std::atan(run.elements[k + 1].slopeAt(z)) -
                                      std::atan(run.elements[k].slopeAt(z))) > kBend;
                }
                if (bends) continue;
                // Weighted least squares of a cylinder and a cone over the seat.
                double n = 0, sz = 0, sr = 0, szz = 0, szr = 0;
                for (const Wall& wall : run.walls) {
                    if (wall.z_mm < from + 0.1 || wall.z_mm > to - 0.1) continue;
                    n += wall.points;
                    sz += wall.points * wall.z_mm;
                    sr += wall.points * wall.r_mm;
                    szz += wall.points * wall.z_mm * wall.z_mm;
                    szr += wall.points * wall.z_mm * wall.r_mm;
                }
                if (!(n > 0) || to - from < 1) continue;
                Element one;
                one.at_mm = sz / n;
                one.level_mm = sr / n;
                one.cylinder = true;
                bool fits = deviationFrom(run, from, to, one.level_mm, 0, one.at_mm) <= form_mm;
                if (!fits && i != j) {
                    one.cylinder = false;
                    one.slope = (szr - sz * sr / n) / std::max(1e-12, szz - sz * sz / n);
                    fits = deviationFrom(run, from, to, one.level_mm, one.slope, one.at_mm) <= form_mm;
                }
                if (!fits) continue;
                for (std::size_t k = i; k < j; ++k) {
                    const double z = run.nodes_mm[k + 1];
                    const double bend =
                        std::atan(run.elements[k + 1].slopeAt(z)) - std::atan(run.elements[k].slopeAt(z));
                    merged.push_back({z, 1e3 * (run.elements[k + 1].radiusAt_mm(z) - run.elements[k].radiusAt_mm(z)),
                                      bend * 180 / std::numbers::pi});
                }
                run.elements.erase(run.elements.begin() + static_cast<std::ptrdiff_t>(i),
                                   run.elements.begin() + static_cast<std::ptrdiff_t>(j));
                run.elements[i] = one;
                run.nodes_mm.erase(run.nodes_mm.begin() + static_cast<std::ptrdiff_t>(i) + 1,
                                   run.nodes_mm.begin() + static_cast<std::ptrdiff_t>(j) + 1);
                for (const std::size_t k : {i - 1, i + 1}) {
                    if (k >= run.elements.size() || !run.elements[k].arc) continue;
                    if (k + 1 == i) run.elements[k].end = Tie::Free;
                    if (k == i + 1) run.elements[k].start = Tie::Free;
                }
                resolve(model, run);
                break;
            }
    return merged;
}

namespace {

/// A thread or knurl that begins on a cone: the row over its crests begins where the cone reaches them.
void meetCones(Model& model, const std::vector<Border>& borders)
{
    constexpr double reach_mm = 3;
    for (std::size_t r = 0; r + 1 < model.runs.size(); ++r) {
        Run &a = model.runs[r], &b = model.runs[r + 1];
        if (a.right != b.left || borders[a.right] != Border::Rough) continue;
        const bool first_rough = a.elements.back().rough;
        const Element& cone = first_rough ? b.elements.front() : a.elements.back();
        const double crest = first_rough ? a.elements.back().level_mm : b.elements.front().level_mm;
        if (cone.arc || std::abs(cone.slope) < 0.2) continue;
        const double z = cone.at_mm + (crest - cone.level_mm) / cone.slope;
        Plane& plane = model.planes[a.right];
        const bool inside = z > a.nodes_mm[a.nodes_mm.size() - 2] && z < b.nodes_mm[1];
        if (std::abs(z - plane.z_mm) > reach_mm || !inside) continue;
        plane.z_mm = plane.seen_mm = z;
        plane.sigma_mm = 0.02;
        resolve(model, a);
        resolve(model, b);
    }
}

}  // namespace

std::optional<Outline> settleOutline(const OutlineInput& input, const Progress& progress)
{
    Outline outline;
    const std::vector<Stretch> stretches = stretchesOf(input, outline, progress.part(0, 0.1));
    if (stretches.empty()) return std::nullopt;
    std::vector<Border> borders;
    makeModel(input, stretches, outline, borders);
    Model& model = outline.model;
    placePlanes(input, outline, borders, progress);
    fitAll(model, 6, progress);
    placePlanes(input, outline, borders, progress);
    progress.report(0.3);
    simplify(model, progress);
    selectKinds(model, progress);
    selectKinds(model, progress);
    fitAll(model, 8, progress);
    progress.report(0.6);
    tryCorners(model, progress);
    simplify(model, progress);
    selectKinds(model, progress);
    selectKinds(model, progress);
    simplify(model, progress);
    for (const MergedJunction& junction : mergeWithinForm(model, input.form_mm)) outline.merged.push_back(junction);
    fitAll(model, 8, progress);
    placePlanes(input, outline, borders, progress);
    outline.fit = fitAll(model, 25, progress);
    meetCones(model, borders);
    progress.report(1);
    return outline;
}

}  // namespace lathelier::features
