// SPDX-License-Identifier: BSD-3-Clause
#include "core/topology/mask_contacts.h"

#include <algorithm>
#include <array>
#include <vector>

#include "core/field/wall_field.h"

namespace angiomesh {
namespace {

/// Of phi at the voxels inside and outside a contact, voxels; nearer to 0 and farther from it with
/// every round.
struct Push {
  float near, far;
};
constexpr std::array<Push, 6> kRounds{
    {{0.25F, 0.3F}, {0.15F, 0.5F}, {0.08F, 0.7F}, {0.04F, 0.9F}, {0.02F, 1.1F}, {0.02F, 1.4F}}};
/// What phi has between the voxels at least, voxels: the surface keeps off there.
constexpr double kClear = 0.03;

/// Voxels around a point where two of them touch: a square's four or a cube's eight.
struct Contact {
  Eigen::Vector3d middle;  ///< index
  std::array<std::size_t, 8> voxels{};
  std::size_t count = 0;
  bool join = false;
};

class Settler {
 public:
  Settler(Volume<float>& phi, const Volume<std::uint8_t>& mask, MaskConnectivity connectivity,
          const Progress& progress)
      : phi_(phi),
        mask_(mask),
        grid_(phi.geometry),
        voxel_(static_cast<float>(grid_.voxelMm())),
        progress_(progress) {
    findContacts(connectivity);
  }

  MaskContacts run() {
    MaskContacts done;
    std::vector<char> changed(contacts_.size(), 0);
    for (std::size_t round = 0; round <= kRounds.size() && !contacts_.empty(); ++round) {
      progress_.check();
      const std::vector<std::size_t> wrong = wrongOnes();
      done.left = wrong.size();
      if (wrong.empty() || round == kRounds.size()) break;
      for (const std::size_t n : wrong) {
        changed[n] = 1;
        push(contacts_[n], kRounds[round]);
      }
    }
    for (std::size_t n = 0; n < contacts_.size(); ++n)
      if (changed[n] != 0) ++(contacts_[n].join ? done.joined : done.parted);
    return done;
  }

 private:
  [[nodiscard]] bool inside(std::size_t voxel) const { return mask_.voxels[voxel] != 0; }

  void findContacts(MaskConnectivity connectivity) {
    const bool joinsEdges = connectivity != MaskConnectivity::Faces;
    const bool joinsCorners = connectivity == MaskConnectivity::Corners;
    const std::array<std::size_t, 3> stride{1, grid_.offset(0, 1, 0), grid_.offset(0, 0, 1)};
    for (int k = 0; k < grid_.size[2]; ++k) {
      progress_.check();
      for (int j = 0; j < grid_.size[1]; ++j)
        for (int i = 0; i < grid_.size[0]; ++i) {
          const Index3 p{i, j, k};
          std::array<bool, 3> more{};
          for (std::size_t a = 0; a < 3; ++a) more[a] = p[a] + 1 < grid_.size[a];
          const std::size_t at = grid_.offset(i, j, k);
          for (std::size_t a = 0; a < 3; ++a) {
            const std::size_t b = (a + 1) % 3;
            if (more[a] && more[b]) addSquare(p, at, a, b, stride, joinsEdges);
          }
          if (more[0] && more[1] && more[2]) addCube(p, at, stride, joinsCorners);
        }
    }
  }

  void addSquare(const Index3& p, std::size_t at, std::size_t a, std::size_t b,
                 const std::array<std::size_t, 3>& stride, bool join) {
    const std::array<std::size_t, 4> corner{at, at + stride[a], at + stride[b],
                                            at + stride[a] + stride[b]};
    const bool in = inside(corner[0]);
    if (inside(corner[3]) != in || inside(corner[1]) == in || inside(corner[2]) == in) return;
    Contact contact;
    contact.middle = {1.0 * p[0], 1.0 * p[1], 1.0 * p[2]};
    contact.middle[static_cast<Eigen::Index>(a)] += 0.5;
    contact.middle[static_cast<Eigen::Index>(b)] += 0.5;
    std::copy(corner.begin(), corner.end(), contact.voxels.begin());
    contact.count = 4;
    contact.join = join;
    contacts_.push_back(contact);
  }

  // Two voxels across a cube of which no other is inside.
  void addCube(const Index3& p, std::size_t at, const std::array<std::size_t, 3>& stride,
               bool join) {
    Contact contact;
    unsigned inner = 0;
    for (unsigned n = 0; n < 8; ++n) {
      const std::size_t voxel =
          at + (n & 1U) * stride[0] + (n >> 1U & 1U) * stride[1] + (n >> 2U) * stride[2];
      contact.voxels[n] = voxel;
      if (inside(voxel)) inner |= 1U << n;
    }
    for (unsigned n = 0; n < 4; ++n)
      if (inner == (1U << n | 1U << (7U - n))) {
        contact.middle = Eigen::Vector3d(p[0] + 0.5, p[1] + 0.5, p[2] + 0.5);
        contact.count = 8;
        contact.join = join;
        contacts_.push_back(contact);
      }
  }

  [[nodiscard]] std::vector<std::size_t> wrongOnes() const {
    const SplineField field = wallField(phi_, SplineKind::InterpolatingBspline);
    const double clear = kClear * static_cast<double>(voxel_);
    std::vector<std::size_t> wrong;
    for (std::size_t n = 0; n < contacts_.size(); ++n) {
      const Contact& contact = contacts_[n];
      const double value = field.atIndex(contact.middle).value;
      bool right = contact.join ? value <= -clear : value >= clear;
      for (std::size_t v = 0; v < contact.count; ++v)
        right = right && keepsSide(contact, contact.voxels[v]);
      if (!right) wrong.push_back(n);
    }
    return wrong;
  }

  // The voxels of the mask that are joined, and the others around those that are parted.
  [[nodiscard]] bool keepsSide(const Contact& contact, std::size_t voxel) const {
    return inside(voxel) != contact.join || (phi_.voxels[voxel] < 0.0F) == contact.join;
  }

  void push(const Contact& contact, const Push& by) {
    const float in = voxel_ * (contact.join ? by.far : by.near);
    const float out = voxel_ * (contact.join ? by.near : by.far);
    for (std::size_t n = 0; n < contact.count; ++n) {
      float& value = phi_.voxels[contact.voxels[n]];
      if (inside(contact.voxels[n]))
        value = contact.join ? std::min(value, -in) : std::max(value, -in);
      else
        value = contact.join ? std::min(value, out) : std::max(value, out);
    }
  }

  Volume<float>& phi_;
  const Volume<std::uint8_t>& mask_;
  const Geometry& grid_;
  float voxel_;
  const Progress& progress_;
  std::vector<Contact> contacts_;
};

}  // namespace

MaskContacts settleContacts(Volume<float>& phi, const Volume<std::uint8_t>& mask,
                            MaskConnectivity connectivity, const Progress& progress) {
  return Settler(phi, mask, connectivity, progress).run();
}

std::string contactText(const MaskContacts& contacts) {
  if (contacts.joined + contacts.parted == 0) return {};
  std::string text = "where voxels share only an edge or a corner, the surface was joined in " +
                     std::to_string(contacts.joined) + " places and parted in " +
                     std::to_string(contacts.parted) + ", as segmentation.connectivity says";
  if (contacts.left > 0)
    text += "; in " + std::to_string(contacts.left) + " it goes the other way all the same";
  return text;
}

}  // namespace angiomesh
