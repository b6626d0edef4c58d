// The corrected program as text: it is read and simulated again, and every pass compared with the programmed contour.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <sstream>

#include "../core/code_of_error.h"
#include "case_a.h"
#include "engine/deflection/corrected_program.h"
#include "engine/deflection/deflection_codes.h"
#include "engine/gcode/gcode_codes.h"

namespace lathelier::deflection {
namespace {

TurningJob jobOf(const std::string& text, Shaft stock = caseAStock(), TurningSetup setup = caseASetup())
{
    gcode::Program program = gcode::readProgram(text, gcode::controlNamed("fanuc"));
    gcode::Toolpath path = findToolpath(program);
    EXPECT_FALSE(path.has_errors) << text;
    return turningJob(std::move(program), std::move(path), std::move(stock), std::move(setup));
}

std::vector<std::string> linesOf(const std::string& text)
{
    std::vector<std::string> lines;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) lines.push_back(line);
    return lines;
}

/// The programmed contour of one pass: its feed moves along z.
class Contour {
public:
    void add(const gcode::Move& from, const gcode::Move& to)
    {
        if (std::abs(to.z_mm - from.z_mm) > 1e-9) pieces_.push_back({from, to});
    }
    bool isEmpty() const { return pieces_.empty(); }

    /// Radius programmed at z; z counts from the free end.
    double at(double z_mm) const
    {
        for (const auto& [from, to] : pieces_) {
            if (-z_mm < to.z_mm - 1e-9) continue;
            if (to.kind != gcode::MoveKind::Arc)
                return from.x_mm + (to.x_mm - from.x_mm) * (-z_mm - from.z_mm) / (to.z_mm - from.z_mm);
            const double radius_mm = std::hypot(from.x_mm - to.centre_x_mm, from.z_mm - to.centre_z_mm);
            const double along_mm = -z_mm - to.centre_z_mm;
            const double across_mm = std::sqrt(std::max(0.0, radius_mm * radius_mm - along_mm * along_mm));
            const bool is_upper = from.x_mm + to.x_mm > 2 * to.centre_x_mm;
            return to.centre_x_mm + (is_upper ? across_mm : -across_mm);
        }
        return pieces_.back().second.x_mm;
    }

private:
    std::vector<std::pair<gcode::Move, gcode::Move>> pieces_;
};

std::vector<Contour> contoursOf(const gcode::Toolpath& path)
{
    std::vector<Contour> contours(1);
    for (std::size_t i = 1; i < path.moves.size(); ++i) {
        const gcode::Move& move = path.moves[i];
        if (move.kind == gcode::MoveKind::Rapid && !contours.back().isEmpty()) contours.emplace_back();
        if (move.kind == gcode::MoveKind::Feed || move.kind == gcode::MoveKind::Arc)
            contours.back().add(path.moves[i - 1], move);
    }
    if (contours.back().isEmpty()) contours.pop_back();
    return contours;
}

/// Largest error on diameter of all passes of the written program, against the contours of the original.
double simulatedResidual_um(const TurningJob& job, const CorrectedProgram& corrected)
{
    TurningSetup setup = job.setup;
    setup.step_mm /= 3;
    const DeflectionResult again = predictJob(jobOf(corrected.text, job.stock, setup));
    const std::vector<Contour> contours = contoursOf(job.path);
    EXPECT_EQ(again.passes.size(), contours.size());
    double largest_um = 0;
    for (std::size_t p = 0; p < std::min(again.passes.size(), contours.size()); ++p) {
        const PassResult& pass = again.passes[p];
        for (std::size_t i = 0; i < pass.z_mm.size(); ++i) {
            const double target_mm = contours[p].at(pass.z_mm[i]);
            constexpr double rubbing_mm = 0.015;  // the scallop: no force, and no correction
            if (pass.radius_mm[i] + pass.depth_mm[i] - target_mm < rubbing_mm) continue;
            largest_um = std::max(largest_um, um_per_mm_of_diameter * std::abs(pass.radius_mm[i] - target_mm));
        }
    }
    return largest_um;
}

/// Roughing, and a finishing pass of cylinder, taper, arc and cylinder.
class RandomProgram {
public:
    explicit RandomProgram(unsigned seed) : random_(seed), is_inch(seed % 3 == 2) {}

