#include "engine/link/link_config.h"

#include <gtest/gtest.h>

#include "engine/core/core_codes.h"
#include "engine/link/link_codes.h"
#include "engine/link/transports.h"
#include "tests/engine/link/paper_case.h"

namespace lathelier::link {
namespace {

Error refusalOf(const std::string& text)
{
    try {
        readConfig(text, ".");
    } catch (const Error& error) {
        return error;
    }
    ADD_FAILURE() << "read: " << text;
    return Error(errors::internal, {});
}

std::string withPart(const std::string& part)
{
    return configText(part);
}

TEST(LinkConfig, written_and_read_is_the_same)
{
    LinkConfig config = readConfig(barConfigText(R"("program": {"clearance_mm": 12}, "linuxcnc": {"component": "lath"},
        "inputs": {"spindle": {"path": "machines/spindle.json"}})"),
                                   "/shop");
    EXPECT_EQ(config.question.inputs.at("spindle").path, "/shop/machines/spindle.json");
    EXPECT_EQ(config.linuxcnc->component, "lath");
    const std::string text = textOf(config, "/shop");
    EXPECT_NE(text.find("\"machines/spindle.json\""), std::string::npos);
    EXPECT_EQ(textOf(readConfig(text, "/shop"), "/shop"), text);
}

TEST(LinkConfig, a_library_with_a_slash_counts_from_the_file)
{
    LinkConfig config;
    const auto library = [&](const std::string& stated, const std::string& folder) {
        std::string registers;
        int address = 0;
        for (const char* name :
             {requestName, runningName, diameterName, speedName, correctedName, stateName, answeredName, heartbeatName})
            registers.append(registers.empty() ? "" : ", ")
                .append(fmt::format(R"("{}": {{"address": {}}})", name, address += 4));
        config = readConfig(withPart(fmt::format(R"("focas": {{"library": "{}", "host": "a", "registers": {{{}}}}})",
                                                 stated, registers)),
                            folder);
        return config.focas->library;
    };
    EXPECT_EQ(library("libfwlib32.so", "/shop"), "libfwlib32.so");
    EXPECT_EQ(library("vendor/libfwlib32.so", "/shop"), "/shop/vendor/libfwlib32.so");
    EXPECT_EQ(library("./libfwlib32.so", "/shop"), "/shop/libfwlib32.so");
    const std::string text = textOf(config, "/shop");
    EXPECT_NE(text.find("\"./libfwlib32.so\""), std::string::npos);
    EXPECT_EQ(textOf(readConfig(text, "/shop"), "/shop"), text);
}

TEST(LinkConfig, refuses_a_member_that_it_does_not_know_by_its_place)
{
    const Error error = refusalOf("{\"schema\": \"lathelier-assist\", \"schema_version\": 1,\n \"limit\": {}}");
    EXPECT_EQ(error.code(), errors::linkMemberUnknown);
    EXPECT_EQ(std::get<std::int64_t>(*find(error.values(), "line")), 2);
    EXPECT_EQ(refusalOf(withPart(R"("loopback": {"hots": "a"})")).code(), errors::linkMemberUnknown);
    EXPECT_EQ(refusalOf(withPart(R"("inputs": {"copy": {"path": "a"}})")).code(), errors::linkMemberUnknown);
}

TEST(LinkConfig, refuses_what_the_control_states_and_what_would_not_be_used_by_its_place)
{
    const auto line = [](const std::string& text) {
        const Error error = refusalOf(text);
        EXPECT_EQ(std::string(error.code().key), "malformed") << text;
        return std::get<std::int64_t>(*find(error.values(), "line"));
    };
    for (const char* stated : {"length_mm", "diameter_mm", "cutting_speed_m_min", "speed_rpm"})
        EXPECT_EQ(line(barConfigText(fmt::format("\n\"parameters\": {{\n\"{}\": 30}}", stated))), 3) << stated;
    EXPECT_EQ(line(barConfigText("\n\"parameters\": {\"range_m_min\": [{\"from\": 200, \"to\": 350}]}")), 2);
    EXPECT_EQ(line(configText("\n\"inputs\": {\n\"spindle\": {\"path\": \"spindle.json\"}}")), 6);  // beside modes
    EXPECT_EQ(line(configText("\n\"inputs\": {\n\"shaft\": {\"path\": \"shaft.json\"}}")), 2);      // the mode
}

TEST(LinkConfig, needs_the_highest_speed_of_the_machine)
{
    const Error error =
        refusalOf(R"({"schema": "lathelier-assist", "schema_version": 1, "limits": {"lowest_diameter_mm": 3}})");
    EXPECT_EQ(std::string(error.code().key), "key_missing");
}

TEST(LinkConfig, needs_every_register_that_the_rules_of_the_link_use)
{
    const Error error = refusalOf(withPart(R"("focas": {"host": "a", "registers": {"request": {"address": 1}}})"));
    EXPECT_EQ(std::string(error.code().key), "key_missing");
    EXPECT_EQ(std::string(
                  refusalOf(withPart(R"("focas": {"host": "a", "registers": {"request": {"address": 1, "bytes": 3}}})"))
                      .code()
                      .key),
              "malformed");
}

/// The registers of the manual, with another one in place of that of a name.
std::string withRegister(const std::string& name, const std::string& place)
{
    std::string registers;
    for (const auto& [one, usual] : {std::pair<std::string, std::string>{"request", R"({"address": 1000, "bytes": 2})"},
                                     {"running", R"({"address": 1002, "bytes": 1})"},
                                     {"diameter_mm", R"({"address": 1004, "bytes": 4, "scale": 0.001})"},
                                     {"cutting_speed_m_min", R"({"address": 1012, "bytes": 4, "scale": 0.1})"},
                                     {"n_cor_rpm", R"({"address": 1100, "bytes": 4})"},
                                     {"state", R"({"address": 1104, "bytes": 2})"},
                                     {"answered", R"({"address": 1106, "bytes": 2})"},
                                     {"heartbeat", R"({"address": 1108, "bytes": 2})"}})
        registers.append(registers.empty() ? "" : ", ").append("\"" + one + "\": " + (one == name ? place : usual));
    return configText(R"("focas": {"host": "a", "registers": {)" + registers + "}}");
}

TEST(LinkConfig, takes_the_registers_of_the_manual)
{
    EXPECT_EQ(readConfig(withRegister("", ""), ".").focas->registers.size(), 8U);
}

TEST(LinkConfig, refuses_written_registers_that_share_a_byte_by_their_place)
{
    for (const char* place : {R"({"address": 1103, "bytes": 2})", R"({"address": 1001, "bytes": 2})"}) {
        const Error error = refusalOf(withRegister("state", place));
        EXPECT_EQ(std::string(error.code().key), "malformed") << place;
        EXPECT_TRUE(find(error.values(), "line")) << place;
    }
    EXPECT_EQ(std::string(refusalOf(withRegister("diameter_mm", R"({"address": 1099, "bytes": 2})")).code().key),
              "malformed");
}

TEST(LinkConfig, refuses_registers_that_cannot_hold_what_is_written)
{
    for (const char* place : {R"({"address": 1100, "bytes": 1})", R"({"address": 1100, "bytes": 4, "scale": 10})"})
        EXPECT_EQ(std::string(refusalOf(withRegister("n_cor_rpm", place)).code().key), "malformed") << place;
    EXPECT_EQ(std::string(refusalOf(withRegister("heartbeat", R"({"address": 1108, "bytes": 1})")).code().key),
              "malformed");
    EXPECT_EQ(std::string(refusalOf(withRegister("state", R"({"address": 1104, "bytes": 2, "scale": 10})")).code().key),
              "malformed");
    EXPECT_EQ(std::string(refusalOf(withRegister("answered", R"({"address": 1106, "bytes": 1})")).code().key),
              "malformed");
}

TEST(LinkConfig, refuses_a_name_of_a_component_that_hal_does_not_take)
{
    for (const char* name : {"", "9lathe", "two words", "a.b", "a-name-that-is-longer-than-hal-takes"})
        EXPECT_EQ(
            std::string(refusalOf(configText(R"("linuxcnc": {"component": ")" + std::string(name) + "\"}")).code().key),
            "malformed")
            << name;
}

TEST(LinkConfig, a_link_that_is_not_configured_is_refused)
{
    const LinkConfig config = readConfig(configText(""), ".");
    EXPECT_THROW(transportOf("loopback", config), Error);
    EXPECT_THROW(transportOf("telegraph", config), Error);
}

}  // namespace
}  // namespace lathelier::link
