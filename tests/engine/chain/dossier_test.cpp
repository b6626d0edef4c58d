// Verification of a dossier: digests recomputed, numbers compared with their files.
#include "engine/chain/dossier.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "engine/chain/chain_codes.h"
#include "engine/chain/dossier_cover.h"
#include "engine/chain/dossier_kind.h"
#include "engine/io/file.h"
#include "engine/io/io_codes.h"
#include "engine/report/result_json.h"
#include "tests/scratch_folder.h"

namespace lathelier::chain {
namespace {

InputFile fileAt(const std::string& folder, const std::string& name)
{
    const std::string bytes{io::FileBytes(folder + "/" + name).view()};
    return {name, static_cast<std::int64_t>(bytes.size()), io::sha256(bytes)};
}

/// Two steps; the second uses the output of the first.
struct SmallChain {
    ScratchFolder scratch;
    std::string folder = (scratch / "chain").string();
    std::string scan = (scratch / "scan.xyz").string();
    Json recognised = {
        {"length_mm", 183.02},
        {"length_uncertainty_mm", 0.01},
        {"segments", Json::array({{{"start_diameter_mm", 30.001}, {"uncertainty", {{"start_diameter_um", 2.5}}}},
                                  {{"start_diameter_mm", 37.25}, {"uncertainty", Json::object()}}})}};
    Json drawn = {{"length_mm", 183.0}, {"volume_mm3", 1234.5}};
    Dossier dossier;

