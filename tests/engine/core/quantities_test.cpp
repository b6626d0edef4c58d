// Results described once: values, nested JSON, and what is absent.
#include "engine/core/quantities.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace lathelier {
namespace {

struct Inner {
    double range_um = 3;
    std::optional<double> limit_um;
};

struct Outer {
    std::string name = "a";
    Inner inner;
    std::optional<Inner> second;
    std::vector<Inner> list{{}, {4, 5.0}};
    Eigen::Vector3d place_mm{1, 2, 3};
    std::size_t points = 7;
    std::optional<Verdict> verdict;
};

const std::vector<QuantityOf<Inner>>& quantitiesOf(const Inner*)
{
    static const auto all = describedBy<Inner>(
        quantity<Inner>("range_um", &Inner::range_um, {Text{"Range"}, Text{"µm"}, 2}),
        quantity<Inner>("limit_um", &Inner::limit_um),
        quantity<Inner>("half_um", [](const Inner& inner) { return inner.range_um / 2; }, {{}, {}, 3, false}));
    return all;
}

const std::vector<QuantityOf<Outer>>& quantitiesOf(const Outer*)
{
    static const auto all = describedBy<Outer>(
        quantity<Outer>("name", &Outer::name), part("inner", &Outer::inner), part("second", &Outer::second),
        quantity<Outer>("list", [](const Outer& outer) { return listed(outer.list); }),
        quantity<Outer>("place_mm", &Outer::place_mm), quantity<Outer>("points", &Outer::points),
        quantity<Outer>("verdict", verdictKey<Outer>));
    return all;
}

TEST(Quantities, MakeNestedJson)
{
    const Json expected = Json::parse(R"({"name": "a", "inner": {"range_um": 3.0, "limit_um": null}, "second": null,
        "list": [{"range_um": 3.0, "limit_um": null}, {"range_um": 4.0, "limit_um": 5.0}],
        "place_mm": [1.0, 2.0, 3.0], "points": 7, "verdict": null})");
    EXPECT_EQ(nestedJson(describedValues(Outer{})), expected);
}

TEST(Quantities, APartThatIsThereIsAnObject)
{
    Outer outer;
    outer.second = Inner{2, 1.0};
    outer.verdict = Verdict::Undecided;
    const Json json = nestedJson(describedValues(outer));
    EXPECT_EQ(json["second"], Json::parse(R"({"range_um": 2.0, "limit_um": 1.0})"));
    EXPECT_EQ(json["verdict"], "undecided");
}

TEST(Quantities, AreFoundByKey)
{
    EXPECT_EQ(quantityOf<Outer>("inner.range_um").get(Outer{}), Value(3.0));
    EXPECT_EQ(quantityOf<Outer>("inner.half_um").get(Outer{}), Value(1.5));  // of tables alone
    EXPECT_EQ(quantityOf<Inner>("range_um").info.decimals, 2);
    EXPECT_THROW(quantityOf<Outer>("range_um"), std::logic_error);
}

}  // namespace
}  // namespace lathelier
