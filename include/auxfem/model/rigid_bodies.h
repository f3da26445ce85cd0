#ifndef auxfem_model_rigid_bodies_h
#define auxfem_model_rigid_bodies_h

#include <auxfem/mathematics/rotation.h>
#include <auxfem/mesh/lattice.h>
#include <auxfem/model/numbering.h>
#include <auxfem/rigid/rigid_part.h>
#include <auxfem/scene/scene.h>

#include <vector>

namespace auxfem
{
  /**
   * A rigid part in natural coordinates as its effects on this rank need it: a
   * body in the plane (dim = 2) or a bar in space (dim = 3).
   */
  template <int dim>
  struct NaturalBody
  {
    /** Number in Lattice::rigid_parts. */
    unsigned int part;
    /** Local unknowns r0_x, r0_y, ..., r1_x, r1_y, ... of the base. */
    std::array<int, 2 * dim> base;
    dealii::Tensor<1, dim>   rest;   ///< r1 - r0 at rest (m)
    double                   length; ///< of the base (m)
    /** Of the centre of mass. */
    NaturalPosition                   centre;
    std::array<double, 4 * dim * dim> mass; ///< on the base unknowns (kg)
    /** Whether this rank counts its energy and writes it to files. */
    bool owned;
  };

  /**
   * A rigid part in space with a rotation of its own as its effects on this
   * rank need it.
   */
  struct RotatingBody
  {
    /** Number in Lattice::rigid_parts. */
    unsigned int part;
    /** Local unknowns of the centre of mass and of the rotation. */
    std::array<int, 3> centre, rotation;
    /** As NaturalBody::counted. */
    bool owned;
  };

  /** The rigid parts kept on this rank, by kind. */
  struct RigidBodies
  {
    std::vector<NaturalBody<2>> in_plane;
    std::vector<NaturalBody<3>> bars;
    std::vector<RotatingBody>   rotating;

    bool empty() const
    {
      return in_plane.empty() && bars.empty() && rotating.empty();
    }
  };

  /** Natural position of @p point (m, at rest) in a rigid part. */
  template <int dim>
  NaturalPosition position_in(const RigidPart        &part,
                              const Lattice          &lattice,
                              const dealii::Point<3> &point)
  {
    return natural_position<dim>(lattice.joints[part.joints[0]],
                                 lattice.joints[part.joints[1]],
                                 point);
  }

  /** The rigid parts kept on this rank. */
  RigidBodies rigid_bodies(const Lattice      &lattice,
                           const DofNumbering &numbering);

  /** A local unknown and the share it gets of a force. */
  using ForceShares = std::vector<std::pair<int, double>>;

  /**
   * How a dead force along @p component at @p point (m, at rest) of a body acts
   * on its unknowns, however it turns.
   */
  template <int dim>
  ForceShares force_shares(const NaturalBody<dim> &body,
                           const Lattice          &lattice,
                           const DofNumbering     &numbering,
                           const dealii::Point<3> &point,
                           unsigned int            component);

  /**
   * Throws InputError for a @p point (m, at rest) that is no weighted mean of
   * the joints and the centre of mass of a @p part with a rotation of its own:
   * no forces on these have their resultant there. To be asked on all ranks
   * alike.
   */
  void refuse_point_beside(const RigidPart        &part,
                           const Lattice          &lattice,
                           const dealii::Point<3> &point);

  /**
   * As above: forces on the centre of mass and the joints with the same
   * resultant at the same point, which refuse_point_beside() has let pass.
   */
  ForceShares force_shares(const RotatingBody     &body,
                           const Lattice          &lattice,
                           const DofNumbering     &numbering,
                           const dealii::Point<3> &point,
                           unsigned int            component);

  /**
   * Makes the rigid parts of @p scene in @p lattice: struts of the definitions
   * become rigid (and lose their section), struts that meet at a joint and are
   * of one definition become one part unless they are to be parts of their own.
   * Mass is spread evenly along the struts, or equally over the joints of a
   * part without struts.
   *
   * Throws InputError for a strut of two definitions, a part of fewer than two
   * joints or of joints at one position.
   */
  void make_rigid_parts(const Scene &scene, Lattice &lattice);

  /** For every joint of @p lattice whether it is one of a rigid part. */
  std::vector<bool> joints_of_rigid_parts(const Lattice &lattice);

  /** The parts that struts of @p struts belong to, each once, in order. */
  std::vector<unsigned int>
  rigid_parts_of(const Lattice                   &lattice,
                 const std::vector<unsigned int> &struts);
} // namespace auxfem

#endif
