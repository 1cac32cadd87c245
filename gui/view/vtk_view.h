// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <QImage>
#include <QOpenGLWidget>
#include <QSize>
#include <memory>

class vtkRenderWindow;
class vtkRenderWindowInteractor;

namespace angiomesh {

/// A widget that VTK draws into: the bridge between Qt's OpenGL widget and a VTK render window with
/// an interactor fed from Qt's events. Frames are drawn when Qt paints; requestRender() asks for
/// one, and any number of requests before it make one frame.
class VtkView : public QOpenGLWidget {
  Q_OBJECT

 public:
  explicit VtkView(QWidget* parent = nullptr);
  ~VtkView() override;

  [[nodiscard]] vtkRenderWindow* renderWindow() const;
  [[nodiscard]] vtkRenderWindowInteractor* interactor() const;
  void requestRender();
  /// What the view shows, drawn anew on `scale` times its device pixels.
  /// @param size Qt's pixels in place of the view's own   @throws IoError
  [[nodiscard]] QImage picture(int scale, const QSize& size = {});

 Q_SIGNALS:
  void rendered();  ///< after each frame
  void renderRequested();
  void maximiseRequested();

 protected:
  void initializeGL() override;
  void resizeGL(int width, int height) override;
  void paintGL() override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void keyReleaseEvent(QKeyEvent* event) override;
  void enterEvent(QEnterEvent* event) override;
  void leaveEvent(QEvent* event) override;

  /// Called before the first frame, and whenever the ratio of device pixels to Qt's pixels changes.
  virtual void pixelRatioChanged(double ratio);
  /// The next frame is for picture().
  virtual void pictureBegins() {}
  /// Frees VTK's OpenGL resources. Subclasses that own scenes call it first in their destructor.
  void releaseGl();
  /// Whole notches of the wheel since the last call, away from the user positive.
  int wheelSteps(const QWheelEvent* event);
  /// VTK's pixels of the window of a position in Qt's pixels, and back.
  [[nodiscard]] Eigen::Vector2d toDisplay(const QPointF& position) const;
  [[nodiscard]] QPointF fromDisplay(const Eigen::Vector2d& display) const;

 private:
  void syncSize();
  void setEventPosition(const QPointF& position, Qt::KeyboardModifiers modifiers, int repeat);
  void forwardKey(const QKeyEvent* event, bool press);

  struct Bridge;
  std::unique_ptr<Bridge> bridge_;
};

}  // namespace angiomesh
