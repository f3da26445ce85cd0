#include <auxfem/algebra/dense_block.h>
#include <auxfem/mesh/sets.h>
#include <auxfem/model/rigid_bodies.h>
#include <auxfem/parameters/errors.h>
#include <auxfem/parameters/numerical_limits.h>

#include <algorithm>
#include <numeric>
#include <set>

namespace auxfem
{
  namespace
  {
    /** Rotary inertia about axes perpendicular to the base, zz in the plane (kg
     * m2). */
    template <int dim>
    double transverse_inertia(const RigidPart              &part,
                              const dealii::Tensor<1, dim> &base)
    {
      const dealii::Tensor<2, 3> &inertia = part.rotary_inertia;
      if constexpr (dim == 2)
        return inertia[2][2];
      else
        return (trace(inertia) - base * (inertia * base) / base.norm_square()) /
          2;
    }

    template <int dim>
    NaturalBody<dim> natural_body(const unsigned int  number,
                                  const Lattice      &lattice,
                                  const DofNumbering &numbering)
    {
      const RigidPart        &part = lattice.rigid_parts[number];
      const dealii::Point<3> &r0   = lattice.joints[part.joints[0]],
                             &r1   = lattice.joints[part.joints[1]];
      NaturalBody<dim> body;
      body.part = number;
      for (unsigned int i = 0; i < 2 * dim; ++i)
        body.base[i] = numbering.joint_unknown(part.joints[i / dim], i % dim);
      body.rest   = in_dimension<dim>(r1 - r0);
      body.length = body.rest.norm();
      body.centre = position_in<dim>(part, lattice, part.centre_of_mass);
      body.mass =
        rigid_mass_matrix<dim>(part.mass,
                               transverse_inertia<dim>(part, body.rest),
                               body.length,
                               body.centre);
      body.owned = numbering.layout().is_owned(
        numbering.constraints().multiplier(number, 0));
      return body;
    }

    /** Minimum-norm weights w_k with sum_k w_k @p arms_k = @p target. Writes
     * the part of the target outside their span to @p rest. */
    std::vector<double> weights_of(const std::vector<SpaceVector> &arms,
                                   const SpaceVector              &target,
                                   SpaceVector                    &rest)
    {
      dealii::Tensor<2, 3> spread;
      for (const SpaceVector &arm : arms)
        spread += dealii::outer_product(arm, arm);
      const auto  axes = principal_axes(spread);
      SpaceVector dual;
      rest = target;
      for (const auto &[value, axis] : axes)
        if (value > round_off * axes[0].value)
          {
            const double along = target * axis;
            dual += along / value * axis;
            rest -= along * axis;
          }
      std::vector<double> weights;
      for (const SpaceVector &arm : arms)
        weights.push_back(arm * dual);
      return weights;
    }

    /** Joint positions of @p part relative to its centre of mass (m). */
    std::vector<SpaceVector> arms_of(const RigidPart &part,
                                     const Lattice   &lattice)
    {
      std::vector<SpaceVector> arms;
      for (const unsigned int joint : part.joints)
        arms.push_back(lattice.joints[joint] - part.centre_of_mass);
      return arms;
    }
  } // namespace

  void refuse_unsupported_load_point(const RigidPart        &part,
                                     const Lattice          &lattice,
                                     const dealii::Point<3> &point)
  {
    if (!part.has_rotation)
      return;
    const std::vector<SpaceVector> arms = arms_of(part, lattice);
    SpaceVector                    rest;
    weights_of(arms, SpaceVector(point - part.centre_of_mass), rest);
    if (rest.norm() > input_precision * arms.front().norm())
      throw InputError("Loads: a line load on a rigid arc acts beside the "
                       "joints and the centre of mass of its part. Give the "
                       "part a joint beside the line of its joints, or load "
                       "joints (Type = joint).");
  }

