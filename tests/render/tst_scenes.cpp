// SPDX-License-Identifier: BSD-3-Clause
#include <vtkCamera.h>
#include <vtkNew.h>
#include <vtkProp3D.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkUnsignedCharArray.h>
#include <QGuiApplication>
#include <QTest>

#include <Eigen/Geometry>
#include <cmath>
#include <cstdlib>

#include "core/base/error.h"
#include "render/picture/offscreen.h"
#include "render/slice/slice_scene.h"
#include "render/stage/stage.h"
#include "render/surface/surface_scene.h"
#include "render/surface/volume_prop.h"

using namespace angiomesh;

namespace {

/// The colours of a rendered window; (x, y) from the lower left.
class Frame {
 public:
  explicit Frame(vtkRenderWindow* window) {
    window->Render();
    const int* size = window->GetSize();
    width = size[0];
    height = size[1];
    window->GetRGBACharPixelData(0, 0, width - 1, height - 1, 0, pixels_);
  }
  [[nodiscard]] std::array<int, 3> at(int x, int y) const {
    const unsigned char* p = pixels_->GetPointer(4 * (static_cast<vtkIdType>(y) * width + x));
    return {p[0], p[1], p[2]};
  }
  /// Centre of the pixels for which `matches`, and how many there are.
  template <class Matches>
  Eigen::Vector3d centreWhere(Matches matches) const {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x)
        if (matches(at(x, y))) sum += Eigen::Vector3d(x + 0.5, y + 0.5, 1.0);
    if (sum[2] > 0.0) sum.head<2>() /= sum[2];
    return sum;
  }
  int width = 0, height = 0;

 private:
  vtkNew<vtkUnsignedCharArray> pixels_;
};

bool white(const std::array<int, 3>& c) { return c[0] > 250 && c[1] > 250 && c[2] > 250; }
bool red(const std::array<int, 3>& c) { return c[0] > 90 && c[0] > 2 * c[1] && c[0] > 2 * c[2]; }
bool green(const std::array<int, 3>& c) { return c[1] > 120 && c[1] > 2 * c[0]; }

std::shared_ptr<Volume<float>> emptyImage(const Eigen::Matrix3d& direction) {
  Geometry g;
  g.size = {40, 44, 36};
  g.spacing = {0.9, 1.0, 1.2};
  g.direction = direction;
  g.origin = -(direction * Eigen::Vector3d(17.0, 22.0, 20.0));
  return std::make_shared<Volume<float>>(g);
}

/// A bright block of 3x3x3 voxels.
void mark(Volume<float>& image, const Index3& voxel) {
  for (int k = -1; k <= 1; ++k)
    for (int j = -1; j <= 1; ++j)
      for (int i = -1; i <= 1; ++i) image.at(voxel[0] + i, voxel[1] + j, voxel[2] + k) = 1000.0F;
}

std::vector<Eigen::Matrix3d> directions() {
  Eigen::Matrix3d sagittal;
  sagittal << 0, 0, 1, 1, 0, 0, 0, -1, 0;
  const Eigen::Matrix3d mirrored = Eigen::Vector3d(-1, 1, -1).asDiagonal();
  const Eigen::Matrix3d leftHanded = Eigen::Vector3d(1, -1, 1).asDiagonal();
  const Eigen::Matrix3d turned =
      Eigen::AngleAxisd(0.4, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
  return {Eigen::Matrix3d::Identity(), sagittal, mirrored, leftHanded, turned * sagittal};
}

TriMesh ball(const Eigen::Vector3d& centre, double radius) {
  TriMesh mesh;
  constexpr int rows = 24;
  constexpr int columns = 48;
  for (int r = 0; r <= rows; ++r)
    for (int c = 0; c < columns; ++c) {
      const double theta = M_PI * r / rows;
      const double angle = 2.0 * M_PI * c / columns;
      mesh.points.emplace_back(centre + radius * Eigen::Vector3d(std::sin(theta) * std::cos(angle),
                                                                 std::sin(theta) * std::sin(angle),
                                                                 std::cos(theta)));
    }
  const auto id = [](int r, int c) {
    return static_cast<std::uint32_t>(r * columns + c % columns);
  };
  for (int r = 0; r < rows; ++r)
    for (int c = 0; c < columns; ++c) {
      mesh.triangles.push_back({id(r, c), id(r + 1, c), id(r + 1, c + 1)});
      mesh.triangles.push_back({id(r, c), id(r + 1, c + 1), id(r, c + 1)});
    }
  return mesh;
}

struct SlicePane {
  SliceScene scene;
  vtkNew<vtkRenderWindow> window;

  SlicePane(int width, int height) {
    window->SetOffScreenRendering(1);
    window->SetMultiSamples(0);
    window->SetSize(width, height);
    window->AddRenderer(scene.renderer());
    scene.setCrosshairVisible(false);
    scene.setWindowLevel(1000.0, 500.0);
  }
};

struct SurfacePane {
  SurfaceScene scene;
  vtkNew<vtkRenderWindow> window;

  SurfacePane(int width, int height) {
    window->SetOffScreenRendering(1);
    window->SetMultiSamples(0);
    window->SetSize(width, height);
    scene.attach(window);
  }
};

}  // namespace

