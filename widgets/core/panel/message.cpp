#include "widgets/core/panel/message.h"

#include "widgets/core/language.h"

namespace lathelier {

MessageKind kindOf(const Message& message)
{
    if (std::holds_alternative<Error>(message.content)) return MessageKind::Error;
    const auto* note = std::get_if<Note>(&message.content);
    return note && note->code.severity == Severity::Warning ? MessageKind::Warning : MessageKind::Info;
}

QString screenText(const Message& message)
{
    struct Visitor {
        QString operator()(const Error& error) const { return screenText(error); }
        QString operator()(const Note& note) const { return screenText(note); }
        QString operator()(const Phrase& phrase) const
        {
            const Language language = screenLanguage();
            return QString::fromStdString(fill(text(phrase.pattern, language), phrase.values, language));
        }
    };
    return std::visit(Visitor{}, message.content);
}

}  // namespace lathelier
