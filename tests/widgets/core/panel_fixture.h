// One panel in a window of its own, with a session.
#pragma once

#include <QTest>
#include <QUndoStack>
#include <memory>
#include <string>

#include "widgets/core/session.h"

namespace lathelier {

template <class P>
class PanelFixture {
protected:
    std::unique_ptr<Session> session_;
    std::unique_ptr<P> panel_;

    void begin()
    {
        session_ = std::make_unique<Session>();
        panel_ = std::make_unique<P>(*session_);
        panel_->resize(1200, 750);
        panel_->show();
        QVERIFY(QTest::qWaitForWindowExposed(panel_.get()));
    }
    void end()
    {
        panel_.reset();
        session_.reset();
    }
    /// Until what is shown answers what is asked.
    void settle() { QTRY_VERIFY_WITH_TIMEOUT(panel_->isCurrent(), 60000); }

    /// Sets a parameter of the panel: one undo step.
    void set(const std::string& key, const Value& value)
    {
        session_->edit("Set", [&](project::Project& project) {
            lathelier::set(project.panels[panel_->facts().stateKey()].parameters, key, value);
        });
    }
};

}  // namespace lathelier
