// What the views of a comparison are made of. Included by the .cpp files of CompareViews only.
#pragma once

#include <QButtonGroup>
#include <QCheckBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QSplitter>
#include <QTabWidget>
#include <QToolButton>
#include <array>

#include "widgets/compare/compare_tables.h"
#include "widgets/compare/compare_views.h"
#include "widgets/plot/chart_view.h"
#include "widgets/plot/map_view.h"
#include "widgets/scene/scene_view.h"

namespace lathelier {

/// The choices of the view bar, in its order.
enum CompareView { All, Space, Map, Profile, Distribution, Zones, Numbers, viewCount };

struct CompareViews::Parts {
    std::shared_ptr<const ComparePicture> picture;
    std::optional<ComparePlace> place;
    std::optional<double> chosenLimit;
    std::optional<double> chosenFactor;
    std::optional<double> draggedTolerance;  ///< where the pointer holds it; the result may be a step behind

    SceneView* scene = nullptr;
    MapView* map = nullptr;
    ChartView* meridian = nullptr;
    ChartView* histogram = nullptr;
    ZoneTable* zones = nullptr;
    StatisticsTable* numbers = nullptr;
    QTabWidget* tabs = nullptr;
    QSplitter* rows = nullptr;
    QSplitter* upper = nullptr;
    QSplitter* lower = nullptr;

    std::array<QToolButton*, viewCount> views{};
    QButtonGroup* viewGroup = nullptr;
    QToolButton* overlay = nullptr;
    QToolButton* deviation = nullptr;
    QCheckBox* smooth = nullptr;
    QLabel* factorLabel = nullptr;
    QDoubleSpinBox* factor = nullptr;
    QLabel* synthetic = nullptr;

    const registration::CompareResult& result() const { return *picture->result; }
    bool hasAxis() const { return picture && result().unrolled && result().meridian && result().axis_T_reference; }
    std::optional<double> tolerance() const { return picture ? result().parameters.tolerance_mm : std::nullopt; }
};

}  // namespace lathelier
