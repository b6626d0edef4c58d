#include "engine/archive/sql/file_system.h"

#include <sys/stat.h>
#include <sys/sysmacros.h>
#include <sys/vfs.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace lathelier::archive::sql {
namespace {

struct KnownFileSystem {
    std::uint32_t magic;
    const char* name;
};

/// statfs(2) and linux/magic.h.
constexpr KnownFileSystem networkFileSystems[] = {
    {0x6969, "NFS"},        {0xFF534D42, "CIFS"},   {0xFE534D42, "SMB2"},     {0x517B, "SMB"},
    {0x564C, "NCP"},        {0x5346414F, "AFS"},    {0x6B414653, "AFS"},      {0x73757245, "Coda"},
    {0x00C36400, "Ceph"},   {0x01021997, "9P"},     {0x0BD00BD0, "Lustre"},   {0x19830326, "BeeGFS"},
    {0x47504653, "GPFS"},   {0x01161970, "GFS2"},   {0x7461636F, "OCFS2"},    {0xAAD7AAEA, "PanFS"},
    {0x786F4256, "VBoxSF"}, {0xBACBACBC, "VMHGFS"}, {0x20030528, "OrangeFS"}, {0x013111A8, "IBRIX"},
    {0xA501FCF5, "VxFS"},   {0x7C7C6673, "PRLFS"}};

constexpr std::uint32_t fuseMagic = 0x65735546;

constexpr const char* localFuseTypes[] = {"fuseblk",         "fuse.ntfs-3g",        "fuse.ntfs",   "fuse.exfat",
                                          "fuse.exfat-fuse", "fuse.gocryptfs",      "fuse.cryfs",  "fuse.encfs",
                                          "fuse.mergerfs",   "fuse.fuse-overlayfs", "fuse.bindfs", "fuse.ext2"};

/// The type of the mount that holds a device, of /proc/self/mountinfo:
/// "36 35 98:0 /mnt1 /mnt2 rw,noatime master:1 - ext3 /dev/root rw".
std::string mountTypeOf(const std::string& device)
{
    std::ifstream mounts("/proc/self/mountinfo");
    std::string line;
    while (std::getline(mounts, line)) {
        std::istringstream words(line);
        std::string number, parent, mounted, word;
        words >> number >> parent >> mounted;
        if (mounted != device) continue;
        while (words >> word && word != "-") {
        }
        words >> word;
        return word;
    }
    return {};
}

}  // namespace

std::optional<std::string> networkFileSystem(std::int64_t magic, const std::string& mount_type)
{
    const auto kind = static_cast<std::uint32_t>(magic);
    for (const KnownFileSystem& known : networkFileSystems)
        if (known.magic == kind) return known.name;
    if (kind != fuseMagic) return std::nullopt;
    if (std::find(std::begin(localFuseTypes), std::end(localFuseTypes), mount_type) != std::end(localFuseTypes))
        return std::nullopt;
    return mount_type.empty() ? "FUSE" : mount_type;
}

std::optional<std::string> networkFileSystemOf(const std::string& path)
{
    std::error_code problem;
    std::filesystem::path place = std::filesystem::weakly_canonical(std::filesystem::absolute(path, problem), problem);
    while (!place.empty() && !std::filesystem::exists(place, problem) && place != place.parent_path())
        place = place.parent_path();
    struct statfs system {};
    struct stat status {};
    if (place.empty() || ::statfs(place.c_str(), &system) != 0 || ::stat(place.c_str(), &status) != 0)
        return std::nullopt;
    const std::string device = std::to_string(major(status.st_dev)) + ":" + std::to_string(minor(status.st_dev));
    return networkFileSystem(static_cast<std::int64_t>(system.f_type), mountTypeOf(device));
}

}  // namespace lathelier::archive::sql
