#ifndef tests_support_beam_lattice_h
#define tests_support_beam_lattice_h

#include <auxfem/algebra/sparse_matrix.h>
#include <auxfem/algebra/unknowns.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/tensor.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <memory>
#include <set>
#include <tuple>

/**
 * Equations of star lattices of Euler-Bernoulli beams, one a strut, without
 * any of the program's meshes, numbering and elements.
 */
namespace auxfem::testing_support
{
  struct BeamLattice
  {
    std::vector<dealii::Point<3>>            joints;
    std::vector<std::array<unsigned int, 2>> struts;
    /** Joints at the lower side. */
    std::set<unsigned int> base;
  };

  /** Stars with struts of 10 mm, joined at their stub ends. */
  inline BeamLattice star_lattice(const unsigned int                 dimension,
                                  const std::array<unsigned int, 3> &cells)
  {
    const double length = 0.01;
    const double angle  = (dimension == 2 ? 60. : 70.) * std::acos(-1.) / 180.;
    const double tip    = length * std::sin(angle) / std::sqrt(dimension - 1.);
    const double notch = tip - length * std::cos(angle), stub = notch + length;

    BeamLattice                                lattice;
    std::map<std::array<int, 3>, unsigned int> joint_at;
    const auto add_joint = [&](const dealii::Point<3> &position) {
      std::array<int, 3> key;
      for (unsigned int c = 0; c < 3; ++c)
        key[c] = static_cast<int>(std::lround(position[c] * 1e6));
      const auto [entry, is_new] = joint_at.emplace(key, lattice.joints.size());
      if (is_new)
        lattice.joints.push_back(position);
      return entry->second;
    };
    for (unsigned int k = 0; k < (dimension == 3 ? cells[2] : 1); ++k)
      for (unsigned int j = 0; j < cells[1]; ++j)
        for (unsigned int i = 0; i < cells[0]; ++i)
          {
            const dealii::Point<3> centre(2 * stub * i,
                                          2 * stub * j,
                                          2 * stub * k);
            for (unsigned int axis = 0; axis < dimension; ++axis)
              for (const double sign : {-1., 1.})
                {
                  dealii::Point<3> at_notch = centre, at_stub = centre;
                  at_notch[axis] += sign * notch;
                  at_stub[axis] += sign * stub;
                  const unsigned int inner = add_joint(at_notch),
                                     outer = add_joint(at_stub);
                  lattice.struts.push_back({{inner, outer}});
                  if (axis == 1 && sign < 0 && j == 0)
                    lattice.base.insert(outer);
                  for (unsigned int t = 0; t < (1u << dimension); ++t)
                    if (((t >> axis & 1) != 0) == (sign > 0))
                      {
                        dealii::Point<3> at_tip = centre;
                        for (unsigned int c = 0; c < dimension; ++c)
                          at_tip[c] += (t >> c & 1) != 0 ? tip : -tip;
                        lattice.struts.push_back({{inner, add_joint(at_tip)}});
                      }
                }
          }
    return lattice;
  }

  struct BeamOptions
  {
    /** On the diagonal of displacements (N/m). */
    double inertia = 0;
    /** Axial forces of all struts (N), by the string stiffness. */
    double tension = 0;
    /** A moment about z proportional to x displacements (N). */
    double follower     = 0;
    bool   has_supports = true;
  };

  /** The joint system of a lattice, spread over the ranks in blocks. */
  class BeamSystem
  {
  public:
    BeamSystem(const unsigned int dimension,
               const BeamLattice &lattice,
               const BeamOptions &options = {})
      : lattice(lattice)
      , components(dimension == 2 ? std::vector<unsigned int>{0, 1, 5}
                                  : std::vector<unsigned int>{0, 1, 2, 3, 4, 5})
    {
      number_unknowns();
      add_struts(options);
      if (!options.has_supports)
        this->lattice.base.clear();
      make_layout();
      fill(options);
    }

    std::unique_ptr<UnknownLayout> layout;
    std::unique_ptr<Unknowns>      unknowns;
    std::unique_ptr<SparseMatrix>  matrix;

    /** Global number of a component (by its place in components) of a joint. */
    int number(const unsigned int joint, const unsigned int c) const
    {
      return first[rank_of[joint]] + position[joint] * components.size() + c;
    }

    /** A right-hand side of about one that does not depend on the ranks. */
    std::vector<double> loads() const
    {
      std::vector<double> b(layout->n_owned());
      for (unsigned int i = 0; i < b.size(); ++i)
        if (unknowns->kinds[i] == UnknownKind::translation)
          b[i] =
            std::sin(1. + unknowns->joint[i] + 2. * unknowns->component[i]);
      return b;
    }

