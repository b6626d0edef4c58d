// Entry of the message log, stored as data so that it follows the language.
#pragma once

#include <QDateTime>
#include <QString>
#include <variant>

#include "engine/core/error.h"
#include "engine/core/text.h"

namespace lathelier {

/// A phrase with named values that is neither error nor note: {"Saved {path}."}.
struct Phrase {
    Text pattern;   ///< with {name} for the values
    Values values;  ///< values by name
};

struct Message {
    std::variant<Error, Note, Phrase> content;
    Text source;                                    ///< panel; empty: the window
    QDateTime time = QDateTime::currentDateTime();  ///< time of the message
};

enum class MessageKind { Info, Warning, Error };
MessageKind kindOf(const Message& message);
QString screenText(const Message& message);
QString shortText(const Message& message);  ///< the same with file names without folders

}  // namespace lathelier
