#include "engine/link/focas/focas_transport.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <thread>
#include <utility>

#include "engine/link/focas/call_thread.h"
#include "engine/link/focas/focas_api.h"
#include "engine/link/focas/focas_library.h"
#include "engine/link/link_codes.h"

namespace lathelier::link {
namespace {

constexpr std::chrono::milliseconds busyPause{5};

std::int64_t numberFrom(const char* data, int bytes)
{
    std::uint64_t bits = 0;
    for (int i = 0; i < bytes; ++i) bits |= std::uint64_t{static_cast<unsigned char>(data[i])} << (8 * i);
    const std::uint64_t sign = std::uint64_t{1} << (8 * bytes - 1);
    return static_cast<std::int64_t>(bits ^ sign) - static_cast<std::int64_t>(sign);
}

void putNumber(std::int64_t number, int bytes, char* data)
{
    for (int i = 0; i < bytes; ++i)
        data[i] = static_cast<char>(static_cast<unsigned char>((static_cast<std::uint64_t>(number) >> (8 * i)) & 0xFF));
}

focas::PmcBlock blockOf(int first, int last)
{
    focas::PmcBlock block;
    block.first = static_cast<unsigned short>(first);
    block.last = static_cast<unsigned short>(last);
    return block;
}

unsigned short lengthOf(const focas::PmcBlock& block)
{
    return static_cast<unsigned short>(focas::headBytes + block.last - block.first + 1);
}

/// "R1000-R1007", with area and type where they are others
std::string rangeText(const focas::PmcBlock& block)
{
    std::string text;
    if (block.area != focas::areaR || block.type != focas::dataBytes)
        text = std::to_string(block.area).append("/").append(std::to_string(block.type)).append(" ");
    return text.append("R").append(std::to_string(block.first)).append("-R").append(std::to_string(block.last));
}

/// A handle, used in the thread of the calls alone; shared with calls that are late.
struct Session {
    std::shared_ptr<const focas::Library> library;
    std::optional<unsigned short> handle = {};
};

/// What a call is given and gives back; shared with it likewise.
struct Answer {
    focas::PmcBlock block = {};
    short result = focas::ok;
};

class FocasTransport : public Transport {
public:
    FocasTransport(FocasSettings settings, double timeout_ms)
        : settings_(std::move(settings)), timeout_ms_(timeout_ms), calls_(timeout_ms)
    {
    }
    ~FocasTransport() override { close(); }
    FocasTransport(const FocasTransport&) = delete;
    FocasTransport& operator=(const FocasTransport&) = delete;

    void open() override;
    ControlValues read(const std::vector<std::string>& names) override;
    void write(const std::string& name, double value) override;
    bool offers(const std::string& name) const override { return settings_.registers.count(name) > 0; }
    void close() noexcept override;
    bool isOpen() const override { return session_ != nullptr; }
    bool isExclusive() const override { return false; }  // the library gives handles to several programs
    bool isVerified() const override { return false; }
    std::string peer() const override { return settings_.host + ":" + std::to_string(settings_.port); }

private:
    using Ask = short (*)(const focas::Library& library, unsigned short handle, focas::PmcBlock& block);

    [[noreturn]] void fail(const ErrorCode& code, const Value& reason);
    [[noreturn]] void refuseValue(const std::string& name, double value);
    focas::PmcBlock asked(const char* name, const focas::PmcBlock& block, Ask ask);
    void readRange(const std::vector<std::string>& names, ControlValues& values);

