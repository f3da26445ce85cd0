#include <auxfem/mesh/lattice_reduction.h>

#include <algorithm>
#include <numeric>
#include <set>
#include <utility>

namespace auxfem
{
  namespace
  {
    std::vector<bool> ends_of_struts(const Lattice &lattice)
    {
      std::vector<bool> is_end(lattice.joints.size(), false);
      for (const Strut &strut : lattice.struts)
        for (const unsigned int joint : strut.joints)
          is_end[joint] = true;
      return is_end;
    }

    void renumber(const std::vector<unsigned int> &numbers,
                  std::vector<unsigned int>       &members)
    {
      std::vector<unsigned int> remaining;
      for (const unsigned int member : members)
        if (numbers[member] != invalid_index)
          remaining.push_back(numbers[member]);
      std::sort(remaining.begin(), remaining.end());
      remaining.erase(std::unique(remaining.begin(), remaining.end()),
                      remaining.end());
      members = std::move(remaining);
    }
  } // namespace

  LatticeReduction::LatticeReduction(Lattice &lattice)
    : keep_strut(lattice.struts.size(), true)
    , keep_joint(lattice.joints.size(), true)
    , target(lattice.joints.size())
    , lattice(lattice)
    , had_struts(ends_of_struts(lattice))
  {
    std::iota(target.begin(), target.end(), 0);
  }

  std::string LatticeReduction::apply()
  {
    renumber_struts();
    renumber_joints();
    std::size_t n_pairs = 0;
    for (auto &[name, pairs] : lattice.pair_sets)
      {
        const std::size_t before = pairs.size();
        renumber_pairs(pairs);
        n_pairs += before - pairs.size();
      }
    for (auto &[name, members] : lattice.joint_sets)
      renumber(new_joint, members);
    for (auto &[name, members] : lattice.strut_sets)
      renumber(new_strut, members);
    std::string lost;
    if (n_lost_joints > 0)
      lost += "joints without struts: " + std::to_string(n_lost_joints);
    if (n_pairs > 0)
      lost += (lost.empty() ? "" : ", ") + std::string("connectors: ") +
        std::to_string(n_pairs);
    return lost.empty() ? "" : "Also removed are " + lost + ".";
  }

  void LatticeReduction::renumber_struts()
  {
    std::set<std::pair<unsigned int, unsigned int>> straight;
    std::vector<Strut>                              remaining;
    new_strut.assign(lattice.struts.size(), invalid_index);
    for (unsigned int s = 0; s < lattice.struts.size(); ++s)
      {
        Strut strut = lattice.struts[s];
        for (unsigned int &joint : strut.joints)
          joint = target[joint];
        if (!keep_strut[s] || strut.joints[0] == strut.joints[1] ||
            (strut.sagitta == 0 &&
             !straight.insert(std::minmax(strut.joints[0], strut.joints[1]))
                .second))
          continue;
        new_strut[s] = remaining.size();
        remaining.push_back(strut);
      }
    lattice.struts = std::move(remaining);
  }

  void LatticeReduction::renumber_joints()
  {
    const std::vector<bool>       has_struts = ends_of_struts(lattice);
    std::vector<dealii::Point<3>> remaining;
    new_joint.assign(lattice.joints.size(), invalid_index);
    for (unsigned int j = 0; j < lattice.joints.size(); ++j)
      {
        const bool is_lost = had_struts[j] && !has_struts[j];
        n_lost_joints += target[j] == j && keep_joint[j] && is_lost;
        if (target[j] != j || !keep_joint[j] || is_lost)
          continue;
        new_joint[j] = remaining.size();
        remaining.push_back(lattice.joints[j]);
      }
    for (unsigned int j = 0; j < lattice.joints.size(); ++j)
      new_joint[j] = new_joint[target[j]];
    lattice.joints = std::move(remaining);
    for (Strut &strut : lattice.struts)
      for (unsigned int &joint : strut.joints)
        joint = new_joint[joint];
  }

  void LatticeReduction::renumber_pairs(std::vector<JointPair> &pairs) const
  {
    std::vector<JointPair> remaining;
    for (JointPair pair : pairs)
      {
        pair.first  = new_joint[pair.first];
        pair.second = new_joint[pair.second];
        if (pair.first != invalid_index && pair.second != invalid_index &&
            pair.first != pair.second)
          remaining.push_back(pair);
      }
    pairs = std::move(remaining);
  }
} // namespace auxfem
