// SPDX-License-Identifier: GPL-2.0-or-later
// Words as a mask of pixels, set in the sans-serif font that VTK carries within itself.
// Scope: VTK's FreeType part, which needs no OpenGL.
#include "draw/text.h"

#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkStdString.h>
#include <vtkTextProperty.h>
#include <vtkTextRenderer.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace muckpile {

TextMask text_mask(const std::string& words, double size, double degrees) {
  constexpr int kDpi = 72;  // one point is one pixel
  vtkTextRenderer* renderer = vtkTextRenderer::GetInstance();
  if (renderer == nullptr)
    throw std::runtime_error("VTK has no text renderer (module RenderingFreeType)");
  vtkNew<vtkTextProperty> style;
  style->SetFontFamilyToArial();
  style->SetFontSize(static_cast<int>(std::lround(size)));
  style->SetColor(1.0, 1.0, 1.0);
  style->SetOrientation(degrees);
  style->SetJustificationToLeft();
  style->SetVerticalJustificationToBottom();
  vtkNew<vtkImageData> image;
  int used[2] = {0, 0};
  vtkTextRenderer::Metrics metrics;
  if (!renderer->RenderString(style, vtkStdString(words), image, used, kDpi) ||
      !renderer->GetMetrics(style, vtkStdString(words), metrics, kDpi)) {
    throw std::runtime_error("VTK cannot set the text '" + words + "'");
  }
  // VTK's origin, y up, is the lower left corner of the words, one descent below the start of the
  // base line.
  int extent[6];
  image->GetExtent(extent);
  TextMask mask;
  mask.width = extent[1] - extent[0] + 1;
  mask.height = extent[3] - extent[2] + 1;
  mask.left = extent[0] + metrics.Descent[0];
  mask.top = -(extent[3] + metrics.Descent[1]);
  const double angle = degrees * std::numbers::pi / 180.0;
  const double length = std::hypot(metrics.TopRight[0] - metrics.TopLeft[0],
                                   metrics.TopRight[1] - metrics.TopLeft[1]);
  mask.advance = {length * std::cos(angle), -length * std::sin(angle)};
  const int channels = image->GetNumberOfScalarComponents();
  const auto* data = static_cast<const unsigned char*>(image->GetScalarPointer());
  for (int y = mask.height - 1; y >= 0; --y) {
    for (int x = 0; x < mask.width; ++x)
      mask.cover.push_back(data[(y * mask.width + x) * channels + channels - 1]);
  }
  return mask;
}

double fitting_size(const std::string& words, double size, double length) {
  constexpr double kLeast = 1.0;
  const double long_now = text_mask(words, size, 0.0).advance.x();
  if (long_now <= length) return size;
  return std::max(kLeast, std::floor(size * length / long_now));  // letters have whole sizes
}

}  // namespace muckpile