  RigidBodies rigid_bodies(const Lattice      &lattice,
                           const DofNumbering &numbering)
  {
    RigidBodies bodies;
    for (const unsigned int number : numbering.constraints().rigid_parts())
      if (lattice.rigid_parts[number].has_rotation)
        {
          RotatingBody body;
          body.part = number;
          for (unsigned int c = 0; c < 3; ++c)
            {
              body.centre[c] = numbering.constraints().motion(number, c);
              body.rotation[c] =
                numbering.constraints().motion(number, first_rotation + c);
            }
          body.owned = numbering.layout().is_owned(
            numbering.constraints().multiplier(number, 0));
          bodies.rotating.push_back(body);
        }
      else if (lattice.dimension == 3)
        bodies.bars.push_back(natural_body<3>(number, lattice, numbering));
      else
        bodies.in_plane.push_back(natural_body<2>(number, lattice, numbering));
    return bodies;
  }

  template <int dim>
  ForceShares force_shares(const NaturalBody<dim> &body,
                           const Lattice          &lattice,
                           const DofNumbering & /*numbering*/,
                           const dealii::Point<3> &point,
                           const unsigned int      component)
  {
    const std::array<double, 2 *dim> shares = shape<dim>(
      position_in<dim>(lattice.rigid_parts[body.part], lattice, point),
      component);
    ForceShares result;
    for (unsigned int i = 0; i < 2 * dim; ++i)
      result.emplace_back(body.base[i], shares[i]);
    return result;
  }

  template ForceShares force_shares<2>(const NaturalBody<2> &,
                                       const Lattice &,
                                       const DofNumbering &,
                                       const dealii::Point<3> &,
                                       unsigned int);
  template ForceShares force_shares<3>(const NaturalBody<3> &,
                                       const Lattice &,
                                       const DofNumbering &,
                                       const dealii::Point<3> &,
                                       unsigned int);

  ForceShares force_shares(const RotatingBody     &body,
                           const Lattice          &lattice,
                           const DofNumbering     &numbering,
                           const dealii::Point<3> &point,
                           const unsigned int      component)
  {
    const RigidPart               &part   = lattice.rigid_parts[body.part];
    const std::vector<SpaceVector> arms   = arms_of(part, lattice);
    const SpaceVector              target = point - part.centre_of_mass;
    SpaceVector                    rest;
    const std::vector<double>      weights = weights_of(arms, target, rest);
    ForceShares                    result;
    double                         on_centre = 1;
    for (unsigned int k = 0; k < weights.size(); ++k)
      {
        result.emplace_back(numbering.joint_unknown(part.joints[k], component),
                            weights[k]);
        on_centre -= weights[k];
      }
    result.emplace_back(body.centre[component], on_centre);
    return result;
  }

  namespace
  {
    /** A position with its share of a part's mass. */
    struct Portion
    {
      dealii::Point<3> position;
      double           share;
    };

    /** Quadrature points of mass spread evenly along the struts of @p part. */
    std::vector<Portion> along_struts(const Lattice   &lattice,
                                      const RigidPart &part)
    {
      double               length = 0;
      std::vector<Portion> portions;
      for (const unsigned int strut : part.struts)
        length += lattice.length(lattice.struts[strut]);
      for (const unsigned int number : part.struts)
        {
          const Strut &strut = lattice.struts[number];
          const double share = lattice.length(strut) / length;
          for (const auto &[position, weight] : lattice.uniform_points(strut))
            portions.push_back({position, weight * share});
        }
      return portions;
    }

    std::vector<Portion> on_joints(const Lattice   &lattice,
                                   const RigidPart &part)
    {
      std::vector<Portion> portions;
      for (const unsigned int joint : part.joints)
        portions.push_back({lattice.joints[joint], 1. / part.joints.size()});
      return portions;
    }

    /** Adds the inertia of a point mass (kg) at @p arm (m) from the centre. */
    void add_inertia(const double                mass,
                     const dealii::Tensor<1, 3> &arm,
                     dealii::Tensor<2, 3>       &inertia)
    {
      for (unsigned int i = 0; i < 3; ++i)
        for (unsigned int j = 0; j < 3; ++j)
          inertia[i][j] +=
            mass * ((i == j ? arm.norm_square() : 0.) - arm[i] * arm[j]);
    }

