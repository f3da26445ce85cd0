#ifndef auxfem_reduced_cell_cell_scheme_h
#define auxfem_reduced_cell_cell_scheme_h

#include <auxfem/scene/scene.h>
#include <auxfem/system/state.h>

#include <deal.II/base/numbers.h>

#include <memory>
#include <vector>

namespace auxfem
{
  /**
   * The cell at one time, a row of its history. What a scheme does not know is
   * not a number.
   */
  struct CellSample
  {
    double   time;        ///< s
    double   angle;       ///< theta (rad)
    double   upper_rise;  ///< Y1 (m)
    double   lower_rise;  ///< Y2 (m)
    double   load;        ///< f1 (N)
    double   transmitted; ///< f2 on the foundation (N), positive in compression
    Energies energies;
  };

  /** An angle (rad) as users read it (deg). */
  inline double degrees(const double radians)
  {
    return radians * 180 / dealii::numbers::PI;
  }

  /** Takes the reduced cell of a scene through time, step by step. */
  class CellScheme
  {
  public:
    virtual ~CellScheme() = default;

    /**
     * The cell at t = 0, at rest. To be called once, before advance(). Throws
     * ComputationError if there is no first acceleration.
     */
    virtual CellSample start() = 0;

    /**
     * Advances by one step of the scene. Throws ComputationError if it cannot;
     * the samples until then hold.
     */
    virtual CellSample advance() = 0;

    /** Iterations, or evaluations of the equations, so far. */
    virtual unsigned long work() const = 0;
  };

  /** One line of the table of the reduced cell's schemes. */
  struct CellSchemeEntry
  {
    std::string name;
    std::string description;
    /** Throws InputError if the scheme cannot do the scene. */
    std::unique_ptr<CellScheme> (*make)(const Scene &scene);
  };

  /** All schemes of the reduced cell (reduced_cell/register.cc). */
  const std::vector<CellSchemeEntry> &cell_scheme_registry();

  /** The line of @p scene's scheme in the table. */
  const CellSchemeEntry &cell_scheme_entry(const Scene &scene);

  /** @name Makers of the table, one per file; only register.cc needs them. */
  ///@{
  /** Newmark, HHT and generalized-alpha, as for lattices. */
  std::unique_ptr<CellScheme> make_alpha_cell_scheme(const Scene &scene);
  /** The paper's grids with a consistent second difference. */
  std::unique_ptr<CellScheme> make_central_difference(const Scene &scene);
  /** The paper's equations and scheme as they stand in it. */
  std::unique_ptr<CellScheme> make_printed_scheme(const Scene &scene);
  /** Runge-Kutta of high order with error control. */
  std::unique_ptr<CellScheme> make_arkode_scheme(const Scene &scene);
  ///@}
} // namespace auxfem

#endif
