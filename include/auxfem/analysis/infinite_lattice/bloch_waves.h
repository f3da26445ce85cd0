#ifndef auxfem_analysis_infinite_lattice_bloch_waves_h
#define auxfem_analysis_infinite_lattice_bloch_waves_h

#include <auxfem/algebra/ritz_pairs.h>
#include <auxfem/analysis/infinite_lattice/period_matrix.h>
#include <auxfem/analysis/simulation/lattice_run.h>

#include <optional>
#include <utility>
#include <vector>

namespace auxfem
{
  /** A wave of an infinite lattice without damping. */
  struct BlochWave
  {
    double angular_frequency; ///< rad/s
    /** Derivatives by the wave vector (m/s); none where several waves have this
     * frequency, so that derivatives depend on the direction. */
    std::optional<dealii::Tensor<1, 3>> group_velocity;
  };

  /** A damped wave: it oscillates and decays as e^((-decay + i w) t). */
  struct DampedWave
  {
    double angular_frequency; ///< w (rad/s)
    double decay;             ///< 1/s
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
     * Assembles stiffness, mass and damping of the period at the state of
     * @p run.
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

    /**
     * The @p n damped waves of lowest frequency, in ascending order; motions
     * that decay without oscillation are no waves. Combinations of undamped
     * waves and of the motions by forces of the dampers, the residual vectors
     * of modal analysis (Dickens, Nakagawa and Wittbrodt, 1997, Computers and
     * Structures 62, 985).
     */
    std::vector<DampedWave> damped_waves(const WavePhases &phases,
                                         unsigned int      n) const;

  private:
    /** Undamped waves and residual vectors, as columns of unit length in the
     * norm of `shifted`, without coupling by mass and stiffness. */
    dealii::FullMatrix<double> damped_basis(const WavePhases &phases,
                                            unsigned int      n) const;

    /** Quotients 1 / (w^2 + shift) of all waves, each twice: a vector and i
     * times it, for the @p n lowest waves. */
    RitzPairs quotients(const WavePhases &phases, unsigned int n) const;

    /** Squared angular frequency (1/s2) of a quotient. */
    double squared_frequency(double quotient) const;

    const Lattice &lattice;
    PeriodMatrix   stiffness{0}, mass{0};
    double         shift = 0; ///< of squared frequencies (1/s2)
    /** Stiffness plus shift times mass. */
    PeriodMatrix shifted{0};
    PeriodMatrix damping{0};
    /** Stiffness of Maxwell elements by relaxation time (s). */
    std::vector<std::pair<double, PeriodMatrix>> relaxing;
  };
} // namespace auxfem

#endif
