#include <auxfem/mathematics/rotation.h>
#include <auxfem/mesh/sets.h>
#include <auxfem/model/initial_velocities.h>
#include <auxfem/model/load_history.h>
#include <auxfem/model/unknown_records.h>
#include <auxfem/parameters/errors.h>
#include <auxfem/parameters/numerical_limits.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <sstream>

namespace auxfem
{
  namespace
  {
    SpaceVector part(const JointVelocity &velocity, const unsigned int first)
    {
      return SpaceVector(
        {velocity[first], velocity[first + 1], velocity[first + 2]});
    }

    /** Component of the spin along the unit vector @p axis. */
    SpaceVector along(const SpaceVector &axis, const SpaceVector &spin)
    {
      return (axis * spin) * axis;
    }
  } // namespace

  StrutVelocities::StrutVelocities(const std::array<MovingEnd, 2> &ends)
    : begin(ends[0].position)
    , chord(ends[1].position - ends[0].position)
    , velocity(part(ends[0].velocity, 0))
  {
    const double      length = chord.norm();
    const SpaceVector axis   = chord / length,
                      apart  = part(ends[1].velocity, 0) - velocity;
    const std::array<SpaceVector, 2> spins = {
      {part(ends[0].velocity, first_rotation),
       part(ends[1].velocity, first_rotation)}};
    // If one end is free to twist, the strut follows the other end.
    const SpaceVector about_axis = ends[0].is_released == ends[1].is_released
      ? (spins[0] + spins[1]) / 2.
      : spins[ends[0].is_released ? 1 : 0];
    angular_velocity =
      dealii::cross_product_3d(axis, apart) / length + along(axis, about_axis);
    lengthening = along(axis, apart);
    for (unsigned int i = 0; i < 2; ++i)
      if (!ends[i].is_released)
        {
          const SpaceVector against = spins[i] - angular_velocity;
          twist[i]                  = along(axis, against);
          bending[i]                = against - twist[i];
        }
    // A released end has no moment: slope of a propped beam.
    for (unsigned int i = 0; i < 2; ++i)
      if (ends[i].is_released)
        {
          bending[i] =
            ends[1 - i].is_released ? SpaceVector() : -0.5 * bending[1 - i];
          twist[i] = twist[1 - i];
        }
  }

  JointVelocity StrutVelocities::at(const double            fraction,
                                    const dealii::Point<3> &position) const
  {
    const double      s = fraction, rest = 1 - fraction;
    const SpaceVector deflection = s * rest * rest * bending[0] -
      s * s * rest * bending[1],
                      slope = rest * (1 - 3 * s) * bending[0] +
      s * (3 * s - 2) * bending[1] + rest * twist[0] + s * twist[1];
    const SpaceVector from_begin = position - begin;
    const SpaceVector moving     = velocity +
      dealii::cross_product_3d(angular_velocity, from_begin) + s * lengthening +
      dealii::cross_product_3d(deflection, chord) +
      dealii::cross_product_3d(slope, from_begin - s * chord);
    const SpaceVector spin = angular_velocity + slope;
    JointVelocity     result;
    for (unsigned int c = 0; c < 3; ++c)
      {
        result[c]                  = moving[c];
        result[first_rotation + c] = spin[c];
      }
    return result;
  }

  namespace
  {
    /** Velocity at a point of a body that moves with @p velocity at
     * @p centre. */
    JointVelocity velocity_at(const dealii::Point<3> &point,
                              const dealii::Point<3> &centre,
                              const JointVelocity    &velocity)
    {
      const SpaceVector rotational =
        dealii::cross_product_3d(SpaceVector(
                                   {velocity[3], velocity[4], velocity[5]}),
                                 point - centre);
      JointVelocity result = velocity;
      for (unsigned int c = 0; c < 3; ++c)
        result[c] += rotational[c];
      return result;
    }

    double norm(const JointVelocity &velocity, const unsigned int first)
    {
      return std::hypot(std::hypot(velocity[first], velocity[first + 1]),
                        velocity[first + 2]);
    }

    /** Velocity of a joint set by a definition. */
    struct DefinedVelocity
    {
      const InitialVelocityDefinition *definition;
      JointVelocity                    velocity;
      double largest_speed; ///< of all joints of the definition (m/s)

      /** Reference size for tolerances of a component (m/s, rad/s). */
      double size(const unsigned int component) const
      {
        return component < first_rotation ? largest_speed
                                          : norm(velocity, first_rotation);
      }
    };

    /** Joints of one definition, which move as a rigid body. */
    struct MovingSet
    {
      const InitialVelocityDefinition *definition;
      std::vector<unsigned int>        joints;
      std::vector<bool>                chosen; ///< by joint of the lattice
      dealii::Point<3>                 centre;

