#include "engine/io/file_system.h"

#include <cerrno>
#include <system_error>

namespace lathelier::io {

Value systemReason(int error)
{
    switch (error) {
        case EACCES:
        case EPERM: return LT_TEXT("Engine", "no permission");
        case ENOSPC: return LT_TEXT("Engine", "the disk is full");
        case EDQUOT: return LT_TEXT("Engine", "the disk quota is used up");
        case EFBIG: return LT_TEXT("Engine", "the file would be too large");
        case EROFS: return LT_TEXT("Engine", "the disk is read-only");
        case EISDIR: return LT_TEXT("Engine", "it is a folder");
        case ENOENT:
        case ENOTDIR: return LT_TEXT("Engine", "the folder does not exist");
        case ENAMETOOLONG: return LT_TEXT("Engine", "the name is too long");
        case ELOOP: return LT_TEXT("Engine", "its links go round in a circle");
        case EMFILE:
        case ENFILE: return LT_TEXT("Engine", "too many files are open");
        case ENOMEM: return LT_TEXT("Engine", "there is not enough memory");
        default: return std::generic_category().message(error);
    }
}

}  // namespace lathelier::io
