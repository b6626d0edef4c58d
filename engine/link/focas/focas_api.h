// The calls of FOCAS2 that the link uses, declared from published facts; the library is the vendor's, loaded when the
// link starts, and no part of this program.
//
// Registers are read and written as bytes alone: the size of the vendor's `long` differs between its libraries, that of
// a byte does not.
#pragma once

#include <cstddef>

namespace lathelier::link::focas {

inline constexpr short areaR = 5;               ///< internal relays of the PMC
inline constexpr short dataBytes = 0;           ///< type of data: byte
inline constexpr std::size_t mostBytes = 64;    ///< of one call
inline constexpr unsigned short headBytes = 8;  ///< of the block before its data
inline constexpr short ok = 0;

/// A range of registers.
struct PmcBlock {
    short area = areaR;
    short type = dataBytes;
    unsigned short first = 0;  ///< address of the first byte
    unsigned short last = 0;   ///< of the last one
    char data[mostBytes] = {};
};

using StartProcess = short (*)(long level, const char* log_file);
using ExitProcess = short (*)();
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

}  // namespace lathelier::link::focas
