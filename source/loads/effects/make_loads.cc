#include <auxfem/equations/make_effects.h>
#include <auxfem/loads/effects/applied_loads.h>
#include <auxfem/loads/effects/follower_loads.h>
#include <auxfem/loads/effects/pressure.h>
#include <auxfem/mesh/sets.h>
#include <auxfem/model/load_history.h>
#include <auxfem/model/unknown_records.h>
#include <auxfem/parameters/errors.h>
#include <auxfem/struts/beam_dispatch.h>
#include <auxfem/struts/beam_shape.h>

#include <algorithm>

namespace auxfem
{
  namespace
  {
    /** Entry of the energy ledger for the work of the load @p name. */
    EnergyEntry work_entry(const std::string &name)
    {
      return {EnergyKind::work,
              name + ".load_work",
              "work of the load since the start"};
    }

    /** Adds @p force to @p load, distributed by @p shares. */
    void
    add_shares(const ForceShares &shares, const double force, AppliedLoad &load)
    {
      for (const auto &[unknown, share] : shares)
        load.weights.push_back({unknown, force * share});
    }

    /** Collects the loads of a scene and makes their effects. */
    struct Loads
    {
      void add_dead(const JointLoadDefinition &definition)
      {
        const std::vector<unsigned int> joints =
          joints_of(definition, lattice, scene.context);
        for (const unsigned int c : numbering.components())
          {
            if (definition.components[c].is_zero())
              continue;
            AppliedLoad      load{proportional(definition.components[c], plan),
                             work_entry(definition.name),
                             {}};
            PositionFunction factor =
              load_distribution(definition, lattice, scene.context);
            for (const unsigned int joint : joints)
              {
                if (!numbering.joint_has(joint, c))
                  throw InputError(definition.path + "/Moment " +
                                   "xyz"[c - first_rotation] + ": " +
                                   missing_rotation_reason(numbering, joint));
                const int unknown = numbering.joint_unknown(joint, c);
                if (unknown >= 0)
                  load.weights.push_back(
                    {unknown, factor.value_at(lattice.joints[joint])});
              }
            dead.push_back(std::move(load));
          }
      }

      void add_following(const JointLoadDefinition &definition)
      {
        if (definition.distribution != "1")
          throw InputError(definition.path +
                           "/Distribution: it must be 1 with Direction = "
                           "follows the joint. Give a load to each set of "
                           "joints");
        auto components = definition.components;
        for (TimeFunction &component : components)
          component = proportional(component, plan);
        FollowerLoad load{components, work_entry(definition.name), {}};
        for (const unsigned int joint :
             joints_of(definition, lattice, scene.context))
          {
            if (!numbering.joint_has(joint, rotation_z))
              throw InputError(definition.path +
                               "/Direction = follows the joint: " +
                               missing_rotation_reason(numbering, joint));
            if (numbering.joint_unknown(joint, rotation_z) >= 0)
              load.joints.push_back(joint);
          }
        following.push_back(std::move(load));
      }

      void add_line_loads()
      {
        for (const LineLoadDefinition &definition : scene.line_loads)
          {
            const std::vector<bool> chosen = chosen_struts(definition);
            for (const RigidPart &part : lattice.rigid_parts)
              for (const unsigned int strut : part.struts)
                if (chosen[strut])
                  refuse_unsupported_load_point(part,
                                                lattice,
                                                lattice.centroid(
                                                  lattice.struts[strut]));
            PositionFunction factor =
              load_distribution(definition, lattice, scene.context);
            for (unsigned int c = 0; c < lattice.dimension; ++c)
              {
                if (definition.components[c].is_zero())
                  continue;
                AppliedLoad load{proportional(definition.components[c], plan),
                                 work_entry(definition.name),
                                 {}};
                add_along_struts(
                  c,
                  chosen,
                  [](const StrutInterval &) { return 1.; },
                  [&](const dealii::Point<3> &position) {
                    return factor.value_at(position);
                  },
                  load);
                if (definition.distribution == "1")
                  add_along_rigid_struts(c, chosen, load);
                else
                  refuse_rigid_struts(chosen,
                                      definition.path + "/Distribution",
                                      "rigid struts take uniform loads only. "
                                      "Leave it out of Struts, or set "
                                      "Distribution = 1");
                dead.push_back(std::move(load));
              }
          }
      }

