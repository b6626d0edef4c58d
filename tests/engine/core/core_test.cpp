#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <numeric>
#include <optional>
#include <regex>
#include <set>
#include <string>
#include <thread>

#include "engine/core/core_codes.h"
#include "engine/core/error.h"
#include "engine/core/fields.h"
#include "engine/core/json.h"
#include "engine/core/parallel.h"
#include "engine/core/progress.h"
#include "engine/core/texts.h"
#include "engine/io/io_codes.h"

namespace lathelier {
namespace {

enum class Colour { Red, Green };

struct Sample {
    double size_mm = 1;
    std::optional<double> limit_mm;
    int count = 3;
    bool flag = false;
    Colour colour = Colour::Red;
    std::string finish = "turned";
    std::vector<Interval> gaps_mm;
};

const std::vector<Field<Sample>>& fieldsOf(const Sample*)
{
    static const std::vector<Field<Sample>> all{
        field("size_mm", &Sample::size_mm, Range{0, 10}, Label{{"Size"}, {}, {"mm"}}),
        field("limit_mm", &Sample::limit_mm, Range{0, 10}, Label{{"Limit"}, {}, {"mm"}}),
        field("count", &Sample::count, Range{1, 9}, Label{{"Count"}, {}}),
        field("flag", &Sample::flag, Label{{"Flag"}, {}}),
        field("colour", &Sample::colour, {{"red", {"Red"}}, {"green", {"Green"}}}, Label{{"Colour"}, {}}),
        choice("finish", &Sample::finish, {{"turned", {"Turned"}}, {"ground", {"Ground"}}}, Label{{"Finish"}, {}}),
        field("gaps_mm", &Sample::gaps_mm, Range{0, 100}, Label{{"Gaps"}, {}, {"mm"}}),
    };
    return all;
}

const FieldInfo& info(std::string_view key)
{
    for (const Field<Sample>& field : fields<Sample>())
        if (field.info.key == key) return field.info;
    throw std::logic_error("no such field");
}

TEST(Fields, RoundTripThroughValuesAndJson)
{
    Sample sample;
    sample.size_mm = 0.1;
    sample.limit_mm = 2;
    sample.colour = Colour::Green;
    sample.finish = "ground";
    sample.gaps_mm = {{1, 2}, {3, 4.5}};
    const Values values = valuesFromJson(Json::parse(toJson(toValues(sample)).dump()));
    const Sample back = fromValues<Sample>(values);
    EXPECT_EQ(toValues(back), toValues(sample));
    EXPECT_EQ(back.colour, Colour::Green);
    EXPECT_EQ(back.finish, "ground");
    EXPECT_EQ(back.gaps_mm.size(), 2u);
}

TEST(Fields, RejectsWhatIsOutOfRangeOrNotUnderstood)
{
    EXPECT_THROW(parse(info("size_mm"), "11"), Error);
    EXPECT_THROW(parse(info("size_mm"), "1,5"), Error);
    EXPECT_THROW(parse(info("size_mm"), "nan"), Error);
    EXPECT_THROW(parse(info("size_mm"), ""), Error);
    EXPECT_THROW(parse(info("count"), "1.5"), Error);
    EXPECT_THROW(parse(info("colour"), "blue"), Error);
    EXPECT_THROW(fromValues<Sample>({{"finish", std::string("polished")}}), Error);
    EXPECT_THROW(parse(info("gaps_mm"), "4:3"), Error);
    EXPECT_THROW(fromValues<Sample>({{"size_mm", Value()}}), Error);
    EXPECT_FALSE(fromValues<Sample>({{"limit_mm", Value()}}).limit_mm);
    EXPECT_EQ(std::get<std::vector<Interval>>(parse(info("gaps_mm"), "1:2,3:4.5")).size(), 2u);
    try {
        parse(info("colour"), "blue");
    } catch (const Error& error) {
        EXPECT_EQ(error.code().kind, ErrorKind::WrongUsage);
        EXPECT_STREQ(error.what(), "colour: found “blue”, expected red | green.");
    }
}

TEST(Texts, AnErrorNamesItsPlace)
{
    Error error(
        errors::malformed,
        {{"line", std::int64_t{12}}, {"column", std::int64_t{4}}, {"found", "abc"}, {"expected", Text{"a number"}}});
    error.with("path", "shaft.xyz").with("line", std::int64_t{99});
    EXPECT_STREQ(error.what(), "shaft.xyz, line 12, column 4: Found “abc”, expected a number.");
    EXPECT_EQ(toJson(error)["line"], 12);
    EXPECT_EQ(toJson(error)["code"], "malformed");
}

TEST(Texts, TranslationAndNumbersOfTheReader)
{
    Language german;
    german.translate = [](const char* english) { return std::string(english) == "a {x} b" ? "ein {x} bee" : english; };
    german.number = [](double) { return std::string("1,5"); };
    EXPECT_EQ(fill(text(Text{"a {x} b"}, german), {{"x", 1.5}}, german), "ein 1,5 bee");
    EXPECT_EQ(fill("{unknown} {", {}), "{unknown} {");
    EXPECT_EQ(fill("{a} {unit}: end", {{"a", 2.0}, {"unit", Text{}}}), "2: end");
}

// Codes are objects beside their rooms: collected from the sources, so that none is missed.
TEST(Codes, KeysAreUniqueAndPatternsNameNoValueCode)
{
    const std::regex definition(R"re((Error|Note)Code (\w+)\{\s*"([^"]*)")re");
    std::set<std::string> keys;
    std::size_t definitions = 0;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(LATHELIER_SOURCE_DIR "/engine")) {
        if (!entry.path().filename().string().ends_with("_codes.h")) continue;
        std::ifstream file(entry.path());
        const std::string source{std::istreambuf_iterator<char>(file), {}};
        for (std::sregex_iterator match(source.begin(), source.end(), definition), end; match != end; ++match) {
            ++definitions;
            EXPECT_TRUE(keys.insert((*match)[1].str() + " " + (*match)[3].str()).second) << *match->begin();
        }
        // In JSON the values of a note stand beside its "code".
        EXPECT_EQ(source.find("{code}"), std::string::npos) << entry.path();
    }
    EXPECT_GE(definitions, 104u);
}

TEST(Json, NumbersThatDoNotExistAreNull)
{
    EXPECT_EQ(toJson(Value(std::numeric_limits<double>::quiet_NaN())).dump(), "null");
    EXPECT_EQ(toJson(Value()).dump(), "null");
    EXPECT_EQ(toJson(Value(0.1)).dump(), "0.1");
}

TEST(Progress, NestsAndStops)
{
    std::stop_source stop;
    std::vector<double> seen;
    const Progress all(stop.get_token(), [&](double fraction, Text) { seen.push_back(fraction); });
    all.part(0.2, 0.7).part(0.5, 1.0).report(0.5);
    ASSERT_EQ(seen.size(), 1u);
    EXPECT_DOUBLE_EQ(seen[0], 0.2 + 0.5 * 0.75);
    stop.request_stop();
    EXPECT_THROW(all.report(0.5), Cancelled);
    EXPECT_NO_THROW(Progress().report(0.5));
}

TEST(Parallel, SameBitsForAnyNumberOfThreads)
{
    const auto sum = [](int threads) {
        const ThreadLimit limit(threads);
        EXPECT_TRUE(threads == 0 || threadsAllowed() == static_cast<std::size_t>(threads));
        return parallelReduce(
            100000, 1000, {}, 0.0,
            [](std::size_t begin, std::size_t end) {
                double part = 0;
                for (std::size_t i = begin; i < end; ++i) part += 1.0 / (1.0 + static_cast<double>(i));
                return part;
            },
            [](double a, double b) { return a + b; });
    };
    EXPECT_EQ(sum(1), sum(2));
    EXPECT_EQ(sum(1), sum(0));
}

// A nested loop completes or throws, whatever its siblings do: incomplete results once crashed the program.
TEST(Parallel, AnErrorBesideALoopDoesNotCutIt)
{
    for (int round = 0; round < 200; ++round) {
        std::atomic<int> inner = 0;
        int seen = 1000;
        const auto both = [&](std::size_t begin, std::size_t) {
            if (begin == 1) throw std::runtime_error("beside");
            parallelFor(1000, 1, {}, [&](std::size_t, std::size_t) { ++inner; });
            seen = inner;
        };
        EXPECT_THROW(parallelFor(2, 1, {}, both), std::runtime_error);
        ASSERT_EQ(seen, 1000) << round;  // complete, or not started
    }
}

TEST(Parallel, ErrorsAndCancelComeOut)
{
    EXPECT_THROW(parallelFor(1000, 10, {}, [](std::size_t, std::size_t) { throw Error(errors::noPoints, {}); }), Error);
    std::stop_source stop;
    stop.request_stop();
    EXPECT_THROW(parallelFor(1000, 10, Progress(stop.get_token(), {}), [](std::size_t, std::size_t) {}), Cancelled);
}

}  // namespace
}  // namespace lathelier
