// The views of a comparison, linked: 3-D, unrolled map, meridian, histogram, tables. A place picked in one is marked in
// all.
#pragma once

#include <QWidget>
#include <memory>
#include <vector>

#include "engine/registration/copies.h"
#include "engine/report/document.h"
#include "widgets/compare/compare_picture.h"

namespace lathelier {
class HeroViews;
}

namespace lathelier::compare_panel {

class CompareViews : public QWidget {
    Q_OBJECT

public:
    explicit CompareViews(QWidget* parent = nullptr);
    ~CompareViews() override;

    void setPicture(const std::shared_ptr<const ComparePicture>& picture);

    /// The place marked in all views.
    void setPlace(const std::optional<ComparePlace>& place);
    const std::optional<ComparePlace>& place() const;

    /// Ends of the colour scale; no upper one: chosen from the data; no lower one: as far below 0 as above.
    void setLimit(std::optional<double> limit_mm, std::optional<double> lower_mm = {});
    double limit_mm() const;

    /// 3-D pictures for the report: overlay and deviation, oblique and from the side. Empty without OpenGL.
    std::vector<report::Picture> pictures();

    HeroViews* heroes() const;

    /// Colours, scale, magnification of the error and camera, to be kept with the project.
    Values view() const;
    void restoreView(const Values& kept);

    /// Marks a place along the axis, at the angle (90° when there is none).
    void markAlong(double z_mm, std::optional<double> angle_deg);

    /// Table and trend of several copies, the first of which is on screen; empty or one: no such view.
    void setCopies(const std::vector<registration::CopySummary>& copies);

    void retranslate();

signals:
    void copyWanted(int number);      ///< of the further copies, from 0: the user wants to see it
    void sectionWanted(double z_mm);  ///< the user wants the roundness of the copy in the marked section
    void toleranceDragged(double tolerance_mm, bool dropped);  ///< a limit of the histogram is dragged there
    void zoneDrawn(double from_mm, double to_mm);              ///< along the axis
    void notWritten(const QString& path);                      ///< the system refused to write this file

private:
    struct Parts;
    void buildBar();
    void showTolerance(double tolerance_mm);
    void showSurface();
    void showCharts();
    void arrange();
    void recolour(std::optional<double> tolerance_mm);
    void tag(const ComparePlace& place);

    std::unique_ptr<Parts> parts_;
};

}  // namespace lathelier::compare_panel
