// A library that speaks the published interface of FOCAS2 and simulates a control: registers, handles of threads,
// errors of any call, one that does not come back, a control that restarts. Further functions, fake_..., let a test do
// that.
#include <array>
#include <condition_variable>
#include <map>
#include <mutex>
#include <thread>

#include "engine/link/focas/focas_api.h"

namespace {

using lathelier::link::focas::PmcBlock;

constexpr short badHandle = -8;
constexpr short badSocket = -16;
constexpr short badLength = 2;
constexpr short badRange = 3;
constexpr int registers = 10000;

using Watch = void (*)(const unsigned char* area, void* of);

/// What happens to the calls after so many more.
struct Fault {
    int calls_before = 0;
    int times = 0;
};

struct Control {
    std::mutex mutex;
    std::condition_variable released;
    std::array<unsigned char, registers> area{};
    std::map<unsigned short, std::thread::id> handles;
    unsigned short next = 1;
    int processes = 0;  // started and not ended
    Fault failure;
    short code = badSocket;
    Fault hold;
    int held = 0;  // calls that do not come back until they are released
    bool states_other_range = false;
    Watch watch = nullptr;
    void* watched_by = nullptr;
};

Control& control()
{
    static Control one;
    return one;
}

bool strikes(Fault& fault)
{
    if (fault.times == 0) return false;
    if (fault.calls_before > 0) {
        --fault.calls_before;
        return false;
    }
    --fault.times;
    return true;
}

/// The code with which this call fails; 0: it succeeds.
short begin(Control& one, std::unique_lock<std::mutex>& lock)
{
    if (strikes(one.hold)) {
        ++one.held;
        one.released.wait(lock, [&] { return one.held == 0; });
    }
    if (one.processes == 0) return badHandle;
    return strikes(one.failure) ? one.code : short{0};
}

bool isHandle(const Control& one, unsigned short handle)
{
    const auto found = one.handles.find(handle);
    return found != one.handles.end() && found->second == std::this_thread::get_id();
}

short move(unsigned short handle, unsigned short length, PmcBlock* block, bool writes)
{
    Control& one = control();
    std::unique_lock lock(one.mutex);
    if (const short code = begin(one, lock)) return code;
    if (!isHandle(one, handle)) return badHandle;
    const int count = block->last - block->first + 1;
    if (count < 1 || length != lathelier::link::focas::headBytes + count ||
        block->area != lathelier::link::focas::areaR || block->type != lathelier::link::focas::dataBytes)
        return badLength;
    if (block->last >= registers) return badRange;
    for (int i = 0; i < count; ++i) {
        unsigned char& place = one.area.at(static_cast<std::size_t>(block->first + i));
        if (writes)
            place = static_cast<unsigned char>(block->data[i]);
        else
            block->data[i] = static_cast<char>(place);
    }
    if (writes && one.watch) one.watch(one.area.data(), one.watched_by);
    if (!writes && one.states_other_range) ++block->first;
    return 0;
}

}  // namespace

extern "C" {

short cnc_startupprocess(long, const char*)
{
    Control& one = control();
    const std::lock_guard lock(one.mutex);
    ++one.processes;
    return 0;
}

short cnc_exitprocess()
{
    Control& one = control();
    const std::lock_guard lock(one.mutex);
    --one.processes;
    one.handles.clear();
    return 0;
}

short cnc_allclibhndl3(const char* host, unsigned short, long timeout_s, unsigned short* handle)
{
    Control& one = control();
    std::unique_lock lock(one.mutex);
    if (const short code = begin(one, lock)) return code;
    if (host[0] == '\0' || timeout_s < 1) return badSocket;
    *handle = one.next++;
    one.handles[*handle] = std::this_thread::get_id();
    return 0;
}

short cnc_freelibhndl(unsigned short handle)
{
    Control& one = control();
    const std::lock_guard lock(one.mutex);
    return isHandle(one, handle) && one.handles.erase(handle) == 1 ? short{0} : badHandle;
}

short pmc_rdpmcrng(unsigned short handle, short area, short type, unsigned short first, unsigned short last,
                   unsigned short length, PmcBlock* block)
{
    block->area = area;
    block->type = type;
    block->first = first;
    block->last = last;
    return move(handle, length, block, false);
}

short pmc_wrpmcrng(unsigned short handle, unsigned short length, PmcBlock* block)
{
    return move(handle, length, block, true);
}

void fake_poke(int address, unsigned char value)
{
    Control& one = control();
    const std::lock_guard lock(one.mutex);
    one.area.at(static_cast<std::size_t>(address)) = value;
}

unsigned char fake_peek(int address)
{
    Control& one = control();
    const std::lock_guard lock(one.mutex);
    return one.area.at(static_cast<std::size_t>(address));
}

/// After so many calls as many fail. The byte is written in the same moment: the calls are counted from it.
void fake_fail_after(int calls, int times, short code, int address, unsigned char value)
{
    Control& one = control();
    const std::lock_guard lock(one.mutex);
    one.failure = {calls, times};
    one.code = code;
    one.area.at(static_cast<std::size_t>(address)) = value;
}

/// After so many calls one does not come back; the byte likewise.
void fake_hold_after(int calls, int address, unsigned char value)
{
    Control& one = control();
    const std::lock_guard lock(one.mutex);
    one.hold = {calls, 1};
    one.area.at(static_cast<std::size_t>(address)) = value;
}

/// Calls that do not come back.
int fake_held()
{
    Control& one = control();
    const std::lock_guard lock(one.mutex);
    return one.held;
}

/// They go on.
void fake_release()
{
    Control& one = control();
    const std::lock_guard lock(one.mutex);
    one.hold = {};
    one.held = 0;
    one.released.notify_all();
}

/// Blocks that are read state another range than was asked for.
void fake_state_other_range(bool states)
{
    Control& one = control();
    const std::lock_guard lock(one.mutex);
    one.states_other_range = states;
}

/// Shown the registers after each write of the library.
void fake_watch(Watch watch, void* of)
{
    Control& one = control();
    const std::lock_guard lock(one.mutex);
    one.watch = watch;
    one.watched_by = of;
}

int fake_handles()
{
    Control& one = control();
    const std::lock_guard lock(one.mutex);
    return static_cast<int>(one.handles.size());
}

/// Registers are cleared and handles end.
void fake_restart()
{
    Control& one = control();
    const std::lock_guard lock(one.mutex);
    one.area.fill(0);
    one.handles.clear();
    one.failure = {};
}
}
