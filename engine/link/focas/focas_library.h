// The vendor's library FOCAS2 in this process: loaded by name at run time, started once, and shared by all links to it.
#pragma once

#include <memory>
#include <string>

#include "engine/link/focas/focas_api.h"

namespace lathelier::link::focas {

class Library {
public:
    explicit Library(const std::string& file);
    /// Ends the library's own threads (cnc_exitprocess). It stays mapped: code of it may still run.
    ~Library();
    Library(const Library&) = delete;
    Library& operator=(const Library&) = delete;

    Allocate allocate = nullptr;
    Free free = nullptr;
    ReadRange read = nullptr;
    WriteRange write = nullptr;

private:
    ExitProcess exit_ = nullptr;
};

/// The library of this file; while one uses it, another gets the same, for start and end are of the process. Error
/// linkNotFound with the reason: no such library, a call that it does not have, a start that fails. Safe from any
/// thread.
std::shared_ptr<const Library> sharedLibrary(const std::string& file);

}  // namespace lathelier::link::focas
