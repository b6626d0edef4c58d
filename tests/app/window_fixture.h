// The main window with panels of the test, made anew for each test function.
#pragma once

#include <QFile>
#include <QSettings>
#include <QTemporaryDir>
#include <QTest>
#include <map>
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

    /// Files whose name ends in `suffix`.
    static const io::FileKind& kindNamed(const std::string& suffix)
    {
        static std::map<std::string, io::FileKind> kinds;
        io::FileKind& kind = kinds[suffix];
        kind.key = suffix;
        kind.sniff = [suffix](const std::string& path, std::string_view, const Values&) {
            return path.ends_with("." + suffix) ? io::Likeness::Certain : io::Likeness::No;
        };
        return kind;
    }
    static std::vector<PanelFacts> panels()
    {
        PanelFacts round = FakePanel::factsOf("round", "roundness");
        PanelFacts records = FakePanel::factsOf("records", "roundness");
        round.kinds = {&kindNamed("profile")};
        records.kinds = {&kindNamed("record")};
        PanelFacts one = FakePanel::factsOf("one"), two = FakePanel::factsOf("two");
        one.kinds = two.kinds = {&kindNamed("txt")};
        return {one, two, round, records};
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
    void openFiles(const QStringList& paths)
    {
        window_->openPaths(paths);
        QTRY_VERIFY(!window_->isOpening());
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