class TestScenes : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void markersShowWhereThePatientHasThem() {
    for (const Eigen::Matrix3d& direction : directions()) {
      const auto image = emptyImage(direction);
      const Index3 voxel{29, 12, 24};
      mark(*image, voxel);
      const Eigen::Vector3d lps =
          image->geometry.toPhysical(Eigen::Vector3d(voxel[0], voxel[1], voxel[2]));
      const Eigen::Vector3d middle = image->geometry.toPhysical({19.5, 21.5, 17.5});
      for (int plane = 0; plane < 3; ++plane) {
        SlicePane pane(300, 240);
        pane.scene.setPlane(plane);
        pane.scene.setImage(image);
        pane.scene.setSlice(pane.scene.sliceAt(lps));
        const Frame frame(pane.window);
        const Eigen::Vector3d found = frame.centreWhere(white);
        QVERIFY(found[2] > 30.0);
        const Eigen::Vector2d expected = pane.scene.displayAt(lps);
        QVERIFY((found.head<2>() - expected).norm() < 2.0);
        QVERIFY((pane.scene.lpsAt(found[0], found[1]) - lps).norm() < 0.5);
        // Said once more without the scene's own arithmetic: L or P to the right, S or A up.
        const Eigen::Vector3d off = lps - middle;
        const double right = plane == 0 ? off[1] : off[0];
        const double up = plane == 2 ? -off[1] : off[2];
        if (std::abs(right) > 5.0) QCOMPARE(found[0] > 150.0, right > 0.0);
        if (std::abs(up) > 5.0) QCOMPARE(found[1] > 120.0, up > 0.0);
      }
    }
  }

  void slabShowsAMarkerOfAnotherSlice() {
    const auto image = emptyImage(Eigen::Matrix3d::Identity());
    mark(*image, {20, 20, 25});
    SlicePane pane(300, 240);
    pane.scene.setImage(image);
    pane.scene.setSlice(18);
    QCOMPARE(Frame(pane.window).centreWhere(white)[2], 0.0);
    pane.scene.setSlab({SlabMode::Mip, 20.0});
    const Frame frame(pane.window);
    QVERIFY(frame.centreWhere(white)[2] > 30.0);
    const Eigen::Vector3d lps = image->geometry.toPhysical({20, 20, 18});
    const auto probe = pane.scene.probe(lps);
    QVERIFY(probe.has_value());
    QCOMPARE(probe->value, 1000.0F);
    QVERIFY(probe->voxel[2] >= 24 && probe->voxel[2] <= 26);
    pane.scene.setSlice(17);
    QVERIFY(Frame(pane.window).centreWhere(white)[2] > 30.0);
  }

  void contourAndSeedsLieWhereTheyBelong() {
    const auto image = emptyImage(directions().back());
    const Eigen::Vector3d centre = image->geometry.toPhysical({20, 21, 18});
    auto phi = std::make_shared<Volume<float>>(image->geometry);
    for (std::size_t p = 0; p < phi->voxels.size(); ++p) {
      const Index3 v = phi->geometry.indexOf(p);
      phi->voxels[p] = static_cast<float>(
          (phi->geometry.toPhysical(Eigen::Vector3d(v[0], v[1], v[2])) - centre).norm() - 8.0);
    }
    for (int plane = 0; plane < 3; ++plane) {
      SlicePane pane(300, 300);
      pane.scene.setPlane(plane);
      pane.scene.setImage(image);
      pane.scene.setSlice(pane.scene.sliceAt(centre));
      pane.scene.setContours({{phi, {1.0, 0.0, 0.0}}});
      pane.scene.setSeeds({centre});
      const Frame frame(pane.window);
      int count = 0;
      for (int y = 0; y < frame.height; ++y)
        for (int x = 0; x < frame.width; ++x)
          if (red(frame.at(x, y))) {
            ++count;
            QVERIFY(std::abs((pane.scene.lpsAt(x + 0.5, y + 0.5) - centre).norm() - 8.0) < 0.4);
          }
      QVERIFY(count > 150);
      const Eigen::Vector3d seed = frame.centreWhere(green);
      QVERIFY(seed[2] > 10.0);
      QVERIFY((seed.head<2>() - pane.scene.displayAt(centre)).norm() < 1.5);
    }
  }

  void zoomKeepsTheSpotAndResizingKeepsTheFit() {
    const auto image = emptyImage(Eigen::Matrix3d::Identity());
    SlicePane pane(300, 240);
    pane.scene.setImage(image);
    const Eigen::Vector3d spot = pane.scene.lpsAt(200.0, 60.0);
    pane.scene.zoom(3.0, 200.0, 60.0);
    QVERIFY((pane.scene.lpsAt(200.0, 60.0) - spot).norm() < 1e-9);
    pane.scene.pan(10.0, 5.0);
    QVERIFY((pane.scene.lpsAt(210.0, 65.0) - spot).norm() < 1e-9);
    pane.scene.fit();
    const Eigen::Vector3d middle = image->geometry.toPhysical({19.5, 21.5, 0});
    QVERIFY((pane.scene.lpsAt(150.0, 120.0) - middle).head<2>().norm() < 1e-6);
    pane.window->SetSize(200, 400);
    QVERIFY((pane.scene.lpsAt(100.0, 200.0) - middle).head<2>().norm() < 1e-6);
    QVERIFY(!pane.scene.probe(pane.scene.lpsAt(100.0, 2.0)).has_value());
  }

  void anotherLayerOfTheSameGridKeepsTheView() {
    const auto image = emptyImage(Eigen::Matrix3d::Identity());
    SlicePane pane(300, 240);
    pane.scene.setImage(image);
    pane.scene.setSlice(5);
    pane.scene.zoom(2.0, 20.0, 20.0);
    const Eigen::Vector3d before = pane.scene.lpsAt(77.0, 33.0);
    pane.scene.setImage(std::make_shared<Volume<float>>(image->geometry, 3.0F));
    QCOMPARE(pane.scene.slice(), 5);
    QVERIFY((pane.scene.lpsAt(77.0, 33.0) - before).norm() < 1e-12);
    pane.scene.setImage(nullptr);
    QCOMPARE(pane.scene.sliceCount(), 0);
    QCOMPARE(Frame(pane.window).centreWhere(white)[2], 0.0);
  }

  void imagesAreLetGo() {
    auto image = emptyImage(Eigen::Matrix3d::Identity());
    const std::weak_ptr<Volume<float>> watched = image;
    SlicePane slices(100, 100);
    SurfacePane surface(100, 100);
    slices.scene.setImage(image);
    slices.scene.setContours({{image, {1.0, 0.0, 0.0}}});
    surface.scene.setImage(image);
    slices.window->Render();
    surface.window->Render();
    image.reset();
    QVERIFY(!watched.expired());
    slices.window->Render();
    surface.window->Render();
    const auto other = emptyImage(Eigen::Matrix3d::Identity());
    slices.scene.setImage(other);
    slices.scene.setContours({});
    surface.scene.setImage(other);
    surface.window->Render();  // the ray caster compares with its last image first
    QVERIFY(watched.expired());
  }

  void surfacesAppearWhereTheyAre() {
    for (const Eigen::Matrix3d& direction : {directions()[0], directions()[4]}) {
      const auto image = emptyImage(direction);
      SurfacePane pane(320, 300);
      pane.scene.setImage(image);
      pane.scene.setVolumeView(VolumeView::None);
      const Eigen::Vector3d centre = image->geometry.toPhysical({19.5, 21.5, 17.5});
      pane.scene.viewFrom('A');
      pane.scene.setSurface(
          std::make_shared<TriMesh>(ball(centre + Eigen::Vector3d(8, 0, 6), 5.0)));
      const Eigen::Vector3d a = Frame(pane.window).centreWhere(red);
      QVERIFY(a[2] > 200.0);
      QVERIFY(a[0] > 175.0 && a[1] > 160.0);  // left of the patient: right; head: up
      pane.scene.setSurface(
          std::make_shared<TriMesh>(ball(centre + Eigen::Vector3d(-8, 0, -6), 5.0)));
      const Eigen::Vector3d b = Frame(pane.window).centreWhere(red);
      QVERIFY(b[0] < 145.0 && b[1] < 140.0);
      QVERIFY(std::abs(b[2] / a[2] - 1.0) < 0.1);  // the camera has not moved
      pane.scene.setSurfaceVisible(false);
      QCOMPARE(Frame(pane.window).centreWhere(red)[2], 0.0);
    }
  }

  void firstViewShowsTheBroadSide() {
    const auto direction = [](SurfacePane& pane) {
      Eigen::Vector3d d;
      pane.scene.renderer()->GetActiveCamera()->GetDirectionOfProjection(d.data());
      return d;
    };
    SurfacePane upright(200, 200);
    upright.scene.setImage(emptyImage(Eigen::Matrix3d::Identity()));
    QVERIFY((direction(upright) - Eigen::Vector3d(0, 1, 0)).norm() < 1e-9);
    Geometry g;
    g.size = {30, 90, 10};
    SurfacePane flat(200, 200);
    flat.scene.setImage(std::make_shared<Volume<float>>(g));
    QVERIFY((direction(flat) - Eigen::Vector3d(0, 0, 1)).norm() < 1e-9);
    flat.scene.viewFrom('A');
    QVERIFY((direction(flat) - Eigen::Vector3d(0, 1, 0)).norm() < 1e-9);
    flat.scene.resetView();
    QVERIFY((direction(flat) - Eigen::Vector3d(0, 0, 1)).norm() < 1e-9);
  }

  void projectionLiesOverTheSurfaceOfTheSameThing() {
    for (const Eigen::Matrix3d& direction : directions()) {
      const auto image = emptyImage(direction);
      const Index3 voxel{29, 12, 24};
      mark(*image, voxel);
      const Eigen::Vector3d lps =
          image->geometry.toPhysical(Eigen::Vector3d(voxel[0], voxel[1], voxel[2]));
      SurfacePane pane(240, 240);
      for (const char side : {'A', 'L', 'S'}) {
        pane.scene.setSurface(nullptr);
        pane.scene.setVolumeView(VolumeView::Mip);
        pane.scene.setImage(image);
        pane.scene.setMipWindow(100.0, 600.0);
        pane.scene.viewFrom(side);
        const Eigen::Vector3d shown =
            Frame(pane.window).centreWhere([](const std::array<int, 3>& c) {
              return c[0] > 200 && c[1] > 200 && c[2] > 200;
            });
        pane.scene.setVolumeView(VolumeView::None);
        pane.scene.setSurface(std::make_shared<TriMesh>(ball(lps, 2.0)));
        const Eigen::Vector3d surface = Frame(pane.window).centreWhere(red);
        QVERIFY(shown[2] > 20.0);
        QVERIFY(surface[2] > 20.0);
        QVERIFY((shown - surface).head<2>().norm() < 3.0);
      }
    }
  }

  void aLitVolumeIsAmongTheSurfaces() {
    const auto image = emptyImage(Eigen::Matrix3d::Identity());
    const Index3 voxel{20, 22, 18};
    mark(*image, voxel);
    const Eigen::Vector3d lps =
        image->geometry.toPhysical(Eigen::Vector3d(voxel[0], voxel[1], voxel[2]));
    SurfacePane pane(240, 240);
    pane.scene.setImage(image);
    pane.scene.setVolumeView(VolumeView::CtAngio);
    pane.scene.viewFrom('A');
    const auto middle = [&] {
      const Eigen::Vector2d at = pane.scene.displayAt(lps);
      return Frame(pane.window).at(static_cast<int>(at[0]), static_cast<int>(at[1]));
    };
    const auto ivory = [](const std::array<int, 3>& c) { return c[1] > 120 && c[0] > c[2]; };
    QVERIFY(ivory(middle()));
    const Eigen::Vector3d nearer(0.0, -8.0, 0.0);
    pane.scene.setSurface(std::make_shared<TriMesh>(ball(lps + nearer, 4.0)));
    QVERIFY(red(middle()));
    pane.scene.setSurface(std::make_shared<TriMesh>(ball(lps - nearer, 4.0)));
    QVERIFY(ivory(middle()));
    // A projection has no depth: surfaces lie over it.
    pane.scene.setVolumeView(VolumeView::Mip);
    pane.scene.setMipWindow(100.0, 600.0);
    QVERIFY(red(middle()));
  }

  void bothRayCastersObeyThePatientsDirections() {
    for (const Eigen::Matrix3d& direction : {directions()[3], directions()[4]})
      for (const bool software : {true, false}) {
        const auto image = emptyImage(direction);
        const Index3 voxel{29, 12, 24};
        mark(*image, voxel);
        const Eigen::Vector3d lps =
            image->geometry.toPhysical(Eigen::Vector3d(voxel[0], voxel[1], voxel[2]));
        vtkNew<vtkRenderWindow> window;
        window->SetOffScreenRendering(1);
        window->SetSize(200, 200);
        vtkNew<vtkRenderer> renderer;
        window->AddRenderer(renderer);
        VolumeProp projection;
        projection.setSoftware(software);
        projection.setVolume(drawnVolume(image));
        projection.setLook(projectionLook(100.0, 600.0));
        projection.prop()->VisibilityOn();
        renderer->AddViewProp(projection.prop());
        vtkCamera* camera = renderer->GetActiveCamera();
        camera->SetPosition(0.6, -1.0, 0.4);
        camera->SetViewUp(0.0, 0.0, 1.0);
        QVERIFY(fitCamera(renderer));
        const Eigen::Vector3d shown =
            Frame(window).centreWhere([](const std::array<int, 3>& c) { return c[0] > 200; });
        QVERIFY(shown[2] > 20.0);
        renderer->SetWorldPoint(lps[0], lps[1], lps[2], 1.0);
        renderer->WorldToDisplay();
        const Eigen::Vector3d expected(renderer->GetDisplayPoint());
        QVERIFY((shown - expected).head<2>().norm() < 3.0);
      }
  }

  void trianglesAreColouredByTheirValue() {
    SurfacePane pane(300, 300);
    const auto mesh = std::make_shared<TriMesh>(ball({0, 0, 0}, 10.0));
    pane.scene.setSurface(mesh);
    std::vector<float> values(mesh->triangles.size());
    for (std::size_t t = 0; t < values.size(); ++t)
      values[t] = mesh->points[mesh->triangles[t][0]][2] > 0.0 ? 1.0F : 0.0F;
    pane.scene.setSurfaceColours(values, "Quality", 0.0, 1.0);
    const auto blue = [](const std::array<int, 3>& c) { return c[2] > 90 && c[2] > 2 * c[0]; };
    const Frame frame(pane.window);
    QVERIFY(blue(frame.at(150, 210)));
    QVERIFY(red(frame.at(150, 90)));
    pane.scene.clearSurfaceColours();
    QVERIFY(red(Frame(pane.window).at(150, 210)));
  }

  void surfacePictureIsLitAndShaped() {
    const TriMesh mesh = ball({40, -30, 100}, 12.0);
    const Picture picture = renderSurfacePicture(mesh, nullptr, 400, 200);
    QCOMPARE(picture.rgb.size(), static_cast<std::size_t>(400 * 200 * 3));
    std::array<int, 2> lit{};
    std::array<int, 2> brightest{};
    int darkest = 255;
    for (int y = 0; y < 200; ++y)
      for (int x = 0; x < 400; ++x) {
        const std::uint8_t* p = &picture.rgb[static_cast<std::size_t>(3 * (y * 400 + x))];
        if (!red({p[0], p[1], p[2]})) continue;
        const auto half = static_cast<std::size_t>(x / 200);
        ++lit[half];
        brightest[half] = std::max(brightest[half], static_cast<int>(p[0]));
        darkest = std::min(darkest, static_cast<int>(p[0]));
      }
    for (std::size_t half = 0; half < 2; ++half) {
      QVERIFY(lit[half] > 7000 && lit[half] < 31000);  // a ball in 200 x 200
      QVERIFY(brightest[half] > 200);
    }
    QVERIFY(darkest < 150);  // shaded, not flat
    QVERIFY_THROWS_EXCEPTION(InputError, renderSurfacePicture(TriMesh(), nullptr, 100, 100));
  }

  void pictureWithoutADisplaySaysSo() {
    const QByteArray display = qgetenv("DISPLAY");
    qputenv("DISPLAY", ":7913");
    QVERIFY_THROWS_EXCEPTION(IoError, renderSurfacePicture(ball({0, 0, 0}, 1.0), nullptr, 64, 64));
    qunsetenv("DISPLAY");
    QVERIFY_THROWS_EXCEPTION(IoError, renderSurfacePicture(ball({0, 0, 0}, 1.0), nullptr, 64, 64));
    qputenv("DISPLAY", display);
  }
};

// The application's own connection keeps a virtual X server from starting afresh between windows.
QTEST_MAIN(TestScenes)
#include "tst_scenes.moc"
