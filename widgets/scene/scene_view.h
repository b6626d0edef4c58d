// The 3-D view of clouds and meshes: decimated during motion, complete at rest; colours by deviation; standard views,
// section, picking, images. Without OpenGL it shows a message.
#pragma once

#include <QImage>
#include <QWidget>
#include <memory>
#include <optional>
#include <vector>

#include "engine/report/chart.h"
#include "widgets/scene/scene_data.h"

namespace lathelier::plot {
struct ScaleCounts;
}

namespace lathelier::scene {

class SceneView : public QWidget {
    Q_OBJECT

public:
    explicit SceneView(QWidget* parent = nullptr);
    ~SceneView() override;

    /// False where there is no OpenGL (an offscreen platform, a missing driver).
    bool canDraw() const;

    /// Shows these objects in place of the earlier ones; the view point stays unless the geometry is another
    /// in size or place.
    void setObjects(std::vector<SceneObject> objects);
    const std::vector<SceneObject>& objects() const;
    void setLongAxis(const std::optional<SceneAxis>& axis);

    /// Thin lines in the scene with depth test: the nominal shape of a part drawn with magnified error.
    void setOutline(const std::vector<std::vector<Eigen::Vector3d>>& lines_mm);

    /// Recolours immediately. The legend is shown while an object has values.
    void setColours(const report::DeviationColours& colours);
    void setCounts(plot::ScaleCounts counts);  ///< beside the scale
    void setScale(const report::Axis& axis);   ///< title and unit of the colour scale

    void setViewpoint(SceneViewpoint viewpoint);
    void setParallel(bool parallel);
    bool isParallel() const;

    /// Camera as numbers that can be kept: rows of rotation and shift into view coordinates, distance and half height
    /// in mm, 1 for parallel projection. Empty where nothing is drawn.
    std::vector<double> view() const;

    /// Sets the camera for the present or the next objects. Invalid numbers are ignored.
    void setView(const std::vector<double>& view);

    /// Removes the part before `share` (0…1) of the extent along the scene axis 0, 1 or 2 (x, y, z).
    void setSection(int sceneAxis, double share);
    void clearSection();

    /// Values at places, in a large picture.
    void setFlags(std::vector<SceneFlag> flags);

    /// Marks a place, in scene coordinates, with its label.
    void setMarker(const std::optional<Eigen::Vector3d>& place_mm, const QString& label = {});
    std::optional<Eigen::Vector3d> marker() const;

    /// The picture as shown, on white; with `viewpoint` as seen from there. Null where nothing can be drawn. `marks`:
    /// with the place that was marked.
    QImage picture(std::optional<SceneViewpoint> viewpoint = {}, bool legend = true, bool marks = true);

    /// The same for paper, without the marked place: of one size and resolution whatever the window's, also while the
    /// view is hidden.
    QImage paperPicture(std::optional<SceneViewpoint> viewpoint = {});

    /// Writes picture() as PNG atomically. Error fileNotWritable.
    void savePicture(const QString& path);

    /// Seconds of the last frames drawn while moving and at rest, and the points drawn while moving.
    struct Speed {
        double moving_s = 0;            ///< frame time while moving
        double resting_s = 0;           ///< frame time at rest
        std::size_t moving_points = 0;  ///< of the thinned clouds; 0: nothing is thinned
    };
    Speed speed() const;

    /// Turns the camera as a drag by the mouse would, thinned while it moves.
    void turn(double right_deg, double up_deg);

    /// The place of a scene point in this widget, if it is before the eye.
    std::optional<QPointF> pixelAt(const Eigen::Vector3d& place_mm) const;

    QSize sizeHint() const override { return {560, 380}; }
    QSize minimumSizeHint() const override { return {200, 150}; }

    /// Tag beside the pointer, set in response to pointHovered() or surfaceHovered().
    void setTag(const QString& value, const QString& place);

signals:
    void pointHovered(int object, qint64 point);  ///< the pointer rests on a cloud, without a button
    void surfaceHovered(int object, const lathelier::scene::PickedPlace& place);  ///< the pointer rests on a mesh,
                                                                                  ///< without a button
    void pointPicked(int object, qint64 point);  ///< of a cloud: index into objects() and its scan
    void surfacePicked(int object, const lathelier::scene::PickedPlace& place);  ///< of a mesh
    void limitEdited(double upper, double lower);  ///< the user wants another colour scale; see LimitEdit::edited()
    void notWritten(const QString& path);          ///< the file could not be written

protected:
    bool event(QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void changeEvent(QEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    struct Parts;
    void showAround();
    void placeOverlays();
    void applyStyle(bool paper);
    void applySection();
    void render();
    void startMoving();
    void endMoving();
    void frameDone(double taken_s);
    void drag(const QPoint& to, Qt::MouseButtons buttons, Qt::KeyboardModifiers keys);
    void zoom(double factor);
    void shareBudget();
    void shareDetail();
    void pick(const QPoint& place);
    void hover(const QPoint& place);
    struct Under;
    Under under(const QPoint& place) const;
    void showMenu(const QPoint& place);

    std::unique_ptr<Parts> parts_;
};

}  // namespace lathelier::scene
