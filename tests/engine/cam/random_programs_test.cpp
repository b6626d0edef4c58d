// Programs of random jobs: steps, cones, arcs, grooves and undercuts, with tools of several entering angles and the
// chuck close behind the part. What is written passes its own check and touches nothing at rapid; what is refused says
// where.
#include <gtest/gtest.h>

#include <cstdlib>
#include <set>

#include "engine/cam/plan_refusal.h"
#include "tests/engine/cam/plan_checks.h"
#include "tests/engine/cam/rapid_checks.h"

namespace lathelier::cam {
namespace {

constexpr int usualJobs = 40;
constexpr unsigned firstSeed = 42000;

Job jobOfSeed(int i)
{
    std::mt19937 random(firstSeed + static_cast<unsigned>(i));
    const auto uniform = [&random](double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(random);
    };
    Job job = randomJob(random, i % 3 != 0);
    JobTool& rough = job.tools.front();
    const double entering[]{95, 75, 80, 85};
    rough.entering_angle_deg = entering[i % 4];
    rough.tip_angle_deg = i % 4 == 0 ? 80 : 90;
    rough.corner_radius_mm = i % 2 == 0 ? 0.8 : 1.2;
    job.part_off = job.part_off && i % 2 == 0;
    job.stock.face_allowance_mm = i % 5 == 0 ? 0 : std::round(10 * uniform(0.5, 3)) / 10;
    // The opposite hand reaches beyond the end of the part, toward the chuck.
    job.setup.chuck_face_z_mm = job.shaft->length_mm() + std::round(10 * uniform(6, 25)) / 10;
    return job;
}

std::string whereIn(const Error& error)
{
    std::string missing;
    for (const char* name : {"operation", "tool", "z_mm"}) {
        const Value* const value = find(error.values(), name);
        if (!value || std::holds_alternative<std::monostate>(*value)) missing += std::string(" ") + name;
    }
    return missing;
}

TEST(RandomPrograms, PassTheirCheckOrSayWhatIsWrong)
{
    const char* soak = std::getenv("LATHELIER_SOAK");
    const int count = soak ? std::atoi(soak) : usualJobs;
    const std::vector<std::string> posts = postNames();
    int written = 0;
    std::set<OperationKind> kinds;
    for (int i = 0; i < count; ++i) {
        const Job job = jobOfSeed(i);
        const std::string post = posts[static_cast<std::size_t>(i) % posts.size()];
        const std::string what = "job " + std::to_string(i) + " " + post;
        const TurningPlan plan = planned(job, post.c_str());
        if (plan.is_refused) {
            try {
                throwIfRefused(plan);
            } catch (const Error& error) {
                EXPECT_EQ(whereIn(error), "") << what;
            }
            continue;
        }
        ++written;
        expectSound(plan, what);
        expectQuietRapids(plan, what);
        for (const PlannedOperation& operation : plan.setups.front().operations) kinds.insert(operation.kind);
    }
    EXPECT_EQ(written, count);
    for (const OperationKind kind :
         {OperationKind::Face, OperationKind::Rough, OperationKind::SemiFinish, OperationKind::Finish,
          OperationKind::FinishBack, OperationKind::Groove, OperationKind::PartOff})
        EXPECT_TRUE(kinds.count(kind) > 0) << key(kind);
}

}  // namespace
}  // namespace lathelier::cam
