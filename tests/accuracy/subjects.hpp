// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// All functions under measurement.

#include <vector>

#include "accuracy/subject.hpp"

namespace vcavity::test {

/// Fresnel reflectance, absorptance and amplitudes.
template <class Real>
std::vector<Subject<Real>> fresnel_subjects();

/// The same of two thin films on a substrate.
template <class Real>
std::vector<Subject<Real>> coated_subjects();

/// What the groove makes of a direction: cosines of incidence, weights, reflectance and absorptance.
template <class Real>
std::vector<Subject<Real>> groove_subjects();

/// What the groove makes of a single ray: its bounces, reflectance and exit direction.
template <class Real>
std::vector<Subject<Real>> ray_subjects();

/// Weights, reflectance and absorptance of grooves with unequal panels, floors and land.
template <class Real>
std::vector<Subject<Real>> profile_subjects();

/// What the groove makes of polarised light.
template <class Real>
std::vector<Subject<Real>> polarization_subjects();

/// The projection of the hemisphere, and bi-hemispherical reflectances that are known in closed form.
template <class Real>
std::vector<Subject<Real>> surface_subjects();

/// What interreflection makes of matte grooves.
template <class Real>
std::vector<Subject<Real>> matte_subjects();

/// What a distribution of grooves makes of a pair of directions.
template <class Real>
std::vector<Subject<Real>> rough_subjects();

/// All of them.
template <class Real>
std::vector<Subject<Real>> all_subjects() {
  std::vector<Subject<Real>> all;
  for (auto* subjects : {fresnel_subjects<Real>, coated_subjects<Real>, groove_subjects<Real>,
                         ray_subjects<Real>, profile_subjects<Real>, polarization_subjects<Real>,
                         surface_subjects<Real>, matte_subjects<Real>, rough_subjects<Real>})
    for (Subject<Real>& subject : subjects()) all.push_back(std::move(subject));
  return all;
}

}  // namespace vcavity::test