    std::string text()
    {
        const double rough_mm = between(14.6, 15.5), finish_mm = rough_mm - between(0.4, 1.2);
        const double end_mm = between(150, 260), radius_mm = std::round(between(1.5, 8)), length_mm = between(10, 60);
        const double taper_mm = chance() ? between(0.05, 0.3) : 0;
        const double taper_z = end_mm - radius_mm - 10, arc_z = end_mm - 10;
        const bool by_centre = chance(), is_convex = chance();
        std::string made =
            fmt::format("O1\n{} G40 G99\nT0101\nG97 S900 M3\nG0 {} {}\n", is_inch ? "G20" : "G21", x(20), z(2));
        made += fmt::format("{}\nG1 {} {}\nG0 {}\n{}\n", x(rough_mm + 0.7), z(-end_mm - 5), f(0.25), x(18), z(2));
        made += fmt::format("{}\nG1 {} {}\n", x(finish_mm), z(-length_mm), f(0.15));
        made += fmt::format("{} {}\n", x(finish_mm + taper_mm), z(-taper_z));
        // An eighth of a circle that stays within what roughing left.
        const double small_mm = std::min(radius_mm, 2.0);
        const double rise_mm = small_mm * (1 - std::sqrt(0.5)), run_mm = small_mm * std::sqrt(0.5);
        const Grid g{is_inch};
        const double from_x = g.radius(finish_mm + taper_mm), from_z = g.length(-taper_z);
        if (is_convex)
            made += fmt::format("G3 {} {} {}\n", x(from_x + rise_mm), z(from_z - run_mm), word('R', small_mm));
        else if (by_centre) {
            leaves_stock = true;
            made += fmt::format("G2 {} {} {} {}\n", x(from_x + g.length(small_mm)), z(from_z - g.length(small_mm)),
                                word('I', small_mm), word('K', 0));
        } else
            made += fmt::format("G2 {} {} {}{}\n", x(from_x + rise_mm), z(from_z - run_mm), word('R', small_mm),
                                chance() ? std::string(" ").append(f(0.1)) : std::string());
        made += fmt::format("G1 {}\nG0 {}\n{}\nM30\n", z(-arc_z), x(20), z(2));
        return made;
    }

private:
    struct Grid {
        bool is_inch;
        double unit() const { return is_inch ? 25.4 * 1e-4 : 1e-3; }
        double length(double mm) const { return std::round(mm / unit()) * unit(); }
        double radius(double mm) const { return std::round(2 * mm / unit()) * unit() / 2; }
    };
    double between(double low, double high) { return std::uniform_real_distribution<>(low, high)(random_); }
    bool chance() { return between(0, 1) < 0.5; }
    std::string word(char letter, double mm) const
    {
        return is_inch ? fmt::format("{}{:.4f}", letter, mm / 25.4) : fmt::format("{}{:.3f}", letter, mm);
    }
    std::string x(double mm) const { return word('X', 2 * mm); }
    std::string z(double mm) const { return word('Z', mm); }
    std::string f(double mm) const { return word('F', mm); }
    std::mt19937 random_;

public:
    bool is_inch;
    bool leaves_stock = false;
};

TEST(CorrectedProgram, RandomProgramsHoldWhatTheyPromise)
{
    std::int64_t added = 0;
    double worst_um = 0, worst_inch_um = 0;
    for (unsigned seed = 1; seed <= 40; ++seed) {
        RandomProgram random(seed);
        const std::string text = random.text();
        SCOPED_TRACE(text);
        const TurningJob job = jobOf(text);
        EXPECT_EQ(job.is_inch, random.is_inch);
        const CorrectedProgram corrected = correctProgram(job);
        const double residual_um = simulatedResidual_um(job, corrected);
        const CompensationParameters& asked = corrected.compensation.parameters;
        EXPECT_LE(residual_um, residualOfArcs_um(asked)) << seed << '\n' << text << corrected.text;
        // The figure that is reported is not below the truth but for the places looked at.
        EXPECT_GE(corrected.compensation.residual.max_um, residual_um - 0.1) << seed;
        EXPECT_LE(corrected.compensation.residual.max_um, residualOfArcs_um(asked)) << seed;
        EXPECT_LE(corrected.compensation.blocks_added, 12) << seed << '\n' << corrected.text;
        // Arcs stay arcs: two at most, some more where one leaves the stock and the forces end.
        const gcode::Toolpath path = jobOf(corrected.text).path;
        const auto arcs = std::count_if(path.moves.begin(), path.moves.end(),
                                        [](const gcode::Move& move) { return move.kind == gcode::MoveKind::Arc; });
        EXPECT_GE(arcs, 1) << seed;
        EXPECT_LE(arcs, random.leaves_stock ? 6 : 2) << seed << '\n' << text << corrected.text;
        added += corrected.compensation.blocks_added;
        (random.is_inch ? worst_inch_um : worst_um) = std::max(random.is_inch ? worst_inch_um : worst_um, residual_um);
    }
    RecordProperty("blocks_added", std::to_string(added));
    RecordProperty("worst_um", std::to_string(worst_um));
    RecordProperty("worst_inch_um", std::to_string(worst_inch_um));
}

TEST(CorrectedProgram, AnArcStaysAnArc)
{
    const std::string text =
        "%\nO0101 (T)\nG21 G18 G40 G99\nT0101\nG50 S2500\nG96 S200 M04\nG00 X38. Z2.\nX28.\nG01 Z-150. F0.2\n"
        "G02 X32. Z-152. R2.\nG01 Z-280.\nX36.\nG00 Z2. M09\nM30\n%\n";
    for (const char* shape : {"R2.", "I2. K0.", "I2."}) {
        std::string program = text;
        program.replace(program.find("R2."), 3, shape);
        const TurningJob job = jobOf(program);
        const CorrectedProgram corrected = correctProgram(job);
        EXPECT_LE(corrected.compensation.residual.max_um, 1.1) << corrected.text;
        EXPECT_LE(simulatedResidual_um(job, corrected), 1.1) << corrected.text;
        EXPECT_LE(corrected.compensation.blocks_added, 10) << corrected.text;
        const auto arcs = std::count_if(corrected.moves.begin(), corrected.moves.end(),
                                        [](const gcode::Move& move) { return move.kind == gcode::MoveKind::Arc; });
        EXPECT_GE(arcs, 1) << corrected.text;
        EXPECT_LE(arcs, 2) << corrected.text;
        // The style of the words is kept.
        EXPECT_EQ(corrected.text.find(shape[0] == 'R' ? 'I' : 'R', corrected.text.find("G02")), std::string::npos)
            << corrected.text;
    }
}

TEST(CorrectedProgram, InchesHaveFourDecimals)
{
    const TurningJob job = jobOf(
        "%\nO0101\nN10 G20 G18 G40 G99\nN30 T0101\nN50 G96 S600 M04\nN60 G00 X1.5 Z.1\nN70 X1.1024\n"
        "N80 G01 Z-11.0236 F.008 (CUT)\nN90 X1.4\nN100 G00 Z.1\nN110 M30\n%\n");
    EXPECT_TRUE(job.is_inch);
    const CorrectedProgram corrected = correctProgram(job);
    for (const std::string& line : linesOf(corrected.text))
        for (std::size_t point = line.find('.'); point != std::string::npos; point = line.find('.', point + 1))
            EXPECT_LE(line.find_first_not_of("0123456789", point + 1) == std::string::npos
                          ? line.size() - point - 1
                          : line.find_first_not_of("0123456789", point + 1) - point - 1,
                      4U)
                << line;
    EXPECT_GT(corrected.compensation.blocks_added, 0);
    EXPECT_LE(corrected.compensation.residual.max_um, 0.6 + 1.27);
    EXPECT_LE(simulatedResidual_um(job, corrected), 0.6 + 1.27);
    EXPECT_FALSE(contains(corrected.compensation.notes, notes::residualAboveTolerance));
}

TEST(CorrectedProgram, AddedBlocksKeepWhatIsAroundTheWords)
{
    const std::string skipped =
        "O1\nG21 G40 G99\nT0101\nG97 S1200 M03\nG00 X36. Z2.\n/X32.\n/N20 G01 Z-100. F0.2\n/G00 X36.\n/Z2.\nX28.\n"
        "G01 Z-100. F0.2\nG00 X40.\nZ2.\nM30\n";
    const CorrectedProgram corrected = correctProgram(jobOf(skipped));
    EXPECT_TRUE(contains(corrected.compensation.notes, notes::skippedBlocksRun));
    ASSERT_GT(corrected.compensation.blocks_added, 2);
    for (const ProgramChange& change : corrected.changes)
        EXPECT_EQ(change.after.starts_with('/'), change.line >= 6 && change.line <= 9) << change.after;

    const std::string ended =
        "O1;\r\nG21G40G99;\r\nT0101;\r\nG97S1200M03;\r\nG00X36.Z2.;\r\nX28.;\r\nG01Z-100.F0.2;\r\n"
        "G00X40.;\r\nZ2.;\r\nM30;\r\n";
    const CorrectedProgram other = correctProgram(jobOf(ended));
    ASSERT_GT(other.compensation.blocks_added, 0);
    for (const ProgramChange& change : other.changes) {
        EXPECT_TRUE(change.after.ends_with(';')) << change.after;
        EXPECT_EQ(change.after.find(' '), std::string::npos) << change.after;
    }
    for (const std::string& line : linesOf(other.text)) EXPECT_TRUE(line.ends_with(";\r")) << line;
}

Values refusal(const std::string& text, const ErrorCode& code, Shaft stock = caseAStock())
{
    try {
        correctProgram(jobOf(text, std::move(stock)));
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), code) << error.what();
        return error.values();
    }
    ADD_FAILURE() << "not refused: " << text;
    return {};
}

