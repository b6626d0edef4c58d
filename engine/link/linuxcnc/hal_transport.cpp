#include "engine/link/linuxcnc/hal_transport.h"

#include "engine/link/link_codes.h"

#ifdef LATHELIER_WITH_LINUXCNC

#include <dlfcn.h>
#include <sys/ipc.h>
#include <sys/shm.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <limits>
#include <utility>

#define ULAPI  // a program of its own, not a part of the real-time side
#include <hal.h>

#include "engine/link/linuxcnc/loaded_program.h"

namespace lathelier::link {
namespace {

constexpr const char* halLibrary = "liblinuxcnchal.so.0";
constexpr key_t halMemoryKey = 0x48414C32;  // of HAL's shared memory, which LinuxCNC makes
constexpr int nameTaken = -EINVAL;          // by hal_init() of a name that is there

/// The functions of the library that are used.
struct Hal {
    decltype(&hal_init) init = nullptr;
    decltype(&hal_exit) exit = nullptr;
    decltype(&hal_ready) ready = nullptr;
    decltype(&hal_malloc) allocate = nullptr;
    decltype(&hal_pin_float_new) newFloat = nullptr;
    decltype(&hal_pin_bit_new) newBit = nullptr;
};

template <class Function>
bool find(void* library, const char* name, Function& function)
{
    function = reinterpret_cast<Function>(::dlsym(library, name));
    return function != nullptr;
}

/// How many programs have HAL's memory of this number; 0: it is given up, or it was never there. A LinuxCNC that is
/// killed leaves its memory with nobody.
unsigned long usersOf(int memory)
{
    shmid_ds state{};
    if (memory < 0 || ::shmctl(memory, IPC_STAT, &state) != 0) return 0;
    return (state.shm_perm.mode & SHM_DEST) != 0 ? 0 : state.shm_nattch;
}

std::string pinName(const std::string& component, std::string name)
{
    std::replace(name.begin(), name.end(), '_', '-');
    return component + "." + name;
}

/// Pins of HAL, in its memory: the place of the address of what they are wired to.
struct FloatPin {
    hal_float_t** place = nullptr;
};
struct BitPin {
    hal_bit_t** place = nullptr;
};

class HalTransport : public Transport {
public:
    HalTransport(LinuxCncSettings settings, double timeout_ms) : settings_(std::move(settings)), timeout_ms_(timeout_ms)
    {
    }
    ~HalTransport() override;
    HalTransport(const HalTransport&) = delete;
    HalTransport& operator=(const HalTransport&) = delete;

    void open() override;
    ControlValues read(const std::vector<std::string>& names) override;
    void write(const std::string& name, double value) override;
    bool offers(const std::string&) const override { return true; }
    std::optional<std::string> loadedProgram() override;
    void close() noexcept override;
    bool isOpen() const override { return component_ > 0; }
    bool isExclusive() const override { return true; }
    std::string peer() const override { return "HAL " + settings_.component; }

private:
    void load();
    void makePins();
    void requireRunning();
    [[noreturn]] void fail(const ErrorCode& code, const Value& reason);

