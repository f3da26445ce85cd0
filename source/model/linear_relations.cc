#include <auxfem/mathematics/rotation.h>
#include <auxfem/mesh/periodic_array.h>
#include <auxfem/mesh/sets.h>
#include <auxfem/model/linear_relations.h>
#include <auxfem/model/unknown_records.h>
#include <auxfem/parameters/errors.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

namespace auxfem
{
  namespace
  {
    using Term = LinearRelation::Term;

    /** Relations that make successive joints of a set move alike. */
    void add_equal_motions(const ConstraintDefinition      &definition,
                           const std::vector<unsigned int> &joints,
                           const double                     length,
                           std::vector<LinearRelation>     &relations)
    {
      if (joints.size() == 1)
        throw InputError(definition.path + "/Joints = " + definition.joints +
                         ": one joint alone needs no constraint. Name at least "
                         "two joints, or hold it by a support.");
      for (std::size_t i = 1; i < joints.size(); ++i)
        for (unsigned int c = 0; c < n_motion_components; ++c)
          if (definition.components[c])
            {
              const double factor = c < first_rotation ? 1. : length;
              relations.push_back({definition.path,
                                   {Term{{joints[i - 1], c}, factor},
                                    Term{{joints[i], c}, -factor}}});
            }
    }

    /** Unit vectors across the direction of a line: one in the plane, two in
     * space. */
    std::vector<dealii::Tensor<1, 3>>
    directions_across(const dealii::Tensor<1, 3> &direction,
                      const unsigned int          dimension)
    {
      dealii::Tensor<1, 3> across;
      if (dimension == 2)
        {
          across[0] = -direction[1];
          across[1] = direction[0];
          return {across};
        }
      const SpaceTensor frame =
        section_frame(direction, default_reference(direction));
      std::vector<dealii::Tensor<1, 3>> both(2);
      for (unsigned int c = 0; c < 3; ++c)
        for (unsigned int i = 0; i < 2; ++i)
          both[i][c] = frame[c][1 + i];
      return both;
    }

    void add_line(const ConstraintDefinition      &definition,
                  const std::vector<unsigned int> &joints,
                  const unsigned int               dimension,
                  std::vector<LinearRelation>     &relations)
    {
      for (const auto &across :
           directions_across(definition.direction, dimension))
        for (const unsigned int joint : joints)
          {
            LinearRelation relation = {definition.path, {}};
            for (unsigned int c = 0; c < dimension; ++c)
              if (across[c] != 0)
                relation.terms.push_back({{joint, c}, across[c]});
            relations.push_back(relation);
          }
    }

    /** Sum of the terms of a `linear relation`, each motion once. */
    std::map<std::pair<unsigned int, unsigned int>, double>
    sum_of_terms(const ConstraintDefinition &definition,
                 const Scene                &scene,
                 const Lattice              &lattice)
    {
      std::map<std::pair<unsigned int, unsigned int>, double> sum;
      for (const ConstraintDefinition::Term &term : definition.terms)
        {
          const std::vector<unsigned int> joints =
            select_joints(lattice,
                          term.joints,
                          scene.context,
                          definition.path + "/Relation");
          for (const unsigned int joint : joints)
            sum[{joint, term.component}] += term.coefficient / joints.size();
        }
      return sum;
    }

    void add_relation(const ConstraintDefinition  &definition,
                      const Scene                 &scene,
                      const Lattice               &lattice,
                      const double                 length,
                      std::vector<LinearRelation> &relations)
    {
      LinearRelation relation = {definition.path, {}};
      double         largest  = 0;
      for (const auto &[motion, coefficient] :
           sum_of_terms(definition, scene, lattice))
        if (coefficient != 0)
          {
            relation.terms.push_back(
              {{motion.first, motion.second}, coefficient});
            if (motion.second < first_rotation)
              largest = std::max(largest, std::abs(coefficient));
          }
      if (relation.terms.empty())
        throw InputError(definition.path +
                         "/Relation: the terms cancel each other. Name "
                         "different motions, or remove the constraint.");
      // Relations of rotations alone have coefficients without unit.
      const double factor = largest > 0 ? 1 / largest : length;
      for (Term &term : relation.terms)
        term.coefficient *= factor;
      relations.push_back(relation);
    }
  } // namespace

  std::vector<ImageTie> image_ties(const Lattice                   &lattice,
                                   const std::vector<JointRelease> &releases)
  {
    std::vector<ImageTie> ties;
    if (!lattice.periodicity)
      return ties;
    const std::vector<RotationOwner> rotations =
      joint_rotations(lattice, ties_of(releases, lattice).released);
    for (const JointImage &image : lattice.periodicity->images)
      for (unsigned int c = 0; c < n_motion_components; ++c)
        if (c < first_rotation
              ? c < lattice.dimension
              : rotations[image.joint].kind != RotationOwner::Kind::ground &&
                (lattice.dimension == 3 || is_in_plane(c)))
          ties.push_back({image.joint, image.base, c, image.shift});
    return ties;
  }

  std::vector<LinearRelation>
  periodic_relations(const Lattice                   &lattice,
                     const std::vector<JointRelease> &releases,
                     const double                     length)
  {
    std::vector<LinearRelation> relations;
    for (const ImageTie &tie : image_ties(lattice, releases))
      {
        const bool   moves  = tie.component < first_rotation;
        const double factor = moves ? 1. : length;
        relations.push_back({"Infinite lattice",
                             {Term{{tie.image, tie.component}, factor},
                              Term{{tie.base, tie.component}, -factor}},
                             !moves && lattice.dimension == 3});
        if (!moves)
          continue;
        const auto distance = lattice.periodicity->translation(tie.shift) /
          lattice.periodicity->length();
        for (unsigned int d = 0; d < lattice.n_axes; ++d)
          if (distance[d] != 0)
            relations.back().terms.push_back(
              {{lattice.joint_of_axis(d), tie.component}, -distance[d]});
      }
    return relations;
  }

  std::vector<LinearRelation> linear_relations(const Scene   &scene,
                                               const Lattice &lattice,
                                               const double   length)
  {
    std::vector<LinearRelation> relations;
    for (const ConstraintDefinition &definition : scene.constraints)
      if (definition.type == ConstraintDefinition::Type::relation)
        add_relation(definition, scene, lattice, length, relations);
      else
        {
          const std::vector<unsigned int> joints =
            joints_of(definition, lattice, scene.context);
          if (definition.type == ConstraintDefinition::Type::line)
            add_line(definition, joints, lattice.dimension, relations);
          else
            add_equal_motions(definition, joints, length, relations);
        }
    return relations;
  }

  void check_relations(const std::vector<LinearRelation> &relations,
                       const DofNumbering                &numbering,
                       const bool                         large_rotation)
  {
    for (const LinearRelation &relation : relations)
      for (const Term &term : relation.terms)
        {
          const auto [joint, component] = term.motion;
          if (component < first_rotation)
            continue;
          if (large_rotation && numbering.lattice().dimension == 3 &&
              !relation.is_of_equal_rotations)
            throw InputError(
              relation.path +
              ": large rotations in space do not add up by components. Use "
              "Rigid parts to turn joints alike, or set Effects/Large rotation "
              "= off.");
          if (!numbering.joint_has(joint, component))
            throw InputError(relation.path + ": " +
                             missing_rotation_reason(numbering, joint));
        }
  }
} // namespace auxfem
