#ifndef auxfem_analysis_infinite_lattice_period_tangent_h
#define auxfem_analysis_infinite_lattice_period_tangent_h

#include <auxfem/analysis/infinite_lattice/period_matrix.h>
#include <auxfem/equations/equations.h>

#include <deal.II/lac/full_matrix.h>

#include <optional>
#include <utility>
#include <vector>

namespace auxfem
{
  /**
   * Tangent stiffness of an infinite lattice at an equilibrium: of its mean
   * deformation, and against waves. Motions inside of struts are eliminated.
   * The constructor is collective; the rest needs the first rank.
   */
  class PeriodTangent
  {
  public:
    /** The tangent at @p state of a run with relations of images. */
    PeriodTangent(const Equations &equations, const State &state);

    /**
     * Derivatives of the mean nominal stress by the mean strain (Pa), in the
     * order xx, xy, yx, yy in the plane (row by row); the period adapts. Empty
     * if its stiffness is singular.
     */
    const std::optional<dealii::FullMatrix<double>> &moduli() const
    {
      return tangent_moduli;
    }

    /**
     * Least eigenvalue of the stiffness against waves of @p phases (N/m);
     * rotations are multiplied by the mean strut length. It is negative if a
     * wave grows. Equal translations, which have no stiffness, are left out.
     */
    double least_stiffness(const WavePhases &phases) const;

    /** Number of motions without stiffness that all periods make alike, besides
     * translations, while the mean deformation is held. */
    unsigned int n_mechanisms() const;

    /** Whether struts touch those of the next period. least_stiffness() then
     * takes both for struts of one phase. */
    bool has_contact_between_periods() const
    {
      return touches_next_period;
    }

    /** Whether struts between their joints are stable. */
    bool struts_are_stable() const
    {
      return inner_is_stable;
    }

  private:
    /** An unknown left after the elimination, with its place in the period and
     * its motion under a mean strain of 1 along each axis (m). */
    struct Outer
    {
      PeriodUnknowns::Place place;
      unsigned int          component = n_motion_components;
      std::array<double, 3> along     = {{0, 0, 0}};
    };

    /** Sets `outer` for all unknowns of the finite elements; returns which of
     * them belong to the inside of struts. */
    std::vector<bool> classify_unknowns(const LatticeModel &model);

    /** Whether contact couples @p entries with the mean deformation. */
    bool has_contact_with_copies(const LatticeModel             &model,
                                 const std::vector<MatrixEntry> &entries,
                                 const std::vector<bool> &is_inner) const;

    /** Numbers the outer unknowns of the period consecutively. */
    void renumber(const std::vector<bool> &is_inner);

    /** Length by which an outer unknown of the period is divided: the mean
     * strut length of rotations, else 1. */
    double unit(unsigned int number) const;

    /** Stiffness against waves of @p phases as PeriodMatrix::at(), with unknowns
     * times unit(); equal translations have an artificial stiffness. */
    dealii::FullMatrix<double>
    stiffness_in_one_unit(const WavePhases &phases) const;

    /** Eliminates inner unknowns of @p entries from them. */
    void eliminate(std::vector<MatrixEntry> &entries,
                   const std::vector<bool>  &is_inner);

    void find_moduli(const std::vector<MatrixEntry> &entries);

    const unsigned int dimension;
    unsigned int       n_multipliers   = 0;
    bool               inner_is_stable = true, touches_next_period = false;
    /** By global number. */
    std::vector<Outer> outer;
    /** Outer unknowns of the period: component of motion; others none. */
    std::vector<unsigned int>                 components;
    double                                    volume; ///< with the depth (m3)
    double                                    strut_length; ///< mean (m)
    PeriodMatrix                              stiffness{0};
    std::optional<dealii::FullMatrix<double>> tangent_moduli;
  };

  /**
   * Least eigenvalue, over directions of long waves, of the acoustic tensor
   * Q_ik = n_j L_ijkl n_l of tangent moduli (Pa), with its direction: waves far
   * longer than the period grow if it is negative (Geymonat, Mueller and
   * Triantafyllidis, 1993, Archive for Rational Mechanics and Analysis 122,
   * 231).
   */
  std::pair<double, dealii::Tensor<1, 3>>
  least_acoustic_modulus(const dealii::FullMatrix<double> &moduli);
} // namespace auxfem

#endif
