#include "engine/link/focas/focas_transport.h"

#include <dlfcn.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include "engine/link/focas/focas_api.h"
#include "engine/link/link_codes.h"

namespace lathelier::link {
namespace {

/// Whole numbers with sign that so many bytes hold.
double mostOf(int bytes)
{
    return std::ldexp(1.0, 8 * bytes - 1) - 1;
}

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

class FocasTransport : public Transport {
public:
    FocasTransport(FocasSettings settings, double timeout_ms)
        : settings_(std::move(settings)), timeout_s_(std::max(1L, std::lround(timeout_ms / 1000)))
    {
    }
    ~FocasTransport() override;
    FocasTransport(const FocasTransport&) = delete;
    FocasTransport& operator=(const FocasTransport&) = delete;

    void open() override;
    ControlValues read(const std::vector<std::string>& names) override;
    void write(const std::string& name, double value) override;
    bool offers(const std::string& name) const override { return settings_.registers.count(name) > 0; }
    void close() noexcept override;
    bool isOpen() const override { return handle_.has_value(); }
    bool isExclusive() const override { return false; }  // the library gives handles to several programs
    bool isVerified() const override { return false; }
    std::string peer() const override { return settings_.host + ":" + std::to_string(settings_.port); }

private:
    void load();
    template <class Function>
    Function symbol(const char* name);
    [[noreturn]] void fail(const ErrorCode& code, const std::string& reason);
    void requireOk(const char* call, short result);
    void readRange(int first, int last, char* data);

    FocasSettings settings_;
    long timeout_s_;
    void* library_ = nullptr;
    focas::ExitProcess exit_ = nullptr;
    focas::Allocate allocate_ = nullptr;
    focas::Free free_ = nullptr;
    focas::ReadRange read_ = nullptr;
    focas::WriteRange write_ = nullptr;
    std::optional<unsigned short> handle_;
};

FocasTransport::~FocasTransport()
{
    close();
    if (exit_) exit_();
    if (library_) ::dlclose(library_);
}

void FocasTransport::fail(const ErrorCode& code, const std::string& reason)
{
    close();
    throw Error(code, {{"peer", peer()}, {"reason", reason}});
}

template <class Function>
Function FocasTransport::symbol(const char* name)
{
    return reinterpret_cast<Function>(::dlsym(library_, name));
}

void FocasTransport::load()
{
    if (library_) return;
    library_ = ::dlopen(settings_.library.c_str(), RTLD_NOW | RTLD_LOCAL);
    if (!library_) {
        const char* const reason = ::dlerror();
        fail(errors::linkNotFound, reason ? reason : settings_.library);
    }
    allocate_ = symbol<focas::Allocate>(focas::allocateName);
    free_ = symbol<focas::Free>(focas::freeName);
    read_ = symbol<focas::ReadRange>(focas::readName);
    write_ = symbol<focas::WriteRange>(focas::writeName);
    for (const auto& [name, is_there] : {std::pair{focas::allocateName, allocate_ != nullptr},
                                         {focas::freeName, free_ != nullptr},
                                         {focas::readName, read_ != nullptr},
                                         {focas::writeName, write_ != nullptr}}) {
        if (is_there) continue;
        ::dlclose(std::exchange(library_, nullptr));
        fail(errors::linkNotFound, settings_.library + ": " + name);
    }
    const auto start = symbol<focas::StartProcess>(focas::startProcessName);
    if (start) start(0, "");
    exit_ = symbol<focas::ExitProcess>(focas::exitProcessName);
}

void FocasTransport::open()
{
    close();
    load();
    unsigned short handle = 0;
    const short result =
        allocate_(settings_.host.c_str(), static_cast<unsigned short>(settings_.port), timeout_s_, &handle);
    if (result != focas::ok)
        fail(errors::linkNotFound, std::string(focas::allocateName).append(": ").append(std::to_string(result)));
    handle_ = handle;
}

void FocasTransport::requireOk(const char* call, short result)
{
    if (result != focas::ok) fail(errors::linkLost, std::string(call).append(": ").append(std::to_string(result)));
}

void FocasTransport::readRange(int first, int last, char* data)
{
    focas::PmcBlock block;
    block.first = static_cast<unsigned short>(first);
    block.last = static_cast<unsigned short>(last);
    const auto length = static_cast<unsigned short>(focas::headBytes + last - first + 1);
    requireOk(focas::readName,
              read_(*handle_, focas::areaR, focas::dataBytes, block.first, block.last, length, &block));
    std::copy_n(block.data, last - first + 1, data);
}

/// One call where all values lie together, so that they are of one moment.
ControlValues FocasTransport::read(const std::vector<std::string>& names)
{
    if (!handle_) fail(errors::linkLost, focas::readName);
    int first = 65536;
    int last = 0;
    for (const std::string& name : names) {
        const Register& place = settings_.registers.at(name);
        first = std::min(first, place.address);
        last = std::max(last, place.address + place.bytes - 1);
    }
    const bool is_together = last - first < static_cast<int>(focas::mostBytes);
    char data[focas::mostBytes] = {};
    if (is_together && !names.empty()) readRange(first, last, data);
    ControlValues values;
    for (const std::string& name : names) {
        const Register& place = settings_.registers.at(name);
        if (!is_together) readRange(place.address, place.address + place.bytes - 1, data);
        const char* const begin = is_together ? data + (place.address - first) : data;
        values[name] = static_cast<double>(numberFrom(begin, place.bytes)) * place.scale;
    }
    return values;
}

void FocasTransport::write(const std::string& name, double value)
{
    if (!handle_) fail(errors::linkLost, focas::writeName);
    const Register& place = settings_.registers.at(name);
    const double number = std::round(value / place.scale);
    const double most = mostOf(place.bytes);
    if (!(number >= -most - 1 && number <= most)) {
        close();
        throw Error(errors::linkValueNotHeld, {{"name", name},
                                               {"peer", peer()},
                                               {"found", value},
                                               {"minimum", std::min(place.scale * most, -place.scale * (most + 1))},
                                               {"maximum", std::max(place.scale * most, -place.scale * (most + 1))}});
    }
    focas::PmcBlock block;
    block.first = static_cast<unsigned short>(place.address);
    block.last = static_cast<unsigned short>(place.address + place.bytes - 1);
    putNumber(static_cast<std::int64_t>(number), place.bytes, block.data);
    requireOk(focas::writeName, write_(*handle_, static_cast<unsigned short>(focas::headBytes + place.bytes), &block));
}

void FocasTransport::close() noexcept
{
    if (handle_ && free_) free_(*handle_);
    handle_.reset();
}

}  // namespace

std::unique_ptr<Transport> focasTransport(const FocasSettings& settings, double timeout_ms)
{
    return std::make_unique<FocasTransport>(settings, timeout_ms);
}

}  // namespace lathelier::link
