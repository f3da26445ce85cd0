#ifndef auxfem_struts_effects_space_motion_h
#define auxfem_struts_effects_space_motion_h

#include <auxfem/equations/element_batches.h>
#include <auxfem/equations/node_rotations.h>
#include <auxfem/struts/beam_3d_damping.h>

/**
 * @file
 * Motion of the nodes of elements in space. Unknowns are those of one element
 * or, in lanes, of several.
 */
namespace auxfem
{
  /** Vector of three consecutive @p values, starting at unknown @p first of an
   * element. */
  template <class Unknowns>
  VectorOf<NumberAt<Unknowns>>
  vector_at(const double *values, const Unknowns &unknowns, const int first)
  {
    VectorOf<NumberAt<Unknowns>> vector;
    for (int i = 0; i < 3; ++i)
      vector[i] = value_at(values, unknowns, first + i);
    return vector;
  }

  /** Index of the rotation of node @p a. */
  inline int rotation_index(const DofNumbering &numbering,
                            const int          *unknowns,
                            const int           a)
  {
    return numbering.rotations().with(unknowns[Beam3D::n_components * a + 3]);
  }

  /** @name Rotation of node @p a. */
  ///@{
  inline const Quaternion &rotation_at(const DofNumbering &numbering,
                                       const int          *unknowns,
                                       const State        &state,
                                       const int           a)
  {
    return state.rotations[rotation_index(numbering, unknowns, a)];
  }

  inline QuaternionOf<Lanes> rotation_at(const DofNumbering &numbering,
                                         const LaneArray<const int *> &unknowns,
                                         const State                  &state,
                                         const int                     a)
  {
    LaneArray<const Quaternion *> rotations;
    for (std::size_t lane = 0; lane < n_lanes; ++lane)
      rotations[lane] = &rotation_at(numbering, unknowns[lane], state, a);
    return pack_lanes<QuaternionOf<Lanes>>(rotations);
  }
  ///@}

  /**
   * Nodes at one end of a step, with displacements relative to the first node.
   */
  template <int order>
  std::array<Beam3D::NodeOf<Lanes>, order + 1>
  nodes_in_step(const DofNumbering           &numbering,
                const LaneArray<const int *> &unknowns,
                const State                  &state)
  {
    std::array<Beam3D::NodeOf<Lanes>, order + 1> nodes;
    for (int a = 0; a <= order; ++a)
      {
        for (int c = 0; c < 3; ++c)
          nodes[a].displacement[c] =
            relative_displacement(state,
                                  unknowns,
                                  Beam3D::n_components * a + c,
                                  c);
        nodes[a].rotation = rotation_at(numbering, unknowns, state, a);
      }
    return nodes;
  }

  /** Power of nodal @p forces of elements at nodal @p rates, by local unknown;
   * those of large rotations are material. */
  template <int order, bool large_rotation>
  Lanes nodal_power(const DofNumbering           &numbering,
                    const LaneArray<const int *> &unknowns,
                    const State                  &state,
                    const Vector                 &rates,
                    const Lanes                  *forces)
  {
    Lanes sum = 0;
    for (int a = 0; a <= order; ++a)
      {
        const int             first = Beam3D::n_components * a;
        const VectorOf<Lanes> velocity =
          vector_at(rates.data(), unknowns, first);
        VectorOf<Lanes> spin = vector_at(rates.data(), unknowns, first + 3);
        if constexpr (large_rotation)
          spin = rotated(rotation_at(numbering, unknowns, state, a), spin);
        for (int i = 0; i < 3; ++i)
          sum +=
            forces[first + i] * velocity[i] + forces[first + 3 + i] * spin[i];
      }
    return sum;
  }

  /** Motion of the nodes with large rotations. */
  template <int order, bool damped, class Number>
  struct RotatingMotion
  {
    Beam3D::NodeOf<Number>         nodes[order + 1];
    Beam3D::NodeVelocityOf<Number> velocities[damped ? order + 1 : 1];

    /** @param v velocities of all local unknowns, used only if damped. */
    template <class Unknowns>
    void gather(const DofNumbering            &numbering,
                const Unknowns                &unknowns,
                const State                   &state,
                [[maybe_unused]] const double *v)
    {
      for (int a = 0; a <= order; ++a)
        {
          const int  first    = Beam3D::n_components * a;
          const auto rotation = rotation_at(numbering, unknowns, state, a);
          nodes[a] = {vector_at(state.displacement.data(), unknowns, first),
                      rotation};
          if constexpr (damped)
            velocities[a] = {vector_at(v, unknowns, first),
                             rotated(rotation,
                                     vector_at(v, unknowns, first + 3))};
        }
    }
  };

  /** Unknowns and velocities of the small-displacement form. */
  template <int order, bool damped, class Number>
  struct SmallMotion
  {
    static constexpr int n = Beam3D::n_components * (order + 1);
    Number               u[n];
    Number               v[damped ? n : 1] = {};

    /** Gathers as RotatingMotion::gather(). */
    template <class Unknowns>
    void gather(const DofNumbering & /*numbering*/,
                const Unknowns                &unknowns,
                const State                   &state,
                [[maybe_unused]] const double *velocities)
    {
      for (int i = 0; i < n; ++i)
        {
          u[i] = value_at(state.displacement.data(), unknowns, i);
          if constexpr (damped)
            v[i] = value_at(velocities, unknowns, i);
        }
    }
  };

  /** Derivative of the angular velocity omega = P W of node @p a by its spin:
   * omega rotates with the section, and W follows the step. */
  template <int order>
  TensorOf<Lanes>
  angular_velocity_by_spin(const DofNumbering                       &numbering,
                           const LaneArray<const int *>             &unknowns,
                           const Evaluation                         &evaluation,
                           const int                                 a,
                           const RotatingMotion<order, true, Lanes> &motion,
                           const TangentFactors                     &factors)
  {
    const NodeRotations    rotations(numbering);
    LaneArray<SpaceTensor> increments;
    for (std::size_t lane = 0; lane < n_lanes; ++lane)
      increments[lane] = rotations.increment_by_spin(
        evaluation,
        rotation_index(numbering, unknowns[lane], a));
    return -factors.stiffness *
      cross_product_tensor(motion.velocities[a].angular) +
      factors.damping *
      rotated(motion.nodes[a].rotation,
              pack_lanes<TensorOf<Lanes>>(increments));
  }
} // namespace auxfem

#endif
