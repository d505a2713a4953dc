#pragma once
// The window of VTK that a VtkWidget draws by.

#include <vtkCallbackCommand.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkNew.h>

#include <QOpenGLContext>

#include "shared/gui/vtk_widget.h"
#include "shared/render/vtk_scene.h"

namespace dobra::gui {

struct VtkWidget::Scene {
  explicit Scene(VtkWidget& owner) : widget(owner), scene(*window) {
    observe(vtkCommand::WindowMakeCurrentEvent, [](vtkObject*, unsigned long, void* self, void*) {
      // Only if it is not: QOpenGLWidget::makeCurrent binds the widget's framebuffer, behind VTK's back while it draws.
      VtkWidget& own = static_cast<Scene*>(self)->widget;
      if (QOpenGLContext::currentContext() != own.context()) own.makeCurrent();
    });
    observe(vtkCommand::WindowIsCurrentEvent, [](vtkObject*, unsigned long, void* self, void* answer) {
      const QOpenGLContext* own = static_cast<Scene*>(self)->widget.context();
      *static_cast<bool*>(answer) = own != nullptr && QOpenGLContext::currentContext() == own;
    });
    window->SetReadyForRendering(true);
    window->SetOwnContext(0);
    window->SetFrameBlitModeToBlitToCurrent();
    window->OpenGLInitContext();
  }
  ~Scene() {
    scene.release();
    window->Finalize();
  }
  Scene(const Scene&) = delete;
  Scene& operator=(const Scene&) = delete;

  void observe(unsigned long event, void (*answer)(vtkObject*, unsigned long, void*, void*)) {
    vtkNew<vtkCallbackCommand> command;
    command->SetCallback(answer);
    command->SetClientData(this);
    window->AddObserver(event, command);
  }

  VtkWidget& widget;
  vtkNew<vtkGenericOpenGLRenderWindow> window;
  render::VtkScene scene;
};

}  // namespace dobra::gui
