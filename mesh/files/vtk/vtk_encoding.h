// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

namespace etendue {

/// Place and form of the numbers in a VTK XML file; they are binary and compressed in both.
enum class VtkEncoding {
  inline_base64,  ///< base64 text in the XML elements: well-formed XML, which every reader accepts
  appended_raw,   ///< raw bytes after the XML elements: a quarter shorter, but strict XML parsers refuse them
};

}  // namespace etendue
