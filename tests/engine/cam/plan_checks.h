// Jobs with known residual material, and invariants of every plan.
#pragma once

#include <gtest/gtest.h>

#include "tests/engine/cam/plan_data.h"

namespace lathelier::cam {

/// Expected residual material.
struct Expected {
    double from, to, left;
};

/// A job with known residual material.
struct Practice {
    const char* name;
    Job job;
    std::vector<Expected> rest;
};

inline std::vector<Practice> practiceJobs()
{
    Job contour = jobWith({row(1, 18, 20), row(17, 20, 20), row(2, 20, 24, -2), row(3, 30, 36, 3), row(7, 36, 36),
                           row(4, 36, 44, -4), row(6, 44, 50), row(20, 50, 50)},
                          54, 90, {roughC80(), finishC80()});
    Job ball = jobWith({row(10, 0.001, 20, 10), row(8, 16, 16), row(6, 16, 28, 9), row(30, 28, 28)}, 30, 90,
                       {roughC80(), finishD55()});
    Job neck =
        jobWith(neckRows(), 32, 150, {roughD55(), finishD55(), backV35(), blade(8, ToolUse::Groove, 2, 0.2, 18)});
    neck.part_off = true;
    Job first = jobWith({row(98, 30, 30), row(6, 37, 37)}, 40, 130, {roughC80(), finishC80()});
    first.sections = {{98, 2154}, {104, 1750}};
    return {
        {"contour", contour, {}},
        {"ball", ball, {{10, 13.52, 1.7321}, {17.76, 18.07, 0.0952}}},
        {"neck_all", neck, {{27, 27.16, 0.0828}, {29.84, 30, 0.0828}, {88.99, 89.02, 0.0052}, {96.97, 97.03, 0.0126}}},
        {"neck_c80",
         jobWith(neckRows(), 32, 150, {roughC80(), finishC80()}),
         {{27, 30, 1.498}, {77.01, 100.41, 3.3666}}},
        {"neck_d55",
         jobWith(neckRows(), 32, 150, {roughD55(), finishD55()}),
         {{27, 30, 1.2991}, {88.99, 89.02, 0.0052}, {96.91, 97.07, 0.0255}}},
        {"paper_c80",
         paperJob({roughC80(), finishC80()}),
         {{97.65, 98, 0.1657}, {108, 138.47, 1.5979}, {178, 183, 4.7385}}},
        {"paper_v35",
         paperJob({roughD55(), finishV35()}),
         {{97.65, 98, 0.1657}, {108, 109.47, 1.0283}, {182.76, 183, 0.1657}}},
        {"paper_s1", first, {{97.65, 98, 0.1657}}},
        {"paper_s2",
         jobWith({row(5, 23.8, 33.8), row(70, 33.8, 33.8), row(4.2, 37, 37)}, 40, 90, {roughC80(), finishC80()}),
         {{74.65, 75, 0.1657}}}};
}

inline void expectRest(const TurningPlan& plan, const std::vector<Expected>& expected, const std::string& what)
{
    std::vector<RestInterval> rest;
    for (const RestInterval& found : plan.rest)
        if (found.left_mm > 0.005) rest.push_back(found);
    ASSERT_EQ(rest.size(), expected.size()) << what;
    for (std::size_t i = 0; i < rest.size(); ++i) {
        EXPECT_NEAR(rest[i].z_start_mm, expected[i].from, 0.05) << what;
        EXPECT_NEAR(rest[i].z_end_mm, expected[i].to, 0.05) << what;
        EXPECT_NEAR(rest[i].left_mm, expected[i].left, 0.002) << what;
    }
}

inline void expectSound(const TurningPlan& plan, const std::string& what)
{
    EXPECT_FALSE(plan.is_refused) << what;
    for (const SetupPlan& setup : plan.setups) {
        EXPECT_FALSE(setup.check.path.has_errors) << what;
        EXPECT_LE(setup.check.gouge_um, 1.5) << what;
        for (const CheckFinding& finding : setup.check.findings)
            ADD_FAILURE() << what << " line " << finding.line << " " << key(finding.kind) << " z " << finding.z_mm
                          << " " << finding.depth_mm << "\n"
                          << setup.text;
    }
}

}  // namespace lathelier::cam