      bool turns() const
      {
        const JointVelocity &v = definition->velocity;
        return v[3] != 0 || v[4] != 0 || v[5] != 0;
      }

      bool has_all(const std::vector<unsigned int> &others) const
      {
        return std::all_of(others.begin(), others.end(), [&](const auto joint) {
          return chosen[joint];
        });
      }
    };

    class InitialVelocities
    {
    public:
      InitialVelocities(const RunPlan      &plan,
                        const Lattice      &lattice,
                        const DofNumbering &numbering)
        : plan(plan)
        , lattice(lattice)
        , numbering(numbering)
        , joint_velocities(lattice.joints.size())
        , spins_of_parts(lattice.rigid_parts.size())
      {
        find_rotating_parts();
        for (const InitialVelocityDefinition &definition :
             plan.initial_velocities())
          apply(definition);
        refuse_supported();
        for (unsigned int j = 0; j < joint_velocities.size(); ++j)
          if (joint_velocities[j])
            move_joint(j, joint_velocities[j]->velocity);
        for (unsigned int e = 0; e < numbering.elements().size(); ++e)
          move_element(e);
      }

      std::vector<std::pair<int, double>> by_unknown() const
      {
        return {velocities.begin(), velocities.end()};
      }

    private:
      void find_rotating_parts()
      {
        for (unsigned int p = 0; p < lattice.rigid_parts.size(); ++p)
          if (lattice.rigid_parts[p].has_rotation)
            rotating_parts
              [numbering.global().rigid_parts[p].motion[rotation_z]] = p;
        for (const unsigned int p : numbering.constraints().rigid_parts())
          if (lattice.rigid_parts[p].has_rotation)
            for (const unsigned int c : numbering.components())
              rigid_part_unknowns.insert(numbering.constraints().motion(p, c));
      }

      void apply(const InitialVelocityDefinition &definition)
      {
        MovingSet set{&definition,
                      joints_of(definition, lattice, plan.scene.context),
                      std::vector<bool>(lattice.joints.size(), false),
                      {}};
        for (const unsigned int joint : set.joints)
          {
            set.chosen[joint] = true;
            set.centre += lattice.joints[joint] / double(set.joints.size());
          }
        refuse_lost_rotation(set);
        move_joints(set);
        for (unsigned int p = 0; p < lattice.rigid_parts.size(); ++p)
          if (lattice.rigid_parts[p].has_rotation &&
              set.has_all(lattice.rigid_parts[p].joints))
            spins_of_parts[p] = definition.velocity;
        for (const unsigned int p : numbering.constraints().rigid_parts())
          if (lattice.rigid_parts[p].has_rotation &&
              set.has_all(lattice.rigid_parts[p].joints))
            move_rigid_part(p, set);
      }

      void move_joints(const MovingSet &set)
      {
        std::vector<JointVelocity> set_velocities;
        double                     largest_speed = 0;
        for (const unsigned int joint : set.joints)
          {
            set_velocities.push_back(velocity_at(lattice.joints[joint],
                                                 set.centre,
                                                 set.definition->velocity));
            largest_speed =
              std::max(largest_speed, norm(set_velocities.back(), 0));
          }
        for (unsigned int i = 0; i < set.joints.size(); ++i)
          joint_velocities[set.joints[i]] = {set.definition,
                                             set_velocities[i],
                                             largest_speed};
      }

      /** Rigid part whose rotation a joint shares, if any. */
      std::optional<unsigned int>
      rotating_part_of(const unsigned int joint) const
      {
        const auto found =
          rotating_parts.find(numbering.global().joints[joint][rotation_z]);
        if (found == rotating_parts.end())
          return {};
        return found->second;
      }

      /** Rejects an angular velocity of a single joint without a free
       * rotation. */
      void refuse_lost_rotation(const MovingSet &set) const
      {
        if (!set.turns() || set.joints.size() > 1)
          return;
        const unsigned int joint = set.joints.front();
        const std::string  found = set.definition->path + "/Angular velocity: ";
        if (!numbering.joint_has(joint, rotation_z))
          throw InputError(
            found + missing_rotation_reason(numbering, joint) +
            " To turn a rigid part, name all its joints in one set.");
        if (const std::optional<unsigned int> part = rotating_part_of(joint);
            part && !set.has_all(lattice.rigid_parts[*part].joints))
          throw InputError(found + "joint " + std::to_string(joint) +
                           " turns with a rigid part. Name all joints of the "
                           "part in one set, which turns about their mean.");
      }

      void refuse_supported() const
      {
        for (const SupportDefinition &support : plan.scene.supports)
          for (const unsigned int joint :
               joints_of(support, lattice, plan.scene.context))
            if (joint_velocities[joint])
              refuse_supported(support, joint, *joint_velocities[joint]);
      }

