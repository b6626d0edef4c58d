#include "widgets/core/form/typing.h"

#include <QWidget>

namespace lathelier {

void takeOverTyping(const QWidget* window)
{
    for (QWidget* child : window->findChildren<QWidget*>())
        if (auto* editor = dynamic_cast<TypingEditor*>(child)) editor->takeOver();
}

}  // namespace lathelier
