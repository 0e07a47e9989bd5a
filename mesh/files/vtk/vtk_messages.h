// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <string>

#include <vtkSmartPointer.h>

class vtkOutputWindow;

namespace etendue {

/// While it lives, what VTK has to complain about is kept and not printed.
class VtkMessages {
 public:
  VtkMessages();
  ~VtkMessages();
  VtkMessages(const VtkMessages&) = delete;
  VtkMessages& operator=(const VtkMessages&) = delete;

  bool any() const;
  /// The first complaint on one line, without the place in VTK's own source.
  std::string first() const;

 private:
  vtkSmartPointer<vtkOutputWindow> before_;
  vtkSmartPointer<vtkOutputWindow> kept_;
  int verbosity_before_;
};

}  // namespace etendue