TEST(CorrectedProgram, SkippedBlocksThatOthersRestOn)
{
    // With the switch on, the cut would begin at X32. instead of X28., and yet be written at X27.9….
    const Values values =
        refusal("O1\nG21 G40 G99\nT0101\nG97 S1200 M3\nG0 X40. Z2.\nX32.\n/X28.\nG1 Z-100. F0.2\nG0 X40.\nZ2.\nM30\n",
                errors::ncBlockNotRewritable);
    EXPECT_EQ(*find(values, "line"), Value(std::int64_t{8}));
}

TEST(CorrectedProgram, WordsThatMayShapeABlock)
{
    const std::string head = "O1\nG21 G40 G99\nT0101\nG97 S1200 M03\nG00 X36. Z2.\nX28.\n";
    const std::string tail = "X34.\nZ-100.\nG00 X40.\nZ2.\nM30\n";
    for (const char* word : {"I2.", "R2.", "C2.", "A180.", "E0.1"}) {
        const Values values = refusal(head + "G01 Z-60. " + word + " F0.2\n" + tail, errors::ncBlockNotRewritable);
        EXPECT_EQ(*find(values, "line"), Value(std::int64_t{7})) << word;
        EXPECT_EQ(*find(values, "word"), Value(std::string(word)));
        EXPECT_EQ(*find(values, "column"), Value(std::int64_t{11}));
    }
    const Values comma = refusal(head + "G01 Z-60. ,C2. F0.2\n" + tail, errors::ncBlockNotRewritable);
    EXPECT_EQ(*find(comma, "line"), Value(std::int64_t{7}));
    // Of a block of the pass that would not change.
    const Values later =
        refusal(head + "G01 Z-60. F0.2\nX32.\nX36. K-1.\nZ-100.\nG00 X40.\nM30\n", errors::ncBlockNotRewritable);
    EXPECT_EQ(*find(later, "line"), Value(std::int64_t{9}));
    // It would stop before the rest of the cut.
    const Values stop = refusal(head + "G01 Z-60. F0.2 M05\n" + tail, errors::ncBlockNotRewritable);
    EXPECT_EQ(*find(stop, "word"), Value(std::string("M05")));
}

