#include "engine/link/control_values.h"

#include <array>

namespace lathelier::link {
namespace {

struct StateFacts {
    State state;
    const char* name;
    Text text;
};

const std::array<StateFacts, 12>& states()
{
    static const std::array<StateFacts, 12> all{{
        {State::Idle, "idle", LT_TEXT("Engine", "no request stands")},
        {State::Ok, "ok", LT_TEXT("Engine", "answered")},
        {State::NoStableSpeed, "no_stable_speed", LT_TEXT("Engine", "no stable speed in the range")},
        {State::OutOfRange, "out_of_range", LT_TEXT("Engine", "a value is outside of what is allowed")},
        {State::NotUnderstood, "not_understood", LT_TEXT("Engine", "a value is missing or is no number")},
        {State::Running, "running", LT_TEXT("Engine", "the machine runs")},
        {State::Changed, "changed", LT_TEXT("Engine", "the values changed while they were answered")},
        {State::AboveSpeedLimit, "above_speed_limit",
         LT_TEXT("Engine", "the stable speed is above the machine's highest speed")},
        {State::NotComputed, "not_computed", LT_TEXT("Engine", "the response cannot be computed with these values")},
        {State::NotWritten, "not_written", LT_TEXT("Engine", "the control did not keep the speed that was written")},
        {State::ProgramNotUsable, "program_not_usable",
         LT_TEXT("Engine", "the loaded program does not give diameter and length")},
        {State::NotModelled, "not_modelled",
         LT_TEXT("Engine", "something that could change the speed was not understood")},
    }};
    return all;
}

const StateFacts& factsOf(State state)
{
    for (const StateFacts& one : states())
        if (one.state == state) return one;
    return states().front();
}

}  // namespace

const std::vector<std::string>& readNames()
{
    static const std::vector<std::string> all{requestName, runningName, diameterName, lengthName,
                                              speedName,   lowestName,  highestName,  depthName};
    return all;
}

const std::vector<std::string>& writtenNames()
{
    static const std::vector<std::string> all{correctedName, stateName, answeredName, heartbeatName};
    return all;
}

const char* nameOf(State state)
{
    return factsOf(state).name;
}

Text textOf(State state)
{
    return factsOf(state).text;
}

std::optional<State> stateOfNumber(std::int64_t number)
{
    for (const StateFacts& one : states())
        if (static_cast<std::int64_t>(one.state) == number) return one.state;
    return std::nullopt;
}

}  // namespace lathelier::link
