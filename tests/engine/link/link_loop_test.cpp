#include "engine/link/link_loop.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "engine/core/random.h"
#include "engine/link/link_codes.h"
#include "engine/link/loopback/loopback_transport.h"
#include "engine/link/transports.h"
#include "tests/engine/link/paper_case.h"

namespace lathelier::link {
namespace {

using Fault = SimulatedControl::Fault;

/// A control and an assistant that are linked.
struct Linked {
    SimulatedControl control;
    LinkConfig config = paperConfig(control.port());
    Assistant assistant = paperAssistant(config);
    std::unique_ptr<Transport> transport = transportOf("loopback", config);

    Linked() { state(control, paperValues()); }
    bool isAnswered() const
    {
        const ControlValues now = control.values();
        return now.at(requestName) != 0 && now.at(answeredName) == now.at(requestName);
    }
    State state_() const { return *stateOfNumber(static_cast<std::int64_t>(control.values().at(stateName))); }
};

TEST(LinkLoop, answers_the_case_of_the_paper)
{
    Linked linked;
    const RunningLoop running(*linked.transport, linked.assistant, loopSettings(linked.config, false));
    linked.control.request();
    ASSERT_TRUE(holdsSoon([&] { return linked.isAnswered(); }));
    EXPECT_EQ(linked.control.correctedRpm().value(), paperCorrected_rpm);
    ASSERT_TRUE(holdsSoon([&] { return running.entries().size() >= 2; }));
    const Exchange exchange = running.entries()[1].exchange.value();
    EXPECT_NEAR(exchange.reply.selected_rpm.value(), paperSelected_rpm, 0.1);
    EXPECT_EQ(exchange.read_back_rpm, exchange.written_rpm);
}

TEST(LinkLoop, answers_the_case_of_the_paper_with_its_spindle)
{
    const ScratchFolder scratch;
    Linked linked;
    Assistant assistant(spindleQuestion(scratch), linked.config.limits);
    const RunningLoop running(*linked.transport, assistant, loopSettings(linked.config, false));
    linked.control.set(lengthName, paperLength_mm);
    for (const double speed_m_min : {paperSpeed_m_min, otherSpeed_m_min}) {
        linked.control.set(speedName, speed_m_min);
        linked.control.request();
        ASSERT_TRUE(holdsSoon([&] { return linked.isAnswered(); })) << speed_m_min;
        EXPECT_EQ(linked.control.correctedRpm(), paperCorrected_rpm) << speed_m_min;
    }
    ASSERT_TRUE(holdsSoon([&] { return running.entries().size() >= 3; }));
    EXPECT_NEAR(running.entries()[1].exchange->reply.selected_rpm.value(), paperSelected_rpm, 0.1);
    EXPECT_NEAR(running.entries()[2].exchange->reply.selected_rpm.value(), 2800, 0.1);
}

TEST(LinkLoop, answers_a_thousand_requests_in_a_row)
{
    Linked linked;
    const RunningLoop running(*linked.transport, linked.assistant, loopSettings(linked.config, false));
    for (int i = 0; i < 1000; ++i) {
        // Every other one is out of range: its speed shall not hold.
        const bool is_good = i % 2 == 0;
        linked.control.set(speedName, is_good ? paperSpeed_m_min : 1e9);
        const std::int64_t request = linked.control.request();
        ASSERT_TRUE(holdsSoon([&] { return linked.isAnswered(); })) << i;
        ASSERT_EQ(linked.control.values().at(answeredName), static_cast<double>(request));
        ASSERT_EQ(linked.control.correctedRpm().has_value(), is_good) << i;
        ASSERT_EQ(linked.control.values().at(correctedName), paperCorrected_rpm);
    }
}

TEST(LinkLoop, a_link_that_is_cut_at_any_moment_lets_nothing_wrong_hold)
{
    Linked linked;
    const RunningLoop running(*linked.transport, linked.assistant, loopSettings(linked.config, false));
    const ControlValues other{{speedName, 2000 * M_PI * paperDiameter_mm / 1000}};
    const double otherCorrected = linked.assistant
                                      .answer(
                                          [&] {
                                              ControlValues v = paperValues();
                                              v[speedName] = other.at(speedName);
                                              return v;
                                          }(),
                                          {}, {})
                                      .n_cor_rpm.value();
    ASSERT_NE(otherCorrected, paperCorrected_rpm);
    for (int i = 0; i < 100; ++i) {
        const bool is_first = i % 2 == 0;
        linked.control.set(speedName, is_first ? paperSpeed_m_min : other.at(speedName));
        linked.control.failAfter(
            static_cast<std::int64_t>(12 * randomUniform(50, 0, static_cast<std::uint64_t>(i))),
            std::array{Fault::Cut, Fault::Garbage, Fault::WrongId}[static_cast<std::size_t>(i) % 3]);
        linked.control.request();
        // Whatever holds at any time is that of the values that stand.
        ASSERT_TRUE(holdsSoon([&] {
            const std::optional<double> held = linked.control.correctedRpm();
            if (held) {
                EXPECT_EQ(*held, is_first ? paperCorrected_rpm : otherCorrected) << i;
            }
            return held.has_value();
        })) << i;
    }
    int lost = 0;
    for (const LogEntry& entry : running.entries()) lost += entry.event == LinkEvent::Lost ? 1 : 0;
    EXPECT_GT(lost, 50);
}

TEST(LinkLoop, a_control_that_is_silent_is_lost_within_the_time_out)
{
    Linked linked;
    linked.control.failAfter(3, Fault::Silence);
    const RunningLoop running(*linked.transport, linked.assistant, loopSettings(linked.config, false));
    ASSERT_TRUE(holdsSoon([&] {
        const auto entries = running.entries();
        return entries.size() >= 2 && entries[1].event == LinkEvent::Lost;
    }));
    EXPECT_EQ(running.entries()[1].error->code(), errors::linkLost);
    linked.control.request();
    EXPECT_TRUE(holdsSoon([&] { return linked.control.correctedRpm() == paperCorrected_rpm; }));
}

TEST(LinkLoop, a_second_assistant_on_one_control_is_refused)
{
    Linked linked;
    const RunningLoop first(*linked.transport, linked.assistant, loopSettings(linked.config, false));
    ASSERT_TRUE(holdsSoon([&] { return !first.entries().empty(); }));
    Assistant another = paperAssistant(linked.config);
    const auto transport = transportOf("loopback", linked.config);
    const RunningLoop second(*transport, another, loopSettings(linked.config, false));
    ASSERT_TRUE(holdsSoon([&] { return second.error().has_value(); }));
    EXPECT_EQ(second.error()->code(), errors::linkTaken);
    linked.control.request();
    EXPECT_TRUE(holdsSoon([&] { return linked.control.correctedRpm() == paperCorrected_rpm; }));
}

TEST(LinkLoop, writes_no_speed_while_the_machine_runs)
{
    Linked linked;
    linked.control.set(runningName, 1);
    linked.control.set(correctedName, 1234);
    const RunningLoop running(*linked.transport, linked.assistant, loopSettings(linked.config, false));
    linked.control.request();
    ASSERT_TRUE(holdsSoon([&] { return linked.isAnswered(); }));
    EXPECT_EQ(linked.state_(), State::Running);
    EXPECT_EQ(linked.control.values().at(correctedName), 1234);
    EXPECT_FALSE(linked.control.correctedRpm());
}

TEST(LinkLoop, tells_a_request_that_is_none)
{
    Linked linked;
    const RunningLoop running(*linked.transport, linked.assistant, loopSettings(linked.config, false));
    for (const double wrong : {0.5, -3.0, 1e9}) {
        linked.control.set(stateName, 0);
        linked.control.set(requestName, wrong);
        EXPECT_TRUE(holdsSoon([&] { return linked.state_() == State::NotUnderstood; })) << wrong;
        EXPECT_EQ(linked.control.values().at(correctedName), 0);
    }
}

TEST(LinkLoop, a_control_with_one_bit_is_answered_each_time_it_asks)
{
    Linked linked;
    const RunningLoop running(*linked.transport, linked.assistant, loopSettings(linked.config, false));
    for (int i = 0; i < 3; ++i) {
        linked.control.set(requestName, 1);
        ASSERT_TRUE(holdsSoon([&] { return linked.control.correctedRpm() == paperCorrected_rpm; }));
        linked.control.set(requestName, 0);
        ASSERT_TRUE(holdsSoon([&] { return linked.control.values().at(answeredName) == 0; }));
        EXPECT_EQ(linked.state_(), State::Idle);
    }
}

TEST(LinkLoop, the_heart_beats_while_it_lives)
{
    Linked linked;
    const auto beat = [&] { return linked.control.values().at(heartbeatName); };
    const RunningLoop running(*linked.transport, linked.assistant, loopSettings(linked.config, false));
    for (int i = 0; i < 3; ++i) {
        const double before = beat();
        EXPECT_TRUE(holdsSoon([&] { return beat() != before; }));
    }
}

TEST(LinkLoop, ends_after_one_answer_when_asked_to)
{
    Linked linked;
    linked.control.request();
    LinkLoop loop(*linked.transport, linked.assistant, loopSettings(linked.config, true), {});
    loop.run({});
    EXPECT_EQ(loop.last()->reply.n_cor_rpm, paperCorrected_rpm);
    EXPECT_EQ(linked.control.correctedRpm(), paperCorrected_rpm);
}

TEST(LinkLoop, without_a_control_says_where_it_looked)
{
    LinkConfig config = paperConfig(1);
    Assistant assistant = paperAssistant(config);
    const auto transport = transportOf("loopback", config);
    LinkLoop loop(*transport, assistant, loopSettings(config, true), {});
    try {
        loop.run({});
        FAIL() << "a control was found";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), errors::linkNotFound);
        EXPECT_EQ(*std::get_if<std::string>(find(error.values(), "peer")), "127.0.0.1:1");
    }
}

