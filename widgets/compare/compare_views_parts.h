// Parts of the views of a comparison. Included by the .cpp files of CompareViews only.
#pragma once

#include <QButtonGroup>
#include <QCheckBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QSplitter>
#include <QTabWidget>
#include <QToolButton>

#include "widgets/compare/compare_tables.h"
#include "widgets/compare/compare_views.h"
#include "widgets/core/panel/primary_views.h"
#include "widgets/plot/chart_view.h"
#include "widgets/plot/map_view.h"
#include "widgets/scene/scene_view.h"

namespace lathelier::compare_panel {

/// Keys of the views in the project file.
namespace view {
inline constexpr const char* part = "part";
inline constexpr const char* map = "map";
inline constexpr const char* meridian = "meridian";
inline constexpr const char* distribution = "distribution";
inline constexpr const char* tables = "tables";
inline constexpr const char* sizes = "sizes";
inline constexpr const char* copies = "copies";
}  // namespace view

struct CompareViews::Parts {
    std::shared_ptr<const cad::CompareOutcome> outcome;  ///< shown outcome; null: none yet
    std::optional<cad::ComparePlace> place;              ///< the marked place; none: no place
    std::optional<double> chosen_limit_mm;  ///< end of the colour scale chosen by the user; none: from the data
    struct Counted {                        ///< values counted by the bars beside the scale
        std::shared_ptr<const std::vector<float>> values;  ///< shared: the address is the identity
        double least = 0, limit = 0;                       ///< ends of the scale, in mm
        friend bool operator==(const Counted&, const Counted&) = default;
    } counted;
    std::shared_ptr<const std::vector<float>> coloured;  ///< deviations shown on the part; null: none
    struct ShownSkin {                                   ///< the skin as drawn
        std::shared_ptr<const Skin> skin;                ///< of the outcome; null: none is drawn
        double factor = 1;                               ///< magnification of the error
        ScanPtr mesh;                                    ///< in the reference's frame
    } skin;
    bool coloured_by_share = false;              ///< `coloured` are shares of the limits
    std::optional<double> chosen_lower_mm;       ///< extent below 0 in mm; none: symmetric
    std::optional<double> chosen_factor;         ///< chosen magnification of the error; none: from the result
    bool restored = false;                       ///< the choices above were restored from the opened project
    std::optional<double> dragged_tolerance_mm;  ///< tolerance being dragged; the result may be older

    scene::SceneView* scene = nullptr;                 ///< reference and copy in space
    plot::MapView* map = nullptr;                      ///< unrolled map of the deviation
    plot::ChartView* along = nullptr;                  ///< mean deviation along the axis, under the scene
    plot::ChartView* meridian = nullptr;               ///< radius along the axis, with the error magnified
    plot::ChartView* histogram = nullptr;              ///< distribution of the deviations
    ZoneTable* zones = nullptr;                        ///< mean deviation by zone
    SizeTable* sizes = nullptr;                        ///< against a drawing, row by row
    StatisticsTable* numbers = nullptr;                ///< statistics of the deviations
    std::vector<registration::CopySummary> summaries;  ///< ; empty: there is one
    QSplitter* copies = nullptr;                       ///< splitter: trend above table
    plot::ChartView* trend = nullptr;
    CopyTable* copy_table = nullptr;        ///< table of copies, one row for each
    QTabWidget* tabs = nullptr;             ///< tabs: zones and statistics
    PrimaryViews* primary_views = nullptr;  ///< one large view, the others small

    QToolButton* overlay = nullptr;    ///< button: both parts in plain colours
    QToolButton* deviation = nullptr;  ///< button: the copy coloured by its deviation
    QToolButton* form = nullptr;       ///< button: the colours show the form of the error
    QToolButton* pass_fail = nullptr;  ///< button: colours by pass and fail
    QCheckBox* smooth = nullptr;       ///< colours by local means, not by each point
    QLabel* factor_label = nullptr;
    QDoubleSpinBox* factor = nullptr;  ///< magnification of the meridian's error
    QToolButton* zone = nullptr;       ///< button: the next drag draws a zone
    QToolButton* section = nullptr;    ///< button: roundness of the marked section
    QLabel* synthetic = nullptr;       ///< label of synthetic data; hidden for measured ones

    const registration::CompareResult& result() const { return *outcome->result; }
    bool hasAxis() const { return outcome && result().unrolled && result().meridian && result().axis_T_reference; }
    /// Whether the part is drawn as its skin, coloured by local means.
    bool showsSkin() const { return outcome && outcome->form.skin && deviation->isChecked() && smooth->isChecked(); }
    /// Whether the colours show shares of the limits at each place, in %.
    bool shares() const
    {
        return hasAxis() && pass_fail->isChecked() && registration::showsShares(result().parameters);
    }
    /// Half width of the green band, in the unit of the colours; none: they show the form only.
    std::optional<double> greenWithin() const
    {
        if (shares()) return 100;
        return outcome && pass_fail->isChecked() ? result().parameters.tolerance_mm : std::nullopt;
    }
};

}  // namespace lathelier::compare_panel
