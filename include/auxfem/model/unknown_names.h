#ifndef auxfem_model_unknown_names_h
#define auxfem_model_unknown_names_h

#include <auxfem/model/numbering.h>

#include <string>

namespace auxfem
{
  /** Words for a component of motion, e.g. `vertical displacement` or `rotation
   * about x`. */
  const char *motion_name(unsigned int component, unsigned int dimension);

  /**
   * Words for a local unknown, e.g. `rotation of joint 12 at (0.01, 0.02)`; for
   * nodes inside a strut that strut is named.
   */
  std::string describe(const DofNumbering &numbering, unsigned int unknown);

  /**
   * Words for the owned unknown of largest @p size (by local unknown, of which
   * the owned ones count; rotations made comparable by the caller) over all
   * ranks; the same on every rank. Collective.
   */
  std::string describe_largest(const DofNumbering        &numbering,
                               const std::vector<double> &size);

  /** Why @p joint has no rotation and what to do, as a sentence. */
  std::string why_no_rotation(const DofNumbering &numbering,
                              unsigned int        joint);
} // namespace auxfem

#endif