TEST(LinkLoop, what_is_lost_again_and_again_is_told_once)
{
    const LinkConfig config = paperConfig(1);  // nobody listens there
    const auto transport = transportOf("loopback", config);
    Assistant assistant = paperAssistant(config);
    const RunningLoop running(*transport, assistant, loopSettings(config, false));
    ASSERT_TRUE(holdsSoon([&] { return !running.entries().empty(); }));
    std::this_thread::sleep_for(std::chrono::milliseconds(100));  // of reconnect_ms 10
    EXPECT_EQ(running.entries().size(), 1U);
}

TEST(LinkLog, is_answered_again_as_it_was)
{
    Linked linked;
    const std::string path = (std::filesystem::path(testing::TempDir()) / "link_log.jsonl").string();
    {
        std::ofstream log(path);
        const auto tell = [&](const LogEntry& entry) { log << toJson(entry).dump() << "\n"; };
        for (const double speed : {paperSpeed_m_min, 1e9, 200.0}) {
            linked.control.set(speedName, speed);
            linked.control.request();
            LinkLoop(*linked.transport, linked.assistant, loopSettings(linked.config, true), tell).run({});
        }
        log << R"({"time": "2026)";  // torn by a power cut
    }
    const std::vector<LoggedExchange> read = readLog(path, {}).exchanges;
    ASSERT_EQ(read.size(), 3U);
    EXPECT_EQ(read[0].exchange.reply.n_cor_rpm, paperCorrected_rpm);
    const Replayed same = replay(read, linked.assistant, {});
    EXPECT_EQ(same.exchanges, 3);
    EXPECT_EQ(same.differing, 0);
    project::PanelState other = linked.config.question;
    set(other.parameters, "peak_shift", 0.5);
    Assistant changed(other, linked.config.limits);
    const Replayed differing = replay(read, changed, {});
    EXPECT_EQ(differing.differing, 2);
    EXPECT_EQ(differing.first_differing_line, read[0].line);
}

TEST(LinkLog, names_the_line_that_is_none)
{
    const std::string path = (std::filesystem::path(testing::TempDir()) / "bad_log.jsonl").string();
    std::ofstream(path) << "{\"event\": \"closed\", \"time\": \"\"}\n{\"event\": \"exchange\"}\n";
    try {
        readLog(path, {});
        FAIL() << "read";
    } catch (const Error& error) {
        EXPECT_EQ(std::get<std::int64_t>(*find(error.values(), "line")), 2);
    }
}

}  // namespace
}  // namespace lathelier::link
