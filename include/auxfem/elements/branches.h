#ifndef auxfem_elements_branches_h
#define auxfem_elements_branches_h

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
  class Where
  {
  public:
    Where(const bool condition, double &number)
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

  inline Where where(const bool condition, double &number)
  {
    return {condition, number};
  }
} // namespace auxfem

#endif
