#include "widgets/core/panel/message.h"

#include <QFileInfo>

#include "widgets/core/language.h"

namespace lathelier {

MessageKind kindOf(const Message& message)
{
    if (std::holds_alternative<Error>(message.content)) return MessageKind::Error;
    const auto* note = std::get_if<Note>(&message.content);
    return note && note->code.severity == Severity::Warning ? MessageKind::Warning : MessageKind::Info;
}

QString shortText(const Message& message)
{
    Message named = message;
    const auto shorten = [](Values& values) {
        const Value* path = find(values, "path");
        const auto* whole = path ? std::get_if<std::string>(path) : nullptr;
        if (whole) set(values, "path", QFileInfo(QString::fromStdString(*whole)).fileName().toStdString());
    };
    if (auto* note = std::get_if<Note>(&named.content)) shorten(note->values);
    if (auto* phrase = std::get_if<Phrase>(&named.content)) shorten(phrase->values);
    if (const auto* error = std::get_if<Error>(&message.content)) {
        Values values = error->values();
        shorten(values);
        named.content = Error(error->code(), std::move(values));
    }
    return screenText(named);
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
