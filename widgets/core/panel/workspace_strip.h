// Widget of fixed height above the panels of a workspace, such as a chain of steps.
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
    void panelRequested(const std::string& id);  ///< request to show a panel, in this workspace if it belongs to it
    void messageRaised(const lathelier::Message& message);
};

/// One strip of the window.
struct StripFacts {
    std::string workspace;                          ///< workspace id
    std::function<WorkspaceStrip*(Session&)> make;  ///< creates the strip with the window
};

}  // namespace lathelier
