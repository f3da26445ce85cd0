#include <auxfem/algebra/principal_axes.h>
#include <auxfem/model/rigid_bodies.h>
#include <auxfem/parameters/errors.h>
#include <auxfem/parameters/numerical_limits.h>

namespace auxfem
{
  namespace
  {
    /** About the axes across the base, zz in the plane (kg m2). */
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

    /**
     * Weights w_k with sum_k w_k @p arms_k = @p target, the smallest there are;
     * what is left of target, if it is not in their span, into @p rest.
     */
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

    /** The joints of @p part about its centre of mass (m). */
    std::vector<SpaceVector> arms_of(const RigidPart &part,
                                     const Lattice   &lattice)
    {
      std::vector<SpaceVector> arms;
      for (const unsigned int joint : part.joints)
        arms.push_back(lattice.joints[joint] - part.centre_of_mass);
      return arms;
    }
  } // namespace

  void refuse_point_beside(const RigidPart        &part,
                           const Lattice          &lattice,
                           const dealii::Point<3> &point)
  {
    if (!part.has_rotation)
      return;
    const std::vector<SpaceVector> arms = arms_of(part, lattice);
    SpaceVector                    rest;
    weights_of(arms, SpaceVector(point - part.centre_of_mass), rest);
    if (rest.norm() > given_digits * arms.front().norm())
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
} // namespace auxfem
