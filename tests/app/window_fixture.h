// The main window with panels of the test, made anew for each test function.
#pragma once

#include <QFile>
#include <QSettings>
#include <QTemporaryDir>
#include <QTest>
#include <memory>

#include "app/gui/main_window.h"
#include "tests/widgets/core/fake_panel.h"
#include "widgets/core/resources.h"

namespace lathelier {

/// Keeps the user's own settings out of the test.
inline void useSettingsOf(const QString& folder)
{
    QCoreApplication::setOrganizationName("LathelierTest");
    QSettings::setDefaultFormat(QSettings::IniFormat);
    QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, folder);
    useResources();
}

class WindowFixture {
protected:
    QTemporaryDir folder_;
    Languages languages_;
    std::unique_ptr<Session> session_;
    std::unique_ptr<MainWindow> window_;

    static std::vector<PanelFacts> panels()
    {
        PanelFacts round = FakePanel::factsOf("round", "roundness");
        PanelFacts records = FakePanel::factsOf("records", "roundness");
        round.recognises = [](const std::string& path) { return path.ends_with(".profile"); };
        records.recognises = [](const std::string& path) { return path.ends_with(".record"); };
        return {FakePanel::factsOf("one"), FakePanel::factsOf("two"), round, records};
    }
    PanelDock* dock(const std::string& id) const
    {
        for (PanelDock* dock : window_->docks())
            if (dock->facts().id == id) return dock;
        return nullptr;
    }
    QString makeFile(const QString& name, int size = 10)
    {
        QFile file(folder_.filePath(name));
        if (file.open(QIODevice::WriteOnly)) file.write(QByteArray(size, 'x'));
        return file.fileName();
    }
    void restart()
    {
        if (window_) window_->close();
        window_.reset();
        session_ = std::make_unique<Session>();
        window_ = std::make_unique<MainWindow>(*session_, languages_, panels());
        window_->show();
        QVERIFY(QTest::qWaitForWindowExposed(window_.get()));
    }
    void prepareSettings() { useSettingsOf(folder_.path()); }
    void begin()
    {
        QSettings().clear();
        languages_.use("en");
        restart();
    }
    void end()
    {
        session_->undoStack().setClean();  // no question about unsaved work
        window_->close();
        window_.reset();
    }
};

}  // namespace lathelier
