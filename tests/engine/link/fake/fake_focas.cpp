// A library that speaks the published interface of FOCAS2 and simulates a control: registers, handles, errors of any
// call, a control that restarts. Further functions, fake_…, let a test do that.
#include <array>
#include <mutex>
#include <set>

#include "engine/link/focas/focas_api.h"

namespace {

using lathelier::link::focas::PmcBlock;

constexpr short badHandle = -8;
constexpr short badSocket = -16;
constexpr short badLength = 2;
constexpr int registers = 65536;

struct Control {
    std::mutex mutex;
    std::array<unsigned char, registers> area{};
    std::set<unsigned short> handles;
    unsigned short next = 1;
    int calls_to_fail = -1;  // that still succeed; below 0: none fails
    short code = badSocket;
};

Control& control()
{
    static Control one;
    return one;
}

/// The code with which this call fails; 0: it succeeds.
short failure(Control& one)
{
    if (one.calls_to_fail < 0 || one.calls_to_fail-- > 0) return 0;
    return one.code;
}

short move(unsigned short handle, unsigned short length, PmcBlock* block, bool writes)
{
    Control& one = control();
    const std::lock_guard lock(one.mutex);
    if (const short code = failure(one)) return code;
    if (one.handles.count(handle) == 0) return badHandle;
    const int count = block->last - block->first + 1;
    if (count < 1 || length != lathelier::link::focas::headBytes + count ||
        block->area != lathelier::link::focas::areaR || block->type != lathelier::link::focas::dataBytes)
        return badLength;
    for (int i = 0; i < count; ++i) {
        unsigned char& place = one.area.at(static_cast<std::size_t>(block->first + i));
        if (writes)
            place = static_cast<unsigned char>(block->data[i]);
        else
            block->data[i] = static_cast<char>(place);
    }
    return 0;
}

}  // namespace

extern "C" {

short cnc_startupprocess(long, const char*)
{
    return 0;
}

short cnc_exitprocess()
{
    return 0;
}

short cnc_allclibhndl3(const char* host, unsigned short, long, unsigned short* handle)
{
    Control& one = control();
    const std::lock_guard lock(one.mutex);
    if (const short code = failure(one)) return code;
    if (host[0] == '\0') return badSocket;
    *handle = one.next++;
    one.handles.insert(*handle);
    return 0;
}

short cnc_freelibhndl(unsigned short handle)
{
    Control& one = control();
    const std::lock_guard lock(one.mutex);
    return one.handles.erase(handle) == 1 ? short{0} : badHandle;
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

void fake_fail_after(int calls, short code)
{
    Control& one = control();
    const std::lock_guard lock(one.mutex);
    one.calls_to_fail = calls;
    one.code = code;
}

/// Registers are cleared and handles end.
void fake_restart()
{
    Control& one = control();
    const std::lock_guard lock(one.mutex);
    one.area.fill(0);
    one.handles.clear();
    one.calls_to_fail = -1;
}
}