      void refuse_supported(const SupportDefinition &support,
                            const unsigned int       joint,
                            const DefinedVelocity   &defined) const
      {
        for (const unsigned int c : numbering.components())
          {
            const double velocity = defined.velocity[c];
            if (!support.fixed[c] || !numbering.joint_has(joint, c) ||
                std::abs(velocity) <= input_precision * defined.size(c))
              continue;
            const double allowed = support.motion[c].jet(0)[1];
            if (std::abs(velocity - allowed) <=
                input_precision * defined.size(c))
              continue;
            const char        *unit = c < first_rotation ? " m/s" : " rad/s";
            std::ostringstream message;
            message << defined.definition->path << ": the "
                    << motion_name(c, lattice.dimension) << " of joint "
                    << joint << " is prescribed by " << support.path
                    << " and starts with " << allowed << unit << ", not with "
                    << velocity << unit
                    << ". Take the joint out of the set, give it another "
                       "velocity in a later one, or give the support a motion "
                       "that starts so.";
            throw InputError(message.str());
          }
      }

      void move_joint(const unsigned int joint, const JointVelocity &velocity)
      {
        for (const unsigned int c : numbering.components())
          if (const int unknown = numbering.joint_unknown(joint, c);
              unknown >= 0 && rigid_part_unknowns.count(unknown) == 0)
            velocities[unknown] = velocity[c];
      }

      void move_rigid_part(const unsigned int p, const MovingSet &set)
      {
        const JointVelocity velocity =
          velocity_at(lattice.rigid_parts[p].centre_of_mass,
                      set.centre,
                      set.definition->velocity);
        for (const unsigned int c : numbering.components())
          velocities[numbering.constraints().motion(p, c)] = velocity[c];
      }

      /** Position and velocity of a strut end; known on every rank, since
       * struts cross rank boundaries. */
      MovingEnd end_of(const unsigned int strut, const unsigned int end) const
      {
        const unsigned int joint = lattice.struts[strut].joints[end];
        MovingEnd          result{lattice.joints[joint],
                         joint_velocities[joint]->velocity,
                         numbering.global().released_ends.count({strut, end}) >
                           0};
        if (const std::optional<unsigned int> part = rotating_part_of(joint);
            part && !result.is_released)
          for (unsigned int c = first_rotation; c < n_motion_components; ++c)
            result.velocity[c] = spins_of_parts[*part][c];
        return result;
      }

      /** Sets the velocities of an element except at unknowns of joints. */
      void move_element(const unsigned int e)
      {
        const StrutInterval &interval = numbering.elements()[e].interval;
        const Strut         &strut    = lattice.struts[interval.strut];
        if (!joint_velocities[strut.joints[0]] ||
            !joint_velocities[strut.joints[1]])
          return;
        const std::array<MovingEnd, 2> ends = {
          {end_of(interval.strut, 0), end_of(interval.strut, 1)}};
        const StrutVelocities inside(ends);
        const LineRule        rule(numbering.elements()[e].order);
        const unsigned int    n = numbering.n_components();
        for (unsigned int a = 0; a < rule.nodes.size(); ++a)
          {
            const double         fraction = interval.at(rule.nodes[a]);
            dealii::Point<3>     position;
            dealii::Tensor<1, 3> tangent;
            lattice.axis(strut, fraction, position, tangent);
            const JointVelocity velocity = inside.at(fraction, position);
            for (unsigned int i = 0; i < n; ++i)
              {
                const int  unknown = numbering.element_unknowns(e)[n * a + i];
                const bool is_of_joint = interval.is_joint(a) &&
                  unknown ==
                    numbering.joint_unknown(strut.joints[a],
                                            numbering.components()[i]);
                if (!is_of_joint)
                  velocities[unknown] = velocity[numbering.components()[i]];
              }
          }
      }

      const RunPlan                              &plan;
      const Lattice                              &lattice;
      const DofNumbering                         &numbering;
      std::vector<std::optional<DefinedVelocity>> joint_velocities;
      /** Velocity by rigid part; a part rotates only with a set of all its
       * joints. */
      std::vector<JointVelocity> spins_of_parts;
      /** Rigid parts by the global number of their rotation. */
      std::map<int, unsigned int> rotating_parts;
      std::set<int>               rigid_part_unknowns; ///< local unknowns
      std::map<int, double>       velocities;          ///< by local unknown
    };
  } // namespace

  std::vector<std::pair<int, double>>
  initial_velocities(const RunPlan      &plan,
                     const Lattice      &lattice,
                     const DofNumbering &numbering)
  {
    if (plan.initial_velocities().empty())
      return {};
    return InitialVelocities(plan, lattice, numbering).by_unknown();
  }
} // namespace auxfem
