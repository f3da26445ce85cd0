#include <auxfem/algebra/joint_rows.h>

#include <algorithm>
#include <unordered_map>

namespace auxfem
{
  namespace
  {
    constexpr unsigned int first_rotation = 3;

    /**
     * Component @p moved of the motion at @p arm that the unit motion of
     * component @p of_body of a rigid body makes.
     */
    double motion(const unsigned int          of_body,
                  const unsigned int          moved,
                  const dealii::Tensor<1, 3> &arm)
    {
      if (of_body == moved)
        return 1.;
      if (of_body < first_rotation || moved >= first_rotation)
        return 0.;
      dealii::Tensor<1, 3> axis;
      axis[of_body - first_rotation] = 1.;
      return dealii::cross_product_3d(axis, arm)[moved];
    }
  } // namespace

  JointRows::JointRows(const Unknowns &all, const std::vector<int> &taken)
    : unknowns(all)
    , rows(all.kinds.size())
  {
    std::unordered_map<unsigned int, std::vector<unsigned int>> blocks;
    for (const int unknown : taken)
      add(unknown, blocks[unknowns.joint[unknown]]);
    share();
  }

  void JointRows::add(const unsigned int         unknown,
                      std::vector<unsigned int> &blocks)
  {
    const std::vector<unsigned int> &components = unknowns.components;
    const unsigned int               number     = std::find(components.begin(),
                                          components.end(),
                                          unknowns.component[unknown]) -
      components.begin();
    auto block =
      std::find_if(blocks.begin(), blocks.end(), [&](const unsigned int b) {
        return !unknown_of_row[b * block_size() + number];
      });
    if (block == blocks.end())
      {
        block = blocks.insert(block, joint_of_block.size());
        joint_of_block.push_back(unknowns.joint[unknown]);
        unknown_of_row.resize(unknown_of_row.size() + block_size());
      }
    rows[unknown]                  = *block * block_size() + number;
    unknown_of_row[*rows[unknown]] = unknown;
  }

  void JointRows::share()
  {
    const UnknownLayout                     &of_unknowns = unknowns.layout;
    const UnknownLayout                      owned(of_unknowns.communicator(),
                              unknown_of_row.size(),
                              {});
    std::vector<std::optional<unsigned int>> numbers = rows;
    for (std::optional<unsigned int> &number : numbers)
      if (number)
        number = owned.global(*number);
    of_unknowns.update_ghosts(numbers);
    std::vector<int> ghosts;
    for (unsigned int i = of_unknowns.n_owned(); i < of_unknowns.n_local(); ++i)
      if (numbers[i])
        {
          rows[i] = unknown_of_row.size() + ghosts.size();
          ghosts.push_back(*numbers[i]);
        }
    row_layout = std::make_unique<UnknownLayout>(of_unknowns.communicator(),
                                                 unknown_of_row.size(),
                                                 ghosts);
  }

  unsigned int JointRows::block_size() const
  {
    return unknowns.components.size();
  }

  std::vector<std::vector<double>> JointRows::rigid_body_modes() const
  {
    const std::vector<dealii::Point<3>> &joints = *unknowns.positions;
    dealii::Point<3>                     middle;
    for (const dealii::Point<3> &joint : joints)
      middle += joint / static_cast<double>(joints.size());

    const std::vector<unsigned int> &components = unknowns.components;
    std::vector<std::vector<double>> modes(
      block_size(),
      std::vector<double>(unknown_of_row.size(), 0.));
    for (unsigned int row = 0; row < unknown_of_row.size(); ++row)
      {
        if (!unknown_of_row[row])
          continue;
        if (unknowns.kinds[*unknown_of_row[row]] == UnknownKind::prescribed)
          continue;
        const dealii::Tensor<1, 3> arm =
          (joints[joint_of_block[row / block_size()]] - middle) /
          unknowns.length;
        for (unsigned int mode = 0; mode < block_size(); ++mode)
          modes[mode][row] =
            motion(components[mode], components[row % block_size()], arm);
      }
    return modes;
  }
} // namespace auxfem
