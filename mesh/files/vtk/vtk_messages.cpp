// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/files/vtk/vtk_messages.h"

#include <algorithm>
#include <cctype>

#include <vtkLogger.h>
#include <vtkOutputWindow.h>

namespace etendue {
namespace {

class KeepingWindow : public vtkOutputWindow {
 public:
  static KeepingWindow* New() {
    auto* window = new KeepingWindow;
    window->InitializeObjectBase();
    return window;
  }
  void DisplayText(const char* text) override { text_ += text; }
  const std::string& text() const { return text_; }

 private:
  std::string text_;
};

/// `ERROR: In file.cxx, line 7\nvtkClass (0x1234): What is wrong\n\n`
std::string without_place(const std::string& text) {
  const auto place = text.find("): ");
  const auto start = place == std::string::npos ? 0 : place + 3;
  std::string message = text.substr(start, text.find("\n\n", start) - start);
  std::replace(message.begin(), message.end(), '\n', ' ');
  while (!message.empty() && std::isspace(static_cast<unsigned char>(message.back()))) message.pop_back();
  return message;
}

}  // namespace

VtkMessages::VtkMessages()
    : before_(vtkOutputWindow::GetInstance()),
      kept_(vtkSmartPointer<KeepingWindow>::New()),
      verbosity_before_(vtkLogger::GetCurrentVerbosityCutoff()) {
  vtkOutputWindow::SetInstance(kept_);
  vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);
}

VtkMessages::~VtkMessages() {
  vtkOutputWindow::SetInstance(before_);
  vtkLogger::SetStderrVerbosity(static_cast<vtkLogger::Verbosity>(verbosity_before_));
}

bool VtkMessages::any() const { return !static_cast<const KeepingWindow&>(*kept_).text().empty(); }

std::string VtkMessages::first() const {
  return without_place(static_cast<const KeepingWindow&>(*kept_).text());
}

}  // namespace etendue
