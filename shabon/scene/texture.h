// What may vary over a surface, by its (u, v): a number, or a reflectance.
#pragma once

#include <memory>

#include "shabon/math/raster.h"

namespace shabon::scene {

struct TexturePicture {
  std::shared_ptr<const math::Raster> raster;  // one channel for numbers, linear sRGB for reflectances
  double repeat_u = 1, repeat_v = 1;           // so many times over the surface
};

struct NumberTexture {
  double constant = 0;  // where there is no picture
  TexturePicture picture = {};

  double at(double u, double v) const {
    if (picture.raster == nullptr) return constant;
    float value = 0;
    bilinear(*picture.raster, u * picture.repeat_u, v * picture.repeat_v, math::RasterEdge::repeat,
             math::RasterEdge::repeat, &value);
    return value;
  }
};

// The sum of a few of the scene's reflectance spectra, Scene::reflectances.
struct ReflectanceTexture {
  int first_channel = 0;  // of one spectrum; of the red, green and blue basis where there is a picture
  TexturePicture picture = {};

  int channel_count() const { return picture.raster == nullptr ? 1 : 3; }
  void coefficients(double u, double v, float* result) const {
    result[0] = 1;
    if (picture.raster != nullptr)
      bilinear(*picture.raster, u * picture.repeat_u, v * picture.repeat_v, math::RasterEdge::repeat,
               math::RasterEdge::repeat, result);
  }
};

}  // namespace shabon::scene
