#include <auxfem/mesh/merge_joints.h>
#include <auxfem/mesh/periodic_array.h>
#include <auxfem/parameters/errors.h>

#include <deal.II/base/symmetric_tensor.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>
#include <tuple>

namespace auxfem
{
  double Periodicity::volume() const
  {
    const dealii::Tensor<1, 3> along_z = dealii::Point<3>(0, 0, 1);
    return std::abs(dealii::cross_product_3d(vectors[0], vectors[1]) *
                    (vectors.size() == 3 ? vectors[2] : along_z));
  }

  double Periodicity::length() const
  {
    return std::pow(volume(), 1. / vectors.size());
  }

  std::vector<dealii::Tensor<1, 3>> Periodicity::reciprocal_vectors() const
  {
    // The plane is completed by z.
    dealii::Tensor<2, 3> translations = dealii::unit_symmetric_tensor<3>();
    for (std::size_t d = 0; d < vectors.size(); ++d)
      translations[d] = vectors[d];
    const dealii::Tensor<2, 3> columns =
      dealii::transpose(dealii::invert(translations));
    std::vector<dealii::Tensor<1, 3>> reciprocal;
    for (std::size_t d = 0; d < vectors.size(); ++d)
      reciprocal.push_back(columns[d]);
    return reciprocal;
  }

  dealii::Tensor<1, 3>
  Periodicity::translation(const std::array<int, 3> &shift) const
  {
    dealii::Tensor<1, 3> sum;
    for (std::size_t d = 0; d < vectors.size(); ++d)
      sum += shift[d] * vectors[d];
    return sum;
  }

  namespace
  {
    using Shift = std::array<int, 3>;

    Shift difference(const Shift &one, const Shift &other)
    {
      return {{one[0] - other[0], one[1] - other[1], one[2] - other[2]}};
    }

    constexpr Shift no_shift = {{0, 0, 0}};

    /** Points moved into the period, united, with their translations. */
    struct ReducedPoints
    {
      std::vector<unsigned int>     first; ///< equal point of lowest number
      std::vector<Shift>            shifts;
      std::vector<dealii::Point<3>> positions; ///< in the period (m)
    };

    class PeriodBuilder
    {
    public:
      PeriodBuilder(const UnitCell                    &cell,
                    const std::array<unsigned int, 3> &n_cells,
                    const unsigned int                 dimension)
        : n_cells(n_cells)
        , tolerance(joint_tolerance(cell))
        , n_made(larger(cell, n_cells, dimension))
        , whole(make_array(cell, n_made))
      {
        for (unsigned int d = 0; d < dimension; ++d)
          result.periodicity.vectors.push_back(double(n_cells[d]) *
                                               cell.vectors[d]);
        reciprocal = result.periodicity.reciprocal_vectors();
        joints     = reduce(whole.joints);
        // The first joint of equal ones stays where the cell has it.
        for (unsigned int j = whole.joints.size(); j-- > 0;)
          joints.shifts[j] =
            difference(joints.shifts[j], joints.shifts[joints.first[j]]);
      }

      PeriodicArray build()
      {
        Lattice &lattice  = result.lattice;
        lattice.dimension = result.periodicity.vectors.size();
        lattice.n_cells   = n_cells[0] * n_cells[1] * n_cells[2];
        lattice.notes     = whole.notes;
        add_bases();
        add_struts();
        add_pairs();
        add_joint_sets();
        return std::move(result);
      }

    private:
      /** Numbers of cells of an array that has every strut of the infinite
       * lattice up to translations. */
      static std::array<unsigned int, 3>
      larger(const UnitCell                    &cell,
             const std::array<unsigned int, 3> &n_cells,
             const unsigned int                 dimension)
      {
        std::array<unsigned int, 3> numbers = {{1, 1, 1}};
        for (unsigned int d = 0; d < dimension; ++d)
          {
            if (!cell.repeats(d))
              throw InputError(
                "Lattice: this cell cannot be repeated along " +
                std::string(1, "xyz"[d]) +
                ", which an infinite lattice needs. Give it a vector (Cell = "
                "pattern or mesh file), or choose another cell." +
                (dimension == 3 ? " Planar cells need Dimension = 2." : ""));
            // Struts and pairs reach the next cell but one at most.
            numbers[d] = n_cells[d] + 2;
          }
        return numbers;
      }

      /** The translation that moves a point out of the period. */
      Shift shift_of(const dealii::Point<3> &point) const
      {
        // Points on the sides of the period count to its lower ones.
        constexpr double rounding = 1e-6;
        Shift            shift    = no_shift;
        for (std::size_t d = 0; d < reciprocal.size(); ++d)
          shift[d] =
            static_cast<int>(std::floor(reciprocal[d] * point + rounding));
        return shift;
      }

      ReducedPoints reduce(const std::vector<dealii::Point<3>> &points) const
      {
        ReducedPoints reduced;
        for (const dealii::Point<3> &point : points)
          {
            reduced.shifts.push_back(shift_of(point));
            reduced.positions.push_back(
              point - result.periodicity.translation(reduced.shifts.back()));
          }
        reduced.first = first_joints_within(tolerance, reduced.positions);
        return reduced;
      }

