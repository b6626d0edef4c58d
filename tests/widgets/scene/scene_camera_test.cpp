#include "widgets/scene/scene_camera.h"

#include <QTest>
#include <cmath>
#include <set>

#include "widgets/scene/scene_pick.h"

using namespace lathelier;
using Eigen::Vector3d;

namespace {

const Vector3d low(-50, -10, -5), high(60, 12, 8);

std::vector<scene::SceneViewpoint> everyViewpoint()
{
    return {scene::SceneViewpoint::Oblique, scene::SceneViewpoint::Side, scene::SceneViewpoint::Top,
            scene::SceneViewpoint::End};
}

}  // namespace

class SceneCameraTest : public QObject {
    Q_OBJECT

private slots:
    void viewpointsHoldTheWholeBoxAndFillThePicture()
    {
        for (const Vector3d& along : {Vector3d(1, 0, 0), Vector3d(0.1, 0.2, 1), Vector3d(0, -1, 0.02)})
            for (const scene::SceneViewpoint viewpoint : everyViewpoint())
                for (const bool parallel : {false, true})
                    for (const double aspect : {0.6, 1.0, 2.5}) {
                        const Eigen::Matrix3d frame = scene::levelFrame(along);
                        const scene::SceneCamera camera =
                            scene::cameraFor(viewpoint, frame, low, high, aspect, parallel);
                        double largest = 0;
                        for (int i = 0; i < 8; ++i) {
                            const Vector3d corner(i & 1 ? high.x() : low.x(), i & 2 ? high.y() : low.y(),
                                                  i & 4 ? high.z() : low.z());
                            const auto place = camera.project(frame * corner);
                            QVERIFY(place.has_value());
                            largest = std::max(largest, place->cwiseAbs().maxCoeff());
                        }
                        QVERIFY2(largest <= 1 && largest > 0.8, qPrintable(QString::number(largest)));
                    }
    }

    void framesAreRightHandedAndLevel()
    {
        for (const Vector3d& along : {Vector3d(1, 0, 0), Vector3d(0, 0, 1), Vector3d(0.3, 0.8, -0.2)}) {
            const Eigen::Matrix3d frame = scene::levelFrame(along);
            QVERIFY((frame.transpose() * frame - Eigen::Matrix3d::Identity()).norm() < 1e-12);
            QVERIFY(std::abs(frame.determinant() - 1) < 1e-12);
            QVERIFY((frame.col(0) - along.normalized()).norm() < 1e-12);
        }
    }

    void sideViewShowsTheAxisLevelToTheRight()
    {
        const Eigen::Matrix3d frame = scene::levelFrame(Vector3d(0, 0, 1));
        const scene::SceneCamera camera = scene::cameraFor(scene::SceneViewpoint::Side, frame, low, high, 1.5, true);
        const Vector3d middle = frame * ((low + high) / 2);
        const auto a = camera.project(middle), b = camera.project(middle + Vector3d(0, 0, 20));
        QVERIFY(b->x() > a->x() && std::abs(b->y() - a->y()) < 1e-12);
    }

    void picksTheFrontPointNotTheHiddenOne()
    {
        // Two plates facing the eye, the rear one offset so that its points are nearer to the pointer.
        std::vector<Vector3d> points;
        for (int i = -20; i <= 20; ++i)
            for (int j = -20; j <= 20; ++j) {
                points.push_back(Vector3d(i, j, 5));
                points.push_back(Vector3d(i + 0.3, j, -5));
            }
        const scene::SceneCamera camera = scene::cameraFor(scene::SceneViewpoint::Side, Eigen::Matrix3d::Identity(),
                                                           Vector3d(-20, -20, -5), Vector3d(20, 20, 5), 1, true);
        const Eigen::Vector2d pointer = *camera.project(Vector3d(3.3, 4, -5));
        const auto pick = scene::nearestVisible(points, Eigen::Isometry3d::Identity(), camera, {}, pointer, 12, 500);
        QVERIFY(pick.has_value());
        QCOMPARE(points[pick->index], Vector3d(3, 4, 5));
        // With the front plate cut away, the rear one is what is seen.
        const scene::SceneSection section{-Vector3d::UnitZ(), 0};
        const auto rear =
            scene::nearestVisible(points, Eigen::Isometry3d::Identity(), camera, section, pointer, 12, 500);
        QCOMPARE(points[rear->index], Vector3d(3.3, 4, -5));
        QVERIFY(!scene::nearestVisible(points, Eigen::Isometry3d::Identity(), camera, {}, Eigen::Vector2d(0.99, 0.99),
                                       3, 500));
    }

