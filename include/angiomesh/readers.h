// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// Images, DICOM, segmentations and meshes from files.
#include "io/dicom/dicom.h"
#include "io/mesh/mesh_io.h"
#include "io/scan/image_io.h"
#include "io/scan/label_image.h"
