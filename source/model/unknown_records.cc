#include <auxfem/algebra/rank_exchange.h>
#include <auxfem/mesh/periodic_array.h>
#include <auxfem/model/rigid_bodies.h>
#include <auxfem/model/unknown_records.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <limits>
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
    /** Description of an unknown of rigid parts and constraints; empty for
     * others. */
    std::string describe_constraint(const Lattice       &lattice,
                                    const GlobalNumbers &numbers,
                                    const int            global)
    {
      const auto has = [global](const auto &globals) {
        return std::find(globals.begin(), globals.end(), global) !=
          globals.end();
      };
      for (unsigned int p = 0; p < numbers.rigid_parts.size(); ++p)
        {
          const GlobalNumbers::MotionNumbers &motion =
            numbers.rigid_parts[p].motion;
          std::ostringstream text;
          if (has(numbers.rigid_parts[p].multipliers))
            text << "constraint";
          else if (has(motion))
            text << motion_name(
              std::find(motion.begin(), motion.end(), global) - motion.begin(),
              lattice.dimension);
          else
            continue;
          text << " of the rigid part of joints";
          const auto &joints = lattice.rigid_parts[p].joints;
          for (unsigned int i = 0; i < joints.size() && i < 4; ++i)
            text << ' ' << joints[i];
          text << (joints.size() > 4 ? " ..." : "");
          return text.str();
        }
      for (const GlobalNumbers::HingeNumbers &hinge : numbers.hinges)
        if (has(hinge.multipliers))
          return "constraint of the revolute hinge at joint " +
            std::to_string(hinge.joint);
      for (const GlobalNumbers::RelationNumbers &relation : numbers.relations)
        if (relation.multiplier == global)
          return "relation of " + relation.path + " at joint " +
            std::to_string(relation.joint);
      return "";
    }

    /** Name of a joint: `joint 3`, `plate "table"`. */
    std::string name_of_joint(const Lattice &lattice, const unsigned int joint)
    {
      if (joint >= lattice.n_structural_joints())
        for (const auto &[name, joints] : lattice.joint_sets)
          if (joints.size() == 1 && joints.front() == joint)
            return lattice.periodicity ? name : "plate \"" + name + '"';
      return "joint " + std::to_string(joint);
    }

    /** Description of an unknown of a joint; empty for others. */
    std::string describe_joint_unknown(const Lattice      &lattice,
                                       const DofNumbering &numbering,
                                       const int           global)
    {
      for (unsigned int j = 0; j < lattice.joints.size(); ++j)
        for (const unsigned int c : numbering.components())
          if (numbering.global().joints[j][c] == global)
            {
              std::ostringstream text;
              text << motion_name(c, lattice.dimension) << " of "
                   << name_of_joint(lattice, j) << " at ("
                   << lattice.joints[j][0] << ", " << lattice.joints[j][1];
              if (lattice.dimension == 3)
                text << ", " << lattice.joints[j][2];
              text << ")";
              return text.str();
            }
      return "";
    }

    /** Description of an unknown of an inner node or a released end. */
    std::string describe_strut_unknown(const Lattice      &lattice,
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
          std::ostringstream text;
          text << motion_name(numbering.components()[(found - begin) %
                                                     numbering.n_components()],
                              lattice.dimension)
               << " of strut " << number << " (joints " << strut.joints[0]
               << " - " << strut.joints[1] << ")";
          return text.str();
        }
      return "";
    }
  } // namespace

  std::string describe(const DofNumbering &numbering,
                       const unsigned int  unknown)
  {
    const Lattice &lattice = numbering.lattice();
    const int      global  = numbering.layout().global(unknown);
    std::string text = describe_constraint(lattice, numbering.global(), global);
    if (text.empty())
      text = describe_joint_unknown(lattice, numbering, global);
    return text.empty() ? describe_strut_unknown(lattice, numbering, unknown)
                        : text;
  }

  std::string describe_largest(const DofNumbering        &numbering,
                               const std::vector<double> &size)
  {
    namespace MPI = dealii::Utilities::MPI;

    const UnknownLayout &layout  = numbering.layout();
    const auto           end     = size.begin() + layout.n_owned();
    const auto           found   = std::max_element(size.begin(), end);
    const double         largest = found == end ? -1. : *found;
    // The lowest rank with the largest value gives the description.
    const unsigned int lowest =
      MPI::min(largest == layout.largest(largest) ? layout.rank()
                                                  : layout.n_ranks(),
               layout.communicator());
    const std::string text =
      lowest == layout.rank() ? describe(numbering, found - size.begin()) : "";
    return broadcast_text(lowest, text, layout.communicator());
  }

  std::string missing_rotation_reason(const DofNumbering &numbering,
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

  std::vector<RotationOwner>
  joint_rotations(const Lattice                          &lattice,
                  const std::vector<std::array<bool, 2>> &released)
  {
    using OwnerKind = RotationOwner::Kind;
    std::vector<RotationOwner> rotation_owner(lattice.joints.size());
    for (unsigned int s = 0; s < lattice.struts.size(); ++s)
      for (unsigned int end = 0; end < 2; ++end)
        if (const unsigned int joint = lattice.struts[s].joints[end];
            !lattice.struts[s].is_rigid() && !released[s][end])
          rotation_owner[joint] = {OwnerKind::joint, joint, 0};
    if (lattice.periodicity)
      for (const JointImage &image : lattice.periodicity->images)
        if (rotation_owner[image.joint].kind == OwnerKind::joint)
          rotation_owner[image.base] = {OwnerKind::joint, image.base, 0};

    std::vector<unsigned int> n_parts(lattice.joints.size(), 0);
    for (const RigidPart &part : lattice.rigid_parts)
      if (part.has_rotation)
        for (const unsigned int joint : part.joints)
          ++n_parts[joint];
    for (unsigned int p = 0; p < lattice.rigid_parts.size(); ++p)
      if (const RigidPart &part = lattice.rigid_parts[p]; part.has_rotation)
        for (const unsigned int joint : part.joints)
          if (rotation_owner[joint].kind == OwnerKind::joint
                ? part.clamps_struts
                : n_parts[joint] == 1)
            rotation_owner[joint] = {OwnerKind::rigid_part, p, 0};
    return rotation_owner;
  }

  UnknownDistribution::UnknownDistribution(const Lattice     &lattice,
                                           const Ties        &ties,
                                           const unsigned int n_ranks)
    : lattice(lattice)
    , ties(ties)
    , rotation_of_joint(joint_rotations(lattice, ties.released))
    , joint_unknowns(lattice.joints.size())
    , part_unknowns(lattice.rigid_parts.size())
    , hinge_unknowns(ties.hinged.size())
    , relation_unknowns(ties.relations.size())
    , count(n_ranks, 0)
  {
    for (unsigned int s = 0; s < lattice.struts.size(); ++s)
      for (unsigned int end = 0; end < 2; ++end)
        if (!lattice.struts[s].is_rigid() && ties.released[s][end])
          released_end_unknowns[{s, end}];
  }

  void UnknownDistribution::assign(Unknown &unknown, const int rank)
  {
    if (unknown.owner < 0)
      unknown = {rank, count[rank]++};
  }

  int UnknownDistribution::assign_inner(const unsigned int n, const int rank)
  {
    const int first = count[rank];
    count[rank] += n;
    return first;
  }

  UnknownDistribution::Motion &
  UnknownDistribution::motion_of(const RotationOwner &rotation_owner)
  {
    switch (rotation_owner.kind)
      {
        case RotationOwner::Kind::strut_end:
          return released_end_unknowns.at(
            {rotation_owner.index, rotation_owner.end});
        case RotationOwner::Kind::rigid_part:
          return part_unknowns[rotation_owner.index].motion;
        default:
          return joint_unknowns[rotation_owner.index];
      }
  }

  const UnknownDistribution::Motion &
  UnknownDistribution::motion_of(const RotationOwner &rotation_owner) const
  {
    return const_cast<UnknownDistribution *>(this)->motion_of(rotation_owner);
  }

  void UnknownDistribution::assign_end(const unsigned int strut,
                                       const unsigned int end,
                                       const unsigned int component,
                                       const int          rank)
  {
    const unsigned int joint = lattice.struts[strut].joints[end];
    Motion &motion = component < first_rotation ? joint_unknowns[joint]
      : ties.released[strut][end] ? released_end_unknowns.at({strut, end})
                                  : motion_of(rotation_of_joint[joint]);
    assign(motion[component], rank);
  }

  void
  UnknownDistribution::assign_joints(const std::vector<unsigned int> &ranks)
  {
    const auto assign_displacements = [&](const unsigned int joint,
                                          const int          rank) {
      for (unsigned int component = 0; component < lattice.dimension;
           ++component)
        assign(joint_unknowns[joint][component], rank);
    };
    for (unsigned int s = 0; s < lattice.struts.size(); ++s)
      if (lattice.struts[s].is_rigid())
        for (const unsigned int joint : lattice.struts[s].joints)
          assign_displacements(joint, ranks[s]);
    // A joint without struts, such as a mass on connectors, has displacements
    // only, unless its images rotate.
    for (unsigned int joint = 0; joint < joint_unknowns.size(); ++joint)
      {
        assign_displacements(joint, 0);
        if (rotation_of_joint[joint].kind == RotationOwner::Kind::joint)
          for (unsigned int component = first_rotation;
               component < n_motion_components;
               ++component)
            if (lattice.dimension == 3 || is_in_plane(component))
              assign(joint_unknowns[joint][component],
                     joint_unknowns[joint][0].owner);
      }
  }

  void UnknownDistribution::assign_rigid_parts()
  {
    for (unsigned int p = 0; p < part_unknowns.size(); ++p)
      {
        const RigidPart   &part   = lattice.rigid_parts[p];
        RigidPartUnknowns &claims = part_unknowns[p];
        const int          rank   = joint_unknowns[part.joints[0]][0].owner;
        const unsigned int d = lattice.dimension, n = part.joints.size();
        if (part.has_rotation)
          for (Unknown &unknown : claims.motion)
            assign(unknown, rank);
        else if (part.clamps_struts)
          for (const unsigned int joint : part.joints)
            if (joint_unknowns[joint][rotation_z].owner >= 0)
              claims.clamped_joints.push_back(joint);
        claims.multipliers.resize(part.has_rotation ? d * n
                                                    : 1 + d * (n - 2) +
                                      claims.clamped_joints.size());
        for (Unknown &multiplier : claims.multipliers)
          assign(multiplier, rank);
      }
  }

  void UnknownDistribution::assign_hinges()
  {
    for (unsigned int h = 0; h < hinge_unknowns.size(); ++h)
      for (Unknown &multiplier : hinge_unknowns[h])
        assign(multiplier, motion_of(ties.hinged[h].end)[rotation_z].owner);
  }

  void UnknownDistribution::assign_relations()
  {
    // Joints have displacements in any case; a missing rotation is refused
    // later.
    for (unsigned int r = 0; r < relation_unknowns.size(); ++r)
      assign(
        relation_unknowns[r],
        joint_unknowns[ties.relations[r].terms.front().motion.joint][0].owner);
  }

  UnknownDistribution::Motion
  UnknownDistribution::joint(const unsigned int joint) const
  {
    Motion        motion   = joint_unknowns[joint];
    const Motion &rotation = motion_of(rotation_of_joint[joint]);
    if (rotation_of_joint[joint].kind != RotationOwner::Kind::ground)
      std::copy(rotation.begin() + first_rotation,
                rotation.end(),
                motion.begin() + first_rotation);
    return motion;
  }

  namespace
  {
    constexpr unsigned int not_numbered =
      std::numeric_limits<unsigned int>::max();

    /** Assigns consecutive numbers to local unknowns and skips others. */
    class SerialNumbers
    {
    public:
      explicit SerialNumbers(const UnknownLayout &layout)
        : layout(layout)
        , numbers(layout.n_local(), not_numbered)
      {}

      /** Numbers the next unknown, given by its global number; ignores -1. */
      void count(const int global)
      {
        if (global < 0)
          return;
        if (const int local = layout.local(global); local >= 0)
          numbers[local] = next;
        ++next;
      }

      template <class Globals>
      void count_all(const Globals &globals)
      {
        for (const int global : globals)
          count(global);
      }

      const UnknownLayout      &layout;
      std::vector<unsigned int> numbers;
      unsigned int              next = 0;
    };

    /** Numbers the unknowns of joints and constraints; joints may share some.
     */
    void count_outside_struts(const GlobalNumbers &numbers,
                              SerialNumbers       &serial)
    {
      for (const GlobalNumbers::MotionNumbers &joint : numbers.joints)
        serial.count_all(joint);
      for (const auto &[end, rotation] : numbers.released_ends)
        serial.count_all(rotation);
      for (const GlobalNumbers::RigidPartNumbers &part : numbers.rigid_parts)
        {
          serial.count_all(part.motion);
          serial.count_all(part.multipliers);
        }
      for (const GlobalNumbers::HingeNumbers &hinge : numbers.hinges)
        serial.count_all(hinge.multipliers);
      for (const GlobalNumbers::RelationNumbers &relation : numbers.relations)
        serial.count(relation.multiplier);
    }

    void count_inside_struts(const DofNumbering &numbering,
                             SerialNumbers      &serial)
    {
      const auto &elements = numbering.elements();
      const auto &first    = numbering.global().first_nodes;
      for (unsigned int e = 0; e < elements.size(); ++e)
        {
          const StrutInterval &interval = elements[e].interval;
          const unsigned int   order    = elements[e].order;
          const int           *unknowns = numbering.element_unknowns(e);
          for (unsigned int node = 0; node <= order;
               ++node, unknowns += numbering.n_components())
            if (!interval.is_joint(node))
              for (unsigned int c = 0; c < numbering.n_components(); ++c)
                serial.numbers[unknowns[c]] = serial.next +
                  (first[interval.strut] + order * interval.number() +
                   position_along(node, order)) *
                    numbering.n_components() +
                  c;
        }
    }

    std::vector<unsigned int> serial_numbers(const DofNumbering &numbering)
    {
      SerialNumbers serial(numbering.layout());
      count_outside_struts(numbering.global(), serial);
      count_inside_struts(numbering, serial);
      return serial.numbers;
    }

    /** Serial numbers including ghosts unknown to the numbering. */
    std::vector<unsigned int> serial_numbers(const DofNumbering  &numbering,
                                             const UnknownLayout &layout)
    {
      const std::vector<unsigned int> known = serial_numbers(numbering);
      Vector                          all(known.begin(), known.end());
      all.resize(layout.n_local());
      layout.update_ghosts(all.data());
      return {all.begin(), all.end()};
    }
  } // namespace

  UnknownRecords::UnknownRecords(const DofNumbering &numbering)
    : layout(numbering.layout())
    , serial(serial_numbers(numbering))
  {}

  UnknownRecords::UnknownRecords(const DofNumbering  &numbering,
                                 const UnknownLayout &layout)
    : layout(layout)
    , serial(serial_numbers(numbering, layout))
  {}

  void UnknownRecords::keep(const std::string &name,
                            const Vector      &values,
                            CheckpointData    &records) const
  {
    records.keep(name,
                 owned(),
                 1,
                 {values.begin(), values.begin() + layout.n_owned()});
  }

  Vector UnknownRecords::values(const std::string    &name,
                                const CheckpointData &records) const
  {
    Vector values = records.values(name, owned(), 1);
    values.resize(layout.n_local());
    layout.update_ghosts(values.data());
    return values;
  }
} // namespace auxfem
