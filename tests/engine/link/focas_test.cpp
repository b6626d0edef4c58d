// The link through FOCAS2, over a library of our own that speaks the published interface.
#include "engine/link/focas/focas_transport.h"

#include <dlfcn.h>
#include <gtest/gtest.h>

#include <functional>

#include "engine/link/link_codes.h"
#include "engine/link/transports.h"
#include "tests/engine/link/paper_case.h"

namespace lathelier::link {
namespace {

constexpr double timeout_ms = 200;
constexpr double watch_ms = 125;  // 2.5 of the heartbeat's periods of these tests
constexpr short handleLost = -8;
constexpr short socketLost = -16;
constexpr short wasReset = -2;
constexpr short isBusy = -1;
constexpr short badRange = 3;
constexpr int refusalCalls = 7;    // request, values twice, state and answered with their read-backs
constexpr int exchangeCalls = 12;  // with state 0 and N_cor and theirs, and the values once more

/// The control inside the library of the tests.
class FakeControl {
public:
    FakeControl() : library_(::dlopen(LATHELIER_FAKE_FOCAS, RTLD_NOW))
    {
        if (!library_) throw std::runtime_error(::dlerror());
        call<void()>("fake_restart")();
    }
    ~FakeControl()
    {
        release();
        watch(nullptr, nullptr);
        ::dlclose(library_);
    }
    FakeControl(const FakeControl&) = delete;
    FakeControl& operator=(const FakeControl&) = delete;

    void put(const Register& place, double value)
    {
        const auto number = static_cast<std::uint32_t>(static_cast<std::int32_t>(std::lround(value / place.scale)));
        for (int i = 0; i < place.bytes; ++i)
            call<void(int, unsigned char)>("fake_poke")(place.address + i,
                                                        static_cast<unsigned char>((number >> (8 * i)) & 0xFF));
    }
    double at(const Register& place) const
    {
        std::uint32_t number = 0;
        for (int i = 0; i < place.bytes; ++i)
            number |= std::uint32_t{call<unsigned char(int)>("fake_peek")(place.address + i)} << (8 * i);
        return static_cast<double>(static_cast<std::int32_t>(number)) * place.scale;
    }
    /// Asks with a request of one byte; after so many calls from then on as many fail.
    void askFailing(const Register& request, unsigned char number, int calls, short code, int times = 1)
    {
        call<void(int, int, short, int, unsigned char)>("fake_fail_after")(calls, times, code, request.address, number);
    }
    /// Likewise; one call does not come back.
    void askHolding(const Register& request, unsigned char number, int calls)
    {
        call<void(int, int, unsigned char)>("fake_hold_after")(calls, request.address, number);
    }
    int held() const { return call<int()>("fake_held")(); }
    void release() { call<void()>("fake_release")(); }
    int handles() const { return call<int()>("fake_handles")(); }
    void stateOtherRange(bool states) { call<void(bool)>("fake_state_other_range")(states); }
    using Watch = void (*)(const unsigned char* area, void* of);
    void watch(Watch show, void* of) { call<void(Watch, void*)>("fake_watch")(show, of); }
    void restart() { call<void()>("fake_restart")(); }

private:
    template <class Function>
    Function* call(const char* name) const
    {
        return reinterpret_cast<Function*>(::dlsym(library_, name));
    }

    void* library_;
};

FocasSettings settings()
{
    FocasSettings made;
    made.library = LATHELIER_FAKE_FOCAS;
    made.host = "192.168.1.10";
    made.registers = {{requestName, {1000, 2, 1}},    {runningName, {1002, 1, 1}},  {diameterName, {1004, 4, 0.001}},
                      {lengthName, {1008, 4, 0.001}}, {speedName, {1012, 4, 0.1}},  {correctedName, {1100, 4, 1}},
                      {stateName, {1104, 2, 1}},      {answeredName, {1106, 2, 1}}, {heartbeatName, {1108, 2, 1}}};
    return made;
}

/// Looks after each write of the assistant whether the control would take a speed that is wrong.
struct Watcher {
    FocasSettings registers;
    double right_rpm = 0;
    int held = 0;   ///< times that a speed held
    int wrong = 0;  ///< of these

