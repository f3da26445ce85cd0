#ifndef auxfem_time_massless_h
#define auxfem_time_massless_h

namespace auxfem
{
  /** Entries of State::is_massless; damped: viscous forces depend on the
   * velocity of the unknown. */
  constexpr double massless = 1, massless_and_damped = 2;
} // namespace auxfem

#endif
