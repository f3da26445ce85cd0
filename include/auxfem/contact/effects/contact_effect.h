#ifndef auxfem_contact_effects_contact_effect_h
#define auxfem_contact_effects_contact_effect_h

#include <auxfem/contact/effects/contact.h>
#include <auxfem/contact/effects/strut_curves.h>
#include <auxfem/contact/plate_definition.h>
#include <auxfem/equations/energy_account.h>
#include <auxfem/equations/evaluation.h>
#include <auxfem/time/schemes/static.h>

#include <vector>

namespace auxfem
{
  /**
   * Sliding velocity (m/s) of the linear motion @p motion(displacements): the
   * velocity of the time scheme, its mean for discrete gradients, and a
   * BackwardDifference without inertia.
   */
  template <class Motion>
  dealii::Tensor<1, 3> sliding_velocity(const Evaluation &evaluation,
                                        const Motion     &motion)
  {
    const State &from = evaluation.from, &to = evaluation.to;
    const auto   way = [&motion](const Vector &begin, const Vector &end) {
      return motion(end) - motion(begin);
    };
    if (evaluation.kind == Evaluation::Kind::discrete_gradient)
      return way(from.displacement, to.displacement) / evaluation.dt;
    if (evaluation.kind != Evaluation::Kind::static_step)
      return motion(*to.velocity);
    const BackwardDifference rule(from, evaluation.dt);
    dealii::Tensor<1, 3>     velocity =
      rule.now * way(from.displacement, to.displacement);
    if (from.before)
      velocity -=
        rule.before * way(from.before->displacement, from.displacement);
    return velocity;
  }

  /** Friction at a point and its relative displacement in the step. */
  struct Sliding
  {
    FrictionForce        friction;
    dealii::Tensor<1, 3> displacement; ///< m
  };

  /** Books the energy dissipated by friction. */
  class FrictionAccount
  {
  public:
    /** Registers the energy `friction`. */
    void register_in(StateLayout &layout);

    /** Adds the loss in a step: the mean power of both ends with inertia,
     * otherwise the work.
     * @param at_start empty except in steps with inertia */
    void add_step(const Evaluation           &step,
                  const std::vector<Sliding> &at_end,
                  const std::vector<Sliding> &at_start,
                  EnergyAccount              &account) const;

    /** Adds the power dissipated at an instant (W). */
    void add_power(const FrictionForce &friction, EnergyAccount &account) const;

  private:
    unsigned int friction_entry = 0, numerical_entry = 0;
  };

  /** A contact point of a strut. */
  struct Touch
  {
    unsigned int pair; ///< index in the coupled pairs of this rank
    unsigned int axis; ///< axis with the point, index in StrutCurves::list()
    /** Penetration at the evaluated state (m). */
    double depth = 0;
    double force = 0; ///< normal force (N)
    double slope =
      0; ///< derivative of the force with respect to the depth (N/m)
    FrictionForce friction = {}; ///< on the strut
  };

  /** Contact points of an evaluation. */
  template <class Point>
  struct ContactResults : EffectCache
  {
    std::vector<Point> points;
  };

  /**
   * Common part of plate and strut contact: couples the pairs near each other,
   * stores contact energy, and books friction losses.
   * @tparam Kind PlateContact or StrutContact
   * @tparam Pair PlatePair or AxisPair
   * @tparam Point derived from Touch
   */
  template <class Kind, class Pair, class Point>
  class ContactEffect : public Kind
  {
  public:
    using Results = ContactResults<Point>;

    bool is_linear() const override
    {
      return false;
    }

    void register_in(StateLayout &layout) override
    {
      contact_entry = layout.energies.enter(contact_energy_entry());
      failures      = layout.failures;
      if (friction.coefficient > 0)
        friction_account.register_in(layout);
    }

    void register_blocks(TangentPattern &pattern) override
    {
      coupled.clear();
      for (const Pair &pair : near())
        {
          const std::vector<int> globals = unknowns_of(pair);
          if (!has_rows_of(globals))
            continue;
          Coupled coupled_pair{pair, {}};
          for (const int global : globals)
            coupled_pair.unknowns.push_back(
              pattern.unknowns().layout.local(global));
          const std::size_t block =
            pattern.register_block(coupled_pair.unknowns.data(),
                                   coupled_pair.unknowns.size());
          if (coupled.empty())
            first_block = block;
          coupled.push_back(std::move(coupled_pair));
        }
    }

    std::unique_ptr<EffectCache> make_results() const override
    {
      return std::make_unique<Results>();
    }

    void account(const Evaluation & /*evaluation*/,
                 const EffectCache *results,
                 EnergyAccount     &account) const override
    {
      for (const Point &point : points_of(results))
        if (is_owned(point))
          account.add(contact_entry, law_at(point).energy(point.depth));
    }

    std::optional<Penetration>
    deepest(const EffectCache &results) const override
    {
      std::optional<Penetration> found;
      for (const Point &point : points_of(&results))
        if (is_owned(point))
          if (const Penetration here = penetration(point);
              here.fraction > (found ? found->fraction : 0.))
            found = here;
      return found;
    }

    bool update_couplings(const State      &accepted,
                          std::vector<int> &required_unknowns) override
    {
      return couple(remove_broken_struts(accepted) ? restart(accepted)
                                                   : follow(accepted),
                    required_unknowns);
    }

