// The chain from scan to proof on parts that are made here, each with its own machine, tools and control; their
// dossiers read back by a reader of its own: every digest computed anew, every number followed to the file that it
// stands in, and that file to the files from outside.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <set>

#include "engine/cam/job_file.h"
#include "engine/deflection/setup_file.h"
#include "engine/io/file.h"
#include "engine/io/shaft/shaft_file.h"
#include "engine/receptance/spindle/spindle_file.h"
#include "tests/app/cli/chain_parts.h"
#include "tests/app/cli/run_program.h"
#include "tests/scratch_folder.h"

namespace lathelier::golden {
namespace {

namespace fs = std::filesystem;
using sample::ShaftModel;

Run runOf(std::vector<std::string> words)
{
    Run run;
    run.words = std::move(words);
    return run;
}

Json readJson(const std::string& path)
{
    const io::FileBytes bytes(path);
    return Json::parse(bytes.view());
}

/// The inputs of a part and what the chain made of them, once for all tests of the part.
class MadePart {
public:
    explicit MadePart(const Part& part)
    {
        ShaftModel worn = part.model, copy = part.model;
        worn.front().barrel_um = -part.worn_um;
        copy.front().taper_start_um = part.copy_um;
        question_ = {"remanufacture", write("worn.ply", scanOf(worn, 11))};
        add("--machine", write("spindle.json", receptance::spindleText({part.springs})));
        add("--job", write("job.json", cam::jobText(jobOf(part))));
        add("--setup", write("setup.json", deflection::setupText(setupOf(part))));
        add("--copy", write("copy.ply", scanOf(copy, 12)));
        add("--post", part.post);
        add("--tolerance-mm", "0.08");
        add("--out", out());
        if (part.is_drawn) {
            add("--drawing", write("drawing.json", io::shaftText(drawingOf(part))));
            add("--confirmed-by", "A. Turner");
        } else {
            add("--snap", "apply");
        }
        add("--json", "-");
        run_ = runProgram(LATHELIER_CLI, runOf(question_));
        fs::copy(inputs_, kept_, fs::copy_options::recursive);
    }

    const std::vector<std::string>& question() const { return question_; }
    const Outcome& run() const { return run_; }
    std::string out() const { return (inputs_ / "chain").string(); }
    std::string write(const std::string& name, const std::string& text) const
    {
        fs::create_directories(inputs_);
        const std::string path = (inputs_ / name).string();
        io::writeFile(path, text);
        return path;
    }
    /// All files as they were after the first run, and of an age at which nobody writes into them any more.
    void restore() const
    {
        fs::remove_all(inputs_);
        fs::copy(kept_, inputs_, fs::copy_options::recursive);
        for (const fs::directory_entry& entry : fs::recursive_directory_iterator(inputs_))
            if (entry.is_regular_file())
                fs::last_write_time(entry.path(), fs::file_time_type::clock::now() - std::chrono::hours(1));
    }

private:
    ScratchFolder scratch_;
    fs::path kept_ = scratch_ / "kept", inputs_ = scratch_ / "part";
    std::vector<std::string> question_;
    Outcome run_;

    void add(const std::string& option, const std::string& value)
    {
        question_.push_back(option);
        question_.push_back(value);
    }
};

class ChainOfPart : public ::testing::TestWithParam<Part> {
protected:
    static void TearDownTestSuite() { made().clear(); }
    void SetUp() override
    {
        std::unique_ptr<MadePart>& part = made()[GetParam().name];
        if (!part) part = std::make_unique<MadePart>(GetParam());
        part_ = part.get();
        part_->restore();
        out_ = part_->out();
        ASSERT_EQ(part_->run().exit_code, 0) << part_->run().standard_error;
    }
    std::string write(const std::string& name, const std::string& text) const { return part_->write(name, text); }
    const std::vector<std::string>& question() const { return part_->question(); }

