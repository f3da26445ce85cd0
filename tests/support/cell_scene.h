#ifndef auxfem_tests_support_cell_scene_h
#define auxfem_tests_support_cell_scene_h

#include <auxfem/analysis/reduced_cell/cell_run.h>
#include <auxfem/scene/scene.h>

#include <sstream>
#include <stdexcept>
#include <string>

namespace auxfem
{
  namespace testing_support
  {
    /** A reduced cell in numbers; by default case 1 of the paper's Table 1. */
    struct CellCase
    {
      double      bar_length = 0.5; ///< L1 (m)
      double      angle      = 30;  ///< theta0 (deg)
      double      bar_mass   = 0.1; ///< m1 (kg)
      double      part_mass  = 0.3; ///< m2 (kg)
      std::string load       = "2e7*t^3";
      std::string law        = "kelvin-voigt";
      double      stiffness  = 2e4; ///< K (N/m)
      double      damping    = 50;  ///< C (N s/m)
      /** Further lines of the connector. */
      std::string  connector_lines = {};
      double       end             = 0.05; ///< s
      unsigned int n_steps         = 1000;
      std::string  scheme          = "arkode";
      double       tolerance       = 1e-12; ///< of Newton's method
    };

    /** Number @p n of Table 1, with L1 = 0.5 m and m2 = 3 m1. */
    inline CellCase table_case(const unsigned int n)
    {
      CellCase c;
      if (n > 4)
        c.law = "maxwell";
      if (n == 2 || n == 6)
        c.angle = 60;
      if (n == 3 || n == 7)
        c.bar_mass = 0.5;
      c.part_mass = 3 * c.bar_mass;
      if (n == 4 || n == 8)
        c.load = "5e4*t";
      return c;
    }

    inline std::string cell_text(const CellCase &c)
    {
      std::ostringstream text;
      text.precision(17);
      text
        << "set Model = reduced cell\nsubsection Reduced cell\n"
        << " set Bar length = " << c.bar_length << "\n set Angle = " << c.angle
        << "\n set Bar mass = " << c.bar_mass
        << "\n set Part mass = " << c.part_mass << "\n set Load = " << c.load
        << "\nend\nsubsection Connectors\n subsection connector\n  set Law = "
        << c.law << '\n';
      if (c.law != "dashpot" && c.law != "generalized-maxwell")
        text << "  set Spring stiffness = " << c.stiffness << '\n';
      if (c.law != "spring" && c.law != "generalized-maxwell" &&
          c.law != "friction-slider")
        text << "  set Damping coefficient = " << c.damping << '\n';
      text << c.connector_lines
           << " end\nend\nsubsection Time\n set Scheme = " << c.scheme
           << "\n set End time = " << c.end
           << "\n set Time step = " << c.end / c.n_steps
           << "\nend\nsubsection Newton\n set Tolerance = " << c.tolerance
           << "\nend\n";
      return text.str();
    }

    inline Scene cell_scene(const CellCase &c)
    {
      return read_scene_from_text(cell_text(c), "cell.prm");
    }

    /** All samples of @p c. Throws if it does not reach its end. */
    inline std::vector<CellSample> complete_history(const CellCase &c)
    {
      CellHistory history = compute_history(cell_scene(c));
      if (history.exit_state != "completed")
        throw std::runtime_error(history.exit_state);
      return history.samples;
    }

    /** Largest |quantity| in @p samples. */
    inline double largest(const std::vector<CellSample> &samples,
                          double CellSample::*const quantity)
    {
      double result = 0;
      for (const CellSample &sample : samples)
        result = std::max(result, std::abs(sample.*quantity));
      return result;
    }

    /**
     * Largest difference at the times of @p coarse, every n-th of @p fine, of
     * the largest value in @p fine.
     */
    inline double largest_difference(const std::vector<CellSample> &coarse,
                                     const std::vector<CellSample> &fine,
                                     double CellSample::*const quantity)
    {
      const std::size_t ratio  = (fine.size() - 1) / (coarse.size() - 1);
      double            result = 0;
      for (std::size_t i = 0; i < coarse.size(); ++i)
        result =
          std::max(result,
                   std::abs(coarse[i].*quantity - fine[ratio * i].*quantity));
      return result / largest(fine, quantity);
    }
  } // namespace testing_support
} // namespace auxfem

#endif
