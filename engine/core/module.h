// Modules: parts of the program that call a large foreign library (OpenCASCADE, PCL, OpenCV). Each is a shared object
// of its own that is loaded when it is first used, so that a program starts without libraries that are not used.
//
// A module exports one table of functions, `extern "C" const Table symbol`; its room calls through
// moduleTable<Table>(). Errors and cancellation pass through: typeinfo is compared by name.
#pragma once

#include <string>

namespace lathelier {

/// The address of `symbol` in the module `name`, a file <name>.so in lib/<program> (installed) or lib/lathelier (built)
/// beside the folder that the program runs from; loaded on first use and kept to the end. Error moduleMissing. Safe
/// from any thread.
const void* moduleSymbol(const std::string& name, const char* symbol);

template <class Table>
const Table& moduleTable(const std::string& name, const char* symbol)
{
    return *static_cast<const Table*>(moduleSymbol(name, symbol));
}

}  // namespace lathelier
