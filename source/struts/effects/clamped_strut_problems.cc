#include <auxfem/equations/make_effects.h>
#include <auxfem/parameters/numerical_limits.h>
#include <auxfem/struts/effects/beam_forces.h>
#include <auxfem/struts/effects/clamped_strut_problems.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace auxfem
{
  namespace
  {
    /**
     * Copy of @p lattice in which every strut has two joints of its own; only
     * @p elastic ones become elements.
     */
    Lattice separate_struts(const Lattice                   &lattice,
                            const std::vector<unsigned int> &elastic)
    {
      Lattice result;
      result.dimension  = lattice.dimension;
      result.struts     = lattice.struts;
      result.strut_sets = lattice.strut_sets;
      result.n_cells    = lattice.n_cells;
      // Any number except invalid_index removes a strut from the mesh.
      for (Strut &strut : result.struts)
        strut.rigid_part = 0;
      for (const unsigned int strut : elastic)
        result.struts[strut].rigid_part = invalid_index;
      for (Strut &strut : result.struts)
        for (unsigned int &joint : strut.joints)
          {
            result.joints.push_back(lattice.joints[joint]);
            joint = result.joints.size() - 1;
          }
      return result;
    }

    Ties no_ties(const Lattice &lattice)
    {
      Ties ties;
      ties.released.resize(lattice.struts.size(), {{false, false}});
      return ties;
    }
  } // namespace

  std::vector<unsigned int> owned_struts(const DofNumbering &numbering)
  {
    std::vector<unsigned int> struts;
    for (const DofNumbering::Element &element : numbering.elements())
      if (element.is_owned && element.interval.begin == 0)
        struts.push_back(element.interval.strut);
    return struts;
  }

  ClampedStrutProblems::ClampedStrutProblems(
    const LatticeModel        &model,
    std::vector<StrutDivision> divisions,
    std::vector<unsigned int>  struts)
    : large_rotation(model.plan.simulated.large_rotation)
    , strut_numbers(std::move(struts))
    , lattice(separate_struts(model.lattice, strut_numbers))
    , numbering(lattice,
                StrutPartition(lattice, std::move(divisions), MPI_COMM_SELF),
                no_ties(lattice),
                MPI_COMM_SELF)
    , forces(make_strut_forces(model,
                               lattice,
                               numbering,
                               /*high_frequency_damping=*/0))
    , inertia(make_strut_inertia(model, lattice, numbering))
    , loads(make_strut_loads(model, lattice, numbering))
    , pattern(numbering.unknowns())
    , first_element(lattice.struts.size(), invalid_index)
    , instants(lattice.struts.size(), 0.)
    , last_work(lattice.struts.size(), 0.)
  {
    StateLayout layout;
    layout.velocity = layout.acceleration = model.plan.simulated.inertia;
    layout.n_rotations =
      model.plan.simulated.large_rotation ? numbering.rotations().size() : 0;
    for (const auto &effect : forces)
      {
        effect->register_in(layout);
        results.push_back(effect->make_results());
      }
    for (const auto *effects : {&inertia, &loads})
      for (const auto &effect : *effects)
        effect->register_in(layout);
    for (unsigned int e = 0; e < numbering.elements().size(); ++e)
      {
        pattern.register_block(numbering.element_unknowns(e),
                               numbering.n_element_unknowns(e));
        if (numbering.elements()[e].interval.begin == 0)
          first_element[numbering.elements()[e].interval.strut] = e;
      }
    tangent      = std::make_unique<TangentMatrix>(pattern);
    condensation = std::make_unique<StrutCondensation>(*tangent);
    state = std::make_unique<State>(numbering.layout().n_local(), layout);
  }

  void ClampedStrutProblems::move(const unsigned int strut,
                                  const StrutMotion &motion)
  {
    const unsigned int first = first_element[strut];
    instants[strut]          = motion.time;
    set_motion_of_strut(numbering,
                        first,
                        interpolated(motion, numbering.divisions()[strut]),
                        *state);
  }

  StrutMotion ClampedStrutProblems::motion(const unsigned int strut) const
  {
    StrutMotion result =
      motion_of_strut(numbering, *state, first_element[strut]);
    result.time = instants[strut];
    return result;
  }

  const StrutForces &
  ClampedStrutProblems::forces_of(const unsigned int element) const
  {
    const auto group =
      std::find_if(forces.begin(), forces.end(), [=](const auto &candidate) {
        return element < candidate->elements().end;
      });
    return **group;
  }

  void ClampedStrutProblems::add_loads()
  {
    if (loads.empty())
      return;
    std::set<double> times;
    for (const unsigned int strut : strut_numbers)
      times.insert(instants[strut]);
    for (const double instant : times)
      {
        state->time = instant;
        std::vector<double> now(residual.size(), 0.);
        for (const auto &effect : loads)
          effect->add_residual(Evaluation::consistent_rates(*state, *state),
                               now.data(),
                               nullptr);
        for (unsigned int e = 0; e < numbering.elements().size(); ++e)
          if (instants[numbering.elements()[e].interval.strut] == instant)
            for (unsigned int i = 0; i < numbering.n_element_unknowns(e); ++i)
              {
                // Count nodes that two elements share once.
                double &nodal_load = now[numbering.element_unknowns(e)[i]];
                residual[numbering.element_unknowns(e)[i]] += nodal_load;
                nodal_load = 0;
              }
      }
  }

  void ClampedStrutProblems::find_residual()
  {
    const Evaluation evaluation = Evaluation::consistent_rates(*state, *state);
    residual.assign(numbering.layout().n_local(), 0.);
    for (unsigned int i = 0; i < forces.size(); ++i)
      forces[i]->add_residual(evaluation, residual.data(), results[i].get());
    for (const auto &effect : inertia)
      effect->add_residual(evaluation, residual.data(), nullptr);
    add_loads();
  }

  std::optional<double> ClampedStrutProblems::newton_iteration()
  {
    const Evaluation evaluation = Evaluation::consistent_rates(*state, *state);
    tangent->reset();
    for (unsigned int i = 0; i < forces.size(); ++i)
      forces[i]->add_tangent(evaluation, results[i].get(), {}, *tangent);
    for (const auto &effect : inertia)
      effect->add_tangent(evaluation, nullptr, {}, *tangent);
    if (condensation->condense(Symmetry::none) != FactorizationOutcome::done)
      return std::nullopt;
    std::vector<double> increment = residual, end_values;
    for (double &value : increment)
      value = -value;
    condensation->reduce(increment, end_values);
    std::fill(end_values.begin(), end_values.end(), 0.);
    condensation->expand(end_values, increment);
    double sum = 0;
    for (const unsigned int strut : strut_numbers)
      sum += last_work[strut] = std::abs(work_on(strut, increment));
    if (large_rotation)
      apply_with_line_search(increment);
    else
      {
        apply(increment);
        find_residual();
      }
    return sum;
  }

  bool ClampedStrutProblems::solve_equilibrium()
  {
    // A motion of low order has spurious strains between its Gauss points,
    // which the first iterations must remove.
    constexpr unsigned int max_iterations = 60;
    if (strut_numbers.empty())
      return true;
    find_residual();
    for (unsigned int i = 0; i < max_iterations; ++i)
      {
        const std::optional<double> work = newton_iteration();
        if (!work || !std::isfinite(*work))
          return false;
        if (*work <= round_off * strain_energy())
          break;
      }
    return std::isfinite(strain_energy());
  }

  void
  ClampedStrutProblems::apply_with_line_search(std::vector<double> &increment)
  {
    constexpr unsigned int max_halvings = 5;
    limit_increment(increment);
    std::vector<double> before;
    for (const unsigned int strut : strut_numbers)
      before.push_back(std::abs(work_on(strut, increment)));
    apply(increment);
    find_residual();
    for (unsigned int n = 1; n <= max_halvings; ++n)
      {
        std::vector<double> back(increment.size(), 0.);
        bool                is_needed = false;
        for (unsigned int i = 0; i < strut_numbers.size(); ++i)
          if (std::abs(work_on(strut_numbers[i], increment)) > before[i])
            {
              is_needed = true;
              for_each_unknown(strut_numbers[i],
                               [&](const int unknown, unsigned int) {
                                 back[unknown] =
                                   -std::pow(0.5, n) * increment[unknown];
                               });
            }
        if (!is_needed)
          return;
        apply(back);
        find_residual();
      }
  }

  double
  ClampedStrutProblems::last_correction_work(const unsigned int strut) const
  {
    return last_work[strut] > round_off * strain_energy() ? last_work[strut]
                                                          : 0.;
  }

  template <class Act>
  void ClampedStrutProblems::for_each_unknown(const unsigned int strut,
                                              const Act         &act) const
  {
    // The second ends and interiors of elements hold every free unknown once.
    const unsigned int n_components = numbering.n_components();
    const unsigned int first        = first_element[strut];
    for (unsigned int e = first; e < first + n_elements(strut); ++e)
      for (unsigned int i = n_components; i < numbering.n_element_unknowns(e);
           ++i)
        act(numbering.element_unknowns(e)[i],
            numbering.components()[i % n_components]);
  }

  double
  ClampedStrutProblems::work_on(const unsigned int         strut,
                                const std::vector<double> &increment) const
  {
    double sum = 0;
    for_each_unknown(strut, [&](const int unknown, unsigned int) {
      sum -= residual[unknown] * increment[unknown];
    });
    return sum;
  }

  void
  ClampedStrutProblems::limit_increment(std::vector<double> &increment) const
  {
    // A full step from a low-order motion of a strongly bent strut would
    // overshoot.
    constexpr double max_increment = 0.5; // rad, and of the strut's length
    for (const unsigned int strut : strut_numbers)
      {
        const double length  = lattice.length(lattice.struts[strut]);
        double       largest = 0;
        for_each_unknown(strut, [&](const int unknown, const unsigned int c) {
          largest = std::max(largest,
                             std::abs(increment[unknown]) /
                               (c < first_rotation ? length : 1.));
        });
        if (largest > max_increment)
          for_each_unknown(strut, [&](const int unknown, unsigned int) {
            increment[unknown] *= max_increment / largest;
          });
      }
  }

  void ClampedStrutProblems::apply(const std::vector<double> &increment)
  {
    for (unsigned int i = 0; i < increment.size(); ++i)
      state->displacement[i] += increment[i];
    for (unsigned int i = 0; i < state->rotations.size(); ++i)
      state->rotations[i] =
        normalized(exponential(vector_at(increment.data(),
                                         numbering.rotations()[i].data())) *
                   state->rotations[i]);
  }

  ClampedStrutProblems::EndForces
  ClampedStrutProblems::second_end_forces(const unsigned int strut) const
  {
    const unsigned int last = first_element[strut] + n_elements(strut) - 1;
    const int *const   unknowns =
      numbering.element_unknowns(last) + numbering.n_components();
    EndForces result;
    for (unsigned int i = 0; i < numbering.n_components(); ++i)
      {
        const unsigned int c = numbering.components()[i];
        (c < first_rotation ? result.force[c]
                            : result.moment[c - first_rotation]) =
          residual[unknowns[i]];
      }
    return result;
  }

  double
  ClampedStrutProblems::difference(const unsigned int          strut,
                                   const ClampedStrutProblems &other) const
  {
    // Simpson's rule is exact for the square of a linear moment.
    constexpr double weights[]   = {1. / 6, 4. / 6, 1. / 6};
    const EndForces  own_forces  = second_end_forces(strut),
                    other_forces = other.second_end_forces(strut);
    const SpaceVector  force     = own_forces.force - other_forces.force;
    const unsigned int first = first_element[strut], n = n_elements(strut);
    const StrutForces &struts = forces_of(first);
    const auto         place  = [this](const StrutPoint &point) {
      return SpaceVector(large_rotation ? point.position + point.displacement
                                        : point.position);
    };
    const SpaceVector end =
      place(struts.sample(*state, first + n - 1, 3).back());
    double sum = 0;
    for (unsigned int e = first; e < first + n; ++e)
      {
        const std::vector<StrutPoint> points = struts.sample(*state, e, 3);
        for (unsigned int i = 0; i < 3; ++i)
          {
            const SpaceVector moment = own_forces.moment - other_forces.moment +
              dealii::cross_product_3d(end - place(points[i]), force);
            const SpaceVector f = force * points[i].axes,
                              m = moment * points[i].axes;
            sum += weights[i] * 2 *
              struts.energy_density(e, {{f[0], f[1], f[2], m[0], m[1], m[2]}});
          }
      }
    return sum * lattice.length(lattice.struts[strut]) / n;
  }

  double ClampedStrutProblems::strain_energy() const
  {
    double sum = 0;
    for (const auto &group_results : results)
      sum += static_cast<const BeamResults &>(*group_results).energy.strain;
    return sum;
  }
} // namespace auxfem
