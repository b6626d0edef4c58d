// Text files of any encoding as UTF-8.
#pragma once

#include <string>
#include <string_view>

#include "engine/core/progress.h"
#include "engine/io/import.h"

namespace lathelier::io {

/// A text in UTF-8 without byte order mark. Typographic blanks and the minus sign U+2212 are plain ' ' and '-'. Padding
/// at the end (NUL, Ctrl-Z) is removed.
class DecodedText {
public:
    DecodedText() = default;
    DecodedText(std::string_view bytes, std::string encoding);  ///< `bytes` must outlive this object
    DecodedText(std::string owned, std::string encoding);
    DecodedText(DecodedText&& other) noexcept;
    DecodedText& operator=(DecodedText&& other) noexcept;

    std::string_view view() const { return isOwned_ ? std::string_view(owned_) : view_; }
    const std::string& encoding() const
    {
        return encoding_;
    }  ///< "utf-8", "utf-16le", "utf-16be", "utf-32le", "utf-32be", "latin-1"

private:
    std::string owned_;
    std::string_view view_;
    bool isOwned_ = false;
    std::string encoding_;
};

/// True when `bytes` are text in one of the encodings: no NUL and no control characters where text has none.
bool looksLikeText(std::string_view bytes);

/// True for a byte order mark of UTF-32.
bool hasUtf32Mark(std::string_view bytes);

/// Decodes. Auto: byte order mark (also of UTF-32), else UTF-16 by its zero bytes, else UTF-8 when valid, else Latin-1
/// (Windows-1252). A plain ASCII or UTF-8 text is not copied. Error malformed (`byte`) when the given encoding does not
/// fit.
DecodedText decodeText(std::string_view bytes, Encoding encoding, const Progress& progress = {});

/// The column (from 1, in characters) of byte `offset` within a line of UTF-8.
std::int64_t columnAt(std::string_view line, std::size_t offset);

/// At most 40 characters of `text`, without control characters: for messages.
std::string excerpt(std::string_view text);

}  // namespace lathelier::io
