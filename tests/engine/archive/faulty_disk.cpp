#include "tests/engine/archive/faulty_disk.h"

#include <sqlite3.h>

#include <cstdlib>
#include <cstring>
#include <new>

namespace lathelier::archive {
namespace {

struct Plan {
    int left = 0;  ///< until one fails; 0: none does
    int code = SQLITE_OK;
    bool is_for_good = false;
    bool has_failed = false;

    int next()
    {
        if (has_failed && is_for_good) return code;
        if (left == 0 || --left > 0) return SQLITE_OK;
        has_failed = true;
        return code;
    }
};
Plan plan;
sqlite3_vfs* real = nullptr;

/// SQLite's file, with the real one behind it in the same memory.
struct FaultyFile {
    sqlite3_file base;
    sqlite3_file* real;
};

sqlite3_file* realOf(sqlite3_file* file)
{
    return reinterpret_cast<FaultyFile*>(file)->real;
}

int closeFile(sqlite3_file* file)
{
    return realOf(file)->pMethods->xClose(realOf(file));
}
int readFile(sqlite3_file* file, void* bytes, int count, sqlite3_int64 at)
{
    return realOf(file)->pMethods->xRead(realOf(file), bytes, count, at);
}
int writeFile(sqlite3_file* file, const void* bytes, int count, sqlite3_int64 at)
{
    const int code = plan.next();
    if (code == SQLITE_OK) return realOf(file)->pMethods->xWrite(realOf(file), bytes, count, at);
    // Half of it gets through, as when the current fails.
    realOf(file)->pMethods->xWrite(realOf(file), bytes, count / 2, at);
    return code;
}
int truncateFile(sqlite3_file* file, sqlite3_int64 size)
{
    const int code = plan.next();
    return code == SQLITE_OK ? realOf(file)->pMethods->xTruncate(realOf(file), size) : code;
}
int syncFile(sqlite3_file* file, int flags)
{
    const int code = plan.next();
    return code == SQLITE_OK ? realOf(file)->pMethods->xSync(realOf(file), flags) : code;
}
int fileSize(sqlite3_file* file, sqlite3_int64* size)
{
    return realOf(file)->pMethods->xFileSize(realOf(file), size);
}
int lockFile(sqlite3_file* file, int kind)
{
    return realOf(file)->pMethods->xLock(realOf(file), kind);
}
int unlockFile(sqlite3_file* file, int kind)
{
    return realOf(file)->pMethods->xUnlock(realOf(file), kind);
}
int checkReserved(sqlite3_file* file, int* held)
{
    return realOf(file)->pMethods->xCheckReservedLock(realOf(file), held);
}
int controlFile(sqlite3_file* file, int what, void* argument)
{
    return realOf(file)->pMethods->xFileControl(realOf(file), what, argument);
}
int sectorSize(sqlite3_file* file)
{
    return realOf(file)->pMethods->xSectorSize(realOf(file));
}
int deviceFeatures(sqlite3_file* file)
{
    return realOf(file)->pMethods->xDeviceCharacteristics(realOf(file));
}
int mapShared(sqlite3_file* file, int page, int size, int extend, void volatile** at)
{
    return realOf(file)->pMethods->xShmMap(realOf(file), page, size, extend, at);
}
int lockShared(sqlite3_file* file, int from, int count, int flags)
{
    return realOf(file)->pMethods->xShmLock(realOf(file), from, count, flags);
}
void barrierShared(sqlite3_file* file)
{
    realOf(file)->pMethods->xShmBarrier(realOf(file));
}
int unmapShared(sqlite3_file* file, int remove)
{
    return realOf(file)->pMethods->xShmUnmap(realOf(file), remove);
}

const sqlite3_io_methods methods{
    2,          closeFile,     readFile,      writeFile,   truncateFile, syncFile,       fileSize,
    lockFile,   unlockFile,    checkReserved, controlFile, sectorSize,   deviceFeatures, mapShared,
    lockShared, barrierShared, unmapShared,   nullptr,     nullptr};

int openFile(sqlite3_vfs*, const char* name, sqlite3_file* file, int flags, int* opened)
{
    auto* made = reinterpret_cast<FaultyFile*>(file);
    made->base.pMethods = nullptr;
    made->real = reinterpret_cast<sqlite3_file*>(made + 1);
    const int code = real->xOpen(real, name, made->real, flags, opened);
    if (made->real->pMethods != nullptr) made->base.pMethods = &methods;
    return code;
}

sqlite3_vfs& faulty()
{
    static sqlite3_vfs vfs{};
    return vfs;
}

}  // namespace

FaultyDisk::FaultyDisk()
{
    plan = {};
    real = sqlite3_vfs_find(nullptr);
    faulty() = *real;  // its other functions look at nothing of their own
    faulty().zName = "faulty";
    faulty().szOsFile = static_cast<int>(sizeof(FaultyFile)) + real->szOsFile;
    faulty().xOpen = openFile;
    sqlite3_vfs_register(&faulty(), 1);
}

FaultyDisk::~FaultyDisk()
{
    sqlite3_vfs_register(real, 1);
    sqlite3_vfs_unregister(&faulty());
}

void FaultyDisk::failAt(int n, int code, bool for_good)
{
    plan = {n, code, for_good, false};
}

bool FaultyDisk::hasFailed() const
{
    return plan.has_failed;
}

}  // namespace lathelier::archive
