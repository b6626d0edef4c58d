// What a control may do between the steps of an exchange, and that no speed holds but that of the values that stand.
#include <gtest/gtest.h>

#include <algorithm>
#include <utility>

#include "engine/link/link_loop.h"
#include "tests/engine/link/paper_case.h"

namespace lathelier::link {
namespace {

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

TEST(LinkLoop, a_spindle_that_starts_at_once_with_the_speed_leaves_it_holding)
{
    ControlInMemory control;
    control.keeps = [&control](const std::string& written) {
        if (written == answeredName) control.values[runningName] = 1;
        return true;
    };
    control.answered(paperAssistant(paperConfig(1)));
    EXPECT_TRUE(control.holds());
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

}  // namespace
}  // namespace lathelier::link