    LinuxCncSettings settings_;
    double timeout_ms_;
    void* library_ = nullptr;
    Hal hal_;
    int component_ = 0;
    int memory_ = -1;                         ///< HAL's memory that the pins lie in
    std::map<std::string, FloatPin> floats_;  ///< by name
    BitPin running_;
};

HalTransport::~HalTransport()
{
    close();
}

void HalTransport::fail(const ErrorCode& code, const Value& reason)
{
    close();
    throw Error(code, {{"peer", peer()}, {"reason", reason}});
}

void HalTransport::load()
{
    // Anew for each link: after hal_exit() the library would go on with memory that it has let go of.
    library_ = ::dlopen(halLibrary, RTLD_NOW | RTLD_LOCAL);
    if (!library_) {
        const char* const reason = ::dlerror();
        fail(errors::linkNotFound, std::string(reason ? reason : halLibrary));
    }
    if (!find(library_, "hal_init", hal_.init) || !find(library_, "hal_exit", hal_.exit) ||
        !find(library_, "hal_ready", hal_.ready) || !find(library_, "hal_malloc", hal_.allocate) ||
        !find(library_, "hal_pin_float_new", hal_.newFloat) || !find(library_, "hal_pin_bit_new", hal_.newBit))
        fail(errors::linkNotFound, std::string(halLibrary));
}

void HalTransport::open()
{
    close();
    memory_ = ::shmget(halMemoryKey, 0, 0);
    const bool is_of_another = memory_ < 0 && errno == EACCES;
    if (usersOf(memory_) == 0)
        fail(errors::linkNotFound, is_of_another ? LT_TEXT("Engine", "LinuxCNC runs as another user")
                                                 : LT_TEXT("Engine", "LinuxCNC does not run"));
    load();
    component_ = hal_.init(settings_.component.c_str());
    if (component_ == nameTaken) {
        close();
        throw Error(errors::linkTaken, {{"peer", peer()}});
    }
    if (component_ <= 0) {
        const int code = component_;
        fail(errors::linkNotFound, std::string("hal_init: ").append(std::to_string(code)));
    }
    makePins();
}

void HalTransport::makePins()
{
    bool is_made = true;
    const auto add = [&](const std::string& name, hal_pin_dir_t direction) {
        FloatPin pin;
        pin.place = static_cast<hal_float_t**>(hal_.allocate(sizeof(hal_float_t*)));
        is_made = is_made && pin.place &&
                  hal_.newFloat(pinName(settings_.component, name).c_str(), direction, pin.place, component_) == 0;
        if (!is_made) return;
        **pin.place = 0;
        floats_[name] = pin;
    };
    for (const std::string& name : readNames())
        if (name != runningName) add(name, HAL_IN);
    for (const std::string& name : writtenNames()) add(name, HAL_OUT);
    running_.place = static_cast<hal_bit_t**>(hal_.allocate(sizeof(hal_bit_t*)));
    is_made = is_made && running_.place &&
              hal_.newBit(pinName(settings_.component, runningName).c_str(), HAL_IN, running_.place, component_) == 0;
    if (is_made) **running_.place = true;  // until it is wired the machine counts as one that runs
    if (!is_made || hal_.ready(component_) != 0)
        fail(errors::linkNotFound, LT_TEXT("Engine", "the pins could not be made"));
}

/// Memory that LinuxCNC has given up stays readable to this program, which is then its only user: what stands there is
/// no machine's any more.
void HalTransport::requireRunning()
{
    if (component_ <= 0 || usersOf(memory_) < 2) fail(errors::linkLost, LT_TEXT("Engine", "LinuxCNC has ended"));
}

ControlValues HalTransport::read(const std::vector<std::string>& names)
{
    requireRunning();
    ControlValues values;
    for (const std::string& name : names)
        values[name] =
            name == runningName ? (**running_.place ? 1.0 : 0.0) : static_cast<double>(**floats_.at(name).place);
    return values;
}

void HalTransport::write(const std::string& name, double value)
{
    requireRunning();
    if (!std::isfinite(value)) {
        close();
        throw Error(errors::linkValueNotHeld, {{"name", name},
                                               {"peer", peer()},
                                               {"found", value},
                                               {"minimum", std::numeric_limits<double>::lowest()},
                                               {"maximum", std::numeric_limits<double>::max()}});
    }
    **floats_.at(name).place = value;
}

std::optional<std::string> HalTransport::loadedProgram()
{
    if (settings_.program_port == 0) return std::nullopt;
    return programOfLinuxCnc(settings_, timeout_ms_);
}

void HalTransport::close() noexcept
{
    floats_.clear();
    running_ = {};
    if (component_ > 0) hal_.exit(component_);
    component_ = 0;
    if (library_) ::dlclose(library_);
    library_ = nullptr;
}

}  // namespace

std::unique_ptr<Transport> halTransport(const LinuxCncSettings& settings, double timeout_ms)
{
    return std::make_unique<HalTransport>(settings, timeout_ms);
}

}  // namespace lathelier::link

#else

namespace lathelier::link {

std::unique_ptr<Transport> halTransport(const LinuxCncSettings& settings, double)
{
    throw Error(errors::linkNotFound, {{"peer", "HAL " + settings.component},
                                       {"reason", LT_TEXT("Engine", "this program was built without LinuxCNC")}});
}

}  // namespace lathelier::link

#endif
