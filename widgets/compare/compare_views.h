// The views of a comparison, linked: 3-D, unrolled map, meridian, histogram, tables. A place picked in one is marked in
// all.
#pragma once

#include <QWidget>
#include <memory>
#include <vector>

#include "engine/cad/task/compare_places.h"
#include "engine/registration/copies.h"
#include "engine/report/document.h"
#include "widgets/scene/scene_data.h"

namespace lathelier {
class PrimaryViews;
}

namespace lathelier::compare_panel {

class CompareViews : public QWidget {
    Q_OBJECT

public:
    explicit CompareViews(QWidget* parent = nullptr);
    ~CompareViews() override;

    void setOutcome(const std::shared_ptr<const cad::CompareOutcome>& outcome);

    /// The place marked in all views.
    void setPlace(const std::optional<cad::ComparePlace>& place);
    const std::optional<cad::ComparePlace>& place() const;

    /// Ends of the colour scale; without upper end: from the data; without lower end: symmetric.
    void setLimit(std::optional<double> limit_mm, std::optional<double> lower_mm = {});
    double limit_mm() const;

    /// 3-D pictures for the report: overlay and deviation, oblique and from the side. Empty without OpenGL.
    std::vector<report::Picture> pictures();

    PrimaryViews* primaryViews() const;

    /// Colours, scale, magnification of the error and camera, saved with the project.
    Values view() const;
    void restoreView(const Values& kept);

    /// Marks a place along the axis, at the angle (90° when there is none).
    void markAlong(double z_mm, std::optional<double> angle_deg);

    /// Table and trend of several copies, the first of which is shown; empty or one: no such view.
    void setCopies(const std::vector<registration::CopySummary>& copies);

    void retranslate();

signals:
    void copyRequested(int number);                            ///< request to show a further copy, from 0
    void sectionRequested(double z_mm);                        ///< request for the roundness of the marked section
    void toleranceDragged(double tolerance_mm, bool dropped);  ///< a limit of the histogram is dragged to this value
    void zoneDrawn(double from_mm, double to_mm);              ///< z interval of a drawn zone
    void notWritten(const QString& path);                      ///< the file could not be written

private:
    struct Parts;
    void buildBar();
    void showTolerance(double tolerance_mm);
    void showSurface();
    void showCharts();
    void arrange();
    void recolour(std::optional<double> tolerance_mm);
    void tag(const cad::ComparePlace& place);
    cad::ComparePlace placeOf(int object, const scene::PickedPlace& surface) const;
    scene::SceneObject skin();

    std::unique_ptr<Parts> parts_;
};

}  // namespace lathelier::compare_panel
