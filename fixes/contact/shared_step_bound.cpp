// SPDX-License-Identifier: GPL-2.0-or-later
// Contacts of bodies that other ranks move go to all ranks, as numbers.
// Scope: see the header.
#include "fixes/contact/shared_step_bound.h"

#include <domain.h>

#include "fixes/engine/exchange.h"

namespace muckpile {
namespace {

// Behind the body's tag; all of it is double.
constexpr std::size_t kNumbers = sizeof(BodyContact) / sizeof(double);
static_assert(sizeof(BodyContact) == (6 + 3 + 3 + 1) * sizeof(double));

void put(int body_tag, const BodyContact& c, std::vector<double>& numbers) {
  const ContactResistance& r = c.resistance;
  for (const double number :
       {static_cast<double>(body_tag), r.normal_stiffness, r.tangential_stiffness,
        r.rolling_stiffness, r.normal_damping, r.tangential_damping, r.torsional_stiffness,
        c.normal.x(), c.normal.y(), c.normal.z(), c.point.x(), c.point.y(), c.point.z(),
        c.other_mass})
    numbers.push_back(number);
}

BodyContact contact_of(const double* n) {
  return {{n[0], n[1], n[2], n[3], n[4], n[5]}, Vec3::Map(n + 6), Vec3::Map(n + 9), n[12]};
}

}  // namespace

void SharedStepBound::add_here(int body, const BodyContact& contact) {
  Vec3 arm = contact.point - bodies_.centre(body);
  domain_.minimum_image(arm.x(), arm.y(), arm.z());
  bound_.add(static_cast<std::size_t>(body), contact.resistance, contact.normal, arm,
             contact.other_mass);
}

void SharedStepBound::add(int body_tag, const BodyContact& contact) {
  if (body_tag < 0) return;
  const int body = map_.data().map(body_tag);
  if (body >= 0)
    add_here(body, contact);
  else
    put(body_tag, contact, for_others_);
}

const ContactStepBound& SharedStepBound::of_all_ranks(MPI_Comm world) {
  const std::vector<double> all = engine::gather_all(for_others_, world);
  for (std::size_t k = 0; k < all.size(); k += 1 + kNumbers) {
    const int body = map_.data().map(static_cast<int>(all[k]));
    if (body >= 0) add_here(body, contact_of(all.data() + k + 1));
  }
  for_others_.clear();
  return bound_;
}

}  // namespace muckpile
