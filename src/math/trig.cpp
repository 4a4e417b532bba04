// Taylor series after reduction to a small argument: nothing here but IEEE + - * / and sqrt.
#include "math/trig.hpp"

#include <cmath>

namespace lustro {
namespace {

// sin and cos on -pi/4..pi/4: the first term left out is below 1e-17.
double sine_kernel(double x) {
  const double z = x * x;
  double sum = 0;
  for (int k = 17; k >= 3; k -= 2) {  // 1 - z/(2 3) (1 - z/(4 5) (...))
    sum = -z / (k * (k - 1)) * (1 + sum);
  }
  return x + x * sum;
}

double cosine_kernel(double x) {
  const double z = x * x;
  double sum = 0;
  for (int k = 18; k >= 2; k -= 2) {
    sum = -z / (k * (k - 1)) * (1 + sum);
  }
  return 1 + sum;
}

// x = quadrant pi/2 + rest; pi/2 in two parts, so that the rest keeps its digits (Cody and Waite).
struct Reduced {
  int quadrant;
  double rest;
};
Reduced reduce(double x) {
  constexpr double kHalfPiHigh = 1.57079632673412561417e+00;  // the first 33 bits of pi/2
  constexpr double kHalfPiLow = 6.07710050650619224932e-11;
  const double n = std::floor(x * (2 / kPi) + 0.5);
  return {static_cast<int>(n - 4 * std::floor(n / 4)), (x - n * kHalfPiHigh) - n * kHalfPiLow};
}

double sine_of_quadrant(int quadrant, double rest) {
  switch (quadrant & 3) {
    case 0:
      return sine_kernel(rest);
    case 1:
      return cosine_kernel(rest);
    case 2:
      return -sine_kernel(rest);
    default:
      return -cosine_kernel(rest);
  }
}

// atan on 0..1 by halving the angle twice: tan(a/2) = t / (1 + sqrt(1 + t^2)).
double arctangent_kernel(double t) {
  t = t / (1 + std::sqrt(1 + t * t));
  t = t / (1 + std::sqrt(1 + t * t));
  const double z = t * t;
  double sum = 0;
  for (int k = 23; k >= 1; k -= 2) {
    sum = 1.0 / k - z * sum;
  }
  return 4 * t * sum;
}

}  // namespace

double sine(double x) {
  const Reduced r = reduce(x);
  return sine_of_quadrant(r.quadrant, r.rest);
}

double cosine(double x) {
  const Reduced r = reduce(x);
  return sine_of_quadrant(r.quadrant + 1, r.rest);
}

double tangent(double x) {
  return sine(x) / cosine(x);
}

double sine_deg(double x) {
  const double n = std::floor(x / 90 + 0.5);
  return sine_of_quadrant(static_cast<int>(n - 4 * std::floor(n / 4)), radians(x - 90 * n));
}

double cosine_deg(double x) {
  return sine_deg(x + 90);
}

double arctangent2(double y, double x) {
  const double ax = std::abs(x);
  const double ay = std::abs(y);
  if (ax == 0 && ay == 0) {
    return 0;
  }
  double angle = ay <= ax ? arctangent_kernel(ay / ax) : kPi / 2 - arctangent_kernel(ax / ay);
  if (x < 0) {
    angle = kPi - angle;
  }
  return y < 0 ? -angle : angle;
}

double arccosine(double x) {
  const double c = x < -1 ? -1 : (x > 1 ? 1 : x);
  return arctangent2(std::sqrt((1 - c) * (1 + c)), c);
}

double angle_between(const Vec3d& a, const Vec3d& b) {
  return arctangent2(length(cross(a, b)), dot(a, b));
}

}  // namespace lustro