      void add_bases()
      {
        bases.assign(whole.joints.size(), invalid_index);
        for (unsigned int j = 0; j < whole.joints.size(); ++j)
          if (joints.first[j] == j)
            {
              bases[j] = result.lattice.joints.size();
              result.lattice.joints.push_back(whole.joints[j]);
            }
        n_bases = result.lattice.joints.size();
      }

      /** The base joint of a joint of the whole array. */
      unsigned int base_of(const unsigned int joint) const
      {
        return bases[joints.first[joint]];
      }

      /** The joint at @p base moved by @p shift; made if there is none. */
      unsigned int image_of(const unsigned int base, const Shift &shift)
      {
        if (shift == no_shift)
          return base;
        const auto [entry, is_new] =
          images.try_emplace({base, shift}, result.lattice.joints.size());
        if (is_new)
          {
            result.lattice.joints.push_back(
              result.lattice.joints[base] +
              result.periodicity.translation(shift));
            result.periodicity.images.push_back({entry->second, base, shift});
          }
        return entry->second;
      }

      unsigned int reduced_cell(const unsigned int cell) const
      {
        const unsigned int i = cell % n_made[0],
                           j = cell / n_made[0] % n_made[1],
                           k = cell / n_made[0] / n_made[1];
        return i % n_cells[0] +
          n_cells[0] * (j % n_cells[1] + n_cells[1] * (k % n_cells[2]));
      }

      void add_struts()
      {
        std::vector<dealii::Point<3>> middles(whole.struts.size());
        for (unsigned int s = 0; s < whole.struts.size(); ++s)
          {
            dealii::Tensor<1, 3> tangent;
            whole.axis(whole.struts[s], 0.5, middles[s], tangent);
          }
        const ReducedPoints reduced = reduce(middles);
        std::map<std::tuple<unsigned int, unsigned int, unsigned int>,
                 unsigned int>
                                  known;
        std::vector<unsigned int> numbers;
        for (unsigned int s = 0; s < whole.struts.size(); ++s)
          {
            const Strut &strut = whole.struts[s];
            const auto   ends =
              std::minmax({base_of(strut.joints[0]), base_of(strut.joints[1])});
            const auto [entry, is_new] =
              known.try_emplace({reduced.first[s], ends.first, ends.second},
                                result.lattice.struts.size());
            numbers.push_back(entry->second);
            if (is_new)
              add_strut(strut);
          }
        for (const auto &[name, members] : whole.strut_sets)
          {
            std::set<unsigned int> reduced_set;
            for (const unsigned int s : members)
              reduced_set.insert(numbers[s]);
            result.lattice.strut_sets[name].assign(reduced_set.begin(),
                                                   reduced_set.end());
          }
      }

      void add_strut(Strut strut)
      {
        const unsigned int first = strut.joints[0], second = strut.joints[1];
        strut.joints = {
          {base_of(first),
           image_of(base_of(second),
                    difference(joints.shifts[second], joints.shifts[first]))}};
        strut.cell = reduced_cell(strut.cell);
        result.lattice.struts.push_back(strut);
      }

      void add_pairs()
      {
        for (const auto &[name, pairs] : whole.pair_sets)
          {
            std::vector<JointPair> &reduced = result.lattice.pair_sets[name];
            std::set<std::tuple<unsigned int, unsigned int, Shift>> known;
            for (const JointPair &pair : pairs)
              {
                const unsigned int first  = base_of(pair.first),
                                   second = base_of(pair.second);
                const Shift shift = difference(joints.shifts[pair.second],
                                               joints.shifts[pair.first]);
                if (!known.insert({first, second, shift}).second)
                  continue;
                known.insert({second, first, difference(no_shift, shift)});
                reduced.push_back(
                  {first, image_of(second, shift), reduced_cell(pair.cell)});
              }
          }
      }

      void add_joint_sets()
      {
        static const std::set<std::string> sides =
          {"left", "right", "bottom", "top", "back", "front"};
        for (const auto &[name, members] : whole.joint_sets)
          {
            if (sides.count(name) > 0)
              continue;
            std::vector<bool> is_member(n_bases, false);
            for (const unsigned int j : members)
              is_member[base_of(j)] = true;
            std::vector<unsigned int> &set = result.lattice.joint_sets[name];
            for (unsigned int j = 0; j < n_bases; ++j)
              if (is_member[j])
                set.push_back(j);
            for (const JointImage &image : result.periodicity.images)
              if (is_member[image.base])
                set.push_back(image.joint);
          }
      }

      const std::array<unsigned int, 3> n_cells;
      const double                      tolerance;
      const std::array<unsigned int, 3> n_made; ///< cells of `whole`
      const Lattice                     whole;
      std::vector<dealii::Tensor<1, 3>> reciprocal;
      ReducedPoints                     joints;
      std::vector<unsigned int>         bases; ///< by first joint of the whole
      unsigned int                      n_bases = 0;
      std::map<std::pair<unsigned int, Shift>, unsigned int> images;
      PeriodicArray                                          result;
    };
  } // namespace

  PeriodicArray make_periodic_array(const UnitCell                    &cell,
                                    const std::array<unsigned int, 3> &n_cells,
                                    const unsigned int dimension)
  {
    return PeriodBuilder(cell, n_cells, dimension).build();
  }
} // namespace auxfem