    static double at(const unsigned char* area, const Register& place)
    {
        std::int64_t number = 0;
        for (int i = 0; i < place.bytes; ++i) number += std::int64_t{area[place.address + i]} << (8 * i);
        return static_cast<double>(number) * place.scale;  // those that are looked at are not negative
    }
    void look(const unsigned char* area)
    {
        const auto value = [&](const char* name) { return at(area, registers.registers.at(name)); };
        if (value(requestName) == 0 || value(answeredName) != value(requestName) || value(stateName) != 1) return;
        ++held;
        if (value(correctedName) != right_rpm || value(speedName) != paperSpeed_m_min) ++wrong;
    }
    static void show(const unsigned char* area, void* of) { static_cast<Watcher*>(of)->look(area); }
};

std::string codeOf(const std::function<void()>& what)
{
    try {
        what();
    } catch (const Error& error) {
        return error.code().key;
    }
    return "";
}

struct FocasLink : testing::Test {
    FakeControl control;
    FocasSettings registers = settings();
    LinkConfig config = [this] {
        LinkConfig made = readConfig(configText(), ".");
        made.focas = registers;
        return made;
    }();
    Assistant assistant = paperAssistant(config);
    std::unique_ptr<Transport> transport = focasTransport(registers, timeout_ms);
    LoopSettings loop = [this] {
        LoopSettings made = loopSettings(config, false);
        made.watch_ms = watch_ms;
        return made;
    }();

