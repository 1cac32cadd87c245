// SPDX-License-Identifier: BSD-3-Clause
#include "render/stage/colour_bar.h"

#include <vtkCoordinate.h>
#include <vtkLookupTable.h>
#include <vtkRenderer.h>
#include <vtkScalarBarActor.h>
#include <vtkTextActor.h>
#include <vtkTextProperty.h>

#include <algorithm>
#include <array>

namespace angiomesh {

namespace {

void fillTable(vtkLookupTable* table, double lo, double hi) {
  constexpr std::array<std::array<double, 3>, 3> stops{
      {{0.80, 0.10, 0.12}, {0.98, 0.90, 0.60}, {0.16, 0.42, 0.72}}};
  constexpr int count = 256;
  table->SetNumberOfTableValues(count);
  for (int k = 0; k < count; ++k) {
    const double position = 2.0 * (lo > hi ? count - 1 - k : k) / (count - 1);
    const auto from = static_cast<std::size_t>(std::min(position, 1.0));
    const double t = position - static_cast<double>(from);
    std::array<double, 3> rgb{};
    for (std::size_t c = 0; c < 3; ++c)
      rgb[c] = (1.0 - t) * stops[from][c] + t * stops[from + 1][c];
    table->SetTableValue(k, rgb[0], rgb[1], rgb[2], 1.0);
  }
  table->SetTableRange(std::min(lo, hi), std::max(lo, hi));
  table->SetNanColor(0.5, 0.5, 0.53, 1.0);
}

}  // namespace

ColourBar::ColourBar(vtkRenderer* renderer) {
  bar_->SetLookupTable(table_);
  bar_->SetOrientationToHorizontal();
  bar_->SetNumberOfLabels(5);
  bar_->SetLabelFormat("%.3g");
  bar_->SetPosition(0.25, 0.10);
  bar_->SetWidth(0.65);
  bar_->SetHeight(0.11);
  bar_->SetBarRatio(0.3);
  title_->GetPositionCoordinate()->SetCoordinateSystemToNormalizedViewport();
  title_->GetPositionCoordinate()->SetValue(0.575, 0.22);
  title_->GetTextProperty()->SetJustificationToCentered();
  title_->VisibilityOff();
  renderer->AddViewProp(title_);
  bar_->SetUnconstrainedFontSize(true);
  for (vtkTextProperty* text : {title_->GetTextProperty(), bar_->GetLabelTextProperty()}) {
    text->SetFontFamilyToArial();
    text->SetFontSize(13);
    text->ItalicOff();
    text->BoldOff();
    text->ShadowOff();
    text->SetColor(0.93, 0.93, 0.93);
  }
  bar_->VisibilityOff();
  renderer->AddViewProp(bar_);
}

ColourBar::~ColourBar() = default;

vtkLookupTable* ColourBar::table() const { return table_; }

void ColourBar::setRange(const std::string& title, double lo, double hi) {
  fillTable(table_, lo, hi);
  title_->SetInput(title.c_str());
}

void ColourBar::setVisible(bool visible) {
  bar_->SetVisibility(visible);
  title_->SetVisibility(visible);
}

}  // namespace angiomesh
