// POST.json as a kind of file.
#pragma once

#include "engine/cam/post/post.h"
#include "engine/io/file_kind.h"

namespace lathelier::cam {

/// A post with the facts and notes of its file.
struct PostFile {
    Post post;
    io::FileFacts facts;  ///< as postFiles() has them
    Notes notes;          ///< of the reading, with the path
};

/// In any encoding. Errors of readPost() and fileEmpty, with the path.
PostFile loadPost(const io::FileToRead& file);

/// POST.json. facts: format "post_json"; details "name", "dialect" (of the control that reads its programs; null where
/// none is stated).
const io::FileKind& postFiles();

}  // namespace lathelier::cam
