#include <auxfem/algebra/joint_blocks.h>

#include <Epetra_IntVector.h>

#include <algorithm>

namespace auxfem
{
  namespace
  {
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

  JointBlocks::JointBlocks(const LatticeModel &model)
    : numbering(model.numbering)
    , lattice(model.lattice)
    , inside(numbering.n_local(), invalid_index)
    , rows(numbering.n_local(), -1)
  {
    find_inside_struts();
    place_unknowns();
    share_rows();
  }

  unsigned int JointBlocks::size() const
  {
    return numbering.n_components();
  }

  const Epetra_Map &JointBlocks::map() const
  {
    return *row_map;
  }

  int JointBlocks::row(const unsigned int unknown) const
  {
    return rows[unknown];
  }

  int JointBlocks::unknown(const unsigned int local_row) const
  {
    return unknowns[local_row];
  }

  unsigned int JointBlocks::strut(const unsigned int unknown) const
  {
    return inside[unknown];
  }

  void JointBlocks::find_inside_struts()
  {
    for (unsigned int e = 0; e < numbering.elements().size(); ++e)
      {
        const StrutMesh::Place &place = numbering.elements()[e].place;
        for (unsigned int node = 0; node <= numbering.order(); ++node)
          {
            const bool at_joint = (node == 0 && place.begin == 0.) ||
              (node == 1 && place.end == 1.);
            if (!at_joint)
              for (unsigned int c = 0; c < size(); ++c)
                inside[numbering.element_unknowns(e)[node * size() + c]] =
                  place.strut;
          }
      }
  }

  void JointBlocks::place_unknowns()
  {
    std::vector<std::vector<int>> blocks(lattice.joints.size());
    for (unsigned int joint = 0; joint < lattice.joints.size(); ++joint)
      for (unsigned int c = 0; c < size(); ++c)
        place(numbering.joint_unknown(joint, numbering.components()[c]),
              c,
              joint,
              blocks[joint]);
    // What is left are rotations of released ends.
    for (unsigned int e = 0; e < numbering.elements().size(); ++e)
      for (unsigned int i = 0; i < 2 * size(); ++i)
        {
          const int unknown = numbering.element_unknowns(e)[i];
          if (inside[unknown] != invalid_index)
            continue;
          const unsigned int strut = numbering.elements()[e].place.strut,
                             joint = lattice.struts[strut].joints[i / size()];
          place(unknown, i % size(), joint, blocks[joint]);
        }
  }

  void JointBlocks::place(const int          unknown,
                          const unsigned int component,
                          const unsigned int joint,
                          std::vector<int>  &blocks)
  {
    if (!numbering.is_owned(unknown) || rows[unknown] >= 0)
      return;
    auto block =
      std::find_if(blocks.begin(), blocks.end(), [&](const int candidate) {
        return unknowns[candidate * size() + component] < 0;
      });
    if (block == blocks.end())
      {
        block = blocks.insert(block, joint_of_block.size());
        joint_of_block.push_back(joint);
        unknowns.resize(unknowns.size() + size(), -1);
      }
    rows[unknown]           = *block * size() + component;
    unknowns[rows[unknown]] = unknown;
  }

  void JointBlocks::share_rows()
  {
    row_map                = std::make_unique<Epetra_Map>(-1,
                                           int(unknowns.size()),
                                           0,
                                           numbering.communicator());
    const int        first = row_map->MinMyGID();
    Epetra_IntVector owned(numbering.owned_map()), local(numbering.local_map());
    for (unsigned int i = 0; i < numbering.n_owned(); ++i)
      owned[i] = rows[i] < 0 ? -1 : first + rows[i];
    if (numbering.n_ranks() == 1)
      local = owned;
    else
      local.Import(owned, numbering.importer(), Insert);
    rows.assign(local.Values(), local.Values() + numbering.n_local());
  }

  std::vector<std::vector<double>>
  JointBlocks::rigid_body_modes(const double length) const
  {
    dealii::Point<3> middle;
    for (const dealii::Point<3> &joint : lattice.joints)
      middle += joint / double(lattice.joints.size());

    const std::vector<unsigned int> &components = numbering.components();
    std::vector<std::vector<double>> modes(size(),
                                           std::vector<double>(unknowns.size(),
                                                               0.));
    for (unsigned int row = 0; row < unknowns.size(); ++row)
      {
        if (unknowns[row] < 0 ||
            numbering.kind(unknowns[row]) == UnknownKind::prescribed)
          continue;
        const dealii::Tensor<1, 3> arm =
          (lattice.joints[joint_of_block[row / size()]] - middle) / length;
        const unsigned int moved = components[row % size()];
        for (unsigned int mode = 0; mode < size(); ++mode)
          modes[mode][row] = motion(components[mode], moved, arm);
      }
    return modes;
  }
} // namespace auxfem