TEST(CorrectedProgram, ABoreIsNoOutsideDiameter)
{
    const std::string bored =
        "O1\nG21 G40 G99\nT0101\nG97 S1200 M3\nG0 X26. Z2.\nX30.\nG1 Z-100. F0.2\nX28.\nG0 Z2.\n"
        "X100. Z100.\nM30\n";
    const Values values = [&] {
        try {
            jobOf(bored, rod(287.5, 34, 28));
        } catch (const Error& error) {
            EXPECT_EQ(error.code(), errors::notModelled);
            return error.values();
        }
        return Values{};
    }();
    EXPECT_EQ(*find(values, "line"), Value(std::int64_t{7}));

    // Beside an outside pass the bore is left out of the prediction, and named; nothing is written.
    const std::string outside =
        "O1\nG21 G40 G99\nT0101\nG97 S1200 M3\nG0 X36. Z2.\nX32.\nG1 Z-100. F0.2\nU1.\nG0 Z2.\n";
    const std::string inside = "G0 X29.\nG1 Z-80. F0.2\nX28.4\nG0 Z2.\nX100. Z100.\nM30\n";
    const TurningJob job = jobOf(outside + inside, rod(287.5, 34, 28));
    EXPECT_EQ(job.bore_line, 11);
    const DeflectionResult predicted = predictJob(job);
    EXPECT_EQ(predicted.passes.size(), 1U);
    EXPECT_TRUE(contains(predicted.notes, notes::boreNotPredicted));
    refusal(outside + inside, errors::notModelled, rod(287.5, 34, 28));
    // A tube is turned outside as any other work.
    EXPECT_FALSE(jobOf(outside + "M30\n", rod(287.5, 34, 28)).bore_line);
    // Drilled by the program, then bored.
    const std::string drilled = "G0 X0. Z2.\nG1 Z-60. F0.1\nG0 Z2.\nX22.\nG1 Z-50. F0.1\nX20.\nG0 Z2.\nM30\n";
    EXPECT_EQ(jobOf(outside + drilled).bore_line, 14);
}

}  // namespace
}  // namespace lathelier::deflection
