// Curves in the plane with equal scales, such as the path of an axis: closed curves, many thin ones, marked points.
#pragma once

#include "widgets/plot/plot_canvas.h"

namespace lathelier {

/// A path; x need not rise.
struct XyCurve {
    QString name;  ///< empty: not in the legend
    std::vector<double> x;
    std::vector<double> y;
    std::vector<double> along;  ///< what runs along the path (an angle), for the crosshair and the CSV; may be empty
    std::optional<QColor> colour;
    bool thin = false;  ///< one of many: faint, and not spoken
    bool closed = true;
};

struct XyData {
    QString title;
    QString remark;
    PlotAxis x;
    PlotAxis y;
    PlotAxis along;
    std::vector<XyCurve> curves;
};

/// Comma-separated: curve, along, x, y.
QString toCsv(const XyData& data);

class XyView : public PlotCanvas {
    Q_OBJECT

public:
    explicit XyView(QWidget* parent = nullptr);
    ~XyView() override;

    /// Shows `data`; the user's zoom stays when the title is the same as before.
    void setData(XyData data);
    const XyData& data() const;

    /// Marks the sample of every spoken curve that lies nearest to this place along it.
    void setMarker(std::optional<double> along);

    QString csv() const override;

protected:
    void applyStyle() override;
    QString readoutAt(double x, double y) const override;
    void fitRanges() override;

private:
    struct Content;
    void keepScalesEqual();

    std::unique_ptr<Content> content_;
};

}  // namespace lathelier
