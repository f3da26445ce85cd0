#ifndef auxfem_model_mean_stress_h
#define auxfem_model_mean_stress_h

#include <auxfem/model/lattice_model.h>

#include <vector>

namespace auxfem
{
  /** A local unknown and its factor in a sum. */
  struct WeightedUnknown
  {
    int    unknown;
    double weight;
  };

  /**
   * The mean nominal stress (Pa) of an infinite lattice as a sum over owned
   * unknowns: force along @p i per area at rest with its normal along @p j. By
   * virtual work it is the force on the joint of axis j, which the relations of
   * images exert, times Periodicity::length() over the volume of the period.
   */
  std::vector<WeightedUnknown>
  mean_stress_terms(const LatticeModel &model, unsigned int i, unsigned int j);
  /** As mean_stress_terms(), for the component @p i of the symmetric stress in
   * the order of ElasticConstants. */
  std::vector<WeightedUnknown> symmetric_stress_terms(const LatticeModel &model,
                                                      unsigned int        i);

  /** The part of the owned @p values in a sum of @p terms. */
  double sum_of_owned(const std::vector<WeightedUnknown> &terms,
                      const double                       *values);
} // namespace auxfem

#endif
