#include <auxfem/analysis/division_table.h>
#include <auxfem/elements/strut_order.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>

namespace auxfem
{
  namespace
  {
    namespace mpi = dealii::Utilities::MPI;

    /** By what the number of elements that all struts have may be multiplied.
     */
    constexpr unsigned int multiples[] =
      {1, 2, 3, 4, 6, 8, 12, 16, 24, 32, 48, 64};
  } // namespace

  DivisionTable::DivisionTable(const Scene        &scene,
                               const LatticeModel &model,
                               const MeshError    &seen,
                               const double        wanted)
    : scene(scene)
    , model(model)
    , seen(seen)
    , of_struts(seen.struts().size())
  {
    // What is good enough in any case: half of what is wanted for equal struts,
    // the other half for those that cannot do so well.
    const double        n_struts = mpi::sum(double(of_struts.size()),
                                     model.numbering.layout().communicator());
    const StrutDivision common   = scene.discretization.common_division();
    for (const unsigned int multiple : multiples)
      try_number(multiple * common.n_elements, wanted / (2 * n_struts));
    allowed = find_allowed(wanted);
  }

  void DivisionTable::try_number(const unsigned int n_elements,
                                 const double       share)
  {
    for (unsigned int order = lowest_chosen_order;
         order <= highest_strut_order(model.lattice.dimension);
         ++order)
      try_division({order, n_elements}, share);
    for (OfStrut &strut : of_struts)
      {
        const bool is_gain =
          std::isfinite(strut.error) && strut.error <= strut.former / 4;
        strut.n_in_vain = is_gain ? 0 : strut.n_in_vain + 1;
        strut.former    = strut.error;
      }
  }

  void DivisionTable::try_division(const StrutDivision &division,
                                   const double         share)
  {
    constexpr unsigned int    most_in_vain = 2;
    std::vector<unsigned int> tried;
    for (unsigned int i = 0; i < of_struts.size(); ++i)
      if (division.n_inner_nodes() < of_struts[i].n_inner_nodes &&
          of_struts[i].n_in_vain < most_in_vain)
        tried.push_back(i);
    const std::vector<double> errors =
      errors_of_division(scene, model, seen, tried, division);
    for (unsigned int i = 0; i < tried.size(); ++i)
      {
        OfStrut &strut = of_struts[tried[i]];
        strut.candidates.push_back({division, errors[i]});
        strut.error = std::min(strut.error, errors[i]);
        if (errors[i] <= share)
          strut.n_inner_nodes = division.n_inner_nodes();
      }
  }

  const DivisionTable::Candidate &
  DivisionTable::OfStrut::best(const double allowed) const
  {
    if (!std::isfinite(error))
      return candidates.back();
    // Half the error is no gain where none is small enough: it may be of
    // round-off.
    const double     enough = error <= allowed ? allowed : 4 * error;
    const Candidate *best   = nullptr;
    for (const Candidate &candidate : candidates)
      if (candidate.error <= enough &&
          (best == nullptr ||
           candidate.division.n_inner_nodes() < best->division.n_inner_nodes()))
        best = &candidate;
    return *best;
  }

  double DivisionTable::sum_with(const double allowed) const
  {
    double sum = 0;
    for (const OfStrut &strut : of_struts)
      sum += strut.best(allowed).error;
    return mpi::sum(sum, model.numbering.layout().communicator());
  }

  double DivisionTable::find_allowed(const double wanted) const
  {
    // Equal shares cost least where one more node reduces errors alike. Found
    // to a hundredth only: struts whose errors differ by rounding get equal
    // elements, so that symmetric lattices stay so.
    double low = std::log(wanted) - 50, high = std::log(wanted);
    if (sum_with(wanted) <= wanted)
      return wanted;
    for (unsigned int i = 0; i < 12; ++i)
      {
        const double middle                                 = (low + high) / 2;
        (sum_with(std::exp(middle)) <= wanted ? low : high) = middle;
      }
    return std::exp(low);
  }

  std::vector<StrutDivision> DivisionTable::chosen() const
  {
    std::vector<StrutDivision> divisions;
    for (const OfStrut &strut : of_struts)
      divisions.push_back(strut.best(allowed).division);
    return divisions;
  }
} // namespace auxfem
