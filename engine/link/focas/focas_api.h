// The calls of FOCAS2 that the link uses, declared from published facts; the library is the vendor's, loaded when the
// link starts, and no part of this program.
//
// Registers are read and written as bytes alone: the size of the vendor's `long` differs between its libraries, that of
// a byte does not. The two arguments of that type are small numbers, passed in a register either way.
#pragma once

#include <cstddef>
#include <string>

namespace lathelier::link::focas {

inline constexpr short areaR = 5;               ///< internal relays of the PMC
inline constexpr short dataBytes = 0;           ///< type of data: byte
inline constexpr std::size_t mostBytes = 64;    ///< of one call
inline constexpr unsigned short headBytes = 8;  ///< of the block before its data

// Results. Below 0: of the link; above: of the call.
inline constexpr short ok = 0;
inline constexpr short protocol = -17;
inline constexpr short socket = -16;    ///< cut, or no answer within the library's time-out
inline constexpr short badHandle = -8;  ///< none of this thread, or one that has ended
inline constexpr short parity = -4;     ///< of the shared memory
inline constexpr short reset = -2;      ///< the control was reset
inline constexpr short busy = -1;       ///< not done: to be asked again
inline constexpr short noPmc = 1;       ///< or the function is not there
inline constexpr short badLength = 2;   ///< of the block
inline constexpr short badRange = 3;    ///< an address that the PMC does not have
inline constexpr short badType = 4;     ///< of area or data
inline constexpr short noOption = 6;    ///< the control lacks an option
inline constexpr short writeProtected = 7;
inline constexpr short rejected = 13;

/// A range of registers.
struct alignas(8) PmcBlock {  // the vendor's holds `long`, which may be so aligned
    short area = areaR;
    short type = dataBytes;
    unsigned short first = 0;  ///< address of the first byte
    unsigned short last = 0;   ///< of the last one
    char data[mostBytes] = {};
};
static_assert(offsetof(PmcBlock, data) == headBytes);

using StartProcess = short (*)(long level, const char* log_file);
using ExitProcess = short (*)();
/// A handle for the thread that calls. `timeout_s`: 0 would be for ever.
using Allocate = short (*)(const char* host, unsigned short port, long timeout_s, unsigned short* handle);
using Free = short (*)(unsigned short handle);
using ReadRange = short (*)(unsigned short handle, short area, short type, unsigned short first, unsigned short last,
                            unsigned short length, PmcBlock* block);
using WriteRange = short (*)(unsigned short handle, unsigned short length, PmcBlock* block);

inline constexpr const char* startProcessName = "cnc_startupprocess";  ///< of the library for Linux alone
inline constexpr const char* exitProcessName = "cnc_exitprocess";      ///< likewise
inline constexpr const char* allocateName = "cnc_allclibhndl3";
inline constexpr const char* freeName = "cnc_freelibhndl";
inline constexpr const char* readName = "pmc_rdpmcrng";
inline constexpr const char* writeName = "pmc_wrpmcrng";

/// "pmc_rdpmcrng: -16 (EW_SOCKET)", with the published name of the result where it has one.
std::string resultText(const char* call, short result);

}  // namespace lathelier::link::focas
