// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "io/dicom/dicom_series.h"

class DcmDataset;
class DcmPixelSequence;

namespace angiomesh {

/// The compressed pixels as they lie in the file: a table, then the fragments. Null when there are
/// none.
DcmPixelSequence* fragmentsOf(DcmDataset& data);

/// The compressed pixels of each frame in one piece, of a syntax that may cut them into several
/// fragments each: which belong together, the table of offsets says, or how a picture begins. Empty
/// where that is not clear, or a fragment cannot be read. To be asked of RLE and JPEG 2000.
std::vector<std::vector<unsigned char>> frameStreams(DcmPixelSequence& fragments,
                                                     const DicomFile& file);

/// How a JPEG 2000 picture holds its values, whatever the header says.
struct Jpeg2000Sample {
  int bits = 16;
  bool isSigned = false;
};
/// Of the first frame. To be asked where fragmentDamage() has nothing to say.
Jpeg2000Sample jpeg2000Sample(DcmDataset& data);

/// What is wrong with the pixels of a loaded file that would make a decoder ask for more memory
/// than the file is worth: lengths that reach behind its end, compressed pictures larger than the
/// header states, more JPEG 2000 tiles than there are bytes for; or that GDCM does not survive: a
/// JPEG 2000 header that is not whole, fragments of which it is not clear whose they are. Empty
/// when nothing is. `fileBytes`: of what was loaded.
std::string fragmentDamage(DcmDataset& data, const DicomFile& file, std::uintmax_t fileBytes);

}  // namespace angiomesh