      void add_pressures()
      {
        for (const PressureDefinition &definition : scene.pressures)
          {
            const std::vector<bool> chosen = chosen_struts(definition);
            refuse_rigid_struts(
              chosen,
              definition.path + "/Struts",
              "pressure acts on elastic struts only. Leave it "
              "out of the set");
            PositionFunction factor =
              load_distribution(definition, lattice, scene.context);
            PressureLoad load{proportional(definition.pressure, plan),
                              work_entry(definition.name),
                              {}};
            for (const DofNumbering::Group &group : numbering.groups())
              dispatch_order(group.order, [&](auto order) {
                const BeamShape<order> shape;
                for (unsigned int e = group.begin; e < group.end; ++e)
                  if (chosen[numbering.elements()[e].interval.strut])
                    load.elements.push_back(pressed(e, shape, factor));
              });
            pressures.push_back(std::move(load));
          }
      }

      /** Element @p e under a pressure times @p factor. */
      template <int order>
      PressureLoad::Element pressed(const unsigned int      e,
                                    const BeamShape<order> &shape,
                                    PositionFunction       &factor) const
      {
        const StrutInterval  &interval = numbering.elements()[e].interval;
        const Strut          &strut    = lattice.struts[interval.strut];
        constexpr int         n        = order + 1;
        PressureLoad::Element pressed{e, std::vector<double>(n * n, 0.), {}};
        dealii::Point<3>      position;
        dealii::Tensor<1, 3>  tangent;
        for (int g = 0; g < order; ++g)
          {
            lattice.axis(strut, interval.at(shape.point[g]), position, tangent);
            const double part = shape.weight[g] * factor.value_at(position);
            for (int a = 0; a < n; ++a)
              for (int b = 0; b < n; ++b)
                pressed.integrals[a * n + b] +=
                  part * shape.value[g][a] * shape.derivative[g][b];
          }
        for (int a = 0; a < n; ++a)
          {
            lattice.axis(strut, interval.at(shape.node[a]), position, tangent);
            pressed.positions.push_back(position[0]);
            pressed.positions.push_back(position[1]);
          }
        return pressed;
      }

      /** Adds the weight, and the load of masses by base motion.
       * @param with_masses whether that of point masses is included */
      void add_accelerations(const bool with_masses)
      {
        if (plan.simulated.gravity)
          add_acceleration(scene.gravity,
                           1,
                           {EnergyKind::work,
                            "gravity_work",
                            "work of the weight since the start"},
                           with_masses);
        add_acceleration(scene.base_motion,
                         -1,
                         {EnergyKind::work,
                          "base_motion_work",
                          "work of the base motion since the start, seen from "
                          "the base"},
                         with_masses);
      }

      /** Adds the mass times @p sign times an acceleration. */
      void add_acceleration(const AccelerationDefinition &definition,
                            const double                  sign,
                            const EnergyEntry            &work,
                            const bool                    with_masses)
      {
        const std::vector<bool> all(lattice.struts.size(), true);
        for (unsigned int c = 0; c < lattice.dimension; ++c)
          {
            const TimeFunction &acceleration = definition.acceleration[c];
            if (acceleration.is_zero())
              continue;
            AppliedLoad load{proportional(acceleration, plan), work, {}};
            add_along_struts(
              c,
              all,
              [&](const StrutInterval &element) {
                return sign *
                  model.sections[lattice.struts[element.strut].section]
                    .at(element.at(0))
                    .mass_per_length();
              },
              [](const dealii::Point<3> &) { return 1.; },
              load);
            for_each_body([&](const auto &body) {
              const RigidPart &part = lattice.rigid_parts[body.part];
              add_shares(
                force_shares(body, lattice, numbering, part.centre_of_mass, c),
                sign * part.mass,
                load);
            });
            if (with_masses)
              for (const MassDefinition &mass : scene.masses)
                for (const unsigned int joint :
                     joints_of(mass, lattice, scene.context))
                  if (numbering.joint_unknown(joint, c) >= 0)
                    load.weights.push_back(
                      {numbering.joint_unknown(joint, c), sign * mass.mass});
            dead.push_back(std::move(load));
          }
      }

      const LatticeModel &model;
      const Lattice      &lattice;
      const DofNumbering &numbering;
      const RigidBodies  &bodies;

      const RunPlan &plan  = model.plan;
      const Scene   &scene = plan.scene;

      std::vector<std::unique_ptr<Effect>> make_effects() const
      {
        const bool raised_from_zero =
          !plan.time.scheme->is_dynamic() && !plan.time.static_start;
        std::vector<std::unique_ptr<Effect>> effects;
        if (!dead.empty())
          effects.push_back(
            make_applied_loads(numbering, raised_from_zero, dead));
        if (!following.empty())
          effects.push_back(make_follower_loads(lattice,
                                                numbering,
                                                raised_from_zero,
                                                following));
        if (!pressures.empty())
          effects.push_back(make_pressures(numbering,
                                           plan.simulated.large_rotation,
                                           raised_from_zero,
                                           pressures));
        return effects;
      }

