// SPDX-License-Identifier: GPL-2.0-or-later
// Writes a finished canvas as a PNG file.
// Scope: 8 bits per channel, no transparency.
#include "draw/png_file.h"

#include <vtkErrorCode.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>

#include <algorithm>

#include "args/input_error.h"

namespace muckpile {

void write_png(const Canvas& canvas, const std::filesystem::path& path) {
  const std::vector<unsigned char> bytes = canvas.bytes();
  vtkNew<vtkImageData> image;
  image->SetDimensions(canvas.width(), canvas.height(), 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  auto* rows = static_cast<unsigned char*>(image->GetScalarPointer());
  const size_t stride = 3 * static_cast<size_t>(canvas.width());
  for (size_t y = 0, n = static_cast<size_t>(canvas.height()); y < n;
       ++y) {  // VTK's rows start at the bottom
    std::copy_n(bytes.data() + (n - 1 - y) * stride, stride, rows + y * stride);
  }
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputData(image);
  writer->SetFileName(path.c_str());
  writer->Write();
  if (writer->GetErrorCode() != vtkErrorCode::NoError)
    throw InputError(path.string() + ": cannot be written");
}

}  // namespace muckpile