    SmallChain()
    {
        std::filesystem::create_directories(folder);
        io::writeFile(scan, "0 0 0\n1 2 3\n");
        io::writeFile(folder + "/recognise.json", report::toText(recognised));
        io::writeFile(folder + "/measured.json", "{}\n");
        io::writeFile(folder + "/draw.json", report::toText(drawn));
        ChainStep first;
        first.id = "recognise";
        first.state = StepState::Done;
        first.inputs = {{scan, 12, io::fileSha256(scan)}};
        first.outputs = {fileAt(folder, "recognise.json"), fileAt(folder, "measured.json")};
        first.result = "recognise.json";
        first.notes = {{notes::unitGuessed, {{"unit", "mm"}}}};
        add(dossier, first, recognised);
        ChainStep second;
        second.id = "draw";
        second.state = StepState::Done;
        second.inputs = {fileAt(folder, "measured.json")};
        second.outputs = {fileAt(folder, "draw.json")};
        second.result = "draw.json";
        add(dossier, second, drawn);
        write();
    }
    void write() const { io::writeFile(folder + "/" + dossierFile, report::toText(toJson(dossier))); }
    DossierCheck check() const { return checkDossier(folder + "/" + dossierFile); }
};

ChainStep judgedStep(const std::string& id, const std::optional<Verdict>& verdict)
{
    ChainStep step;
    step.id = id;
    step.state = StepState::Done;
    step.verdict = verdict;
    return step;
}

TEST(Dossier, TheCoverIsAsRedAsItsWorstStep)
{
    Dossier dossier;
    dossier.steps = {judgedStep("recognise", {}), judgedStep("program", Verdict::Pass)};
    EXPECT_FALSE(dossier.coverVerdict());  // no copy was judged
    dossier.verdict = Verdict::Pass;
    EXPECT_EQ(dossier.coverVerdict(), Verdict::Pass);
    dossier.steps.push_back(judgedStep("deflection", Verdict::Undecided));
    EXPECT_EQ(dossier.coverVerdict(), Verdict::Undecided);
    dossier.steps[1].verdict = Verdict::Fail;
    EXPECT_EQ(dossier.coverVerdict(), Verdict::Fail);
    const Json json = toJson(dossier);
    EXPECT_EQ(json["verdict"], "pass");
    EXPECT_EQ(json["cover_verdict"], "fail");
    const report::Document document = dossierReport(dossier);
    const auto& cover = std::get<report::Answer>(document.sections.front().blocks.front());
    EXPECT_EQ(cover.verdict, Verdict::Fail);
    dossier.steps[1].verdict = Verdict::Pass;
    dossier.steps[2].verdict = Verdict::Fail;
    EXPECT_EQ(dossier.coverVerdict(), Verdict::Fail);
    dossier.steps[2].outputs = {{"program_corrected.nc", 1, "0"}};
    dossier.steps.push_back(judgedStep("corrected_check", Verdict::Pass));
    EXPECT_EQ(dossier.coverVerdict(), Verdict::Pass);  // what was out as programmed has been corrected
    dossier.steps[3].verdict = Verdict::Fail;
    EXPECT_EQ(dossier.coverVerdict(), Verdict::Fail);
    dossier.steps[3] = judgedStep("corrected_check", {});
    dossier.steps[3].state = StepState::Failed;
    EXPECT_EQ(dossier.coverVerdict(), Verdict::Fail);
}

TEST(Dossier, ThePictureOfEachStepIsOnItsPagesAndTheRestInAnnexes)
{
    Dossier dossier;
    for (const char* id : {"recognise", "draw", "speeds", "program", "deflection", "copy", "proof"}) {
        ChainStep step = judgedStep(id, Verdict::Pass);
        report::Plot plot;
        plot.title = LT_TEXT("Engine", "Meridian");
        plot.curves.push_back({{}, {0, 1}, {0, 1}});
        report::Plot more = plot;
        step.sections = {{LT_TEXT("Engine", "Result"), {report::Answer{}, plot, more}}};
        dossier.steps.push_back(std::move(step));
    }
    std::size_t pictures = 0;
    for (const report::Section& section : dossierReport(dossier).sections)
        for (const report::Block& block : section.blocks) {
            EXPECT_FALSE(std::holds_alternative<report::Plot>(block));
            const auto* const picture = std::get_if<report::Picture>(&block);
            if (!picture) continue;
            EXPECT_TRUE(picture->isHalf());
            ++pictures;
        }
    EXPECT_EQ(pictures, 6u);
    const std::vector<Annex> annexes = annexesOf(dossier, {});
    ASSERT_EQ(annexes.size(), 8u);
    EXPECT_EQ(annexes[4].file, "annex_deflection.html");
    EXPECT_EQ(annexes[4].document.sections.size(), 1u);
    EXPECT_EQ(annexes.back().file, "annex_numbers.html");
}

TEST(Dossier, NumbersAreFoundWithTheirUncertainties)
{
    const SmallChain chain;
    const std::vector<TracedNumber>& numbers = chain.dossier.numbers;
    ASSERT_EQ(numbers.size(), 5u);
    EXPECT_EQ(numbers[0].pointer, "/length_mm");
    EXPECT_EQ(numbers[0].uncertainty, 0.01);
    EXPECT_EQ(numbers[1].pointer, "/segments/0/start_diameter_mm");
    EXPECT_EQ(numbers[1].key, "start_diameter_mm");
    EXPECT_EQ(numbers[1].value, 30.001);
    EXPECT_EQ(numbers[1].uncertainty, 2.5);
    EXPECT_EQ(numbers[1].uncertainty_pointer, "/segments/0/uncertainty/start_diameter_um");
    EXPECT_EQ(numbers[2].pointer, "/segments/1/start_diameter_mm");
    EXPECT_FALSE(numbers[2].uncertainty);
    EXPECT_EQ(numbers[3].file, "draw.json");
}

TEST(Dossier, ItemsOfAPlainListAreNamedAfterTheList)
{
    const std::vector<TracedNumber> numbers =
        numbersOf("machine", {{"natural_frequencies_hz", {223.0, 1410.5}}}, "machine.json");
    ASSERT_EQ(numbers.size(), 2u);
    EXPECT_EQ(numbers[1].key, "natural_frequencies_hz");
    EXPECT_EQ(numbers[1].pointer, "/natural_frequencies_hz/1");
}

TEST(Dossier, UntouchedFilesAreSound)
{
    const SmallChain chain;
    const DossierCheck check = chain.check();
    EXPECT_TRUE(check.faults.empty());
    EXPECT_EQ(check.numbers, 5);
    EXPECT_EQ(check.files, 4);
}

TEST(Dossier, AssumptionsAreListed)
{
    const Json json = toJson(SmallChain().dossier);
    ASSERT_EQ(json["assumed"].size(), 1u);
    EXPECT_EQ(json["assumed"][0]["step"], "recognise");
}

TEST(Dossier, AChangedFileIsNamedWhereItWasMadeAndTaken)
{
    const SmallChain chain;
    io::writeFile(chain.folder + "/measured.json", "{ }\n");
    const DossierCheck check = chain.check();
    ASSERT_EQ(check.faults.size(), 2u);
    EXPECT_EQ(check.faults[0].step, "recognise");
    EXPECT_EQ(check.faults[0].what, "output");
    EXPECT_EQ(check.faults[1].step, "draw");
    EXPECT_EQ(check.faults[1].what, "input");
    EXPECT_FALSE(check.faults[1].is_gone);
}

TEST(Dossier, AFileOfTheChainThatNoStepMadeIsFound)
{
    SmallChain chain;
    io::writeFile(chain.folder + "/by_hand.json", "{}\n");
    chain.dossier.steps[1].inputs.push_back(fileAt(chain.folder, "by_hand.json"));
    chain.write();
    const DossierCheck check = chain.check();
    ASSERT_EQ(check.faults.size(), 1u);
    EXPECT_EQ(check.faults[0].step, "draw");
    EXPECT_EQ(check.faults[0].path, "by_hand.json");
}

TEST(Dossier, AMissingScanIsGone)
{
    const SmallChain chain;
    std::filesystem::remove(chain.scan);
    const DossierCheck check = chain.check();
    ASSERT_EQ(check.faults.size(), 1u);
    EXPECT_EQ(check.faults[0].path, chain.scan);
    EXPECT_TRUE(check.faults[0].is_gone);
}

TEST(Dossier, ANumberThatStandsNowhereIsFound)
{
    SmallChain chain;
    chain.dossier.numbers[0].value = 183.03;
    chain.dossier.numbers[3].pointer = "/length";
    chain.dossier.numbers[4].file = "elsewhere.json";
    chain.write();
    const DossierCheck check = chain.check();
    ASSERT_EQ(check.faults.size(), 3u);
    EXPECT_EQ(check.faults[0].place, "/length_mm");
    EXPECT_FALSE(check.faults[0].is_gone);
    EXPECT_TRUE(check.faults[1].is_gone);
    EXPECT_EQ(check.faults[2].path, "elsewhere.json");
}

TEST(Dossier, WhatIsNoDossierIsRefusedWithItsPlace)
{
    const ScratchFolder scratch;
    const std::string path = (scratch / "d.json").string();
    for (const char* text :
         {"", "[]", "{\"schema\": 3}", "{\"schema\": \"lathelier-dossier\", \"steps\": {}}",
          "{\"schema\": \"lathelier-dossier\", \"steps\": [{\"step\": \"draw\", \"inputs\": [{}]}]}"}) {
        io::writeFile(path, text);
        EXPECT_THROW(checkDossier(path), Error) << text;
    }
}

}  // namespace
}  // namespace lathelier::chain
