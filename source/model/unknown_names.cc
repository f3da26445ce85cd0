#include <auxfem/algebra/shared_work.h>
#include <auxfem/model/rigid_parts.h>
#include <auxfem/model/unknown_names.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <sstream>

namespace auxfem
{
  const char *motion_name(const unsigned int component,
                          const unsigned int dimension)
  {
    constexpr std::array<const char *, n_motion_components> in_plane = {
      {"horizontal displacement",
       "vertical displacement",
       "",
       "",
       "",
       "rotation"}};
    constexpr std::array<const char *, n_motion_components> in_space = {
      {"displacement along x",
       "displacement along y",
       "displacement along z",
       "rotation about x",
       "rotation about y",
       "rotation about z"}};
    return (dimension == 2 ? in_plane : in_space)[component];
  }

  namespace
  {
    /** Words for an unknown of a rigid part or a hinge; empty for others. */
    std::string describe_constraint(const Lattice       &lattice,
                                    const GlobalNumbers &numbers,
                                    const int            global)
    {
      const auto has = [global](const auto &of_kind) {
        return std::find(of_kind.begin(), of_kind.end(), global) !=
          of_kind.end();
      };
      for (unsigned int p = 0; p < numbers.rigid_parts.size(); ++p)
        {
          const GlobalNumbers::OfMotion &motion = numbers.rigid_parts[p].motion;
          std::ostringstream             words;
          if (has(numbers.rigid_parts[p].multipliers))
            words << "constraint";
          else if (has(motion))
            words << motion_name(
              std::find(motion.begin(), motion.end(), global) - motion.begin(),
              lattice.dimension);
          else
            continue;
          words << " of the rigid part of joints";
          const auto &joints = lattice.rigid_parts[p].joints;
          for (unsigned int i = 0; i < joints.size() && i < 4; ++i)
            words << ' ' << joints[i];
          words << (joints.size() > 4 ? " ..." : "");
          return words.str();
        }
      for (const GlobalNumbers::OfHinge &hinge : numbers.hinges)
        if (has(hinge.multipliers))
          return "constraint of the revolute hinge at joint " +
            std::to_string(hinge.joint);
      return "";
    }

    /** `joint 3`, `plate "table"`. */
    std::string name_of_joint(const Lattice &lattice, const unsigned int joint)
    {
      if (joint >= lattice.n_structural_joints())
        for (const auto &[name, joints] : lattice.joint_sets)
          if (joints.size() == 1 && joints.front() == joint)
            return "plate \"" + name + '"';
      return "joint " + std::to_string(joint);
    }

    /** Words for an unknown of a joint; empty for others. */
    std::string describe_of_joint(const Lattice      &lattice,
                                  const DofNumbering &numbering,
                                  const int           global)
    {
      for (unsigned int j = 0; j < lattice.joints.size(); ++j)
        for (const unsigned int c : numbering.components())
          if (numbering.global().joints[j][c] == global)
            {
              std::ostringstream words;
              words << motion_name(c, lattice.dimension) << " of "
                    << name_of_joint(lattice, j) << " at ("
                    << lattice.joints[j][0] << ", " << lattice.joints[j][1];
              if (lattice.dimension == 3)
                words << ", " << lattice.joints[j][2];
              words << ")";
              return words.str();
            }
      return "";
    }

    /** Words for an unknown of a node inside a strut or of a released end. */
    std::string describe_of_strut(const Lattice      &lattice,
                                  const DofNumbering &numbering,
                                  const unsigned int  unknown)
    {
      for (unsigned int e = 0; e < numbering.elements().size(); ++e)
        {
          const int *const        begin = numbering.element_unknowns(e),
                           *const end = begin + numbering.n_element_unknowns(e),
                           *const found =
                             std::find(begin, end, static_cast<int>(unknown));
          if (found == end)
            continue;
          const unsigned int number = numbering.elements()[e].interval.strut;
          const Strut       &strut  = lattice.struts[number];
          std::ostringstream words;
          words << motion_name(numbering.components()[(found - begin) %
                                                      numbering.n_components()],
                               lattice.dimension)
                << " of strut " << number << " (joints " << strut.joints[0]
                << " - " << strut.joints[1] << ")";
          return words.str();
        }
      return "";
    }
  } // namespace

  std::string describe(const DofNumbering &numbering,
                       const unsigned int  unknown)
  {
    const Lattice &lattice = numbering.lattice();
    const int      global  = numbering.layout().global(unknown);
    std::string    words =
      describe_constraint(lattice, numbering.global(), global);
    if (words.empty())
      words = describe_of_joint(lattice, numbering, global);
    return words.empty() ? describe_of_strut(lattice, numbering, unknown)
                         : words;
  }

  std::string describe_largest(const DofNumbering        &numbering,
                               const std::vector<double> &size)
  {
    namespace MPI = dealii::Utilities::MPI;

    const UnknownLayout &layout  = numbering.layout();
    const auto           end     = size.begin() + layout.n_owned();
    const auto           found   = std::max_element(size.begin(), end);
    const double         largest = found == end ? -1. : *found;
    // Every rank gets the words of the lowest rank that has the largest value.
    const unsigned int who =
      MPI::min(largest == layout.largest(largest) ? layout.rank()
                                                  : layout.n_ranks(),
               layout.communicator());
    const std::string words =
      who == layout.rank() ? describe(numbering, found - size.begin()) : "";
    return text_of_rank(who, words, layout.communicator());
  }

  std::string why_no_rotation(const DofNumbering &numbering,
                              const unsigned int  joint)
  {
    const bool is_of_rigid_part =
      joints_of_rigid_parts(numbering.lattice())[joint] &&
      !numbering.joint_has(joint, rotation_z);
    return "joint " + std::to_string(joint) +
      " has no rotation of its own, because " +
      (is_of_rigid_part
         ? "a rigid part is hinged there. Act on a second joint of the part "
           "(hold it, load it, give it a mass), or give the part a Rotary "
           "inertia."
         : "every strut is released there or no strut ends there. Leave one "
           "strut unreleased, or take another joint.");
  }
} // namespace auxfem