    double at(const char* name) const { return control.at(registers.registers.at(name)); }
    void put(const char* name, double value) { control.put(registers.registers.at(name), value); }
    void statePaper()
    {
        put(diameterName, paperDiameter_mm);
        put(speedName, paperSpeed_m_min);
    }
    bool holds(double request) const { return at(answeredName) == request && at(stateName) == 1; }
};

TEST_F(FocasLink, answers_the_case_of_the_paper)
{
    statePaper();
    const RunningLoop running(*transport, assistant, loop);
    put(requestName, 1);
    ASSERT_TRUE(holdsSoon([&] { return holds(1); }));
    EXPECT_EQ(at(correctedName), paperCorrected_rpm);
    ASSERT_TRUE(holdsSoon([&] { return running.entries().size() >= 2; }));
    EXPECT_FALSE(running.entries()[0].is_verified);
    EXPECT_NEAR(running.entries()[1].exchange->reply.selected_rpm.value(), paperSelected_rpm, 0.1);
}

TEST_F(FocasLink, answers_the_case_of_the_paper_with_its_spindle)
{
    const ScratchFolder scratch;
    Assistant with_spindle(spindleQuestion(scratch), config.limits);
    statePaper();
    put(lengthName, paperLength_mm);
    const RunningLoop running(*transport, with_spindle, loop);
    put(requestName, 1);
    ASSERT_TRUE(holdsSoon([&] { return holds(1); }));
    EXPECT_EQ(at(correctedName), paperCorrected_rpm);
}

TEST_F(FocasLink, a_call_that_fails_at_any_place_lets_nothing_wrong_hold)
{
    statePaper();
    Watcher watcher{registers, paperCorrected_rpm};
    control.watch(Watcher::show, &watcher);
    int asked = 0;
    int lost = 0;
    {
        const RunningLoop running(*transport, assistant, loop);
        ASSERT_TRUE(holdsSoon([&] { return at(heartbeatName) != 0; }));
        for (const short code : {socketLost, handleLost, wasReset, badRange})
            for (int place = 0; place < exchangeCalls + 2; ++place) {  // a heartbeat may come between
                // Out of range every other time: no speed shall hold.
                const bool is_good = ++asked % 2 == 0;
                put(speedName, is_good ? paperSpeed_m_min : 150000);
                put(correctedName, 1);
                control.askFailing(registers.registers.at(requestName), static_cast<unsigned char>(asked), place, code);
                ASSERT_TRUE(holdsSoon([&] { return at(answeredName) == asked; })) << asked;
                EXPECT_EQ(at(stateName) == 1, is_good) << asked;
                EXPECT_EQ(at(correctedName), is_good ? paperCorrected_rpm : 1) << asked;
            }
        for (const LogEntry& entry : running.entries()) lost += entry.event == LinkEvent::Lost ? 1 : 0;
    }
    control.watch(nullptr, nullptr);
    EXPECT_GE(lost, 4 * refusalCalls);
    EXPECT_GE(watcher.held, asked / 2);
    EXPECT_EQ(watcher.wrong, 0);
}

TEST_F(FocasLink, a_call_that_does_not_come_back_is_left_and_nothing_late_holds)
{
    statePaper();
    Watcher watcher{registers, paperCorrected_rpm};
    control.watch(Watcher::show, &watcher);
    {
        const RunningLoop running(*transport, assistant, loop);
        ASSERT_TRUE(holdsSoon([&] { return at(heartbeatName) != 0; }));
        const auto lost = [&] {
            int count = 0;
            for (const LogEntry& entry : running.entries()) count += entry.event == LinkEvent::Lost ? 1 : 0;
            return count;
        };
        for (int place = 0; place < exchangeCalls; ++place) {
            const int before = lost();
            put(speedName, paperSpeed_m_min);
            put(correctedName, 1);
            control.askHolding(registers.registers.at(requestName), static_cast<unsigned char>(2 * place + 1), place);
            ASSERT_TRUE(holdsSoon([&] { return control.held() == 1; })) << place;
            // Lost, and tried again while the call is still away.
            ASSERT_TRUE(holdsSoon([&] { return lost() >= before + 2; })) << place;
            const bool is_written = place == exchangeCalls - 1;  // its read-back is away
            EXPECT_EQ(at(answeredName) == 2 * place + 1, is_written) << place;
            put(speedName, 150000);
            put(requestName, 2 * place + 2);
            control.release();
            ASSERT_TRUE(holdsSoon([&] { return at(answeredName) == 2 * place + 2; })) << place;
            EXPECT_NE(at(stateName), 1) << place;
        }
    }
    control.watch(nullptr, nullptr);
    EXPECT_EQ(watcher.wrong, 0);
    transport.reset();
    EXPECT_EQ(control.handles(), 0);
}

TEST_F(FocasLink, a_loop_is_stopped_while_a_call_does_not_come_back)
{
    {
        const RunningLoop running(*transport, assistant, loop);
        ASSERT_TRUE(holdsSoon([&] { return at(heartbeatName) != 0; }));
        control.askHolding(registers.registers.at(requestName), 1, 0);
        ASSERT_TRUE(holdsSoon([&] { return control.held() == 1; }));
    }  // would not end
    transport.reset();
    EXPECT_EQ(control.held(), 1);
    control.release();
    EXPECT_TRUE(holdsSoon([&] { return control.handles() == 0; }));
}

TEST_F(FocasLink, a_control_that_is_busy_is_asked_again)
{
    transport->open();
    put(diameterName, 32);
    control.askFailing(registers.registers.at(requestName), 0, 0, isBusy, 3);
    EXPECT_EQ(transport->read({diameterName}).at(diameterName), 32);
    control.askFailing(registers.registers.at(requestName), 0, 0, isBusy, 1000000);
    EXPECT_EQ(codeOf([&] { transport->read({diameterName}); }), "link_lost");
}

TEST_F(FocasLink, a_control_that_restarts_is_linked_again)
{
    const RunningLoop running(*transport, assistant, loop);
    ASSERT_TRUE(holdsSoon([&] { return at(heartbeatName) != 0; }));
    control.restart();
    statePaper();
    put(requestName, 7);
    ASSERT_TRUE(holdsSoon([&] { return holds(7); }));
    EXPECT_EQ(at(correctedName), paperCorrected_rpm);
}

TEST_F(FocasLink, a_second_assistant_is_refused_by_the_heartbeat)
{
    const RunningLoop first(*transport, assistant, loop);
    ASSERT_TRUE(holdsSoon([&] { return at(heartbeatName) != 0; }));
    Assistant another = paperAssistant(config);
    const auto second = focasTransport(registers, timeout_ms);
    LinkLoop of_second(*second, another, loop, {});
    try {
        of_second.run({});
        FAIL() << "two assistants on one control";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), errors::linkTaken);
    }
    statePaper();
    put(requestName, 3);
    EXPECT_TRUE(holdsSoon([&] { return holds(3); }));
}