    void picksThroughThePoseAndPerspective()
    {
        Eigen::Isometry3d pose(Eigen::AngleAxisd(0.7, Vector3d(1, 2, 3).normalized()));
        pose.translation() = Vector3d(5, -7, 11);
        std::vector<Vector3d> points;
        for (int i = 0; i < 400; ++i) points.push_back(pose.inverse() * Vector3d(i % 20 - 10.0, i / 20 - 10.0, 0));
        const scene::SceneCamera camera = scene::cameraFor(scene::SceneViewpoint::Oblique, Eigen::Matrix3d::Identity(),
                                                           Vector3d(-10, -10, -1), Vector3d(10, 10, 1), 1.6, false);
        for (const std::size_t i : {0UL, 57UL, 399UL}) {
            const auto place = camera.project(pose * points[i]);
            const auto pick = scene::nearestVisible(points, pose, camera, {}, *place, 5, 800);
            QVERIFY(pick && pick->index == i && pick->away_px < 1e-6);
        }
    }

    void picksOnTheSurfaceOfAMesh()
    {
        // A plate of two triangles, far larger than the pointer's reach, and one behind it.
        Scan mesh;
        for (const double z : {4.0, -4.0})
            for (const auto& [x, y] : {std::pair{-20.0, -20.0}, {20.0, -20.0}, {20.0, 20.0}, {-20.0, 20.0}})
                mesh.points_mm.push_back({x, y, z});
        for (const std::uint32_t i : {0U, 4U}) {
            mesh.triangles.push_back({i, i + 1, i + 2});
            mesh.triangles.push_back({i, i + 2, i + 3});
        }
        Eigen::Isometry3d pose(Eigen::AngleAxisd(0.4, Vector3d(1, 2, 3).normalized()));
        pose.translation() = Vector3d(5, -7, 11);
        const auto placeOf = [&](const scene::SceneHit& hit) {
            Vector3d place = Vector3d::Zero();
            for (int i = 0; i < 3; ++i)
                place += hit.place.weights[i] * mesh.points_mm[hit.place.corners[static_cast<std::size_t>(i)]];
            return Vector3d(pose * place);
        };
        for (const bool parallel : {false, true}) {
            const scene::SceneCamera camera =
                scene::cameraFor(scene::SceneViewpoint::Oblique, Eigen::Matrix3d::Identity(), Vector3d(-25, -25, -5),
                                 Vector3d(25, 25, 25), 1.6, parallel);
            const Vector3d wanted = pose * Vector3d(3.7, -5.1, 4);
            const auto hit = scene::firstHit(mesh, pose, camera, {}, *camera.project(wanted));
            QVERIFY(hit.has_value());
            QVERIFY2((placeOf(*hit) - wanted).norm() < 1e-9,
                     qPrintable(QString::number((placeOf(*hit) - wanted).norm())));
            QVERIFY(std::abs(hit->place.weights.sum() - 1) < 1e-12);
            // With the front plate cut away the ray goes on to the rear one.
            const Vector3d up = pose.linear().col(2);
            const auto rear =
                scene::firstHit(mesh, pose, camera, scene::SceneSection{-up, -up.dot(pose * Vector3d::Zero())},
                                *camera.project(wanted));
            QVERIFY(rear && std::abs((pose.inverse() * placeOf(*rear)).z() + 4) < 1e-9);
            QVERIFY(!scene::firstHit(mesh, pose, camera, {}, Eigen::Vector2d(-0.99, 0.99)));
        }
    }

    void thinnedPrefixesCoverTheWholeWithoutRepeats()
    {
        const auto order = scene::thinnedOrder(100'000, 20'000);
        QCOMPARE(order.size(), std::size_t{20'000});
        QCOMPARE(std::set<std::uint32_t>(order.begin(), order.end()).size(), order.size());
        std::array<int, 10> shares{};
        for (std::size_t i = 0; i < 5000; ++i) ++shares[order[i] / 10'000];
        for (const int share : shares) QVERIFY(std::abs(share - 500) < 110);  // 5 standard deviations
        QCOMPARE(scene::thinnedOrder(7, 20).size(), std::size_t{7});
        QVERIFY(scene::thinnedOrder(0, 20).empty());
        QVERIFY(scene::thinnedOrder(1000, 100) == scene::thinnedOrder(1000, 100));
    }
};

QTEST_MAIN(SceneCameraTest)
#include "scene_camera_test.moc"
