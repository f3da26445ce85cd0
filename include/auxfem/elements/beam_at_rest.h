#ifndef auxfem_elements_beam_at_rest_h
#define auxfem_elements_beam_at_rest_h

namespace auxfem
{
  /**
   * What the kernels of beams know of an element at rest; of several elements
   * with Lanes for numbers.
   */
  template <int order, class Frame, class Stiffness, class Number>
  struct BeamAtRest
  {
    Frame     frames[order]; ///< at the Gauss points
    Number    jacobian;      ///< half the element's length (m)
    Stiffness stiffness;
  };
} // namespace auxfem

#endif
