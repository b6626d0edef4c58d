// Faults of one word in programs of our own: each is found at its line or the next; the original program has none.
#include <gtest/gtest.h>

#include <fmt/format.h>

#include <cmath>

#include "tests/engine/cam/cam_data.h"
#include "tests/engine/cam/plan_checks.h"

namespace lathelier::cam {
namespace {

std::vector<std::string> linesOf(const std::string& text)
{
    std::vector<std::string> lines;
    std::size_t at = 0;
    while (at < text.size()) {
        const std::size_t end = std::min(text.find('\n', at), text.size());
        lines.push_back(text.substr(at, end - at));
        at = end + 1;
    }
    return lines;
}

std::string joined(const std::vector<std::string>& lines)
{
    std::string text;
    for (const std::string& line : lines) text += line + "\n";
    return text;
}

/// Adds to the number behind an address in a line.
bool shiftWord(std::string& line, char address, double by)
{
    const std::size_t comment = line.find_first_of("(;");
    const std::size_t at = line.find(address);
    if (at == std::string::npos || at > comment) return false;
    std::size_t end = at + 1;
    while (end < line.size() &&
           (std::isdigit(static_cast<unsigned char>(line[end])) || line[end] == '.' || line[end] == '-'))
        ++end;
    const double value = std::stod(line.substr(at + 1, end - at - 1)) + by;
    line.replace(at + 1, end - at - 1, fmt::format("{:.3f}", value));
    return true;
}

/// Puts one word in place of another within a line.
bool swapWord(std::string& line, const std::string& word, const std::string& by)
{
    const std::size_t at = line.find(word);
    if (at == std::string::npos || at + word.size() >= line.size() || line[at + word.size()] != ' ') return false;
    line.replace(at, word.size(), by);
    return true;
}

/// A correct program with the operation of each block.
struct Sound {
    std::string name, text;
    Job job;
    std::vector<std::string> lines;
    std::vector<gcode::Move> moves;
    gcode::ControlPtr control;

