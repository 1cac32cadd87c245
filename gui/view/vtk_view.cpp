// SPDX-License-Identifier: BSD-3-Clause
#include "gui/view/vtk_view.h"

#include <vtkCallbackCommand.h>
#include <vtkCommand.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkOpenGLState.h>
#include <vtkRenderWindowInteractor.h>

#include <QEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QOpenGLContext>
#include <QOpenGLFunctions>
#include <QScopeGuard>
#include <QTimer>
#include <QWheelEvent>
#include <cmath>
#include <map>

#include "core/base/error.h"
#include "render/stage/offscreen_window.h"

namespace angiomesh {

namespace {

/// An interactor without a native window: it gets its events, frames and timers from a widget.
class WidgetInteractor : public vtkRenderWindowInteractor {
 public:
  static WidgetInteractor* New();

  void setView(VtkView* view) { view_ = view; }

  void Initialize() override {
    Initialized = 1;
    Enable();
  }
  void Start() override {}
  void TerminateApp() override {}
  void Render() override {
    if (view_ != nullptr) view_->requestRender();
  }

 protected:
  int InternalCreateTimer(int timerId, int timerType, unsigned long duration) override {
    auto timer = std::make_unique<QTimer>();
    timer->setSingleShot(timerType == OneShotTimer);
    QObject::connect(timer.get(), &QTimer::timeout, [this, timerId] {
      int id = timerId;
      InvokeEvent(vtkCommand::TimerEvent, &id);
    });
    timer->start(static_cast<int>(duration));
    timers_[timerId] = std::move(timer);
    return timerId;
  }
  int InternalDestroyTimer(int platformTimerId) override {
    const auto found = timers_.find(platformTimerId);
    if (found == timers_.end()) return 0;
    // The timer may be the one that is firing right now.
    found->second->stop();
    found->second.release()->deleteLater();
    timers_.erase(found);
    return 1;
  }

