#include <auxfem/algebra/joint_groups.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <unordered_map>

namespace auxfem
{
  namespace
  {
    /**
     * Share of a constraint that must be new to the joint that takes its
     * multiplier: nearly dependent constraints make large factors.
     */
    constexpr double independent_share = 0.2;

    /** Entries of a constraint by row of the unknown that it acts on. */
    using Constraint = std::map<int, double>;

    double norm(const Constraint &constraint)
    {
      double sum = 0;
      for (const auto &[row, entry] : constraint)
        sum += entry * entry;
      return std::sqrt(sum);
    }
  } // namespace

  /** Groups while they are made; rows that are one have one root. */
  class JointGroups::Assignment
  {
  public:
    Assignment(const SparseMatrix        &matrix,
               const Unknowns            &unknowns,
               const std::vector<double> &scale)
      : matrix(matrix)
      , unknowns(unknowns)
      , scale(scale)
      , parent(matrix.layout->n_owned())
    {
      std::unordered_map<unsigned int, unsigned int> first_of_joint;
      for (unsigned int row = 0; row < parent.size(); ++row)
        {
          parent[row] = row;
          if (unknowns.kinds[row] != UnknownKind::prescribed &&
              unknowns.kinds[row] != UnknownKind::multiplier)
            parent[row] =
              first_of_joint.emplace(unknowns.joint[row], row).first->second;
        }
    }

    unsigned int root(unsigned int row)
    {
      while (parent[row] != row)
        row = parent[row] = parent[parent[row]];
      return row;
    }

    void merge(const unsigned int row, const unsigned int other)
    {
      const unsigned int kept = root(row), gone = root(other);
      if (kept == gone)
        return;
      parent[gone] = kept;
      // What is independent in either is so in both together.
      const auto taken = directions.extract(gone);
      if (!taken.empty())
        directions[kept].insert(directions[kept].end(),
                                taken.mapped().begin(),
                                taken.mapped().end());
    }

    /** Gives the multiplier @p row to one of the joints it constrains. */
    void assign(const unsigned int row)
    {
      const Constraint constraint = constraint_of(row);
      const double     size       = norm(constraint);
      auto             parts      = parts_by_group(constraint);
      while (!parts.empty() && size > 0)
        {
          double       best_share = 0;
          unsigned int best       = 0;
          Constraint   direction;
          for (const auto &[group, part] : parts)
            {
              const Constraint rest  = without_known(group, part);
              const double     share = norm(rest) / size;
              if (share > best_share)
                {
                  best_share = share;
                  best       = group;
                  direction  = rest;
                }
            }
          if (best_share > independent_share)
            {
              for (auto &[unknown, entry] : direction)
                entry /= best_share * size;
              directions[best].push_back(direction);
              parent[row] = best;
              return;
            }
          if (parts.size() == 1)
            break;
          const unsigned int one   = parts.begin()->first,
                             other = std::next(parts.begin())->first;
          merge(one, other);
          parts = parts_by_group(constraint);
        }
      // The constraint follows from others, or all it acts on is elsewhere:
      // elimination will tell.
      if (!parts.empty())
        parent[row] = parts.begin()->first;
    }

  private:
    Constraint constraint_of(const unsigned int row) const
    {
      Constraint constraint;
      for (std::size_t i = matrix.first[row]; i < matrix.first[row + 1]; ++i)
        if (const int column = matrix.columns[i];
            matrix.layout->is_owned(column) && matrix.entries[i] != 0 &&
            unknowns.kinds[column] != UnknownKind::prescribed &&
            unknowns.kinds[column] != UnknownKind::multiplier)
          constraint[column] = matrix.entries[i] * scale[row] * scale[column];
      return constraint;
    }

    std::map<unsigned int, Constraint>
    parts_by_group(const Constraint &constraint)
    {
      std::map<unsigned int, Constraint> parts;
      for (const auto &[row, entry] : constraint)
        parts[root(row)][row] = entry;
      return parts;
    }

    /** What the constraints that @p group has already leave of @p part. */
    Constraint without_known(const unsigned int group, Constraint part) const
    {
      const auto known = directions.find(group);
      if (known != directions.end())
        for (const Constraint &direction : known->second)
          {
            double product = 0;
            for (const auto &[row, entry] : direction)
              if (const auto own = part.find(row); own != part.end())
                product += entry * own->second;
            if (product != 0)
              for (const auto &[row, entry] : direction)
                part[row] -= product * entry;
          }
      return part;
    }

    const SparseMatrix        &matrix;
    const Unknowns            &unknowns;
    const std::vector<double> &scale;
    std::vector<unsigned int>  parent;
    /** Orthonormal directions that the constraints of a group bind. */
    std::unordered_map<unsigned int, std::vector<Constraint>> directions;
  };

  JointGroups::JointGroups(const SparseMatrix                     &matrix,
                           const Unknowns                         &unknowns,
                           const std::vector<double>              &scale,
                           const std::vector<std::pair<int, int>> &merged)
    : of_row(matrix.layout->n_owned())
    , number(matrix.layout->n_owned(), 0)
  {
    Assignment assignment(matrix, unknowns, scale);
    for (unsigned int row = 0; row < of_row.size(); ++row)
      if (unknowns.kinds[row] == UnknownKind::multiplier)
        assignment.assign(row);
    for (const auto &[row, other] : merged)
      assignment.merge(row, other);

    std::vector<std::optional<unsigned int>> of_root(of_row.size());
    for (unsigned int row = 0; row < of_row.size(); ++row)
      {
        if (unknowns.kinds[row] == UnknownKind::prescribed)
          continue;
        std::optional<unsigned int> &group = of_root[assignment.root(row)];
        if (!group)
          {
            group = in_group.size();
            in_group.emplace_back();
            constrained.push_back(false);
          }
        of_row[row] = group;
        number[row] = in_group[*group].size();
        in_group[*group].push_back(row);
        if (unknowns.kinds[row] == UnknownKind::multiplier)
          constrained[*group] = true;
      }
  }
} // namespace auxfem