      std::vector<AppliedLoad>  dead      = {};
      std::vector<FollowerLoad> following = {};
      std::vector<PressureLoad> pressures = {};

      /** Struts of a load, by number. */
      template <class Definition>
      std::vector<bool> chosen_struts(const Definition &definition) const
      {
        std::vector<bool> chosen(lattice.struts.size(), false);
        for (const unsigned int strut :
             struts_of(definition, lattice, scene.context))
          chosen[strut] = true;
        return chosen;
      }

      /** Refuses rigid struts among those @p chosen by the parameter @p path. */
      void refuse_rigid_struts(const std::vector<bool> &chosen,
                               const std::string       &path,
                               const std::string       &why) const
      {
        for (unsigned int s = 0; s < chosen.size(); ++s)
          if (chosen[s] && lattice.struts[s].is_rigid())
            throw InputError(path + ": strut " + std::to_string(s) +
                             " is rigid, and " + why);
      }

      /** Adds the force @p per_length(element) (N/m) along component @p c, times
       * @p factor by position, to the chosen struts. */
      template <class PerLength, class Factor>
      void add_along_struts(const unsigned int       c,
                            const std::vector<bool> &chosen,
                            const PerLength         &per_length,
                            const Factor            &factor,
                            AppliedLoad             &load) const
      {
        const unsigned int n = numbering.n_components();
        for (const DofNumbering::Group &group : numbering.groups())
          {
            const LineRule rule(group.order);
            for (unsigned int e = group.begin; e < group.end; ++e)
              {
                const StrutInterval &interval =
                  numbering.elements()[e].interval;
                if (!chosen[interval.strut])
                  continue;
                const Strut &strut = lattice.struts[interval.strut];
                const double force = per_length(interval) *
                  lattice.length(strut) * (interval.end - interval.begin) / 2;
                std::vector<double> shares(rule.nodes.size(), 0.);
                for (const LineRule::Point &point : rule.points)
                  {
                    dealii::Point<3>     position;
                    dealii::Tensor<1, 3> tangent;
                    lattice.axis(strut,
                                 interval.at(point.xi),
                                 position,
                                 tangent);
                    const double part = point.weight * factor(position);
                    for (unsigned int a = 0; a < shares.size(); ++a)
                      shares[a] += part * point.shapes[a];
                  }
                for (unsigned int a = 0; a < shares.size(); ++a)
                  load.weights.push_back(
                    {numbering.element_unknowns(e)[n * a + c],
                     force * shares[a]});
              }
          }
      }

      /** Calls @p action for the rigid parts of all kinds. */
      template <class Action>
      void for_each_body(const Action &action) const
      {
        std::for_each(bodies.in_plane.begin(), bodies.in_plane.end(), action);
        std::for_each(bodies.bars.begin(), bodies.bars.end(), action);
        std::for_each(bodies.rotating.begin(), bodies.rotating.end(), action);
      }

      /** Adds a unit force per length along component @p c to the chosen rigid
       * struts. */
      void add_along_rigid_struts(const unsigned int       c,
                                  const std::vector<bool> &chosen,
                                  AppliedLoad             &load) const
      {
        for_each_body([&](const auto &body) {
          for (const unsigned int number :
               lattice.rigid_parts[body.part].struts)
            if (const Strut &strut = lattice.struts[number]; chosen[number])
              add_shares(force_shares(body,
                                      lattice,
                                      numbering,
                                      lattice.centroid(strut),
                                      c),
                         lattice.length(strut),
                         load);
        });
      }
    };

  } // namespace

  std::vector<std::unique_ptr<Effect>> make_loads(const LatticeModel &model)
  {
    Loads loads{model, model.lattice, model.numbering, model.bodies};
    for (const JointLoadDefinition &load : model.plan.joint_loads())
      // With small rotations, follower loads keep their direction.
      if (load.follows_joint && model.plan.simulated.large_rotation)
        loads.add_following(load);
      else
        loads.add_dead(load);
    loads.add_line_loads();
    loads.add_pressures();
    loads.add_accelerations(/*with_masses=*/true);
    return loads.make_effects();
  }

  std::vector<std::unique_ptr<Effect>>
  make_strut_loads(const LatticeModel &model,
                   const Lattice      &lattice,
                   const DofNumbering &numbering)
  {
    const RigidBodies bodies = rigid_bodies(lattice, numbering);
    Loads             loads{model, lattice, numbering, bodies};
    loads.add_line_loads();
    loads.add_pressures();
    loads.add_accelerations(/*with_masses=*/false);
    return loads.make_effects();
  }
} // namespace auxfem
