// SPDX-License-Identifier: BSD-3-Clause
#include "render/slice/slice_overlay.h"

#include <vtkActor2D.h>
#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper2D.h>
#include <vtkProperty2D.h>
#include <vtkRenderer.h>
#include <vtkTextActor.h>
#include <vtkTextProperty.h>

#include <cmath>
#include <utility>

#include "core/base/formatted.h"
#include "render/stage/stage.h"

namespace angiomesh {

namespace {

constexpr int letterSize = 18;

void style(vtkTextActor* actor, int size, bool centredAcross, bool rightAligned,
           bool centredUpwards, bool top) {
  styleText(actor, size);
  vtkTextProperty* property = actor->GetTextProperty();
  if (centredAcross) property->SetJustificationToCentered();
  if (rightAligned) property->SetJustificationToRight();
  if (centredUpwards) property->SetVerticalJustificationToCentered();
  if (top) property->SetVerticalJustificationToTop();
}

std::string turnedText(std::string text, double degrees) {
  const std::size_t at = text.find("%1");
  return at == std::string::npos ? text : text.replace(at, 2, formatted("%.0f", degrees));
}

std::string lengthText(double mm) {
  if (mm >= 10.0 && std::fmod(mm, 10.0) == 0.0) return formatted("%g cm", mm / 10.0);
  return formatted("%g mm", mm);
}

}  // namespace

double scaleBarLengthMm(double longestMm) {
  if (!(longestMm > 0.0) || !std::isfinite(longestMm)) return 0.0;
  const double decade = std::pow(10.0, std::floor(std::log10(longestMm)));
  for (const double factor : {5.0, 2.0})
    if (factor * decade <= longestMm) return factor * decade;
  return decade;
}

struct SliceOverlay::Parts {
  vtkNew<vtkTextActor> left, right, top, bottom, upperLeft, upperRight, lowerLeft, barText;
  vtkNew<vtkPolyData> bar;
  vtkNew<vtkActor2D> barActor;
  SliceWords words;

  std::array<vtkTextActor*, 8> texts() {
    return {left, right, top, bottom, upperLeft, upperRight, lowerLeft, barText};
  }
};

SliceOverlay::SliceOverlay(vtkRenderer* renderer) : parts_(std::make_unique<Parts>()) {
  Parts& p = *parts_;
  style(p.left, letterSize, false, false, true, false);
  style(p.right, letterSize, false, true, true, false);
  style(p.top, letterSize, true, false, false, true);
  style(p.bottom, letterSize, true, false, false, false);
  style(p.upperLeft, textSize, false, false, false, true);
  style(p.upperRight, textSize, false, true, false, true);
  style(p.lowerLeft, textSize, false, false, false, false);
  style(p.barText, textSize, true, false, false, false);
  vtkNew<vtkPolyDataMapper2D> mapper;
  mapper->SetInputData(p.bar);
  p.barActor->SetMapper(mapper);
  p.barActor->GetProperty()->SetColor(0.93, 0.90, 0.72);
  renderer->AddViewProp(p.barActor);
  for (vtkTextActor* text : p.texts()) renderer->AddViewProp(text);
}

SliceOverlay::~SliceOverlay() = default;

void SliceOverlay::setVisible(bool visible) {
  parts_->barActor->SetVisibility(visible);
  for (vtkTextActor* text : parts_->texts()) text->SetVisibility(visible);
}

void SliceOverlay::setWords(SliceWords words) { parts_->words = std::move(words); }

void SliceOverlay::setLetters(const PaneAxes& axes) {
  parts_->right->SetInput(orientationLetters(axes.rightLps).c_str());
  parts_->left->SetInput(orientationLetters(-axes.rightLps).c_str());
  parts_->top->SetInput(orientationLetters(axes.upLps).c_str());
  parts_->bottom->SetInput(orientationLetters(-axes.upLps).c_str());
}

void SliceOverlay::setTexts(const Texts& texts) {
  constexpr std::array<const char*, 3> rising{"L", "P", "S"};
  constexpr std::array<const char*, 3> falling{"R", "A", "I"};
  const auto plane = static_cast<std::size_t>(texts.plane);
  const SliceWords& words = parts_->words;
  const std::string where =
      texts.turnedDeg > 0.05
          ? turnedText(words.turned, texts.turnedDeg)
          : formatted("%s %.1f mm", texts.alongMm >= 0.0 ? rising[plane] : falling[plane],
                      std::abs(texts.alongMm));
  parts_->upperLeft->SetInput(formatted("%s %d/%d\n%s%s", words.planes[plane].c_str(),
                                        texts.slice + 1, texts.count, where.c_str(),
                                        texts.patientAxes ? ("\n" + words.patientAxes).c_str() : "")
                                  .c_str());
  const std::string slab =
      texts.slab.mode != SlabMode::None
          ? formatted("%s %.1f mm\n",
                      words.slabs[static_cast<std::size_t>(texts.slab.mode)].c_str(),
                      texts.slab.thicknessMm)
          : std::string();
  parts_->upperRight->SetInput((slab + texts.caption).c_str());
  const std::string contrast = formatted("W %.4g  L %.4g", texts.window, texts.level);
  const std::string above = texts.pointer.empty() ? std::string() : texts.pointer + "\n";
  parts_->lowerLeft->SetInput((above + contrast).c_str());
}

void SliceOverlay::setScale(double mmPerPixel, int widthPixels, int heightPixels,
                            double pixelRatio) {
  Parts& p = *parts_;
  const double w = widthPixels;
  const double h = heightPixels;
  const double m = textMargin * pixelRatio;
  p.left->SetPosition(m, h / 2);
  p.right->SetPosition(w - m, h / 2);
  p.top->SetPosition(w / 2, h - m);
  p.bottom->SetPosition(w / 2, m);
  p.upperLeft->SetPosition(m, h - m);
  p.upperRight->SetPosition(w - m, h - m);
  p.lowerLeft->SetPosition(m, m);

  const double lengthMm = scaleBarLengthMm(0.25 * w * mmPerPixel);
  const double length = mmPerPixel > 0.0 ? lengthMm / mmPerPixel : 0.0;
  const double tick = 4.0 * pixelRatio;
  const double x1 = std::round(w - 2.0 * m);
  const double x0 = std::round(x1 - length);
  const double y = std::round(m + tick);
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(x0, y + tick, 0.0);
  points->InsertNextPoint(x0, y, 0.0);
  points->InsertNextPoint(x1, y, 0.0);
  points->InsertNextPoint(x1, y + tick, 0.0);
  vtkNew<vtkCellArray> lines;
  lines->InsertNextCell({0, 1, 2, 3});
  p.bar->SetPoints(points);
  p.bar->SetLines(lines);
  p.barActor->GetProperty()->SetLineWidth(static_cast<float>(1.5 * pixelRatio));
  p.barText->SetPosition((x0 + x1) / 2, y + 1.5 * tick);
  p.barText->SetInput(lengthText(lengthMm).c_str());
}

}  // namespace angiomesh
