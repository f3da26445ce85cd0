#ifndef auxfem_tests_elements_some_rotation_h
#define auxfem_tests_elements_some_rotation_h

#include <auxfem/mathematics/rotation.h>

namespace auxfem::testing_support
{
  /** Any large rotation. */
  inline const Quaternion some_rotation =
    exponential(SpaceVector({2.1, -0.8, 1.3}));

  inline double distance_between(const SpaceVector &a, const SpaceVector &b)
  {
    return (a - b).norm();
  }
} // namespace auxfem::testing_support

#endif
