#ifndef auxfem_analysis_infinite_lattice_bloch_waves_h
#define auxfem_analysis_infinite_lattice_bloch_waves_h

#include <auxfem/algebra/eigen_solver.h>
#include <auxfem/analysis/simulation/lattice_run.h>

#include <array>
#include <vector>

namespace auxfem
{
  /** Phases (rad) of a wave over the translations of the period. */
  using WavePhases = std::array<double, 3>;

  /** A wave of an infinite lattice without damping. */
  struct BlochWave
  {
    double angular_frequency; ///< rad/s
    /** Derivatives by the wave vector (m/s); none where several waves have this
     * frequency, so that derivatives depend on the direction. */
    std::optional<dealii::Tensor<1, 3>> group_velocity;
  };

  /**
   * Waves $\mathbf u_{j + \mathbf s} = e^{\mathrm i \mathbf k\cdot\mathbf s}
   * \mathbf u_j$ of an infinite lattice, in the elements of a run (Bloch's
   * theorem; Phani, Woodhouse and Fleck, 2006, J. Acoust. Soc. Am. 119, 1995).
   */
  class BlochWaves
  {
  public:
    /**
     * Assembles stiffness and mass of the period at rest.
     * @param run of an infinite lattice without relations of images, on one
     * rank. Throws InputError for motions without mass.
     */
    explicit BlochWaves(LatticeRun &run);

    /** The @p n lowest angular frequencies (rad/s), in ascending order. */
    std::vector<double> frequencies(const WavePhases &phases,
                                    unsigned int      n) const;

    /** The @p n waves of lowest frequency, in ascending order. */
    std::vector<BlochWave> waves(const WavePhases &phases,
                                 unsigned int      n) const;

  private:
    /** Entries of the matrices between unknowns of the period, whose factor
     * depends on the phase of their difference in periods. */
    struct Entry
    {
      unsigned int       row, column;
      std::array<int, 3> shift;
      double             stiffness, mass;
    };

    /** Sum over the entries, as a real symmetric matrix of twice the size.
     * @param value of an entry
     * @param derivative number of the phase by which to differentiate; 3: none
     */
    template <class Value>
    dealii::FullMatrix<double> real_matrix(const WavePhases &phases,
                                           const Value      &value,
                                           unsigned int derivative = 3) const;

    /** Quotients 1 / (w^2 + shift) of all waves, each twice: a vector and i
     * times it. */
    RitzPairs quotients(const WavePhases &phases) const;

    /** Squared angular frequency (1/s2) of a quotient. */
    double squared_frequency(double quotient) const;

    const Lattice     &lattice;
    unsigned int       n_reduced = 0;
    std::vector<Entry> entries;
    double             shift = 0; ///< of squared frequencies (1/s2)
  };
} // namespace auxfem

#endif
