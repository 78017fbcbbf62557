// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Colours as numbers: CIE XYZ, CIE L*a*b*, and linear RGB for displays.
///
/// XYZ are scaled so that a perfect reflector has Y = 1.

namespace vcavity::tools {

/// CIE tristimulus values, of either standard observer.
struct Xyz {
  double x;
  double y;
  double z;
};

/// CIE 1976 L*a*b*: lightness 0 to 100, a* from green to red, b* from blue to yellow.
struct Lab {
  double lightness;
  double a;
  double b;
};

/// Linear RGB: 0 to 1 inside the gamut.
struct LinearRgb {
  double r;
  double g;
  double b;
};

/// L*a*b* of a colour seen beside a white. Source: CIE 15:2018, section 8.2.1 (ISO/CIE 11664-4).
/// @param white of a perfect reflector under the same light, all components > 0
Lab to_lab(const Xyz& colour, const Xyz& white);

/// Linear RGB with the primaries and the D65 white of sRGB (IEC 61966-2-1:1999, matrix of eq. 7). Components
/// below 0 or above 1 mean that a display cannot show the colour. Colours under a light other than D65 keep
/// the tint of that light: they are not adapted. Meant for XYZ of the 2 degree observer.
LinearRgb to_linear_srgb(const Xyz& colour);

/// The colour that linear sRGB components stand for (the same source, eq. 2).
Xyz from_linear_srgb(const LinearRgb& colour);

/// Linear RGB with the primaries and the D65 white of ITU-R BT.2020.
LinearRgb to_linear_rec2020(const Xyz& colour);

/// The RGB spaces that colours are given in.
enum class RgbSpace { srgb, rec2020 };

/// Linear RGB in a space.
LinearRgb to_linear_rgb(const Xyz& colour, RgbSpace space);

/// The transfer function of sRGB: from a linear component to an encoded one, both 0 to 1; others are limited
/// to that. Source: IEC 61966-2-1:1999, eq. 9 and 10.
double encode_srgb(double linear);

/// Its inverse: from an encoded component to a linear one, both 0 to 1.
double decode_srgb(double encoded);

}  // namespace vcavity::tools
