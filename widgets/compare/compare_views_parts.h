// What the views of a comparison are made of. Included by the .cpp files of CompareViews only.
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
#include "widgets/core/panel/hero_views.h"
#include "widgets/plot/chart_view.h"
#include "widgets/plot/map_view.h"
#include "widgets/scene/scene_view.h"

namespace lathelier::compare_panel {

/// Keys of the views, as the project keeps them.
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
    std::shared_ptr<const ComparePicture> picture;  ///< what is shown; null: nothing yet
    std::optional<ComparePlace> place;              ///< the marked place; none: no place
    std::optional<double> chosenLimit;  ///< end of the colour scale that the user chose, in mm; none: from the result
    struct Counted {                    ///< what the bars beside the scale count
        std::shared_ptr<const std::vector<float>> values;  ///< held, so that no others take their place in memory
        double least = 0, limit = 0;                       ///< ends of the scale, in mm
        friend bool operator==(const Counted&, const Counted&) = default;
    } counted;
    std::shared_ptr<const std::vector<float>> coloured;  ///< deviations that the part shows; null: none
    std::optional<double> chosenLower;                   ///< how far below 0 it goes then, in mm; none: as far as above
    std::optional<double> chosenFactor;                  ///< likewise, magnification of the meridian's error
    bool restored = false;                   ///< the choices above are those of the project that is being opened
    std::optional<double> draggedTolerance;  ///< where the pointer holds it; the result may be a step behind

    scene::SceneView* scene = nullptr;                 ///< reference and copy in space
    plot::MapView* map = nullptr;                      ///< unrolled map of the deviation
    plot::ChartView* along = nullptr;                  ///< mean deviation along the axis, under the scene
    plot::ChartView* meridian = nullptr;               ///< radius along the axis, with the error magnified
    plot::ChartView* histogram = nullptr;              ///< distribution of the deviations
    ZoneTable* zones = nullptr;                        ///< mean deviation by zone
    SizeTable* sizes = nullptr;                        ///< against a drawing, row by row
    StatisticsTable* numbers = nullptr;                ///< statistics of the deviations
    std::vector<registration::CopySummary> summaries;  ///< of several copies; empty: there is one
    QSplitter* copies = nullptr;                       ///< trend over table
    plot::ChartView* trend = nullptr;                  ///< of several copies
    CopyTable* copyTable = nullptr;                    ///< one row for each
    QTabWidget* tabs = nullptr;                        ///< zones and numbers
    HeroViews* heroes = nullptr;                       ///< one of them large, the others small

    QToolButton* overlay = nullptr;    ///< button: both parts in plain colours
    QToolButton* deviation = nullptr;  ///< button: the copy coloured by its deviation
    QToolButton* form = nullptr;       ///< button: the colours show the form of the error
    QToolButton* passFail = nullptr;   ///< button: they show what is within the tolerance
    QCheckBox* smooth = nullptr;       ///< colours by local means, not by each point
    QLabel* factorLabel = nullptr;     ///< label of `factor`
    QDoubleSpinBox* factor = nullptr;  ///< magnification of the meridian's error
    QToolButton* zone = nullptr;       ///< button: the next drag draws a zone
    QToolButton* section = nullptr;    ///< button: roundness of the marked section
    QLabel* synthetic = nullptr;       ///< label of synthetic data; hidden for measured ones

    const registration::CompareResult& result() const { return *picture->result; }
    bool hasAxis() const { return picture && result().unrolled && result().meridian && result().axis_T_reference; }
    /// What is drawn green; none: the colours show the form alone.
    std::optional<double> greenWithin() const
    {
        return picture && passFail->isChecked() ? result().parameters.tolerance_mm : std::nullopt;
    }
};

}  // namespace lathelier::compare_panel
