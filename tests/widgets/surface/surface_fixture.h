// The panel "Surface" with pictures of known truth in files.
#pragma once

#include <QFile>
#include <QTemporaryDir>
#include <QTest>
#include <cmath>

#include "engine/surface/synthetic.h"
#include "tests/widgets/core/drop_files.h"
#include "tests/widgets/core/panel_fixture.h"
#include "widgets/surface/surface_panel.h"
#include "widgets/surface/surface_views.h"

namespace lathelier::surface_panel {

class SurfaceFixture : protected PanelFixture<SurfacePanel> {
protected:
    QTemporaryDir folder_;
    QString before_, after_, field_;

    QString write(const QString& name, const surface::SyntheticParameters& p) const
    {
        const QString path = folder_.filePath(name);
        const std::string png = surface::syntheticPng(surface::syntheticPicture(p));
        QFile file(path);
        if (file.open(QIODevice::WriteOnly)) file.write(png.data(), static_cast<qint64>(png.size()));
        return path;
    }

    /// The whole width of a part of 30 mm.
    static surface::SyntheticParameters overview(double speed_rpm, double amplitude_um)
    {
        surface::SyntheticParameters p;
        p.feed_mm_rev = 0.2;
        p.nose_radius_mm = 0.8;
        p.speed_rpm = speed_rpm;
        p.amplitude_um = amplitude_um;
        p.mm_per_px = 0.03;
        p.width = 300;
        p.height = 880;
        p.cylinder = true;
        return p;
    }

    void writePictures()
    {
        before_ = write("before.png", overview(2016, 18.75));
        surface::SyntheticParameters after = overview(2154, 0);
        after.seed = 2;
        after_ = write("after.png", after);
        surface::SyntheticParameters field;
        field.amplitude_um = 9;
        field.width = 560;
        field.height = 420;
        field_ = write("field.png", field);
    }

    void setCut()
    {
        session_->edit("Set", [&](project::Project& project) {
            Values& p = project.panels["surface"].parameters;
            lathelier::set(p, "feed_mm_rev", 0.2);
            lathelier::set(p, "diameter_mm", 30.0);
            lathelier::set(p, "speed_before_rpm", 2016.0);
            lathelier::set(p, "speed_after_rpm", 2154.0);
            lathelier::set(p, "mm_per_px", 0.03);
            lathelier::set(p, "feed_direction_deg", 0.0);
            lathelier::set(p, "cut_direction", std::string("down"));
        });
    }
    void openBoth()
    {
        drop(panel_.get(), {before_, after_});
        setCut();
        settle();
    }
    Value parameter(const std::string& key) const
    {
        const Value* const value = find(session_->panel("surface").parameters, key);
        return value ? *value : Value();
    }
    SurfaceViews& views() const { return panel_->views(); }
    const surface::SurfaceResult& found() const { return *panel_->result()->result; }
    static void dragOver(PictureView* view, const QPointF& from, const QPointF& to)
    {
        QTest::qWait(50);  // a tool may have moved the view
        const QPoint a = view->placeOf(from).toPoint(), b = view->placeOf(to).toPoint();
        QTest::mousePress(view, Qt::LeftButton, {}, a);
        QTest::mouseMove(view, (a + b) / 2);
        QTest::mouseMove(view, b);
        QTest::mouseRelease(view, Qt::LeftButton, {}, b);
    }
};

}  // namespace lathelier::surface_panel