    /** Largest |A x - b| relative to the largest |A| |x|. */
    double residual(const std::vector<double> &x,
                    const std::vector<double> &b) const
    {
      std::vector<double> local(layout->n_local()), image(layout->n_owned()),
        sizes(image);
      std::copy(x.begin(), x.end(), local.begin());
      layout->update_ghosts(local.data());
      matrix->multiply(local.data(), image.data());
      double error = 0, size = 0;
      for (unsigned int row = 0; row < image.size(); ++row)
        {
          const double factor =
            unknowns->is_rotation[row] ? 1 / unknowns->length : 1;
          double sum = std::abs(b[row]);
          for (std::size_t i = matrix->first[row]; i < matrix->first[row + 1];
               ++i)
            sum += std::abs(matrix->entries[i] * local[matrix->columns[i]]);
          error = std::max(error, std::abs(image[row] - b[row]) * factor);
          size  = std::max(size, sum * factor);
          if (std::isnan(image[row]))
            return image[row];
        }
      return layout->largest(error) / layout->largest(size);
    }

    static constexpr double side = 0.0004, young = 70e9;

  private:
    static constexpr double second_moment = side * side * side * side / 12,
                            shear         = young / 2.66,
                            torsion       = 0.141 * side * side * side * side;

    void number_unknowns()
    {
      n_ranks = dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD);
      rank    = dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD);
      dealii::Point<3> largest;
      for (const dealii::Point<3> &joint : lattice.joints)
        for (unsigned int c = 0; c < 3; ++c)
          largest[c] = std::max(largest[c], joint[c]);
      // Two columns of ranks if their number is even.
      const unsigned int across = n_ranks % 2 == 0 ? 2 : 1,
                         up     = n_ranks / across;
      const auto part =
        [](const double x, const double end, const unsigned int n) {
          return std::min<int>(
            n - 1,
            std::max<int>(0, static_cast<int>(x / (end + 1e-9) * n)));
        };
      std::vector<int> count(n_ranks, 0);
      for (const dealii::Point<3> &joint : lattice.joints)
        {
          rank_of.push_back(part(joint[0], largest[0], across) * up +
                            part(joint[1], largest[1], up));
          position.push_back(count[rank_of.back()]++);
        }
      first.assign(1, 0);
      for (unsigned int r = 0; r < n_ranks; ++r)
        first.push_back(first.back() +
                        count[r] * static_cast<int>(components.size()));
      rows.resize(first[rank + 1] - first[rank]);
    }

    /** Adds to the rows of this rank. */
    void add(const int row, const int column, const double entry)
    {
      if (row >= first[rank] && row < first[rank + 1])
        rows[row - first[rank]].push_back({column, entry});
    }

    /** Direction and two across it. */
    std::array<dealii::Tensor<1, 3>, 3> axes(const unsigned int strut) const
    {
      const auto &[a, b]         = lattice.struts[strut];
      dealii::Tensor<1, 3> along = lattice.joints[b] - lattice.joints[a], other;
      along /= along.norm();
      other[2] = 1;
      if (std::abs(along[2]) > 0.9)
        {
          other    = 0.;
          other[0] = 1;
        }
      dealii::Tensor<1, 3> y = dealii::cross_product_3d(other, along);
      y /= y.norm();
      return {{along, y, dealii::cross_product_3d(along, y)}};
    }

    void add_struts(const BeamOptions &options)
    {
      for (unsigned int strut = 0; strut < lattice.struts.size(); ++strut)
        {
          const auto &[a, b] = lattice.struts[strut];
          if (rank_of[a] != rank && rank_of[b] != rank)
            continue;
          add_strut(strut, options);
        }
    }

    void add_strut(const unsigned int strut, const BeamOptions &options)
    {
      const auto   ends  = lattice.struts[strut];
      const auto   frame = axes(strut);
      const double l =
        lattice.joints[ends[0]].distance(lattice.joints[ends[1]]);
      const double bending = young * second_moment / (l * l * l);
      std::array<std::array<double, 12>, 12> k = {};
      const auto set = [&k](const int i, const int j, const double value) {
        k[i][j] += value;
        if (i != j)
          k[j][i] += value;
      };
      const auto pair = [&](const int c, const double value) {
        set(c, c, value);
        set(6 + c, 6 + c, value);
        set(c, 6 + c, -value);
      };
      pair(0, young * side * side / l);
      pair(3, shear * torsion / l);
      // Bending towards axis 1 turns about 2, towards 2 about minus 1.
      for (const auto &[w, r, sign] :
           {std::make_tuple(1, 5, 1.), std::make_tuple(2, 4, -1.)})
        {
          pair(w, 12 * bending + options.tension / l);
          for (const int e : {0, 6})
            {
              set(w, e + r, sign * 6 * bending * l);
              set(6 + w, e + r, -sign * 6 * bending * l);
              set(e + r, e + r, 4 * bending * l * l);
            }
          set(r, 6 + r, 2 * bending * l * l);
        }
      for (unsigned int i = 0; i < 2 * components.size(); ++i)
        for (unsigned int j = 0; j < 2 * components.size(); ++j)
          {
            const unsigned int n = components.size(), ci = components[i % n],
                               cj = components[j % n];
            double entry          = 0;
            for (unsigned int p = 0; p < 3; ++p)
              for (unsigned int q = 0; q < 3; ++q)
                entry += frame[p][ci % 3] * frame[q][cj % 3] *
                  k[i / n * 6 + ci / 3 * 3 + p][j / n * 6 + cj / 3 * 3 + q];
            add(number(ends[i / n], i % n), number(ends[j / n], j % n), entry);
          }
    }

    void make_layout()
    {
      std::vector<int> ghosts;
      for (const std::vector<Summand> &row : rows)
        for (const auto &[column, value] : row)
          if (column < first[rank] || column >= first[rank + 1])
            ghosts.push_back(column);
      std::sort(ghosts.begin(), ghosts.end());
      ghosts.erase(std::unique(ghosts.begin(), ghosts.end()), ghosts.end());
      layout   = std::make_unique<UnknownLayout>(MPI_COMM_WORLD,
                                               first[rank + 1] - first[rank],
                                               ghosts);
      unknowns = std::make_unique<Unknowns>(*layout);
      unknowns->positions =
        std::make_shared<const std::vector<dealii::Point<3>>>(lattice.joints);
      unknowns->components = components;
      unknowns->length     = 0.01;
      for (unsigned int joint = 0; joint < lattice.joints.size(); ++joint)
        for (unsigned int c = 0; c < components.size(); ++c)
          if (const int local = layout->local(number(joint, c)); local >= 0)
            {
              unknowns->joint[local]       = joint;
              unknowns->component[local]   = components[c];
              unknowns->is_rotation[local] = components[c] >= 3;
              unknowns->kinds[local]       = lattice.base.count(joint) > 0
                      ? UnknownKind::prescribed
                      : components[c] >= 3 ? UnknownKind::rotation
                                           : UnknownKind::translation;
            }
    }

    void fill(const BeamOptions &options)
    {
      matrix = std::make_unique<SparseMatrix>(*layout);
      for (unsigned int row = 0; row < rows.size(); ++row)
        {
          fill_row(row);
          matrix->first[row + 1] = matrix->columns.size();
          if (unknowns->kinds[row] == UnknownKind::translation)
            for (std::size_t i = matrix->first[row]; i < matrix->first[row + 1];
                 ++i)
              if (matrix->columns[i] == static_cast<int>(row))
                matrix->entries[i] += options.inertia;
        }
      rows.clear();
      if (options.follower != 0)
        add_follower(options.follower);
    }

    void fill_row(const unsigned int row)
    {
      std::vector<Summand> &summands = rows[row];
      for (Summand &summand : summands)
        summand.column = layout->local(summand.column);
      std::sort(summands.begin(),
                summands.end(),
                [](const Summand &a, const Summand &b) {
                  return a.column < b.column;
                });
      int last = -1;
      for (const auto &[column, value] : summands)
        {
          if (column != last)
            {
              matrix->columns.push_back(column);
              matrix->entries.push_back(0);
            }
          last = column;
          const bool is_fixed =
            unknowns->kinds[row] == UnknownKind::prescribed ||
            unknowns->kinds[column] == UnknownKind::prescribed;
          if (!is_fixed)
            matrix->entries.back() += value;
          else if (static_cast<int>(row) == column)
            matrix->entries.back() = 1;
        }
    }

    void add_follower(const double moment)
    {
      matrix->is_symmetric = false;
      for (unsigned int row = 0; row < layout->n_owned(); ++row)
        if (unknowns->kinds[row] == UnknownKind::rotation &&
            unknowns->component[row] == 5)
          for (std::size_t i = matrix->first[row]; i < matrix->first[row + 1];
               ++i)
            if (const int column = matrix->columns[i];
                unknowns->kinds[column] == UnknownKind::translation &&
                unknowns->component[column] == 0)
              matrix->entries[i] += moment;
    }

    struct Summand
    {
      int    column; ///< global at first, then local
      double value;
    };

    BeamLattice                       lattice;
    std::vector<unsigned int>         components;
    unsigned int                      n_ranks, rank;
    std::vector<unsigned int>         rank_of, position;
    std::vector<int>                  first;
    std::vector<std::vector<Summand>> rows; ///< of this rank
  };
} // namespace auxfem::testing_support

#endif
