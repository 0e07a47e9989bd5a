// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/files/vtk/vtk_write.h"

#include <ostream>
#include <string>

#include <vtkErrorCode.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPolyData.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLPolyDataWriter.h>
#include <vtkXMLUnstructuredGridWriter.h>

#include "base/errors.h"
#include "mesh/files/vtk/file_stream.h"
#include "mesh/files/vtk/vtk_messages.h"
#include "mesh/files/vtk/vtk_threads.h"

namespace etendue {
namespace {

/// A writer of VTK that writes to a stream of ours in place of a file of its own.
template <class Writer>
class StreamWriter : public Writer {
 public:
  static StreamWriter* New() { VTK_STANDARD_NEW_BODY(StreamWriter); }
  int write_to(std::ostream& stream) {
    this->Stream = &stream;
    return this->Write();
  }

 protected:
  StreamWriter() = default;
  ~StreamWriter() override = default;
};

/// Returns the reason that VTK gives for a failure; empty: none.
template <class Writer>
std::string written(vtkDataSet& data, std::ostream& stream, VtkEncoding encoding,
                    VtkCompression compression) {
  const VtkMessages messages;
  vtkNew<StreamWriter<Writer>> writer;
  writer->SetInputDataObject(&data);
  writer->SetHeaderTypeToUInt64();
  if (encoding == VtkEncoding::inline_base64) {
    writer->SetDataModeToBinary();
  } else {
    writer->SetDataModeToAppended();
    writer->EncodeAppendedDataOff();
  }
  if (compression == VtkCompression::zlib)
    writer->SetCompressorTypeToZLib();
  else
    writer->SetCompressorTypeToLZ4();
  const bool whole = writer->write_to(stream) != 0;
  if (messages.any()) return messages.first();
  if (writer->GetErrorCode() != vtkErrorCode::NoError)
    return vtkErrorCode::GetStringFromErrorCode(writer->GetErrorCode());
  return whole ? "" : "VTK gives no reason";
}

}  // namespace

void write_vtk_file(vtkDataSet& data, const std::filesystem::path& path, const std::filesystem::path& shown,
                    VtkEncoding encoding, VtkCompression compression) {
  use_vtk_without_threads();
  FileBuffer file(path);
  std::ostream stream(&file);
  const std::string vtk_reason =
      vtkPolyData::SafeDownCast(&data) != nullptr
          ? written<vtkXMLPolyDataWriter>(data, stream, encoding, compression)
          : written<vtkXMLUnstructuredGridWriter>(data, stream, encoding, compression);
  const std::string file_reason = file.close();
  const std::string& reason = file_reason.empty() ? vtk_reason : file_reason;
  if (!reason.empty()) throw FileError(shown.string(), "cannot be written (" + reason + ")");
}

}  // namespace etendue
