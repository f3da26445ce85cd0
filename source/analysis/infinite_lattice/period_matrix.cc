#include <auxfem/analysis/infinite_lattice/period_matrix.h>
#include <auxfem/mesh/periodic_array.h>
#include <auxfem/model/linear_relations.h>

#include <deal.II/base/mpi.h>

#include <cmath>
#include <set>

namespace auxfem
{
  std::vector<MatrixEntry> entries_on_first_rank(const TangentMatrix &matrix,
                                                 const UnknownLayout &layout)
  {
    const TangentPattern    &pattern = matrix.pattern();
    std::vector<MatrixEntry> mine;
    for (std::size_t block = 0; block < pattern.n_blocks(); ++block)
      {
        const int *const   unknowns = pattern.begin(block);
        const unsigned int n        = pattern.size(block);
        const double      *values   = matrix.values(block);
        // The owned rows of all ranks are the matrix.
        for (unsigned int i = 0; i < n; ++i)
          if (layout.is_owned(unknowns[i]))
            for (unsigned int j = 0; j < n; ++j)
              if (unknowns[j] >= 0 && values[i * n + j] != 0)
                mine.push_back({layout.global(unknowns[i]),
                                layout.global(unknowns[j]),
                                values[i * n + j]});
      }
    if (layout.n_ranks() == 1)
      return mine;
    std::vector<double> packed;
    for (const MatrixEntry &entry : mine)
      packed.insert(packed.end(),
                    {double(entry.row), double(entry.column), entry.value});
    std::vector<MatrixEntry> all;
    for (const std::vector<double> &part :
         dealii::Utilities::MPI::gather(layout.communicator(), packed))
      for (std::size_t i = 0; i < part.size(); i += 3)
        all.push_back({int(part[i]), int(part[i + 1]), part[i + 2]});
    return all;
  }

  PeriodUnknowns::PeriodUnknowns(const LatticeModel &model)
  {
    const Lattice       &lattice = model.lattice;
    const GlobalNumbers &numbers = model.numbering.global();
    places.resize(model.numbering.layout().n_global());
    std::vector<bool> has_number(places.size(), true);
    for (unsigned int d = 0; d < lattice.n_axes; ++d)
      for (unsigned int c = 0; c < lattice.dimension; ++c)
        has_number[numbers.joints[lattice.joint_of_axis(d)][c]] = false;
    for (const GlobalNumbers::RelationNumbers &relation : numbers.relations)
      has_number[relation.multiplier] = false;
    const std::vector<ImageTie> ties = image_ties(lattice, model.releases);
    for (const ImageTie &tie : ties)
      has_number[numbers.joints[tie.image][tie.component]] = false;
    for (std::size_t u = 0; u < places.size(); ++u)
      if (has_number[u])
        places[u].number = n++;
    for (const ImageTie &tie : ties)
      places[numbers.joints[tie.image][tie.component]] =
        {places[numbers.joints[tie.base][tie.component]].number, tie.shift};
  }

  void PeriodMatrix::add(const PeriodUnknowns::Place &row,
                         const PeriodUnknowns::Place &column,
                         const double                 value)
  {
    if (row.number == invalid_index || column.number == invalid_index)
      return;
    Entry entry{row.number, column.number, {}, value};
    for (unsigned int d = 0; d < 3; ++d)
      entry.shift[d] = column.shift[d] - row.shift[d];
    entries.push_back(entry);
  }

  void PeriodMatrix::add_multiple(const double        factor,
                                  const PeriodMatrix &other)
  {
    for (Entry entry : other.entries)
      {
        entry.value *= factor;
        entries.push_back(entry);
      }
  }

  dealii::FullMatrix<double>
  PeriodMatrix::at(const WavePhases  &phases,
                   const unsigned int derivative) const
  {
    // Re z + i Im z acts on real and imaginary parts as [Re, -Im; Im, Re].
    dealii::FullMatrix<double> matrix(2 * n, 2 * n);
    for (const Entry &entry : entries)
      {
        double phase = 0;
        for (unsigned int d = 0; d < 3; ++d)
          phase += entry.shift[d] * phases[d];
        double real = std::cos(phase), imaginary = std::sin(phase);
        if (derivative < 3)
          {
            const double cosine = real;
            real                = -entry.shift[derivative] * imaginary;
            imaginary           = entry.shift[derivative] * cosine;
          }
        const auto add =
          [&](const unsigned int i, const unsigned int j, const double part) {
            matrix(i, j) += entry.value * part;
          };
        add(entry.row, entry.column, real);
        add(entry.row, n + entry.column, -imaginary);
        add(n + entry.row, entry.column, imaginary);
        add(n + entry.row, n + entry.column, real);
      }
    return matrix;
  }

  std::vector<unsigned int> PeriodMatrix::unknowns() const
  {
    std::set<unsigned int> found;
    for (const Entry &entry : entries)
      found.insert({entry.row, entry.column});
    return {found.begin(), found.end()};
  }

  std::vector<double> PeriodMatrix::diagonal() const
  {
    std::vector<double> sums(n, 0.);
    for (const Entry &entry : entries)
      if (entry.row == entry.column && entry.shift == std::array<int, 3>{})
        sums[entry.row] += entry.value;
    return sums;
  }
} // namespace auxfem
