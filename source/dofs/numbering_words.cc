#include <auxfem/dofs/numbering.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <sstream>

namespace auxfem
{
  std::string DofNumbering::describe(const unsigned int local_number) const
  {
    const int          global       = local->GID(local_number);
    const char        *component[3] = {"horizontal displacement",
                                       "vertical displacement",
                                       "rotation"};
    std::ostringstream words;
    for (unsigned int j = 0; j < joint_numbers.size(); ++j)
      for (unsigned int c = 0; c < n_components; ++c)
        if (joint_numbers[j][c] == global)
          {
            words << component[c] << " of joint " << j << " at ("
                  << lattice.joints[j][0] << ", " << lattice.joints[j][1]
                  << ")";
            return words.str();
          }
    for (unsigned int p = 0; p < of_rigid_part.size(); ++p)
      for (const int multiplier : of_rigid_part[p].multipliers)
        if (multiplier == global)
          {
            words << "condition of the rigid part of joints";
            const auto &joints = lattice.rigid_parts[p].joints;
            for (unsigned int i = 0; i < joints.size() && i < 4; ++i)
              words << ' ' << joints[i];
            words << (joints.size() > 4 ? " ..." : "");
            return words.str();
          }
    const unsigned int n = (polynomial_order + 1) * n_components;
    for (std::size_t i = 0; i < element_numbers.size(); ++i)
      if (element_numbers[i] == static_cast<int>(local_number))
        {
          const Element &element = element_list[i / n];
          const Strut   &strut   = lattice.struts[element.place.strut];
          words << component[i % n_components] << " of strut "
                << element.place.strut << " (joints " << strut.joints[0]
                << " - " << strut.joints[1] << ")";
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
    return !joint_has(joint, 2) &&
      std::any_of(lattice.rigid_parts.begin(),
                  lattice.rigid_parts.end(),
                  [joint](const RigidPart &part) {
                    return std::count(part.joints.begin(),
                                      part.joints.end(),
                                      joint) > 0;
                  });
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
