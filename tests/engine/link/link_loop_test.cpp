#include "engine/link/link_loop.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <utility>

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

/// A control in memory. The test decides what it keeps; it is asked until it holds a speed, or for some heartbeats.
struct ControlInMemory : Transport {
    ControlValues values = paperValues();
    std::function<bool(const std::string& name)> keeps = [](const std::string&) { return true; };
    std::string program;
    std::stop_source stop;
    int beats = 0;

    void open() override { values.insert({{answeredName, 0}, {stateName, 0}, {heartbeatName, 0}, {correctedName, 0}}); }
    ControlValues read(const std::vector<std::string>& names) override
    {
        ControlValues found;
        for (const std::string& name : names) found[name] = values.at(name);
        return found;
    }
    void write(const std::string& name, double value) override
    {
        if (keeps(name)) values[name] = value;
        if (holds() || (name == heartbeatName && ++beats > 5)) stop.request_stop();
    }
    bool holds() const { return values.at(answeredName) == values.at(requestName) && values.at(stateName) == 1; }
    bool offers(const std::string& name) const override { return values.count(name) != 0; }
    std::optional<std::string> loadedProgram() override { return program; }
    void close() noexcept override {}
    bool isOpen() const override { return true; }
    bool isExclusive() const override { return true; }
    std::string peer() const override { return "memory"; }

    /// The log of a loop that answers it.
    std::vector<LogEntry> answered(Assistant assistant)
    {
        std::vector<LogEntry> log;
        LinkLoop loop(*this, assistant, loopSettings(paperConfig(1), false),
                      [&](const LogEntry& entry) { log.push_back(entry); });
        loop.run(Progress(stop.get_token(), {}));
        return log;
    }
};

int countOf(const std::vector<LogEntry>& log, LinkEvent event)
{
    return static_cast<int>(
        std::count_if(log.begin(), log.end(), [&](const LogEntry& entry) { return entry.event == event; }));
}

TEST(LinkLoop, a_control_cleared_before_answered_is_answered_anew_under_the_same_number)
{
    ControlInMemory control;
    int answers = 0;
    control.keeps = [&](const std::string& name) {
        if (name == answeredName && ++answers == 1) control.values[stateName] = control.values[correctedName] = 0;
        return true;
    };
    const auto log = control.answered(paperAssistant(paperConfig(1)));
    EXPECT_EQ(answers, 2);
    EXPECT_EQ(countOf(log, LinkEvent::Exchanged), 2);
    EXPECT_TRUE(control.holds());
    EXPECT_EQ(control.values.at(correctedName), paperCorrected_rpm);
}

TEST(LinkLoop, a_state_that_the_control_does_not_keep_lets_no_earlier_speed_hold)
{
    ControlInMemory control;
    control.values[stateName] = 1;  // of the request 1
    control.values[answeredName] = 1;
    control.values[correctedName] = paperCorrected_rpm;
    control.values[requestName] = 2;
    control.values[diameterName] = -5;
    control.keeps = [](const std::string& name) { return name != stateName; };
    const auto log = control.answered(paperAssistant(paperConfig(1)));
    EXPECT_FALSE(control.holds());
    EXPECT_EQ(control.values.at(answeredName), 1);
    EXPECT_EQ(countOf(log, LinkEvent::Exchanged), 0);
    EXPECT_GT(countOf(log, LinkEvent::Lost), 0);
}

TEST(LinkLoop, values_that_change_while_the_speed_is_written_let_it_not_hold)
{
    for (const auto& [name, value, state] :
         {std::tuple{diameterName, 60.0, State::Changed}, {runningName, 1.0, State::Running}}) {
        ControlInMemory control;
        control.keeps = [&control, name = name, value = value](const std::string& written) {
            if (written == correctedName) control.values[name] = value;
            if (written == answeredName) control.stop.request_stop();
            return true;
        };
        const auto log = control.answered(paperAssistant(paperConfig(1)));
        EXPECT_FALSE(control.holds()) << name;
        EXPECT_EQ(control.values.at(stateName), static_cast<double>(state)) << name;
        EXPECT_FALSE(log.at(1).exchange->reply.n_cor_rpm) << name;
    }
}

TEST(LinkLoop, a_control_with_one_bit_that_gave_up_and_asks_anew_takes_no_speed_of_other_values)
{
    ControlInMemory control;
    control.values[stateName] = 2;
    control.keeps = [&control](const std::string& written) {
        if (written == stateName && control.values[correctedName] == paperCorrected_rpm)
            control.values[diameterName] = 60;
        return true;
    };
    control.answered(paperAssistant(paperConfig(1)));
    EXPECT_FALSE(control.holds());
    EXPECT_EQ(control.values.at(stateName), static_cast<double>(State::Changed));
}

TEST(LinkLoop, a_request_that_is_taken_back_before_it_is_answered_is_none)
{
    ControlInMemory control;
    control.values.insert({{answeredName, 1}, {stateName, 0}, {heartbeatName, 0}, {correctedName, 0}});
    const LinkConfig config = paperConfig(1);
    Assistant assistant = paperAssistant(config);
    LinkLoop loop(control, assistant, loopSettings(config, true), {});
    control.keeps = [&control](const std::string& name) {
        if (name == heartbeatName) control.values[diameterName] = 33;
        if (name == correctedName) control.values[requestName] = 2;
        return true;
    };
    loop.run({});
    ASSERT_TRUE(loop.last());
    EXPECT_EQ(loop.last()->request, 2);
}

TEST(LinkLoop, a_link_that_opens_and_fails_again_and_again_is_told_once)
{
    ControlInMemory control;
    control.keeps = [](const std::string& name) { return name != stateName; };
    const auto log = control.answered(paperAssistant(paperConfig(1)));
    EXPECT_EQ(countOf(log, LinkEvent::Opened), 1);
    EXPECT_EQ(countOf(log, LinkEvent::Lost), 1);
}

TEST(LinkLoop, a_program_that_is_exchanged_while_it_is_answered_is_refused)
{
    const ScratchFolder scratch;
    const auto made = [&](const char* name, double z_mm) {
        const std::string path = (scratch / name).string();
        io::writeFile(path, fmt::format("G18 G21 G90 G7\nG97 S500 M3\nG0 X32 Z2\nG1 Z{} F0.2\nM2\n", z_mm));
        return path;
    };
    ControlInMemory control;
    control.values[diameterName] = 0;
    control.program = made("first.ngc", -60);
    bool is_changed = false;
    control.keeps = [&](const std::string& name) {
        if (name == correctedName && !std::exchange(is_changed, true)) made("first.ngc", -90);
        if (name == answeredName) control.stop.request_stop();
        return true;
    };
    const LinkConfig config = readConfig(configText(R"("program": {"clearance_mm": 20})"), ".");
    control.answered(paperAssistant(config));
    EXPECT_TRUE(is_changed);
    EXPECT_EQ(control.values.at(stateName), static_cast<double>(State::Changed));
}

TEST(LinkLoop, without_a_request_no_state_of_an_earlier_one_stands)
{
    ControlInMemory control;
    control.values[requestName] = 0;
    control.values[stateName] = 1;  // a link that was cut before it wrote `answered`
    control.values[answeredName] = 0;
    control.answered(paperAssistant(paperConfig(1)));
    EXPECT_EQ(control.values.at(stateName), 0);
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
