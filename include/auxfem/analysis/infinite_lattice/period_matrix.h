#ifndef auxfem_analysis_infinite_lattice_period_matrix_h
#define auxfem_analysis_infinite_lattice_period_matrix_h

#include <auxfem/algebra/tangent_matrix.h>
#include <auxfem/model/lattice_model.h>

#include <array>
#include <vector>

namespace auxfem
{
  /** Phases (rad) of a wave over the translations of the period. */
  using WavePhases = std::array<double, 3>;

  /** An entry of a matrix by global numbers of the finite elements. */
  struct MatrixEntry
  {
    int    row, column;
    double value;
  };

  /** All entries of @p matrix on the first rank, in the order of its blocks;
   * none on others. Prescribed unknowns have entries, too. Collective. */
  std::vector<MatrixEntry> entries_on_first_rank(const TangentMatrix &matrix,
                                                 const UnknownLayout &layout);

  /**
   * Unknowns of one period by unknowns of the finite elements: those of images
   * are the ones of their base joints, some periods away. The axes of the mean
   * deformation and the multipliers that tie images have none.
   */
  class PeriodUnknowns
  {
  public:
    explicit PeriodUnknowns(const LatticeModel &model);

    struct Place
    {
      unsigned int       number = invalid_index; ///< in the period
      std::array<int, 3> shift  = {{0, 0, 0}};   ///< in periods
    };

    /** @param global number of an unknown of the finite elements */
    const Place &operator[](const int global) const
    {
      return places[global];
    }

    /** Number of unknowns of the period. */
    unsigned int size() const
    {
      return n;
    }

  private:
    std::vector<Place> places;
    unsigned int       n = 0;
  };

  /** A matrix of a period: its entries have a factor that depends on the phase
   * of a wave between row and column. */
  class PeriodMatrix
  {
  public:
    /** @param size number of unknowns */
    explicit PeriodMatrix(const unsigned int size) : n(size)
    {}

    /** Adds an entry between two unknowns. */
    void add(const PeriodUnknowns::Place &row,
             const PeriodUnknowns::Place &column,
             double                       value);

    /** Adds @p factor times @p other, which has the same unknowns. */
    void add_multiple(double factor, const PeriodMatrix &other);

    /**
     * The Hermitian matrix for @p phases as a real symmetric one of twice the
     * size: it acts on real and imaginary parts.
     * @param derivative number of the phase by which to differentiate; 3: none
     */
    dealii::FullMatrix<double> at(const WavePhases &phases,
                                  unsigned int      derivative = 3) const;

    /** Sorted unknowns that have entries. */
    std::vector<unsigned int> unknowns() const;

    /** Diagonal, without entries that depend on the phases. */
    std::vector<double> diagonal() const;

    unsigned int size() const
    {
      return n;
    }

  private:
    struct Entry
    {
      unsigned int       row, column;
      std::array<int, 3> shift; ///< from row to column, in periods
      double             value;
    };

    unsigned int       n;
    std::vector<Entry> entries;
  };
} // namespace auxfem

#endif
