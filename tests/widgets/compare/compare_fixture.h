// The comparison panel with a scan of a shaft and one of its copy, to be driven as a user would.
#pragma once

#include <QCoreApplication>
#include <QLocale>
#include <QTemporaryDir>
#include <QTest>
#include <fstream>
#include <memory>
#include <optional>

#include "engine/sample/sample.h"
#include "tests/widgets/core/drop_files.h"
#include "widgets/compare/compare_panel.h"
#include "widgets/core/resources.h"
#include "widgets/core/session.h"

namespace lathelier {

class CompareFixture {
protected:
    static void write(const QString& path, const Scan& scan)
    {
        std::ofstream file(path.toStdString());
        file.precision(9);
        for (const Eigen::Vector3d& p : scan.points_mm) file << p.x() << ' ' << p.y() << ' ' << p.z() << '\n';
    }
    QTemporaryDir folder_;
    QString original_, copy_;
    std::unique_ptr<Session> session_;
    std::unique_ptr<compare_panel::ComparePanel> panel_;

    template <class W>
    W* part(const char* name) const
    {
        return panel_->findChild<W*>(name);
    }
    void settle()
    {
        QTRY_VERIFY_WITH_TIMEOUT(panel_->isCurrent() || panel_->error(), 60000);
        QVERIFY2(!panel_->error(), panel_->error() ? panel_->error()->what() : "");
    }
    void dropBoth()
    {
        drop(panel_.get(), {original_, copy_});
        settle();
        QTest::qWait(100);  // laid out and drawn
    }
    std::optional<double> tolerance() const
    {
        return fromValues<registration::CompareParameters>(session_->panel("compare").parameters).tolerance_mm;
    }
    void setTolerance(double value_mm)
    {
        session_->edit("tolerance", [&](project::Project& project) {
            lathelier::set(project.panels["compare"].parameters, "tolerance_mm", value_mm);
        });
        settle();
    }
    void prepare()
    {
        useResources();
        QLocale::setDefault(QLocale::c());
        sample::ScannerModel scanner;
        scanner.row_pitch_mm = 0.3;
        scanner.angle_step_deg = 2.4;
        original_ = folder_.filePath("original.xyz");
        copy_ = folder_.filePath("copy.xyz");
        write(original_, sample::scanShaft(sample::nominalShaft(), scanner));
        scanner.seed = 2;
        write(copy_, sample::scanShaft(sample::copiedShaft(), scanner));
    }
    void begin()
    {
        session_ = std::make_unique<Session>();
        panel_ = std::make_unique<compare_panel::ComparePanel>(*session_);
        panel_->resize(1280, 760);
        panel_->show();
        QVERIFY(QTest::qWaitForWindowExposed(panel_.get()));
        QCoreApplication::processEvents();
    }
    void end()
    {
        panel_.reset();
        session_.reset();
    }
};

}  // namespace lathelier
