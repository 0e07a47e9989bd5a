// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/files/vtk/vtk_data_set.h"

#include <algorithm>
#include <cmath>
#include <new>
#include <string>
#include <vector>

#include <vtkCompositeDataIterator.h>
#include <vtkDoubleArray.h>
#include <vtkImageData.h>
#include <vtkInformation.h>
#include <vtkInformationDoubleVectorKey.h>
#include <vtkMatrix3x3.h>
#include <vtkMatrix4x4.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkNIFTIImageReader.h>
#include <vtkNew.h>
#include <vtkOpenFOAMReader.h>
#include <vtkPointData.h>
#include <vtkStreamingDemandDrivenPipeline.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLImageDataReader.h>
#include <vtkXMLUnstructuredGridReader.h>

#include "base/errors.h"
#include "mesh/files/vtk/refused_file.h"
#include "mesh/files/vtk/vtk_messages.h"

namespace etendue {
namespace {

/// Times are taken for the same to this part of them: OpenFOAM writes six digits.
constexpr double same_time = 1e-5;

template <class Reader>
void update(Reader& reader, const std::filesystem::path& path) {
  const VtkMessages messages;
  try {
    reader.Update();
  } catch (const std::bad_alloc&) {
    refuse_file(path, "VTK needs more memory than there is to read it (is it corrupt?)");
  }
  if (messages.any() || reader.GetErrorCode() != 0)
    refuse_file(path, "VTK cannot read it (" + messages.first() + "); is it cut short or corrupt?");
}

template <class Reader>
vtkSmartPointer<vtkDataSet> read_file(const std::filesystem::path& path) {
  const vtkNew<Reader> reader;
  reader->SetFileName(path.c_str());
  update(*reader, path);
  return reader->GetOutput();
}

/// Stored numbers become physical values: slope times number plus intercept, where the slope is not 0.
void rescale(vtkNIFTIImageReader& reader, vtkImageData& image) {
  const double slope = reader.GetRescaleSlope(), intercept = reader.GetRescaleIntercept();
  vtkDataArray* stored = image.GetPointData()->GetScalars();
  if (stored == nullptr || slope == 0 || (slope == 1 && intercept == 0)) return;
  const vtkNew<vtkDoubleArray> values;
  values->SetName(stored->GetName());
  values->SetNumberOfComponents(stored->GetNumberOfComponents());
  values->SetNumberOfTuples(stored->GetNumberOfTuples());
  for (vtkIdType tuple = 0; tuple < stored->GetNumberOfTuples(); ++tuple)
    for (int component = 0; component < stored->GetNumberOfComponents(); ++component)
      values->SetComponent(tuple, component, slope * stored->GetComponent(tuple, component) + intercept);
  image.GetPointData()->SetScalars(values);
}

/// The voxels' places are those of the scanner where the file has them.
vtkSmartPointer<vtkDataSet> read_nifti(const std::filesystem::path& path) {
  const vtkNew<vtkNIFTIImageReader> reader;
  reader->SetFileName(path.c_str());
  update(*reader, path);
  vtkSmartPointer<vtkImageData> image = reader->GetOutput();
  rescale(*reader, *image);
  vtkMatrix4x4* places =
      reader->GetSFormMatrix() != nullptr ? reader->GetSFormMatrix() : reader->GetQFormMatrix();
  if (places == nullptr) return image;
  // The matrix takes lengths along the rows, columns and slices, whose spacing the image has.
  vtkNew<vtkMatrix3x3> directions;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) directions->SetElement(i, j, places->GetElement(i, j));
  image->SetDirectionMatrix(directions);
  image->SetOrigin(places->GetElement(0, 3), places->GetElement(1, 3), places->GetElement(2, 3));
  return image;
}

std::string times_text(const std::vector<double>& times) {
  std::string text;
  for (const double time : times) text += (text.empty() ? "" : ", ") + std::to_string(time);
  return text;
}

double chosen_time(const std::filesystem::path& path, vtkOpenFOAMReader& reader,
                   std::optional<double> wanted) {
  vtkInformation* information = reader.GetOutputInformation(0);
  vtkInformationDoubleVectorKey* key = vtkStreamingDemandDrivenPipeline::TIME_STEPS();
  if (!information->Has(key)) refuse_file(path, "holds no times; is it the folder of an OpenFOAM case?");
  const double* first = information->Get(key);
  const std::vector<double> times(first, first + information->Length(key));
  if (!wanted) return times.back();
  for (const double time : times)
    if (std::abs(time - *wanted) <= same_time * std::max(std::abs(time), std::abs(*wanted))) return time;
  refuse_file(path, "holds no time " + std::to_string(*wanted) + "; there are " + times_text(times));
}

/// A folder is named to VTK by a file in it.
std::filesystem::path open_foam_file(const std::filesystem::path& path) {
  return std::filesystem::is_directory(path) ? path / "system" / "controlDict" : path;
}

vtkSmartPointer<vtkDataSet> read_open_foam(const std::filesystem::path& path, std::optional<double> time) {
  const vtkNew<vtkOpenFOAMReader> reader;
  const VtkMessages messages;
  reader->SetFileName(open_foam_file(path).c_str());
  reader->SetSkipZeroTime(false);
  reader->UpdateInformation();
  if (messages.any())
    refuse_file(path, "VTK cannot read it (" + messages.first() + "); is it an OpenFOAM case?");
  reader->DisableAllPatchArrays();
  reader->SetPatchArrayStatus("internalMesh", 1);
  reader->EnableAllCellArrays();
  reader->EnableAllPointArrays();
  reader->SetReadZones(false);
  reader->DecomposePolyhedraOff();
  reader->UpdateTimeStep(chosen_time(path, *reader, time));
  if (messages.any())
    refuse_file(path, "VTK cannot read it (" + messages.first() + "); is it cut short or corrupt?");
  const auto iterator = vtkSmartPointer<vtkCompositeDataIterator>::Take(reader->GetOutput()->NewIterator());
  for (iterator->InitTraversal(); !iterator->IsDoneWithTraversal(); iterator->GoToNextItem())
    if (auto* grid = vtkUnstructuredGrid::SafeDownCast(iterator->GetCurrentDataObject())) return grid;
  refuse_file(path, "holds no mesh of its inside (constant/polyMesh)");
}

}  // namespace

vtkSmartPointer<vtkDataSet> read_data_set(const std::filesystem::path& path, std::optional<double> time) {
  const std::string name = path.filename().string();
  if (name.ends_with(".vtu")) return read_file<vtkXMLUnstructuredGridReader>(path);
  if (name.ends_with(".vti")) return read_file<vtkXMLImageDataReader>(path);
  if (name.ends_with(".nii") || name.ends_with(".nii.gz")) return read_nifti(path);
  if (name.ends_with(".foam") || name == "controlDict" || std::filesystem::is_directory(path))
    return read_open_foam(path, time);
  refuse_file(path, "is not the name of a field; use .vtu or .vti (VTK), .nii (NIfTI) or an OpenFOAM case");
}

}  // namespace etendue
