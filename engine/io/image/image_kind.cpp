#include "engine/io/image/image_kind.h"

#include "engine/io/image/image.h"

namespace lathelier::io {

const FileKind& imageFiles()
{
    static const FileKind kind{"image",
                               LT_TEXT("Engine", "Pictures"),
                               "*.png *.jpg *.jpeg *.tif *.tiff",
                               {},
                               {},
                               [](const std::string&, std::string_view head, const Values&) {
                                   return isImage(head) ? Likeness::Certain : Likeness::No;
                               },
                               [](const FileToRead& file, Notes& notes) {
                                   const Image image = readImage(file.path, file.bytes, file.progress);
                                   notes.insert(notes.end(), image.notes.begin(), image.notes.end());
                                   return imageFacts(file.path, image);
                               }};
    return kind;
}

}  // namespace lathelier::io
