// The link through FOCAS2, over a library of our own that speaks the published interface.
#include "engine/link/focas/focas_transport.h"

#include <dlfcn.h>
#include <gtest/gtest.h>

#include "engine/link/link_codes.h"
#include "engine/link/transports.h"
#include "tests/engine/link/paper_case.h"

namespace lathelier::link {
namespace {

constexpr short socketLost = -16;

/// The control inside the library of the tests.
class FakeControl {
public:
    FakeControl() : library_(::dlopen(LATHELIER_FAKE_FOCAS, RTLD_NOW))
    {
        if (!library_) throw std::runtime_error(::dlerror());
        call<void()>("fake_restart")();
    }
    ~FakeControl() { ::dlclose(library_); }
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
    void failAfter(int calls, short code) { call<void(int, short)>("fake_fail_after")(calls, code); }
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
    made.registers = {{requestName, {1000, 2, 1}},  {runningName, {1002, 1, 1}},   {diameterName, {1004, 4, 0.001}},
                      {speedName, {1012, 4, 0.1}},  {correctedName, {1100, 4, 1}}, {stateName, {1104, 2, 1}},
                      {answeredName, {1106, 2, 1}}, {heartbeatName, {1108, 2, 1}}};
    return made;
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
    std::unique_ptr<Transport> transport = focasTransport(registers, 500);

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
    const RunningLoop running(*transport, assistant, loopSettings(config, false));
    put(requestName, 1);
    ASSERT_TRUE(holdsSoon([&] { return holds(1); }));
    EXPECT_EQ(at(correctedName), paperCorrected_rpm);
    ASSERT_TRUE(holdsSoon([&] { return running.entries().size() >= 2; }));
    EXPECT_FALSE(running.entries()[0].is_verified);
    EXPECT_NEAR(running.entries()[1].exchange->reply.selected_rpm.value(), paperSelected_rpm, 0.1);
}

TEST_F(FocasLink, a_call_that_fails_at_any_place_lets_nothing_wrong_hold)
{
    statePaper();
    const RunningLoop running(*transport, assistant, loopSettings(config, false));
    ASSERT_TRUE(holdsSoon([&] { return !running.entries().empty(); }));
    for (int i = 0; i < 40; ++i) {
        // Out of range every other time: no speed shall hold.
        const bool is_good = i % 2 == 0;
        put(speedName, is_good ? paperSpeed_m_min : 150000);
        put(correctedName, 1);
        control.failAfter(i % 14, i % 3 == 0 ? short{-8} : socketLost);
        put(requestName, i + 1);
        ASSERT_TRUE(holdsSoon([&] { return at(answeredName) == i + 1; })) << i;
        EXPECT_EQ(at(stateName) == 1, is_good) << i;
        EXPECT_EQ(at(correctedName), is_good ? paperCorrected_rpm : 1) << i;
    }
    bool is_lost = false;
    for (const LogEntry& entry : running.entries()) is_lost = is_lost || entry.event == LinkEvent::Lost;
    EXPECT_TRUE(is_lost);
}

TEST_F(FocasLink, a_control_that_restarts_is_linked_again)
{
    const RunningLoop running(*transport, assistant, loopSettings(config, false));
    ASSERT_TRUE(holdsSoon([&] { return at(heartbeatName) != 0; }));
    control.restart();
    statePaper();
    put(requestName, 7);
    ASSERT_TRUE(holdsSoon([&] { return holds(7); }));
    EXPECT_EQ(at(correctedName), paperCorrected_rpm);
}

TEST_F(FocasLink, a_second_assistant_is_refused_by_the_heartbeat)
{
    const RunningLoop first(*transport, assistant, loopSettings(config, false));
    ASSERT_TRUE(holdsSoon([&] { return at(heartbeatName) != 0; }));
    Assistant another = paperAssistant(config);
    const auto second = focasTransport(registers, 500);
    LinkLoop loop(*second, another, loopSettings(config, false), {});
    try {
        loop.run({});
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

TEST_F(FocasLink, a_library_that_is_missing_or_another_one_is_said)
{
    FocasSettings other = registers;
    other.library = "/nowhere/libfwlib32.so";
    const auto codeOf = [](const FocasSettings& one) {
        try {
            focasTransport(one, 500)->open();
        } catch (const Error& error) {
            return std::string(error.code().key);
        }
        return std::string();
    };
    EXPECT_EQ(codeOf(other), "link_not_found");
    other.library = "libm.so.6";
    EXPECT_EQ(codeOf(other), "link_not_found");
    other = registers;
    other.host = "";
    EXPECT_EQ(codeOf(other), "link_not_found");
}

}  // namespace
}  // namespace lathelier::link
