// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <string>
#include <string_view>
#include <vector>

namespace angiomesh {

enum class CorrectionKind {
  Add,          ///< all within a radius of a line of points becomes vessel
  AddToEdge,    ///< of that what is as bright as the vessel, up to the edge in the image
  Erase,        ///< all within a radius of a line of points is taken out
  EraseToEdge,  ///< of that what is not as bright as the vessel
  Bridge,       ///< two ends of vessels are joined along the brightest way between them
  Separate,     ///< two vessels that touch are parted in the valley between them
  CutOff,       ///< what lies beyond a plane across a vessel is taken out
  FillHole,     ///< a cavity, or a hole through a vessel, is filled
  OpenLoop      ///< a loop is cut where it is thinnest
};

/// A correction of a segmentation by hand, as an edit of the level set.
struct Correction {
  CorrectionKind kind = CorrectionKind::Add;
  double radiusMm = 0.0;  ///< of Add, AddToEdge, Erase and EraseToEdge
  /// mm LPS. Of a brush its line, one or more; of Bridge and Separate two; of the others one.
  std::vector<Eigen::Vector3d> placesLps;
  /// Of CutOff, towards what is taken out; 0: along the vessel, to the side that has less of it.
  Eigen::Vector3d normalLps{0.0, 0.0, 0.0};

  bool operator==(const Correction&) const = default;
};

/// Whether it is a brush, with a radius.
bool isBrush(CorrectionKind kind);

/// "add 1.5 x,y,z x,y,z", "add-to-edge ...", "erase ...", "erase-to-edge ...", "bridge x,y,z
/// x,y,z", "separate x,y,z x,y,z", "cut-off x,y,z" with or without "nx,ny,nz", "fill-hole x,y,z",
/// "open-loop x,y,z".
/// @throws InputError
Correction parseCorrection(const std::string& text);
/// Places to 1 um. parseCorrection() of it is the same correction up to that.
std::string correctionText(const Correction& correction);
/// Its first word.
const char* correctionWord(CorrectionKind kind);

/// The form that parseCorrection() takes, for messages and help.
extern const char* const kCorrectionForm;

}  // namespace angiomesh
