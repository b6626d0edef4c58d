// What stands over the panels of a workspace, at a fixed height: a chain of steps, say.
#pragma once

#include <QFrame>
#include <functional>
#include <string>

#include "widgets/core/panel/message.h"

namespace lathelier {

class Session;

class WorkspaceStrip : public QFrame {
    Q_OBJECT
public:
    using QFrame::QFrame;

signals:
    void panelWanted(const std::string& id);  ///< shows it, in this workspace where it stands there
    void messageRaised(const lathelier::Message& message);
};

/// One strip of the window.
struct StripFacts {
    std::string workspace;                          ///< id
    std::function<WorkspaceStrip*(Session&)> make;  ///< made with the window
};

}  // namespace lathelier
