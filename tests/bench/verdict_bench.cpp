// How often the verdict about the surface is right: fresh noise and poses, several kinds of part, noise and scan.
// Prints one line for each case; --runs N (default 20), --only TEXT for the cases whose name holds TEXT.
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <string>
#include <vector>

#include "engine/core/random.h"
#include "engine/registration/compare.h"
#include "engine/registration/surface/surface_samples.h"
#include "engine/registration/verdict/verdict.h"
#include "tests/engine/registration/bumped_scan.h"
#include "tests/engine/registration/lost_ends.h"
#include "tests/engine/registration/stepped_scan.h"
#include "tests/engine/registration/synthetic_pair.h"

namespace lathelier {
namespace {

using registration::compare;
using registration::CompareParameters;
using registration::CompareResult;
using registration::Finding;

/// What a case counts over its runs.
struct Tally {
    int runs = 0, pass = 0, undecided = 0, fail = 0, wrong = 0;
    int covered = 0, stated = 0;  ///< how often a stated U held the truth, of how many
    double largest_u_mm = 0;
    double largest_error_mm = 0;

    void add(const CompareResult& result)
    {
        ++runs;
        if (!result.verdict) return;
        pass += *result.verdict == Verdict::Pass;
        undecided += *result.verdict == Verdict::Undecided;
        fail += *result.verdict == Verdict::Fail;
    }
    void state(double value, double uncertainty, double truth)
    {
        ++stated;
        covered += std::abs(value - truth) <= uncertainty;
        largest_u_mm = std::max(largest_u_mm, uncertainty);
        largest_error_mm = std::max(largest_error_mm, std::abs(value - truth));
    }
};

/// By decision rule.
struct Tallies {
    Tally rejection, simple, guarded;
};

void print(const std::string& name, const Tally& t)
{
    std::printf("%-64s %4d  pass %4d  undecided %4d  fail %4d  wrong %3d", name.c_str(), t.runs, t.pass, t.undecided,
                t.fail, t.wrong);
    if (t.stated > 0)
        std::printf("  U held %5.1f %% of %d, U <= %.4f, error <= %.4f mm", 100.0 * t.covered / t.stated, t.stated,
                    t.largest_u_mm, t.largest_error_mm);
    std::printf("\n");
    std::fflush(stdout);
}

CompareParameters within(double tolerance_mm, DecisionRule decision = DecisionRule::GuardedRejection)
{
    CompareParameters parameters;
    parameters.tolerance_mm = tolerance_mm;
    parameters.decision = decision;
    return parameters;
}

/// What the verdict needs, of a part that is no body of revolution.
CompareResult compareBoxes(const testing_bump::BoxScans& scans)
{
    CompareParameters asked;
    asked.symmetry = registration::Symmetry::None;
    return compare(scans.reference, scans.copy, asked, {}, registration::CompareDetail::Summary);
}

struct Case {
    std::string name;
    std::function<void(std::uint64_t seed, Tallies& rules)> run;
};

/// Leaves the result of guarded rejection.
void judgeByAll(CompareResult& result, double tolerance_mm, Tallies& rules)
{
    judge(result, within(tolerance_mm, DecisionRule::Simple));
    rules.simple.add(result);
    judge(result, within(tolerance_mm, DecisionRule::Guarded));
    rules.guarded.add(result);
    judge(result, within(tolerance_mm));
    rules.rejection.add(result);
}

std::vector<Case> cases()
{
    using namespace testing_pair;
    using namespace testing_bump;
    std::vector<Case> all;
    char name[200];
    // The same shaft twice: the zones' means have to be 0 within their U.
    struct Kind {
        const char* name;
        double dropout, spurious;
        bool one_sided;
        double alike_mm;
        bool clamped;
    };
    const Kind kinds[] = {{"", 0, 0, false, 0, false},
                          {", 30 % dropouts, 2 % spurious", 0.3, 0.02, false, 0, false},
                          {", copy from one side (180 deg)", 0, 0, true, 0, false},
                          {", noise alike over 0.5 mm", 0, 0, false, 0.5, false},
                          {", noise alike over 1 mm", 0, 0, false, 1, false},
                          {", z 0-30 excluded", 0, 0, false, 0, true}};
    for (const double sigma : {0.02, 0.05, 0.1})
        for (const double step_deg : {6.6, 0.9})
            for (const Kind& kind : kinds) {
                std::snprintf(name, sizeof name, "same shaft, sigma %.2f, %dk points%s, +-0.03", sigma,
                              static_cast<int>(658.8 / step_deg), kind.name);
                all.push_back({name, [=](std::uint64_t seed, Tallies& rules) {
                                   const ShaftScans scans = shaftTwice(seed, {.sigma_mm = sigma,
                                                                              .step_deg = step_deg,
                                                                              .dropout = kind.dropout,
                                                                              .spurious = kind.spurious,
                                                                              .one_sided = kind.one_sided,
                                                                              .alike_mm = kind.alike_mm});
                                   CompareParameters asked;
                                   if (kind.clamped) asked.exclude_z_mm = {{0, 30}};
                                   CompareResult result = compare(scans.reference, scans.copy, asked);
                                   judgeByAll(result, 0.03, rules);
                                   for (const auto& zone : result.zones)
                                       rules.rejection.state(zone.mean_mm, zone.uncertainty_mm, 0);
                                   if (result.worst)
                                       rules.guarded.state(result.worst->deviation_mm, result.worst->uncertainty_mm, 0);
                               }});
            }
    // The sample copy: passes ±0.08, fails ±0.04 by its collar.
    for (const double sigma : {0.02, 0.05, 0.1})
        for (const double step_deg : {6.6, 0.9}) {
            std::snprintf(name, sizeof name, "sample copy, sigma %.2f, %dk points, +-0.08", sigma,
                          static_cast<int>(658.8 / step_deg));
            const auto scan = [=](std::uint64_t seed) {
                return shaftTwice(seed, {.sigma_mm = sigma, .step_deg = step_deg, .copy = sample::copiedShaft()});
            };
            all.push_back({name, [=](std::uint64_t seed, Tallies& rules) {
                               const ShaftScans scans = scan(seed);
                               CompareResult result = compare(scans.reference, scans.copy);
                               judgeByAll(result, 0.08, rules);
                           }});
            std::snprintf(name, sizeof name, "sample copy, sigma %.2f, %dk points, +-0.04, collar +0.050", sigma,
                          static_cast<int>(658.8 / step_deg));
            all.push_back({name, [=](std::uint64_t seed, Tallies& rules) {
                               const ShaftScans scans = scan(seed);
                               CompareResult result = compare(scans.reference, scans.copy);
                               judgeByAll(result, 0.04, rules);
                               bool named = false;
                               for (const Finding& f : result.findings)
                                   if (f.kind == Finding::Kind::Step && std::abs(*f.z_start_mm - 98) < 2) {
                                       named = f.verdict == Verdict::Fail;
                                       rules.rejection.state(f.value_mm, f.uncertainty_mm, 0.05);
                                   } else if (f.kind == Finding::Kind::Taper) {
                                       rules.guarded.state(f.value_mm * 98 / (*f.z_end_mm - *f.z_start_mm),
                                                           f.uncertainty_mm, -0.06);
                                   }
                               rules.rejection.wrong += !named;
                           }});
        }
    // A bump of +0.12 mm, 4 mm across.
    for (const double sigma : {0.02, 0.05})
        for (const double density : {12.0, 20.0, 40.0})
            for (const bool bump : {true, false}) {
                const char* what = bump ? "with bump" : "without bump";
                std::snprintf(name, sizeof name, "shaft %s, sigma %.2f, %.0f/mm2, +-0.08", what, sigma, density);
                all.push_back({name, [=](std::uint64_t seed, Tallies& rules) {
                                   const double step = 0.9 * 40 / density;
                                   ShaftScans scans = shaftTwice(seed, {.sigma_mm = sigma, .step_deg = step});
                                   if (bump) addBump(scans, seed, 0.12, 4);
                                   CompareResult result = compare(scans.reference, scans.copy);
                                   judgeByAll(result, 0.08, rules);
                                   for (const Finding& f : result.findings)
                                       if (f.kind == Finding::Kind::Bump) {
                                           if (bump &&
                                               std::abs((*f.z_start_mm + *f.z_end_mm) / 2 - scans.bump_z_mm) < 3)
                                               rules.rejection.state(f.value_mm, f.uncertainty_mm, 0.12);
                                           else
                                               ++rules.rejection.wrong;
                                       }
                               }});
                for (const bool mesh : {false, true}) {
                    std::snprintf(name, sizeof name, "box %s, %s, sigma %.2f, %.0f/mm2, +-0.08", what,
                                  mesh ? "to mesh" : "to cloud", sigma, density);
                    all.push_back({name, [=](std::uint64_t seed, Tallies& rules) {
                                       const BoxScans scans = boxTwice(seed, sigma, density, bump ? 0.12 : 0, 4, mesh);
                                       CompareResult result = compareBoxes(scans);
                                       judgeByAll(result, 0.08, rules);
                                       for (const Finding& f : result.findings)
                                           if (f.kind == Finding::Kind::Bump) {
                                               if (bump && (f.point_mm - scans.bump_mm).norm() < 3)
                                                   rules.rejection.state(std::abs(f.value_mm), f.uncertainty_mm, 0.12);
                                               else
                                                   ++rules.rejection.wrong;
                                           }
                                   }});
                }
            }
    for (const double sigma : {0.02, 0.05, 0.1})
        for (const double density : {10.0, 50.0})
            for (const bool mesh : {false, true}) {
                std::snprintf(name, sizeof name, "same box, %s, sigma %.2f, %.0f/mm2, +-0.03",
                              mesh ? "to mesh" : "to cloud", sigma, density);
                all.push_back({name, [=](std::uint64_t seed, Tallies& rules) {
                                   const BoxScans scans = boxTwice(seed, sigma, density, 0, 4, mesh);
                                   CompareResult result = compareBoxes(scans);
                                   judgeByAll(result, 0.03, rules);
                                   if (result.worst)
                                       rules.guarded.state(result.worst->deviation_mm, result.worst->uncertainty_mm, 0);
                               }});
            }
    for (const double sigma : {0.02, 0.05, 0.1})
        for (const double alike_mm : {0.5, 1.0})
            for (const bool mesh : {false, true}) {
                std::snprintf(name, sizeof name,
                              "same box in lines, %s, sigma %.2f, alike over %.1f mm, 20/mm2, +-0.03",
                              mesh ? "to mesh" : "to cloud", sigma, alike_mm);
                all.push_back({name, [=](std::uint64_t seed, Tallies& rules) {
                                   const BoxScans scans = boxTwice(seed, sigma, 20, 0, 4, mesh, alike_mm);
                                   CompareResult result = compareBoxes(scans);
                                   judgeByAll(result, 0.03, rules);
                                   if (result.worst)
                                       rules.guarded.state(result.worst->deviation_mm, result.worst->uncertainty_mm, 0);
                               }});
            }
    for (const double sigma : {0.02, 0.05, 0.1})
        for (const std::size_t count : {100000U, 300000U})
            for (const bool mesh : {false, true}) {
                std::snprintf(name, sizeof name, "same bracket, %s, sigma %.2f, %zuk points, +-0.03",
                              mesh ? "to mesh" : "to cloud", sigma, count / 1000);
                all.push_back({name, [=](std::uint64_t seed, Tallies& rules) {
                                   const Eigen::Isometry3d pose(
                                       Eigen::Translation3d(4, 5, -6) *
                                       Eigen::AngleAxisd(
                                           0.3, Eigen::Vector3d(1, 0.2 * static_cast<double>(seed), 0.3).normalized()));
                                   const Scan reference =
                                       mesh
                                           ? sample::bracketMesh()
                                           : sample::scanBracket(count, sigma, Eigen::Isometry3d::Identity(), 2 * seed);
                                   CompareResult result =
                                       compare(reference, sample::scanBracket(count, sigma, pose, 2 * seed + 1));
                                   judgeByAll(result, 0.03, rules);
                                   if (result.worst)
                                       rules.guarded.state(result.worst->deviation_mm, result.worst->uncertainty_mm, 0);
                               }});
            }
    // Faces across the axis: the same shaft, one that is 0.12 mm longer, and one whose shoulder is 0.12 mm further.
    for (const double sigma : {0.02, 0.05, 0.1})
        for (const double density : {2.0, 12.0})
            for (const int kind : {0, 1, 2}) {
                const char* what = kind == 0 ? "same" : kind == 1 ? "longer" : "shoulder moved";
                std::snprintf(name, sizeof name, "faces, %s, sigma %.2f, %.0f/mm2, +-%s", what, sigma, density,
                              kind == 0 ? "0.03" : "0.08");
                all.push_back({name, [=](std::uint64_t seed, Tallies& rules) {
                                   FacedShaft copy;
                                   if (kind == 1) copy.length_mm += 0.12;
                                   if (kind == 2) copy.shoulder_mm += 0.12;
                                   const ShaftScans scans = facedShafts(seed, sigma, density, copy);
                                   CompareResult result = compare(scans.reference, scans.copy);
                                   judgeByAll(result, kind == 0 ? 0.03 : 0.08, rules);
                                   for (const Finding& f : result.findings)
                                       if (f.kind == Finding::Kind::Step && kind > 0)
                                           rules.rejection.state(std::abs(f.value_mm), f.uncertainty_mm, 0.12);
                                   rules.rejection.wrong += kind == 0 && !result.findings.empty();
                                   if (result.worst && kind == 0)
                                       rules.guarded.state(result.worst->deviation_mm, result.worst->uncertainty_mm, 0);
                               }});
            }
    // Points spread by area, thin to dense, quiet to noisy: a plateau of +0.12 mm, 4 mm across, and none.
    for (const double sigma : {0.03, 0.05, 0.08, 0.1})
        for (const std::size_t count : {20000U, 60000U, 200000U})
            for (const double plateau : {0.12, 0.08, 0.0}) {
                std::snprintf(name, sizeof name, "steps, plateau +%.2f, sigma %.2f, %zuk, +-0.08", plateau, sigma,
                              count / 1000);
                all.push_back({name, [=](std::uint64_t seed, Tallies& rules) {
                                   const testing_steps::StepScans scans =
                                       testing_steps::stepsTwice(count, sigma, plateau, seed);
                                   CompareResult result = compare(scans.reference, scans.copy, {}, {},
                                                                  registration::CompareDetail::Summary);
                                   judgeByAll(result, 0.08, rules);
                                   for (const Finding& f : result.findings)
                                       if (f.kind == Finding::Kind::Bump && plateau > 0)
                                           rules.rejection.state(f.value_mm, f.uncertainty_mm, plateau);
                                   rules.rejection.wrong += plateau == 0 && !result.findings.empty();
                                   if (result.worst && plateau == 0)
                                       rules.guarded.state(result.worst->deviation_mm, result.worst->uncertainty_mm, 0);
                               }});
            }
    // Wrong: further off than 5 um, and not said to be undetermined.
    all.push_back({"ends lost, two shoulders, sigma 0.05, 40k, +-0.1", [](std::uint64_t seed, Tallies& rules) {
                       using namespace testing_lost_ends;
                       LostEnds lost = compareWithLostEnds(randomShaft(seed), 40000, seed);
                       judgeByAll(lost.result, 0.1, rules);
                       const double stated_um = lost.result.alignment.uncertainty.axial_um;
                       if (std::isnan(stated_um)) return;
                       rules.rejection.wrong += std::abs(lost.axial_um) > 5;
                       rules.rejection.state(lost.axial_um / 1000, stated_um / 1000, 0);
                   }});
    for (const int sides : {24, 36, 72, 400}) {
        std::snprintf(name, sizeof name, "shaft to mesh of %d sides, sigma 0.05, 100k points, +-0.03", sides);
        all.push_back({name, [=](std::uint64_t seed, Tallies& rules) {
                           const ShaftScans scans = shaftTwice(seed, {.sigma_mm = 0.05, .step_deg = 6.6});
                           CompareResult result = compare(sample::shaftMesh(sample::nominalShaft(), sides), scans.copy);
                           judgeByAll(result, 0.03, rules);
                           rules.rejection.wrong += !result.findings.empty();
                       }});
    }
    return all;
}

}  // namespace
}  // namespace lathelier

int main(int argc, char** argv)
{
    int runs = 20;
    std::string only;
    for (int i = 1; i + 1 < argc; i += 2) {
        if (std::strcmp(argv[i], "--runs") == 0) runs = std::atoi(argv[i + 1]);
        if (std::strcmp(argv[i], "--only") == 0) only = argv[i + 1];
    }
    for (const lathelier::Case& one : lathelier::cases()) {
        if (one.name.find(only) == std::string::npos) continue;
        lathelier::Tallies rules;
        for (int run = 0; run < runs; ++run) {
            try {
                one.run(static_cast<std::uint64_t>(run) + 1, rules);
            } catch (const std::exception& failure) {
                std::printf("%s: %s\n", one.name.c_str(), failure.what());
            }
        }
        print(one.name + ", guarded rejection", rules.rejection);
        print(one.name + ", simple", rules.simple);
        print(one.name + ", guarded", rules.guarded);
    }
}