    FocasSettings settings_;
    double timeout_ms_;
    std::shared_ptr<Session> session_;
    CallThread calls_;
};

void FocasTransport::fail(const ErrorCode& code, const Value& reason)
{
    close();
    throw Error(code, {{"peer", peer()}, {"reason", reason}});
}

void FocasTransport::open()
{
    close();
    // A file was refused by the same rules: see readConfig().
    if (const auto name = sharedRegister(settings_.registers))
        fail(errors::linkNotFound, LT_TEXT("Engine", "a register that is written shares a byte with another"));
    if (const auto one = narrowRegister(settings_.registers)) refuseValue(one->name, one->value);
    const auto session = std::make_shared<Session>();
    try {
        session->library = focas::sharedLibrary(settings_.library);
    } catch (Error& error) {
        throw error.with("peer", peer());
    }
    session_ = session;
    const auto answer = std::make_shared<Answer>();
    // Of the library: whole seconds, and 0 would be for ever.
    const auto timeout_s = static_cast<long>(std::max(1.0, std::ceil(timeout_ms_ / 1000)));
    const bool is_done = calls_.run([session, answer, timeout_s, host = settings_.host, port = settings_.port] {
        unsigned short handle = 0;
        answer->result =
            session->library->allocate(host.c_str(), static_cast<unsigned short>(port), timeout_s, &handle);
        if (answer->result == focas::ok) session->handle = handle;
    });
    if (!is_done) fail(errors::linkNotFound, LT_TEXT("Engine", "no answer within the time-out"));
    if (answer->result != focas::ok) fail(errors::linkNotFound, focas::resultText(focas::allocateName, answer->result));
}

/// The block as the library left it. A control that is busy is asked again, for as long as it may still answer within
/// the time-out. Errors linkLost.
focas::PmcBlock FocasTransport::asked(const char* name, const focas::PmcBlock& block, Ask ask)
{
    if (!session_) fail(errors::linkLost, std::string(name));
    const auto answer = std::make_shared<Answer>();
    answer->block = block;
    const auto end = std::chrono::steady_clock::now() + std::chrono::duration<double, std::milli>(timeout_ms_ / 2);
    const bool is_done = calls_.run([session = session_, answer, ask, end] {
        answer->result = ask(*session->library, *session->handle, answer->block);
        while (answer->result == focas::busy && std::chrono::steady_clock::now() < end) {
            std::this_thread::sleep_for(busyPause);
            answer->result = ask(*session->library, *session->handle, answer->block);
        }
    });
    if (!is_done) fail(errors::linkLost, LT_TEXT("Engine", "no answer within the time-out"));
    if (answer->result != focas::ok) fail(errors::linkLost, focas::resultText(name, answer->result));
    return answer->block;
}

/// Registers that lie within one call.
void FocasTransport::readRange(const std::vector<std::string>& names, ControlValues& values)
{
    int last = 0;
    for (const std::string& name : names) last = std::max(last, settings_.registers.at(name).last());
    const focas::PmcBlock question = blockOf(settings_.registers.at(names.front()).address, last);
    const focas::PmcBlock answer = asked(
        focas::readName, question, [](const focas::Library& library, unsigned short handle, focas::PmcBlock& block) {
            return library.read(handle, focas::areaR, focas::dataBytes, block.first, block.last, lengthOf(block),
                                &block);
        });
    if (rangeText(answer) != rangeText(question)) {  // the library states what it has read
        close();
        throw Error(errors::linkProtocol,
                    {{"peer", peer()}, {"found", rangeText(answer)}, {"expected", rangeText(question)}});
    }
    for (const std::string& name : names) {
        const Register& place = settings_.registers.at(name);
        const char* const begin = answer.data + (place.address - question.first);
        values[name] = static_cast<double>(numberFrom(begin, place.bytes)) * place.scale;
    }
}

ControlValues FocasTransport::read(const std::vector<std::string>& names)
{
    const auto placeOf = [this](const std::string& name) -> const Register& { return settings_.registers.at(name); };
    std::vector<std::string> sorted = names;
    std::stable_sort(sorted.begin(), sorted.end(), [&](const std::string& a, const std::string& b) {
        return placeOf(a).address < placeOf(b).address;
    });
    ControlValues values;
    std::vector<std::string> together;
    for (const std::string& name : sorted) {
        if (!together.empty() &&
            placeOf(name).last() - placeOf(together.front()).address >= static_cast<int>(focas::mostBytes)) {
            readRange(together, values);
            together.clear();
        }
        together.push_back(name);
    }
    if (!together.empty()) readRange(together, values);
    return values;
}

void FocasTransport::refuseValue(const std::string& name, double value)
{
    close();
    const Register& place = settings_.registers.at(name);
    const double most = greatestNumber(place.bytes);
    throw Error(errors::linkValueNotHeld, {{"name", name},
                                           {"peer", peer()},
                                           {"found", value},
                                           {"minimum", std::min(place.scale * most, -place.scale * (most + 1))},
                                           {"maximum", std::max(place.scale * most, -place.scale * (most + 1))}});
}

void FocasTransport::write(const std::string& name, double value)
{
    const Register& place = settings_.registers.at(name);
    focas::PmcBlock question = blockOf(place.address, place.last());
    const std::optional<std::int64_t> number = heldNumber(name, place, value);
    if (!number) refuseValue(name, value);
    putNumber(*number, place.bytes, question.data);
    asked(focas::writeName, question, [](const focas::Library& library, unsigned short handle, focas::PmcBlock& block) {
        return library.write(handle, lengthOf(block), &block);
    });
}

/// After the calls that are still to come back, which may be the one that takes the handle.
void FocasTransport::close() noexcept
{
    if (!session_) return;
    calls_.post([session = std::exchange(session_, nullptr)] {
        if (session->handle) session->library->free(*session->handle);
        session->handle.reset();
    });
}

}  // namespace

std::unique_ptr<Transport> focasTransport(const FocasSettings& settings, double timeout_ms)
{
    return std::make_unique<FocasTransport>(settings, timeout_ms);
}

}  // namespace lathelier::link
