#ifndef auxfem_algebra_joint_groups_h
#define auxfem_algebra_joint_groups_h

#include <auxfem/algebra/sparse_matrix.h>
#include <auxfem/algebra/unknowns.h>

#include <optional>
#include <utility>

namespace auxfem
{
  /**
   * The rows of this rank that are not prescribed in groups that one pivot
   * block can eliminate: those of a joint, and with them as many multipliers as
   * find constraints on that joint that do not follow from each other. The
   * block of a joint with stiffness A and constraints B on it,
   *
   *     A  B^T
   *     B   0
   *
   * is then regular whatever is beside it, if A is positive definite where B
   * allows motion. Where no joint has room for a multiplier, joints are merged.
   */
  class JointGroups
  {
  public:
    /**
     * @param scale of local unknowns: entries are taken times those of their
     * row and column
     * @param merged pairs of rows whose groups are to be one
     */
    JointGroups(const SparseMatrix                     &matrix,
                const Unknowns                         &unknowns,
                const std::vector<double>              &scale,
                const std::vector<std::pair<int, int>> &merged);

    unsigned int n_groups() const
    {
      return in_group.size();
    }

    /** Group of an owned row; none of prescribed ones. */
    std::optional<unsigned int> group(const unsigned int row) const
    {
      return of_row[row];
    }

    /** Rows of a group, and the number of a row among them. */
    const std::vector<int> &rows(const unsigned int group) const
    {
      return in_group[group];
    }

    unsigned int number_in_group(const unsigned int row) const
    {
      return number[row];
    }

    bool has_multipliers(const unsigned int group) const
    {
      return constrained[group];
    }

  private:
    class Assignment;

    std::vector<std::optional<unsigned int>> of_row;
    std::vector<unsigned int>                number;
    std::vector<std::vector<int>>            in_group;
    std::vector<bool>                        constrained;
  };
} // namespace auxfem

#endif
