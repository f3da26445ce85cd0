#ifndef auxfem_mathematics_lanes_h
#define auxfem_mathematics_lanes_h

#include <deal.II/base/template_constraints.h>

#include <array>

#include <experimental/simd>

/**
 * @file
 * Several elements computed at a time by vector instructions: what a kernel
 * does with a number it does with one of each element, its lane. Lanes do not
 * meet, so results do not depend on which elements share them.
 */
namespace auxfem
{
#ifdef AUXFEM_SANITIZERS
  /** One element at a time: sanitizers, which look into each function of the
   * library's vectors, would make several slower than one after the other. */
  using Lanes = double;

  constexpr std::size_t n_lanes = 1;

  /** What @p function, a function of a lane, gives for each. */
  template <class Function>
  Lanes each_lane(const Function &function)
  {
    return function(std::size_t(0));
  }

  /** The number of one @p lane. */
  inline double number_in(const Lanes &lanes, const std::size_t /*lane*/)
  {
    return lanes;
  }
#else
  /** A number of each of the elements that are computed at a time: as many as
   * a register of the compiling processor's instructions holds. */
  using Lanes = std::experimental::native_simd<double>;

  /** How many elements these are: 4 with AVX2, 2 without. */
  constexpr std::size_t n_lanes = Lanes::size();

  /** What @p function, a function of a lane, gives for each. */
  template <class Function>
  Lanes each_lane(const Function &function)
  {
    return Lanes(function);
  }

  /** The number of one @p lane. */
  inline double number_in(const Lanes &lanes, const std::size_t lane)
  {
    return lanes[lane];
  }
#endif

  /** An object of each of them. */
  template <class T>
  using EachLane = std::array<T, n_lanes>;

  /** @p LaneObject is the object of Lanes that @p Object is of double: the same
   * numbers in the same order, and nothing else. */
  template <class LaneObject, class Object>
  LaneObject in_lanes(const EachLane<const Object *> &objects)
  {
    static_assert(sizeof(LaneObject) == n_lanes * sizeof(Object) &&
                  sizeof(Lanes) == n_lanes * sizeof(double));
    LaneObject result;
    auto      *lanes = reinterpret_cast<Lanes *>(&result);
    for (std::size_t i = 0; i < sizeof(Object) / sizeof(double); ++i)
      lanes[i] = each_lane([&](const auto lane) {
        return reinterpret_cast<const double *>(objects[lane])[i];
      });
    return result;
  }

  /** @copydoc in_lanes */
  template <class LaneObject, class Object>
  LaneObject in_lanes(const EachLane<Object> &objects)
  {
    EachLane<const Object *> pointers;
    for (std::size_t lane = 0; lane < n_lanes; ++lane)
      pointers[lane] = &objects[lane];
    return in_lanes<LaneObject>(pointers);
  }

  /** The object of double of one @p lane of an object of Lanes; as in_lanes().
   */
  template <class Object, class LaneObject>
  Object in_lane(const LaneObject &objects, const std::size_t lane)
  {
    static_assert(sizeof(LaneObject) == n_lanes * sizeof(Object));
    Object      result;
    const auto *lanes   = reinterpret_cast<const Lanes *>(&objects);
    auto       *numbers = reinterpret_cast<double *>(&result);
    for (std::size_t i = 0; i < sizeof(Object) / sizeof(double); ++i)
      numbers[i] = number_in(lanes[i], lane);
    return result;
  }

  /** The @p n numbers at @p lanes of one @p lane. */
  template <std::size_t n>
  void
  take_lane(const Lanes (&lanes)[n], const std::size_t lane, double *numbers)
  {
    for (std::size_t i = 0; i < n; ++i)
      numbers[i] = number_in(lanes[i], lane);
  }
} // namespace auxfem

#ifndef AUXFEM_SANITIZERS
namespace dealii
{
  /** Tensors take Lanes for numbers. */
  template <>
  struct EnableIfScalar<auxfem::Lanes>
  {
    using type = auxfem::Lanes;
  };
} // namespace dealii
#endif

/**
 * @file
 * What the library has for several numbers at a time, for one: a function
 * written with it is for either.
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

  /** A number that is assigned to on a condition. */
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
