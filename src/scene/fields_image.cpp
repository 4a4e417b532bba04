// The keys of `image`, `image.tone` and `camera`.
#include <array>

#include "scene/fields.hpp"

namespace lustro {
namespace {

constexpr std::array kSampleCounts{1, 2, 4, 8, 16};

constexpr Range kPixels{.lower = 1, .upper = 16384};
constexpr Range kSamples{.lower = 1, .upper = 16, .allowed = kSampleCounts};
constexpr Range kColor{.lower = 0};
constexpr Range kFov{.lower = 0, .upper = 180, .lower_open = true, .upper_open = true};
constexpr Range kPositive{.lower = 0, .lower_open = true};
constexpr Range kNotNegative{.lower = 0};

constexpr std::array kImageFields{
    Field<ImageSettings>{"width", "--width", at<&ImageSettings::width>, "width of the picture", "pixels", kPixels},
    Field<ImageSettings>{"height", "--height", at<&ImageSettings::height>, "height of the picture", "pixels", kPixels},
    Field<ImageSettings>{"samples", "--samples", at<&ImageSettings::samples>, "coverage samples a pixel, against jagged edges", "", kSamples},
    Field<ImageSettings>{"transfer", "--transfer", at<&ImageSettings::transfer>, "what is stored for a light value"},
    Field<ImageSettings>{"background", "--background", color_at<&ImageSettings::background, &ImageSettings::background_alpha>,
                         "colour where nothing is drawn; a fourth number is its alpha", "", kColor},
    Field<ImageSettings>{"transparent", "--transparent", at<&ImageSettings::transparent>, "the background has alpha 0"},
    Field<ImageSettings>{"tone", "", at<&ImageSettings::tone>,
                         "how light of any brightness becomes what is stored; of bytes, floats are stored as they are"},
};

constexpr Range kStops{.lower = -100, .upper = 100};

constexpr std::array kToneFields{
    Field<Tone>{"operator", "--tone", at<&Tone::curve>, "the curve, before the transfer"},
    Field<Tone>{"exposure", "--exposure", at<&Tone::exposure>, "before the curve everything is multiplied by two to this power", "stops",
                kStops},
};

constexpr std::array kCameraFields{
    Field<Camera>{"projection", "--projection", at<&Camera::projection>, "how space becomes a plane"},
    Field<Camera>{"view", "--view", at<&Camera::view>, "where the camera stands when no eye is stated; it frames the whole scene"},
    Field<Camera>{"eye", "--eye", at<&Camera::eye>, "where the camera stands", "world units", {}, "chosen by `view`"},
    Field<Camera>{"target", "--target", at<&Camera::target>, "what the camera looks at", "world units", {}, "the centre of the scene"},
    Field<Camera>{"up", "--up", at<&Camera::up>, "the direction that points up on the image", "", {}, "0,1,0, or what suits the view"},
    Field<Camera>{"fov", "--fov", at<&Camera::fov>, "vertical angle of view of a perspective camera", "degrees", kFov},
    Field<Camera>{"height", "--view-height", at<&Camera::height>, "what an orthographic camera sees from bottom to top", "world units",
                  kPositive, "frames the whole scene"},
    Field<Camera>{"near", "--near", at<&Camera::near>, "nothing nearer than this is drawn, along the view direction", "world units",
                  kNotNegative, "just before the scene"},
    Field<Camera>{"far", "--far", at<&Camera::far>, "nothing farther than this is drawn, along the view direction", "world units", kPositive,
                  "just behind the scene"},
};

}  // namespace

template <>
std::span<const Field<ImageSettings>> fields<ImageSettings>() {
  return kImageFields;
}

template <>
std::span<const Field<Tone>> fields<Tone>() {
  return kToneFields;
}

template <>
std::span<const Field<Camera>> fields<Camera>() {
  return kCameraFields;
}

}  // namespace lustro