 private:
  VtkView* view_ = nullptr;
  std::map<int, std::unique_ptr<QTimer>> timers_;
};

vtkStandardNewMacro(WidgetInteractor);

const char* keySymbol(int key) {
  static const std::map<int, const char*> symbols{
      {Qt::Key_Left, "Left"},        {Qt::Key_Right, "Right"},   {Qt::Key_Up, "Up"},
      {Qt::Key_Down, "Down"},        {Qt::Key_Escape, "Escape"}, {Qt::Key_Shift, "Shift_L"},
      {Qt::Key_Control, "Control_L"}};
  const auto found = symbols.find(key);
  return found == symbols.end() ? nullptr : found->second;
}

}  // namespace

struct VtkView::Bridge {
  vtkNew<vtkGenericOpenGLRenderWindow> window;
  vtkNew<WidgetInteractor> interactor;
  vtkNew<vtkCallbackCommand> contextEvents;
  QMetaObject::Connection contextDies;
  double pixelRatio = 0.0;
  int scale = 1;      ///< of picture()
  QSize pictureSize;  ///< empty: the widget's
  int wheelRemainder = 0;
};

VtkView::VtkView(QWidget* parent) : QOpenGLWidget(parent), bridge_(std::make_unique<Bridge>()) {
  setFocusPolicy(Qt::StrongFocus);
  setMouseTracking(true);
  setMinimumSize(80, 80);

  vtkGenericOpenGLRenderWindow* window = bridge_->window;
  window->SetReadyForRendering(false);
  window->SetOwnContext(0);
  window->SetFrameBlitModeToBlitToCurrent();
  window->SetMultiSamples(0);

  bridge_->contextEvents->SetClientData(this);
  bridge_->contextEvents->SetCallback(
      [](vtkObject*, unsigned long event, void* self, void* answer) {
        auto* view = static_cast<VtkView*>(self);
        const bool current =
            view->context() != nullptr && QOpenGLContext::currentContext() == view->context();
        // The widget's makeCurrent() also binds its framebuffer, behind VTK's back: never while
        // VTK is drawing.
        if (event == vtkCommand::WindowMakeCurrentEvent) {
          if (!current) view->makeCurrent();
        } else if (event == vtkCommand::WindowIsCurrentEvent) {
          *static_cast<bool*>(answer) = current;
        } else {
          *static_cast<int*>(answer) = 1;
        }
      });
  for (const unsigned long event :
       {vtkCommand::WindowMakeCurrentEvent, vtkCommand::WindowIsCurrentEvent,
        vtkCommand::WindowSupportsOpenGLEvent, vtkCommand::WindowIsDirectEvent})
    window->AddObserver(event, bridge_->contextEvents);

  bridge_->interactor->setView(this);
  bridge_->interactor->SetRenderWindow(window);
  bridge_->interactor->SetInteractorStyle(nullptr);
  bridge_->interactor->Initialize();
}

VtkView::~VtkView() {
  releaseGl();
  bridge_->interactor->setView(nullptr);
  bridge_->interactor->SetRenderWindow(nullptr);
  bridge_->window->RemoveObserver(bridge_->contextEvents);
}

vtkRenderWindow* VtkView::renderWindow() const { return bridge_->window; }
vtkRenderWindowInteractor* VtkView::interactor() const { return bridge_->interactor; }

void VtkView::requestRender() {
  update();
  Q_EMIT renderRequested();
}

void VtkView::pixelRatioChanged(double) {}

void VtkView::releaseGl() {
  // Left connected, the context's end would call back into a half-destroyed widget.
  disconnect(bridge_->contextDies);
  if (context() == nullptr || !bridge_->window->GetReadyForRendering()) return;
  makeCurrent();
  bridge_->window->Finalize();
  bridge_->window->SetReadyForRendering(false);
  doneCurrent();
}

void VtkView::initializeGL() {
  disconnect(bridge_->contextDies);
  // Moving the widget to another window ends its context; this function then runs again.
  bridge_->contextDies =
      connect(context(), &QOpenGLContext::aboutToBeDestroyed, this, [this] { releaseGl(); });
  bridge_->window->SetForceMaximumHardwareLineWidth(1);
  bridge_->window->SetReadyForRendering(true);
  bridge_->window->OpenGLInit();
}

void VtkView::syncSize() {
  const double ratio = devicePixelRatioF() * bridge_->scale;
  const QSize size = bridge_->pictureSize.isEmpty() ? this->size() : bridge_->pictureSize;
  const int w = std::max(1, static_cast<int>(std::lround(size.width() * ratio)));
  const int h = std::max(1, static_cast<int>(std::lround(size.height() * ratio)));
  const int* current = bridge_->window->GetSize();
  if (current[0] != w || current[1] != h) {
    bridge_->window->SetSize(w, h);
    bridge_->interactor->UpdateSize(w, h);
  }
  if (ratio != bridge_->pixelRatio) {
    bridge_->pixelRatio = ratio;
    bridge_->window->SetDPI(static_cast<int>(std::lround(72.0 * ratio)));
    pixelRatioChanged(ratio);
  }
}

void VtkView::resizeGL(int, int) { syncSize(); }

void VtkView::paintGL() {
  syncSize();
  QOpenGLFunctions* gl = context()->functions();
  vtkOpenGLState* state = bridge_->window->GetState();
  state->Reset();
  state->vtkglDepthFunc(GL_LEQUAL);  // VTK's assumption; Qt leaves GL_LESS
  gl->glBindFramebuffer(GL_FRAMEBUFFER, defaultFramebufferObject());
  bridge_->window->Render();
  gl->glBindFramebuffer(GL_FRAMEBUFFER, defaultFramebufferObject());
  // VTK leaves alpha 0 behind, which shows as holes wherever the widget is composed or grabbed.
  gl->glDisable(GL_SCISSOR_TEST);
  gl->glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_TRUE);
  gl->glClearColor(0.0F, 0.0F, 0.0F, 1.0F);
  gl->glClear(GL_COLOR_BUFFER_BIT);
  gl->glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  Q_EMIT rendered();
}

QImage VtkView::picture(int scale, const QSize& size) {
  if (context() == nullptr || !bridge_->window->GetReadyForRendering())
    throw IoError("this pane was never drawn", "OpenGL", "show it first");
  makeCurrent();
  const auto restore = qScopeGuard([this] {
    bridge_->window->SetFrameBlitModeToBlitToCurrent();
    bridge_->scale = 1;
    bridge_->pictureSize = {};
    syncSize();
    doneCurrent();
  });
  // The widget's own framebuffer has another size.
  bridge_->window->SetFrameBlitModeToNoBlit();
  bridge_->scale = scale;
  bridge_->pictureSize = size;
  pictureBegins();
  syncSize();
  vtkOpenGLState* state = bridge_->window->GetState();
  state->Reset();
  state->vtkglDepthFunc(GL_LEQUAL);
  const Picture drawn = takePicture(bridge_->window);
  return QImage(drawn.rgb.data(), drawn.width, drawn.height, 3 * drawn.width, QImage::Format_RGB888)
      .copy();
}

void VtkView::setEventPosition(const QPointF& position, Qt::KeyboardModifiers modifiers,
                               int repeat) {
  const double ratio = devicePixelRatioF();
  bridge_->interactor->SetEventInformationFlipY(static_cast<int>(std::lround(position.x() * ratio)),
                                                static_cast<int>(std::lround(position.y() * ratio)),
                                                modifiers.testFlag(Qt::ControlModifier),
                                                modifiers.testFlag(Qt::ShiftModifier), 0, repeat);
  bridge_->interactor->SetAltKey(modifiers.testFlag(Qt::AltModifier));
}

