#include <auxfem/analysis/mesh_error.h>
#include <auxfem/elements/strut_order.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace auxfem
{
  namespace
  {
    std::vector<StrutDivision> finer_than(const LatticeModel        &model,
                                          std::vector<StrutDivision> divisions)
    {
      for (StrutDivision &division : divisions)
        division = {std::min(division.order + 1,
                             highest_strut_order(model.lattice.dimension)),
                    2 * division.n_elements};
      return divisions;
    }

    /** Errors (J) of the struts of @p coarse in @p motions, not finite where
     * they cannot be found. What is out of balance still counts. */
    std::vector<double> errors_of(HeldStruts                     &coarse,
                                  HeldStruts                     &finer,
                                  const std::vector<StrutMotion> &motions)
    {
      const std::vector<unsigned int> &struts = coarse.struts();
      std::vector<double>              errors(struts.size(),
                                 std::numeric_limits<double>::infinity());
      for (unsigned int i = 0; i < struts.size(); ++i)
        coarse.move(struts[i], motions[i]);
      if (!coarse.settle())
        return errors;
      for (const unsigned int strut : struts)
        finer.move(strut, coarse.motion(strut));
      if (!finer.settle())
        return errors;
      for (unsigned int i = 0; i < struts.size(); ++i)
        if (const double error = finer.difference(struts[i], coarse) +
              coarse.out_of_balance(struts[i]) +
              finer.out_of_balance(struts[i]);
            std::isfinite(error))
          errors[i] = error;
      return errors;
    }
  } // namespace

  MeshError::MeshError(const Scene &scene, const LatticeModel &model)
    : model(model)
    , same(scene,
           model,
           model.numbering.divisions(),
           owned_struts(model.numbering))
    , finer(scene,
            model,
            finer_than(model, model.numbering.divisions()),
            owned_struts(model.numbering))
    , largest(same.struts().size(), -1.)
    , motions(same.struts().size())
  {
    const auto &elements = model.numbering.elements();
    for (unsigned int e = 0; e < elements.size(); ++e)
      if (elements[e].is_owned && elements[e].interval.begin == 0)
        first_elements.push_back(e);
  }

  void MeshError::look(const State &state)
  {
    std::vector<StrutMotion> now;
    now.reserve(first_elements.size());
    for (const unsigned int element : first_elements)
      now.push_back(motion_of_strut(model.numbering, state, element));
    const std::vector<double> errors = errors_of(same, finer, now);
    double                    sum    = 0;
    for (unsigned int i = 0; i < errors.size(); ++i)
      {
        sum += errors[i];
        if (errors[i] > largest[i])
          {
            largest[i] = errors[i];
            motions[i] = std::move(now[i]);
          }
      }
    error  = std::max(error, model.numbering.layout().sum(sum));
    energy = std::max(energy, 2 * state.energies.strain());
  }

  double MeshError::relative() const
  {
    return energy > 0 ? std::sqrt(error / energy) : 0.;
  }

  std::vector<double> errors_of_division(const Scene                     &scene,
                                         const LatticeModel              &model,
                                         const MeshError                 &seen,
                                         const std::vector<unsigned int> &which,
                                         const StrutDivision division)
  {
    if (which.empty())
      return {};
    std::vector<unsigned int> struts;
    std::vector<StrutMotion>  motions;
    for (const unsigned int i : which)
      {
        struts.push_back(seen.struts()[i]);
        motions.push_back(seen.most_demanding()[i]);
      }
    const std::vector<StrutDivision> divisions(model.lattice.struts.size(),
                                               division);
    HeldStruts                       divided(scene, model, divisions, struts),
      finer(scene, model, finer_than(model, divisions), struts);
    return errors_of(divided, finer, motions);
  }
} // namespace auxfem