    std::size_t operationOf(std::int64_t line) const
    {
        std::size_t found = 0;
        for (std::size_t i = 0; i < operations.size(); ++i)
            if (operations[i].first_line <= line) found = i;
        return found;
    }
    std::vector<PlannedOperation> operations;
};

std::vector<Sound> soundPrograms()
{
    std::vector<Sound> all;
    std::vector<Practice> jobs = practiceJobs();
    jobs.push_back({"threaded", threadedJob(), {}});
    jobs.push_back({"tailstock", tailstockJob(), {}});
    for (const Practice& practice : jobs)
        for (const char* post : {"fanuc_a", "linuxcnc", "sinumerik"}) {
            const TurningPlan plan = planned(practice.job, post);
            Sound sound;
            sound.name = std::string(practice.name) + " " + post;
            sound.text = plan.setups[0].text;
            sound.job = practice.job;
            sound.lines = linesOf(sound.text);
            sound.moves = plan.setups[0].check.path.moves;
            sound.operations = plan.setups[0].operations;
            sound.control = postNamed(post).control;
            all.push_back(std::move(sound));
        }
    return all;
}

CheckResult checkedAs(const std::string& text, const Sound& sound)
{
    CheckParameters parameters;
    parameters.program.control = sound.control;
    return checkTurning(text, *sound.job.shaft, sound.job, parameters);
}

void expectFound(const CheckResult& result, std::int64_t line, std::initializer_list<CheckKind> kinds,
                 const std::string& what)
{
    bool is_found = false;
    for (const CheckFinding& finding : result.findings)
        for (const CheckKind kind : kinds)
            is_found = is_found || (finding.kind == kind && std::abs(finding.line - line) <= 1);
    std::string all;
    for (const CheckFinding& finding : result.findings) all += fmt::format(" {}@{}", key(finding.kind), finding.line);
    EXPECT_TRUE(is_found) << what << " line " << line << ':' << all;
}

/// Long moves along a cylinder toward the chuck, of one kind of operation.
std::vector<std::size_t> passesOf(const Sound& sound, OperationKind kind)
{
    std::vector<std::size_t> found;
    for (std::size_t i = 1; i < sound.moves.size(); ++i) {
        const gcode::Move &move = sound.moves[i], &before = sound.moves[i - 1];
        if (move.kind != gcode::MoveKind::Feed || sound.operations[sound.operationOf(move.line)].kind != kind) continue;
        if (std::abs(move.x_mm - before.x_mm) < 1e-6 && before.z_mm - move.z_mm > 4) found.push_back(i);
    }
    return found;
}

TEST(PlantedFaults, UntouchedProgramsHaveNone)
{
    for (const Sound& sound : soundPrograms()) {
        const CheckResult result = checkedAs(sound.text, sound);
        EXPECT_TRUE(result.findings.empty()) << sound.name;
        EXPECT_LE(result.gouge_um, 1.5) << sound.name;
    }
}

TEST(PlantedFaults, DiameterTooSmallByThirtyMicrometres)
{
    int planted = 0;
    for (const Sound& sound : soundPrograms())
        for (const std::size_t i : passesOf(sound, OperationKind::Finish)) {
            // The block that states X of this pass.
            std::vector<std::string> lines = sound.lines;
            auto line = static_cast<std::size_t>(sound.moves[i - 1].line - 1);
            if (!shiftWord(lines[line], 'X', -0.030) || lines[line].find('I') != std::string::npos ||
                lines[line].find("CR") != std::string::npos)
                continue;
            ++planted;
            const CheckResult result = checkedAs(joined(lines), sound);
            if (result.path.has_errors) {  // a following arc no longer ends on its circle
                bool is_said = false;
                for (const gcode::Diagnostic& diagnostic : result.path.diagnostics)
                    is_said = is_said || (diagnostic.error && std::abs(diagnostic.line - sound.moves[i].line) <= 1);
                EXPECT_TRUE(is_said) << sound.name;
                continue;
            }
            expectFound(result, sound.moves[i].line, {CheckKind::InsertBelowDrawing},
                        sound.name + " 30 um " + lines[line] + " / " + lines[line + 1]);
            EXPECT_NEAR(result.gouge_um, 15, 2) << sound.name;
        }
    EXPECT_GT(planted, 8);
}

TEST(PlantedFaults, InTheSecondClamping)
{
    const Job job = paperJob({roughC80(), finishC80()});
    const TurningPlan plan = planned(job, "fanuc_a", SetupChoice::Two);
    ASSERT_EQ(plan.setups.size(), 2U);
    const SetupPlan& second = plan.setups[1];
    Sound sound;
    sound.name = "second clamping";
    sound.text = second.text;
    sound.lines = linesOf(second.text);
    sound.moves = second.check.path.moves;
    sound.operations = second.operations;
    CheckInputs inputs;
    inputs.before = plan.setups[0].text;
    const auto check = [&](const std::vector<std::string>& lines) {
        return checkTurning(joined(lines), *job.shaft, job, second.check.parameters, inputs);
    };
    EXPECT_TRUE(check(sound.lines).findings.empty());
    int planted = 0;
    for (const std::size_t i : passesOf(sound, OperationKind::Finish)) {
        std::vector<std::string> lines = sound.lines;
        lines.insert(lines.begin() + static_cast<std::ptrdiff_t>(sound.moves[i].line - 1),
                     fmt::format("G1 X{:.3f}", 2 * sound.moves[i].x_mm - 0.030));
        ++planted;
        expectFound(check(lines), sound.moves[i].line, {CheckKind::InsertBelowDrawing}, "second 30 um");
    }
    const std::vector<std::size_t> rough = passesOf(sound, OperationKind::Rough);
    ASSERT_FALSE(rough.empty());
    std::vector<std::string> lines = sound.lines;
    const auto at = static_cast<std::size_t>(sound.moves[rough.back()].line - 1);
    if (swapWord(lines[at], "G1", "G0") && ++planted)
        expectFound(check(lines), sound.moves[rough.back()].line, {CheckKind::RapidThroughStock}, "second rapid");
    lines = sound.lines;
    const double chuck = second.clamping.job.setup.chuck_face_z_mm;
    if (shiftWord(lines[at], 'Z', -sound.moves[rough.back()].z_mm - chuck - 3) && ++planted)
        expectFound(check(lines), sound.moves[rough.back()].line, {CheckKind::Chuck}, "second chuck");
    EXPECT_GE(planted, 3);
}

TEST(PlantedFaults, RoughingTooDeepAndRapidForFeedAndIntoTheChuck)
{
    int planted = 0;
    for (const Sound& sound : soundPrograms()) {
        const std::vector<std::size_t> passes = passesOf(sound, OperationKind::Rough);
        if (passes.empty()) continue;
        // The last pass from the front stands nearest to the drawing.
        const std::size_t i = passes.back();
        const auto at = static_cast<std::size_t>(sound.moves[i].line - 1);
        std::vector<std::string> lines = sound.lines;
        if (shiftWord(lines[static_cast<std::size_t>(sound.moves[i - 1].line - 1)], 'X', -4) && ++planted)
            expectFound(checkedAs(joined(lines), sound), sound.moves[i].line, {CheckKind::InsertBelowDrawing},
                        sound.name + " deep");
        lines = sound.lines;
        if (swapWord(lines[at], "G1", "G0") && ++planted)
            expectFound(checkedAs(joined(lines), sound), sound.moves[i].line, {CheckKind::RapidThroughStock},
                        sound.name + " rapid");
        lines = sound.lines;
        if (shiftWord(lines[at], 'Z', sound.moves[i].z_mm * -1 - sound.job.setup.chuck_face_z_mm - 3) && ++planted)
            expectFound(checkedAs(joined(lines), sound), sound.moves[i].line, {CheckKind::Chuck},
                        sound.name + " chuck");
    }
    EXPECT_GT(planted, 40);
}

TEST(PlantedFaults, ArcTheOtherWay)
{
    int planted = 0;
    for (const Sound& sound : soundPrograms())
        for (const gcode::Move& move : sound.moves) {
            if (move.kind != gcode::MoveKind::Arc ||
                sound.operations[sound.operationOf(move.line)].kind != OperationKind::Finish)
                continue;
            // A relevant arc: its other half deviates by more than 0.05 mm.
            const gcode::Move& before = *(&move - 1);
            const double radius = std::hypot(move.x_mm - move.centre_x_mm, move.z_mm - move.centre_z_mm);
            const double chord = std::hypot(move.x_mm - before.x_mm, move.z_mm - before.z_mm);
            const double sagitta = radius - std::sqrt(std::max(0.0, radius * radius - chord * chord / 4));
            if (sagitta < 0.05) continue;
            std::vector<std::string> lines = sound.lines;
            std::string& line = lines[static_cast<std::size_t>(move.line - 1)];
            if (!(swapWord(line, "G2", "G9") ? swapWord(line, "G9", "G3") : swapWord(line, "G3", "G2"))) continue;
            ++planted;
            const CheckResult result = checkedAs(joined(lines), sound);
            bool is_found = false;
            for (const CheckFinding& finding : result.findings)
                is_found = is_found || std::abs(finding.line - move.line) <= 1;
            for (const RestInterval& rest : result.rest) is_found = is_found || std::abs(rest.line - move.line) <= 1;
            std::string all;
            for (const RestInterval& rest : result.rest)
                all += fmt::format(" {:.3f}-{:.3f} {:.4f}@{}", rest.z_start_mm, rest.z_end_mm, rest.left_mm, rest.line);
            for (const CheckFinding& finding : result.findings)
                all += fmt::format(" {}@{}", key(finding.kind), finding.line);
            EXPECT_TRUE(is_found) << sound.name << " line " << move.line << ' ' << line << all;
        }
    EXPECT_GT(planted, 10);
}

TEST(PlantedFaults, NoseAndInsertThatAreNotTheJobs)
{
    for (const Sound& sound : soundPrograms()) {
        Sound other = sound;
        for (JobTool& tool : other.job.tools)
            if (tool.use == ToolUse::Finish) tool.corner_radius_mm = 0.8;
        const CheckResult nose = checkedAs(sound.text, other);
        const CheckResult right = checkedAs(sound.text, sound);
        // Either 0.05 mm more residual material, or a gouge.
        const auto is_more = [&](const RestInterval& rest) {
            return std::all_of(right.rest.begin(), right.rest.end(), [&](const RestInterval& known) {
                return known.z_start_mm > rest.z_end_mm || known.z_end_mm < rest.z_start_mm ||
                       rest.left_mm > known.left_mm + 0.05;
            });
        };
        const bool is_left = std::any_of(nose.rest.begin(), nose.rest.end(), [&](const RestInterval& rest) {
            return rest.left_mm > 0.05 && is_more(rest);
        });
        const bool is_cut = std::any_of(nose.findings.begin(), nose.findings.end(), [](const CheckFinding& finding) {
            return finding.kind == CheckKind::InsertBelowDrawing && finding.depth_mm > 0.05;
        });
        EXPECT_TRUE(is_left || is_cut) << sound.name;
    }
    for (const Sound& sound : soundPrograms()) {
        if (sound.name.find("neck_d55") == std::string::npos && sound.name.find("paper_v35") == std::string::npos)
            continue;
        Sound other = sound;
        for (JobTool& tool : other.job.tools)
            if (tool.use == ToolUse::Finish) tool.tip_angle_deg = 80;
        const CheckResult insert = checkedAs(sound.text, other);
        bool is_found = false;
        for (const CheckFinding& finding : insert.findings)
            is_found = is_found || (finding.kind == CheckKind::InsertBelowDrawing && finding.depth_mm > 0.3);
        EXPECT_TRUE(is_found) << sound.name;
    }
}

}  // namespace
}  // namespace lathelier::cam