    /** Whether joints and mass lie on the line of the base joints. */
    bool lie_on_base_line(const Lattice              &lattice,
                          const RigidPart            &part,
                          const std::vector<Portion> &portions)
    {
      const dealii::Point<3>     origin = lattice.joints[part.joints[0]];
      const dealii::Tensor<1, 3> base = lattice.joints[part.joints[1]] - origin;
      const auto is_on_line           = [&](const dealii::Point<3> &point) {
        return dealii::cross_product_3d(base, point - origin).norm() <=
          input_precision * base.norm_square();
      };
      return std::all_of(part.joints.begin(),
                         part.joints.end(),
                         [&](const unsigned int joint) {
                           return is_on_line(lattice.joints[joint]);
                         }) &&
        std::all_of(portions.begin(),
                    portions.end(),
                    [&](const Portion &portion) {
                      return is_on_line(portion.position);
                    });
    }

    void set_mass(const RigidPartDefinition &definition,
                  const Lattice             &lattice,
                  RigidPart                 &part)
    {
      const std::vector<Portion> portions = part.struts.empty()
        ? on_joints(lattice, part)
        : along_struts(lattice, part);
      part.mass                           = definition.mass;
      for (const Portion &portion : portions)
        part.centre_of_mass += portion.share * portion.position;
      for (const Portion &portion : portions)
        add_inertia(part.mass * portion.share,
                    portion.position - part.centre_of_mass,
                    part.rotary_inertia);
      if (definition.rotary_inertia)
        {
          part.rotary_inertia = 0;
          for (unsigned int c = 0; c < 3; ++c)
            part.rotary_inertia[c][c] = (*definition.rotary_inertia)[c];
        }
      part.has_rotation = lattice.dimension == 3 &&
        (part.clamps_struts || !lie_on_base_line(lattice, part, portions));
    }

    /** Records clamped joints and rejects a second part that clamps the same
     * joint.
     * @param clamped_to clamping part by joint, or invalid_index; updated for
     *   @p part, the next part */
    void clamp_once(const RigidPartDefinition &definition,
                    const Scene               &scene,
                    const Lattice             &lattice,
                    const RigidPart           &part,
                    std::vector<unsigned int> &clamped_to)
    {
      if (!part.clamps_struts || lattice.dimension == 2)
        return;
      for (const unsigned int joint : part.joints)
        {
          if (clamped_to[joint] != invalid_index)
            throw InputError(
              definition.path +
              "/Elastic struts = clamped: the elastic struts at joint " +
              std::to_string(joint) + " are clamped to a part of " +
              scene
                .rigid_parts[lattice.rigid_parts[clamped_to[joint]].definition]
                .path +
              " already. Set hinged for one of the two, or make one part of "
              "them (Parts = struts that meet).");
          clamped_to[joint] = lattice.rigid_parts.size();
        }
    }

    /** Moves the joint farthest from the first to the second place. Throws if
     * all joints coincide. */
    void choose_base(const RigidPartDefinition &definition,
                     const Lattice             &lattice,
                     RigidPart                 &part)
    {
      const auto distance = [&](const unsigned int joint) {
        return lattice.joints[joint].distance(
          lattice.joints[part.joints.front()]);
      };
      if (part.joints.size() < 2)
        throw InputError(definition.path +
                         "/Joints: a rigid part needs at least two joints, but "
                         "joint " +
                         std::to_string(part.joints.front()) +
                         " is alone. Name more joints.");
      const auto farthest =
        std::max_element(part.joints.begin() + 1,
                         part.joints.end(),
                         [&](const unsigned int a, const unsigned int b) {
                           return distance(a) < distance(b);
                         });
      if (!(distance(*farthest) > 0))
        throw InputError(definition.path + ": joints " +
                         std::to_string(part.joints.front()) + " and " +
                         std::to_string(*farthest) +
                         " lie at one position, so the part has no direction. "
                         "Leave one of them out.");
      std::iter_swap(part.joints.begin() + 1, farthest);
    }

    void add_part(const Scene                     &scene,
                  const unsigned int               definition_number,
                  const std::vector<unsigned int> &struts,
                  const std::vector<unsigned int> &joints,
                  Lattice                         &lattice,
                  std::vector<unsigned int>       &clamped_to)
    {
      const RigidPartDefinition &definition =
        scene.rigid_parts[definition_number];
      RigidPart part;
      part.struts        = struts;
      part.joints        = joints;
      part.definition    = definition_number;
      part.clamps_struts = definition.clamps_struts;
      choose_base(definition, lattice, part);
      set_mass(definition, lattice, part);
      clamp_once(definition, scene, lattice, part, clamped_to);
      for (const unsigned int strut : struts)
        lattice.struts[strut].rigid_part = lattice.rigid_parts.size();
      if (!struts.empty())
        part.cell = lattice.struts[struts.front()].cell;
      lattice.rigid_parts.push_back(std::move(part));
    }