void VtkView::mousePressEvent(QMouseEvent* event) {
  setEventPosition(event->position(), event->modifiers(),
                   event->type() == QEvent::MouseButtonDblClick ? 1 : 0);
  if (event->button() == Qt::LeftButton)
    bridge_->interactor->InvokeEvent(vtkCommand::LeftButtonPressEvent);
  else if (event->button() == Qt::MiddleButton)
    bridge_->interactor->InvokeEvent(vtkCommand::MiddleButtonPressEvent);
  else if (event->button() == Qt::RightButton)
    bridge_->interactor->InvokeEvent(vtkCommand::RightButtonPressEvent);
}

void VtkView::mouseMoveEvent(QMouseEvent* event) {
  setEventPosition(event->position(), event->modifiers(), 0);
  bridge_->interactor->InvokeEvent(vtkCommand::MouseMoveEvent);
}

void VtkView::mouseReleaseEvent(QMouseEvent* event) {
  setEventPosition(event->position(), event->modifiers(), 0);
  if (event->button() == Qt::LeftButton)
    bridge_->interactor->InvokeEvent(vtkCommand::LeftButtonReleaseEvent);
  else if (event->button() == Qt::MiddleButton)
    bridge_->interactor->InvokeEvent(vtkCommand::MiddleButtonReleaseEvent);
  else if (event->button() == Qt::RightButton)
    bridge_->interactor->InvokeEvent(vtkCommand::RightButtonReleaseEvent);
}

void VtkView::mouseDoubleClickEvent(QMouseEvent* event) {
  if (event->button() == Qt::LeftButton)
    Q_EMIT maximiseRequested();
  else
    mousePressEvent(event);
}

Eigen::Vector2d VtkView::toDisplay(const QPointF& position) const {
  // Mouse positions name a pixel; its centre is half a pixel further.
  const double ratio = devicePixelRatioF();
  return {(position.x() + 0.5) * ratio, (height() - position.y() - 0.5) * ratio};
}

QPointF VtkView::fromDisplay(const Eigen::Vector2d& display) const {
  const Eigen::Vector2d at = display / devicePixelRatioF();
  return {at[0] - 0.5, height() - at[1] - 0.5};
}

int VtkView::wheelSteps(const QWheelEvent* event) {
  // With Alt held the platforms turn the wheel sideways.
  const QPoint delta = event->angleDelta();
  bridge_->wheelRemainder += delta.y() != 0 ? delta.y() : delta.x();
  const int steps = bridge_->wheelRemainder / 120;
  bridge_->wheelRemainder -= 120 * steps;
  return steps;
}

void VtkView::wheelEvent(QWheelEvent* event) {
  setEventPosition(event->position(), event->modifiers(), 0);
  const int steps = wheelSteps(event);
  for (int k = 0; k < std::abs(steps); ++k)
    bridge_->interactor->InvokeEvent(steps > 0 ? vtkCommand::MouseWheelForwardEvent
                                               : vtkCommand::MouseWheelBackwardEvent);
  event->accept();
}

void VtkView::forwardKey(const QKeyEvent* event, bool press) {
  const QByteArray text = event->text().toLatin1();
  const char character = text.isEmpty() ? '\0' : text[0];
  const char* symbol = keySymbol(event->key());
  bridge_->interactor->SetKeyEventInformation(event->modifiers().testFlag(Qt::ControlModifier),
                                              event->modifiers().testFlag(Qt::ShiftModifier),
                                              character, event->count(),
                                              symbol != nullptr ? symbol : text.constData());
  bridge_->interactor->InvokeEvent(press ? vtkCommand::KeyPressEvent : vtkCommand::KeyReleaseEvent);
  if (press && character != '\0') bridge_->interactor->InvokeEvent(vtkCommand::CharEvent);
}

// Keys that nobody here uses go on to the parents, so that the window's shortcuts work.
void VtkView::keyPressEvent(QKeyEvent* event) {
  forwardKey(event, true);
  event->ignore();
}

void VtkView::keyReleaseEvent(QKeyEvent* event) {
  forwardKey(event, false);
  event->ignore();
}

void VtkView::enterEvent(QEnterEvent* event) {
  bridge_->interactor->InvokeEvent(vtkCommand::EnterEvent);
  QOpenGLWidget::enterEvent(event);
}

void VtkView::leaveEvent(QEvent* event) {
  bridge_->interactor->InvokeEvent(vtkCommand::LeaveEvent);
  QOpenGLWidget::leaveEvent(event);
}

}  // namespace angiomesh
