#ifndef auxfem_equations_effects_step_starts_h
#define auxfem_equations_effects_step_starts_h

#include <auxfem/time/state.h>

#include <cstring>

namespace auxfem
{
  /**
   * What the iterations of a step find of every element at its start, made once
   * in a step: kept for as long as the start is the same to the last bit.
   */
  template <class OfElement>
  class StepStarts
  {
  public:
    /**
     * @param from start of the step
     * @param make what there is of an element by its number, from which alone
     *   and @p from it follows
     */
    template <class Make>
    void
    update(const State &from, const unsigned int n_elements, const Make &make)
    {
      if (of_elements.size() == n_elements && is_of(from))
        return;
      displacement = from.displacement;
      compensation = *from.compensation;
      rotations    = from.rotations;
      of_elements.resize(n_elements);
      for (unsigned int e = 0; e < n_elements; ++e)
        of_elements[e] = make(e);
    }

    /** Of element @p e at the last start. */
    const OfElement &operator[](const unsigned int e) const
    {
      return of_elements[e];
    }

  private:
    bool is_of(const State &state) const
    {
      return are_same(displacement, state.displacement) &&
        are_same(compensation, *state.compensation) &&
        are_same(rotations, state.rotations);
    }

    /** To the last bit, the sign of zero too. */
    template <class T>
    static bool are_same(const std::vector<T> &one, const std::vector<T> &other)
    {
      return one.size() == other.size() &&
        (one.empty() ||
         std::memcmp(one.data(), other.data(), one.size() * sizeof(T)) == 0);
    }

    Vector                  displacement, compensation;
    std::vector<Quaternion> rotations;
    std::vector<OfElement>  of_elements;
  };
} // namespace auxfem

#endif