    std::vector<unsigned int> joints_of(const Lattice &lattice,
                                        const std::vector<unsigned int> &struts)
    {
      std::set<unsigned int> joints;
      for (const unsigned int strut : struts)
        joints.insert(lattice.struts[strut].joints.begin(),
                      lattice.struts[strut].joints.end());
      return {joints.begin(), joints.end()};
    }

    /** Groups of @p struts connected through common joints. */
    std::vector<std::vector<unsigned int>>
    connected_groups(const Lattice                   &lattice,
                     const std::vector<unsigned int> &struts)
    {
      std::vector<unsigned int> parent(lattice.joints.size());
      std::iota(parent.begin(), parent.end(), 0u);
      const auto root = [&parent](unsigned int joint) {
        while (parent[joint] != joint)
          joint = parent[joint] = parent[parent[joint]];
        return joint;
      };
      for (const unsigned int strut : struts)
        parent[root(lattice.struts[strut].joints[0])] =
          root(lattice.struts[strut].joints[1]);
      std::map<unsigned int, std::vector<unsigned int>> by_root;
      for (const unsigned int strut : struts)
        by_root[root(lattice.struts[strut].joints[0])].push_back(strut);
      std::vector<std::vector<unsigned int>> groups;
      for (const auto &group : by_root)
        groups.push_back(group.second);
      std::sort(groups.begin(), groups.end());
      return groups;
    }

    void refuse_second_definition(const Scene                     &scene,
                                  const RigidPartDefinition       &definition,
                                  const std::vector<unsigned int> &struts,
                                  const Lattice                   &lattice)
    {
      for (const unsigned int strut : struts)
        if (lattice.struts[strut].is_rigid())
          {
            const RigidPart &other =
              lattice.rigid_parts[lattice.struts[strut].rigid_part];
            throw InputError(definition.path + "/Struts: strut " +
                             std::to_string(strut) + " belongs to " +
                             scene.rigid_parts[other.definition].path +
                             " already. Take it out of one of the two.");
          }
    }
  } // namespace

  void make_rigid_parts(const Scene &scene, Lattice &lattice)
  {
    std::vector<unsigned int> clamped_to(lattice.joints.size(), invalid_index);
    for (unsigned int d = 0; d < scene.rigid_parts.size(); ++d)
      {
        const RigidPartDefinition &definition = scene.rigid_parts[d];
        if (!definition.joints.empty())
          {
            add_part(scene,
                     d,
                     {},
                     joints_of(definition, lattice, scene.context),
                     lattice,
                     clamped_to);
            continue;
          }
        const std::vector<unsigned int> struts =
          struts_of(definition, lattice, scene.context);
        refuse_second_definition(scene, definition, struts, lattice);
        std::vector<std::vector<unsigned int>> groups;
        if (definition.single_struts)
          for (const unsigned int strut : struts)
            groups.push_back({strut});
        else
          groups = connected_groups(lattice, struts);
        for (const std::vector<unsigned int> &group : groups)
          add_part(scene,
                   d,
                   group,
                   joints_of(lattice, group),
                   lattice,
                   clamped_to);
      }
  }

  std::vector<bool> joints_of_rigid_parts(const Lattice &lattice)
  {
    std::vector<bool> is_of_part(lattice.joints.size(), false);
    for (const RigidPart &part : lattice.rigid_parts)
      for (const unsigned int joint : part.joints)
        is_of_part[joint] = true;
    return is_of_part;
  }

  std::vector<unsigned int>
  rigid_parts_of(const Lattice                   &lattice,
                 const std::vector<unsigned int> &struts)
  {
    std::set<unsigned int> parts;
    for (const unsigned int strut : struts)
      if (lattice.struts[strut].is_rigid())
        parts.insert(lattice.struts[strut].rigid_part);
    return {parts.begin(), parts.end()};
  }
} // namespace auxfem
