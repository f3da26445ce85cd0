#include <auxfem/model/numbering.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <sstream>

namespace auxfem
{
  const char *motion_in_words(const unsigned int component,
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

  std::string DofNumbering::describe_condition(const int global) const
  {
    const auto has = [global](const auto &numbers) {
      return std::find(numbers.begin(), numbers.end(), global) != numbers.end();
    };
    for (unsigned int p = 0; p < of_rigid_part.size(); ++p)
      {
        const MotionNumbers &motion = of_rigid_part[p].motion;
        std::ostringstream   words;
        if (has(of_rigid_part[p].multipliers))
          words << "condition";
        else if (has(motion))
          words << motion_in_words(
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
    for (const HingeUnknowns &hinge : of_hinge)
      if (has(hinge.multipliers))
        return "condition of the revolute hinge at joint " +
          std::to_string(hinge.joint);
    return "";
  }

  std::string DofNumbering::describe(const unsigned int local_number) const
  {
    const int          global = local->GID(local_number);
    std::ostringstream words;
    words << describe_condition(global);
    if (!words.str().empty())
      return words.str();
    for (unsigned int j = 0; j < joint_numbers.size(); ++j)
      for (const unsigned int c : node_components)
        if (joint_numbers[j][c] == global)
          {
            words << motion_in_words(c, lattice.dimension) << " of joint " << j
                  << " at (" << lattice.joints[j][0] << ", "
                  << lattice.joints[j][1];
            if (lattice.dimension == 3)
              words << ", " << lattice.joints[j][2];
            words << ")";
            return words.str();
          }
    const unsigned int n = (polynomial_order + 1) * n_components();
    for (std::size_t i = 0; i < element_numbers.size(); ++i)
      if (element_numbers[i] == static_cast<int>(local_number))
        {
          const Element &element = element_list[i / n];
          const Strut   &strut   = lattice.struts[element.place.strut];
          words << motion_in_words(node_components[i % n_components()],
                                   lattice.dimension)
                << " of strut " << element.place.strut << " (joints "
                << strut.joints[0] << " - " << strut.joints[1] << ")";
          break;
        }
    return words.str();
  }

  std::string
  DofNumbering::describe_largest(const std::vector<double> &size) const
  {
    const auto place   = std::max_element(size.begin(), size.end());
    double     largest = size.empty() ? -1. : *place;
    double     of_all  = 0;
    comm.MaxAll(&largest, &of_all, 1);
    // Every rank gets the words of the lowest rank that has the largest value.
    int mine = largest == of_all ? comm.MyPID() : comm.NumProc();
    int who  = 0;
    comm.MinAll(&mine, &who, 1);
    const std::string words =
      who == comm.MyPID() ? describe(place - size.begin()) : "";
    return dealii::Utilities::MPI::broadcast(comm.Comm(), words, who);
  }

  bool DofNumbering::is_rigid_joint(const unsigned int joint) const
  {
    return !joint_has(joint, rotation_z) && is_of_rigid_part[joint];
  }

  std::string DofNumbering::why_no_rotation(const unsigned int joint) const
  {
    return "joint " + std::to_string(joint) +
      " has no rotation of its own, because " +
      (is_rigid_joint(joint)
         ? "a rigid part is hinged there. Act on a second joint of the part "
           "(hold it, load it, give it a mass), or give the part a Rotary "
           "inertia."
         : "every strut is released there or no strut ends there. Leave one "
           "strut unreleased, or take another joint.");
  }
} // namespace auxfem