    bool restart_couplings(const State      &accepted,
                           std::vector<int> &required_unknowns) override
    {
      remove_broken_struts(accepted);
      return couple(restart(accepted), required_unknowns);
    }

    void account_step(const Evaluation  &step,
                      const EffectCache *results,
                      EnergyAccount     &account) const override
    {
      if (friction.coefficient == 0 || !account.has_duration())
        return;
      std::vector<Point> at_start;
      if (step.kind == Evaluation::Kind::step)
        {
          State before = step.from;
          at_start = touching(Evaluation::consistent_rates(step.from, before));
        }
      friction_account.add_step(step,
                                sliding(points_of(results), step),
                                sliding(at_start, step),
                                account);
    }

    void account_stage(const Evaluation & /*stage*/,
                       const EffectCache *results,
                       EnergyAccount     &account) const override
    {
      if (friction.coefficient == 0)
        return;
      for (const Point &point : points_of(results))
        if (is_owned(point))
          friction_account.add_power(point.friction, account);
    }

    StageTerms::StageNeeds stage_needs() const override
    {
      return friction.coefficient == 0 ? StageTerms::StageNeeds::state
                                       : StageTerms::StageNeeds::results;
    }

  protected:
    /** A pair with rows on this rank, and the local unknowns of both
     * partners. */
    struct Coupled
    {
      Pair             pair;
      std::vector<int> unknowns;
    };

    explicit ContactEffect(const LatticeModel &model)
      : model(model)
      , parameters(model.plan.scene.contact)
      , friction{parameters.friction, parameters.slip_velocity}
      , dimension(model.lattice.dimension)
      , axes(make_contact_axes(model, parameters.stiffness))
      , curves(model, axes)
    {}

    /** Update near() for an accepted state and return whether it changed.
     * restart() ignores earlier states. Collective. */
    ///@{
    virtual bool follow(const State &accepted)  = 0;
    virtual bool restart(const State &accepted) = 0;
    ///@}

    /** Sorted near pairs of all ranks. */
    virtual const std::vector<Pair> &near() const = 0;

    /** Global numbers of the displacements that a pair couples. */
    virtual std::vector<int> unknowns_of(const Pair &pair) const = 0;

    /** Contact points of all coupled pairs. */
    virtual std::vector<Point> touching(const Evaluation &evaluation) const = 0;

    virtual ContactLaw law_at(const Point &point) const = 0;

    virtual Penetration penetration(const Point &point) const = 0;

    /** Motion of a point relative to the touched point, for values by local
     * unknown. */
    virtual dealii::Tensor<1, 3> difference(const Point  &point,
                                            const Vector &values) const = 0;

    static const std::vector<Point> &points_of(const EffectCache *results)
    {
      return static_cast<const Results &>(*results).points;
    }

    /** Whether this rank accounts for the point. */
    bool is_owned(const Point &point) const
    {
      return axes[point.axis].is_owned;
    }

    const LatticeModel            &model;
    const ContactParameters        parameters;
    const CoulombFriction          friction;
    const unsigned int             dimension;
    const std::vector<ContactAxis> axes;
    StrutCurves                    curves;
    std::vector<Coupled>           coupled; ///< of this rank
    std::size_t                    first_block = 0;

  private:
    /** Takes struts that have lost all their forces out of contact: nothing
     * would carry its forces. Returns whether there are others than before. */
    bool remove_broken_struts(const State &accepted)
    {
      if (!failures)
        return false;
      const std::vector<Strut> &struts = model.lattice.struts;
      std::vector<bool>         removed(struts.size(), false);
      for (unsigned int s = 0; s < struts.size(); ++s)
        if (const auto time = failures->time_of(accepted.history, s))
          removed[s] = accepted.time - *time >=
            *model.sections[struts[s].section].law->failure_time();
      if (removed == curves.removed() ||
          (curves.removed().empty() &&
           std::find(removed.begin(), removed.end(), true) == removed.end()))
        return false;
      curves.set_removed(std::move(removed));
      return true;
    }

    /** If near() has changed, adds the unknowns of pairs with rows on this rank
     * to @p required_unknowns. Returns @p has_changed. */
    bool couple(const bool        has_changed,
                std::vector<int> &required_unknowns) const
    {
      if (!has_changed)
        return false;
      for (const Pair &pair : near())
        if (const std::vector<int> globals = unknowns_of(pair);
            has_rows_of(globals))
          required_unknowns.insert(required_unknowns.end(),
                                   globals.begin(),
                                   globals.end());
      return true;
    }

    bool has_rows_of(const std::vector<int> &globals) const
    {
      const UnknownLayout &layout = model.numbering.layout();
      return std::any_of(globals.begin(),
                         globals.end(),
                         [&layout](const int global) {
                           return layout.is_owned(layout.local(global));
                         });
    }

    std::vector<Sliding> sliding(const std::vector<Point> &points,
                                 const Evaluation         &step) const
    {
      std::vector<Sliding> result;
      for (const Point &point : points)
        if (is_owned(point))
          result.push_back({point.friction,
                            difference(point, step.to.displacement) -
                              difference(point, step.from.displacement)});
      return result;
    }

    unsigned int                  contact_entry = 0;
    FrictionAccount               friction_account;
    std::optional<FailureRecords> failures;
  };
} // namespace auxfem

#endif
