// A file system under SQLite whose writes fail when a test says so.
#pragma once

namespace lathelier::archive {

/// Of the process, from the making to the end: what SQLite opens goes through it.
class FaultyDisk {
public:
    FaultyDisk();
    ~FaultyDisk();
    FaultyDisk(const FaultyDisk&) = delete;
    FaultyDisk& operator=(const FaultyDisk&) = delete;

    /// The n-th write, synchronisation or truncation from now on fails with `code` of SQLite, and all behind it if
    /// `for_good`. 0: none.
    void failAt(int n, int code, bool for_good);

    /// Whether one has failed since.
    bool hasFailed() const;
};

}  // namespace lathelier::archive
