#ifndef auxfem_mathematics_lanes_h
#define auxfem_mathematics_lanes_h

#include <deal.II/base/template_constraints.h>

#include <array>

#include <experimental/simd>

/**
 * Inlines all calls of a function, which the compiler would not do for
 * functions of this size. Sanitizer builds skip it because their checks make
 * compilation too slow.
 */
#ifdef AUXFEM_SANITIZERS
#  define AUXFEM_FLATTEN
#else
#  define AUXFEM_FLATTEN [[gnu::flatten]]
#endif

/**
 * @file
 * SIMD over elements: a kernel written for a number computes one number per
 * element, its lane, at a time. Lanes do not interact, so results do not depend
 * on the grouping of elements.
 */
namespace auxfem
{
#ifdef AUXFEM_SANITIZERS
  /**
   * One element at a time: sanitizers instrument each function of the SIMD
   * library and make it slower than scalar code.
   */
  using Lanes = double;

  constexpr std::size_t n_lanes = 1;

  /** The values of @p function at all lanes. */
  template <class Function>
  Lanes make_lanes(const Function &function)
  {
    return function(std::size_t(0));
  }

  /** The number in one @p lane. */
  inline double lane_value(const Lanes &lanes, const std::size_t /*lane*/)
  {
    return lanes;
  }
#else
  /**
   * One number for each element of a batch, as many as a register of the target
   * processor holds.
   */
  using Lanes = std::experimental::native_simd<double>;

  /** Number of lanes: 4 with AVX2, 2 without. */
  constexpr std::size_t n_lanes = Lanes::size();

  /** The values of @p function at all lanes. */
  template <class Function>
  Lanes make_lanes(const Function &function)
  {
    return Lanes(function);
  }

  /** The number in one @p lane. */
  inline double lane_value(const Lanes &lanes, const std::size_t lane)
  {
    return lanes[lane];
  }
#endif

  /** One object per lane. */
  template <class T>
  using LaneArray = std::array<T, n_lanes>;

  /**
   * Packs one object per lane into an object of Lanes. @p LaneObject must have
   * the layout of @p Object with Lanes in place of double, and no other
   * members.
   */
  template <class LaneObject, class Object>
  LaneObject pack_lanes(const LaneArray<const Object *> &objects)
  {
    static_assert(sizeof(LaneObject) == n_lanes * sizeof(Object) &&
                  sizeof(Lanes) == n_lanes * sizeof(double));
    LaneObject result;
    auto      *lanes = reinterpret_cast<Lanes *>(&result);
    for (std::size_t i = 0; i < sizeof(Object) / sizeof(double); ++i)
      lanes[i] = make_lanes([&](const auto lane) {
        return reinterpret_cast<const double *>(objects[lane])[i];
      });
    return result;
  }

  /** @copydoc pack_lanes */
  template <class LaneObject, class Object>
  LaneObject pack_lanes(const LaneArray<Object> &objects)
  {
    LaneArray<const Object *> pointers;
    for (std::size_t lane = 0; lane < n_lanes; ++lane)
      pointers[lane] = &objects[lane];
    return pack_lanes<LaneObject>(pointers);
  }

  /** Unpacks the object of one @p lane; inverse of pack_lanes(). */
  template <class Object, class LaneObject>
  Object unpack_lane(const LaneObject &objects, const std::size_t lane)
  {
    static_assert(sizeof(LaneObject) == n_lanes * sizeof(Object));
    Object      result;
    const auto *lanes   = reinterpret_cast<const Lanes *>(&objects);
    auto       *numbers = reinterpret_cast<double *>(&result);
    for (std::size_t i = 0; i < sizeof(Object) / sizeof(double); ++i)
      numbers[i] = lane_value(lanes[i], lane);
    return result;
  }

  /** Copies the @p n numbers of one @p lane to @p numbers. */
  template <std::size_t n>
  void
  copy_lane(const Lanes (&lanes)[n], const std::size_t lane, double *numbers)
  {
    for (std::size_t i = 0; i < n; ++i)
      numbers[i] = lane_value(lanes[i], lane);
  }
} // namespace auxfem

#ifndef AUXFEM_SANITIZERS
namespace dealii
{
  /** Admits Lanes as the number type of tensors. */
  template <>
  struct EnableIfScalar<auxfem::Lanes>
  {
    using type = auxfem::Lanes;
  };
} // namespace dealii
#endif

/**
 * @file
 * Scalar counterparts of the SIMD library's masked assignment, so that one
 * function template serves double and Lanes:
 * @code
 * Number result = series(x);
 * const auto large = x > limit;
 * if (any_of(large))
 *   where(large, result) = function(x);
 * @endcode
 */
namespace auxfem
{
  inline bool any_of(const bool condition)
  {
    return condition;
  }

  /** Assigns to a number under a condition. */
  class WhereExpression
  {
  public:
    WhereExpression(const bool condition, double &number)
      : condition(condition)
      , number(number)
    {}

    void operator=(const double value) &&
    {
      if (condition)
        number = value;
    }

  private:
    const bool condition;
    double    &number;
  };

  inline WhereExpression where(const bool condition, double &number)
  {
    return {condition, number};
  }
} // namespace auxfem

#endif