TEST_F(FocasLink, registers_hold_numbers_with_sign_and_scale)
{
    transport->open();
    put(diameterName, -0.001);
    EXPECT_DOUBLE_EQ(transport->read({diameterName}).at(diameterName), -0.001);
    transport->write(correctedName, 2147483647);
    EXPECT_EQ(at(correctedName), 2147483647);
    EXPECT_THROW(transport->write(correctedName, 2147483648.0), Error);
    transport->open();
    EXPECT_THROW(transport->write(answeredName, 32768), Error);
    EXPECT_EQ(at(answeredName), 0);
}

TEST_F(FocasLink, values_far_apart_are_read_by_several_calls)
{
    FocasSettings apart = registers;
    apart.registers[lengthName] = {1000 + 63, 1, 1};  // the last byte of the first call
    apart.registers[depthName] = {9000, 4, -0.001};   // a scale may turn the sign
    const auto link = focasTransport(apart, timeout_ms);
    link->open();
    control.put(apart.registers.at(lengthName), 120);
    control.put(apart.registers.at(depthName), 0.5);
    control.put(apart.registers.at(stateName), 18);
    put(diameterName, 32);
    // One call more than those that are needed would fail.
    control.askFailing(registers.registers.at(requestName), 5, 3, socketLost);
    const ControlValues values = link->read({depthName, stateName, lengthName, diameterName, requestName});
    EXPECT_EQ(values, (ControlValues{
                          {requestName, 5}, {diameterName, 32}, {lengthName, 120}, {stateName, 18}, {depthName, 0.5}}));
    EXPECT_EQ(codeOf([&] { link->read({requestName}); }), "link_lost");
}

TEST_F(FocasLink, a_block_of_another_range_is_refused)
{
    transport->open();
    control.stateOtherRange(true);
    EXPECT_EQ(codeOf([&] { transport->read({diameterName}); }), "link_protocol");
    control.stateOtherRange(false);
    EXPECT_FALSE(transport->isOpen());
}

TEST_F(FocasLink, registers_that_cannot_hold_what_is_written_are_refused_before_anything_is_asked)
{
    const auto opened = [&](const char* name, const Register& place) {
        FocasSettings other = registers;
        other.registers[name] = place;
        return codeOf([&] { focasTransport(other, timeout_ms)->open(); });
    };
    EXPECT_EQ(opened(heartbeatName, {1108, 1, 1}), "link_value_not_held");
    EXPECT_EQ(opened(stateName, {1104, 2, 10}), "link_value_not_held");  // 1 would be written as 0
    EXPECT_EQ(opened(answeredName, {1106, 1, 1}), "link_value_not_held");
    EXPECT_EQ(opened(stateName, {1103, 2, 1}), "link_not_found");  // the last byte of N_cor
    EXPECT_EQ(opened(heartbeatName, {1005, 2, 1}), "link_not_found");
    EXPECT_EQ(opened(stateName, {1104, 1, 1}), "");
    EXPECT_EQ(control.handles(), 0);
    // A request of one bit is answered by one.
    registers.registers[requestName] = {1000, 1, 1};
    EXPECT_EQ(opened(answeredName, {1106, 1, 1}), "");
}

TEST_F(FocasLink, a_link_that_ends_leaves_another_one_open)
{
    transport->open();
    focasTransport(registers, timeout_ms)->open();
    put(diameterName, 32);
    EXPECT_EQ(transport->read({diameterName}).at(diameterName), 32);
    EXPECT_EQ(control.handles(), 1);
}

TEST_F(FocasLink, a_library_that_is_missing_or_another_one_is_said)
{
    const auto opened = [](const FocasSettings& one) {
        return codeOf([&] { focasTransport(one, timeout_ms)->open(); });
    };
    FocasSettings other = registers;
    other.library = "/nowhere/libfwlib32.so";
    EXPECT_EQ(opened(other), "link_not_found");
    other.library = "libm.so.6";
    EXPECT_EQ(opened(other), "link_not_found");
    other = registers;
    other.host = "";
    EXPECT_EQ(opened(other), "link_not_found");
    control.askFailing(registers.registers.at(requestName), 0, 1, socketLost);
    transport->open();
    try {
        transport->read({diameterName});
        FAIL() << "the call fails";
    } catch (const Error& error) {
        EXPECT_NE(std::string(error.what()).find("pmc_rdpmcrng: -16 (EW_SOCKET)"), std::string::npos) << error.what();
    }
}

}  // namespace
}  // namespace lathelier::link