    const MadePart* part_ = nullptr;
    std::string out_;

private:
    static std::map<std::string, std::unique_ptr<MadePart>>& made()
    {
        static std::map<std::string, std::unique_ptr<MadePart>> all;
        return all;
    }
};

/// The dossier's own check is not used here: it is what is tested.
void followEverything(const std::string& folder, const Json& dossier)
{
    std::map<std::string, std::string> made;              // file of the chain → digest
    std::map<std::string, std::set<std::string>> origin;  // file of the chain → files from outside
    for (const Json& step : dossier["steps"]) {
        if (step["state"] != "done") continue;
        std::set<std::string> from;
        EXPECT_FALSE(step["inputs"].empty()) << step["step"];
        for (const Json& file : step["inputs"]) {
            const std::string path = file["path"], sha256 = file["sha256"];
            const std::string at = (fs::path(folder) / path).string();
            EXPECT_EQ(io::fileSha256(at), sha256) << step["step"] << ": " << path;
            EXPECT_EQ(fs::file_size(at), file["bytes"].get<std::uintmax_t>()) << path;
            if (fs::path(path).is_absolute()) {
                from.insert(path);
                continue;
            }
            // Its own step may write what its verb then takes.
            if (made.count(path) == 0) {
                bool is_own = false;
                for (const Json& output : step["outputs"]) is_own = is_own || output["path"] == path;
                EXPECT_TRUE(is_own) << path;
                continue;
            }
            EXPECT_EQ(made[path], sha256) << path;
            from.insert(origin[path].begin(), origin[path].end());
        }
        EXPECT_FALSE(from.empty()) << step["step"];
        for (const Json& file : step["outputs"]) {
            const std::string path = file["path"];
            EXPECT_EQ(io::fileSha256((fs::path(folder) / path).string()), file["sha256"]) << path;
            made[path] = file["sha256"];
            origin[path] = from;
        }
    }
    EXPECT_GT(dossier["numbers"].size(), 30u);
    std::map<std::string, Json> read;
    for (const Json& number : dossier["numbers"]) {
        const std::string file = number["file"];
        ASSERT_EQ(made.count(file), 1u) << file;
        EXPECT_FALSE(origin[file].empty()) << file;
        if (read.count(file) == 0) read[file] = readJson((fs::path(folder) / file).string());
        const Json& written = read[file];
        const Json::json_pointer place(number["pointer"].get<std::string>());
        ASSERT_TRUE(written.contains(place)) << file << number["pointer"];
        EXPECT_EQ(written.at(place), number["value"]) << file << number["pointer"];
        if (number["uncertainty"].is_null()) continue;
        const Json::json_pointer spread(number["uncertainty_pointer"].get<std::string>());
        EXPECT_EQ(written.at(spread), number["uncertainty"]) << file << number["uncertainty_pointer"];
    }
}

TEST_P(ChainOfPart, IsFollowedFromScanToProof)
{
    const Part& part = GetParam();
    const Json dossier = readJson(out_ + "/dossier.json");
    for (const Json& step : dossier["steps"]) {
        const std::string id = step["step"];
        if (id != "surface") {
            EXPECT_EQ(step["state"], "done") << id << step["remarks"];
        }
    }
    followEverything(out_, dossier);
    EXPECT_TRUE(fs::exists(out_ + "/program" + part.extension) || fs::exists(out_ + "/program_1" + part.extension));
    EXPECT_TRUE(dossier["verdict"].is_string());
    if (part.is_drawn) {
        EXPECT_EQ(dossier["confirmed"][0]["by"], "A. Turner");
    }
    // What was cut into the copy is what its rows say.
    const Json copy = readJson(out_ + "/copy.json");
    double measured_um = 0;
    for (const Json& row : copy["rows"])
        if (row["quantity"] == "diameter" && row["row"] == 1) measured_um = 1000 * row["deviation_mm"].get<double>();
    EXPECT_NEAR(measured_um, part.copy_um, 4);  // a taper of the radius: half of it on the mean radius
    const Json proof = readJson(out_ + "/proof.json");
    EXPECT_FALSE(proof["places"].empty());
}

TEST_P(ChainOfPart, GoesOnWhereAFileHasChanged)
{
    std::vector<std::string> words = question();
    const Json before = readJson(out_ + "/dossier.json");
    words.emplace_back("--resume");
    ASSERT_EQ(runProgram(LATHELIER_CLI, runOf(words)).exit_code, 0);
    const Json same = readJson(out_ + "/dossier.json");
    EXPECT_EQ(before["steps"], same["steps"]);
    EXPECT_EQ(before["numbers"], same["numbers"]);
    EXPECT_EQ(before["assumed"].size(), same["assumed"].size());
    deflection::TurningSetup setup = setupOf(GetParam());
    setup.chuck.tilt_N_mm_rad /= 2;
    write("setup.json", deflection::setupText(setup));
    ASSERT_EQ(runProgram(LATHELIER_CLI, runOf(words)).exit_code, 0);
    const Json after = readJson(out_ + "/dossier.json");
    followEverything(out_, after);
    for (std::size_t i = 0; i < after["steps"].size(); ++i) {
        const std::string id = after["steps"][i]["step"];
        const bool follows = id.starts_with("deflection") || id == "corrected_check" || id == "proof";
        EXPECT_EQ(before["steps"][i]["outputs"] == after["steps"][i]["outputs"], !follows || id == "surface") << id;
    }
}

/// The question with another job, as a technologist gets it wrong.
std::vector<std::string> withJob(std::vector<std::string> words, const std::string& path)
{
    *(std::find(words.begin(), words.end(), "--job") + 1) = path;
    return words;
}

TEST_P(ChainOfPart, AToolListThatCannotMakeThePartIsSaidAndWhatWasMadeStays)
{
    const std::string drawn = io::fileSha256(out_ + "/draw.json"), compared = io::fileSha256(out_ + "/copy.json");
    cam::Job job = jobOf(GetParam());
    std::erase_if(job.tools, [](const cam::JobTool& tool) { return tool.use == cam::ToolUse::Finish; });
    std::vector<std::string> bad = withJob(question(), write("no_finish.json", cam::jobText(job)));
    bad.emplace_back("--resume");
    const Outcome run = runProgram(LATHELIER_CLI, runOf(bad));
    EXPECT_TRUE(run.exit_code == 3 || run.exit_code == 4) << run.exit_code;
    EXPECT_FALSE(run.standard_error.empty());
    const Json dossier = readJson(out_ + "/dossier.json");
    bool has_failed = false;
    for (const Json& step : dossier["steps"]) {
        if (has_failed) {
            EXPECT_EQ(step["state"], "not_reached") << step["step"];
        }
        if (step["state"] != "failed") continue;
        has_failed = true;
        EXPECT_TRUE(step["error"]["code"].is_string());
        EXPECT_FALSE(step["remarks"].empty());
    }
    EXPECT_TRUE(has_failed);
    EXPECT_EQ(io::fileSha256(out_ + "/draw.json"), drawn);
    EXPECT_EQ(io::fileSha256(out_ + "/copy.json"), compared);
}

TEST_P(ChainOfPart, ASectionWithoutASafeSpeedIsSaid)
{
    cam::Job job = jobOf(GetParam());
    job.max_rpm = 200;  // below every lobe that is looked at
    std::vector<std::string> words = withJob(question(), write("slow.json", cam::jobText(job)));
    words.emplace_back("--resume");
    const Outcome run = runProgram(LATHELIER_CLI, runOf(words));
    ASSERT_EQ(run.exit_code, 0) << run.standard_error;
    const Json dossier = readJson(out_ + "/dossier.json");
    const Json planned = readJson(out_ + "/program.json");
    std::size_t chosen = 0;
    for (const Json& section : planned["sections"]) {
        if (section["speed_rpm"].is_null()) continue;  // a cone keeps the cutting speed
        ++chosen;
        EXPECT_NE(section["reason"].get<std::string>().find("no stable speed"), std::string::npos);
        EXPECT_LE(section["speed_rpm"].get<double>(), 200);
    }
    std::size_t noteCount = 0;
    for (const Json& note : dossier["notes"]) noteCount += note["code"] == "no_stable_speed";
    EXPECT_GT(chosen, 0u);
    EXPECT_GE(noteCount, chosen);
    for (const Json& step : dossier["steps"])
        if (step["step"] == "draw" || step["step"] == "speeds") {
            EXPECT_EQ(step["state"], "done");
        }
}

TEST_P(ChainOfPart, AFileThatChangedSinceIsToldByInspect)
{
    write("setup.json", "{}");
    fs::remove(out_ + "/rows.csv");
    const Outcome run = runProgram(LATHELIER_CLI, runOf({"inspect", out_ + "/dossier.json", "--json", "-"}));
    ASSERT_EQ(run.exit_code, 0) << run.standard_error;
    const Json details = Json::parse(run.standard_output)["files"][0]["details"];
    EXPECT_EQ(details["unchanged"], false);
    std::set<std::string> named;
    for (const Json& fault : details["faults"])
        named.insert(fs::path(fault["path"].get<std::string>()).filename().string());
    EXPECT_EQ(named, (std::set<std::string>{"setup.json", "rows.csv"}));
}

INSTANTIATE_TEST_SUITE_P(Chain, ChainOfPart, ::testing::ValuesIn(parts()),
                         [](const auto& of) { return std::string(of.param.name); });

}  // namespace
}  // namespace lathelier::golden
