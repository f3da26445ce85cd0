#ifndef auxfem_equations_effects_step_starts_h
#define auxfem_equations_effects_step_starts_h

#include <auxfem/equations/element_batches.h>

#include <cstring>

namespace auxfem
{
  /**
   * What the iterations of a step find of all elements at its start, of several
   * at a time, made once in a step: kept for as long as the start is the same
   * to the last bit.
   */
  template <class OfBatch>
  class StepStarts
  {
  public:
    /**
     * @param from start of the step
     * @param make what there is of an ElementBatch, from which alone and @p from
     *   it follows
     */
    template <class Make>
    void
    update(const State &from, const unsigned int n_elements, const Make &make)
    {
      if (n_elements == this->n_elements && is_of(from))
        return;
      this->n_elements = n_elements;
      displacement     = from.displacement;
      compensation     = *from.compensation;
      rotations        = from.rotations;
      of_batches.clear();
      for_each_batch(n_elements, [&](const ElementBatch &batch) {
        of_batches.push_back(make(batch));
      });
    }

    /** Of batch @p number at the last start. */
    const OfBatch &operator[](const unsigned int number) const
    {
      return of_batches[number];
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
    unsigned int            n_elements = 0;
    std::vector<OfBatch>    of_batches;
  };
} // namespace auxfem

#endif
