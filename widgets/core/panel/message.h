// What is told to the user in the message log: kept as data, so that it follows the language.
#pragma once

#include <QDateTime>
#include <QString>
#include <variant>

#include "engine/core/error.h"
#include "engine/core/text.h"

namespace lathelier {

/// A phrase with named values, for what is neither error nor note: {"Saved {path}."}.
struct Phrase {
    Text pattern;   ///< with {name} for the values
    Values values;  ///< by name
};

struct Message {
    std::variant<Error, Note, Phrase> content;      ///< what is said
    Text source;                                    ///< which panel; empty: the window
    QDateTime time = QDateTime::currentDateTime();  ///< when it was made
};

enum class MessageKind { Info, Warning, Error };
MessageKind kindOf(const Message& message);
QString screenText(const Message& message);
QString shortText(const Message& message);  ///< the same with files by their names, without folders

}  // namespace lathelier
