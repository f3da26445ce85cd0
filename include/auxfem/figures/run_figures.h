#ifndef auxfem_figures_run_figures_h
#define auxfem_figures_run_figures_h

#include <auxfem/figures/figures_definition.h>
#include <auxfem/figures/recorded_table.h>

#include <optional>
#include <string>
#include <vector>

namespace auxfem
{
  /** The bodies and the lattice between them at rest, for a crush curve. */
  struct CrushGeometry
  {
    /** Middle of the first and the second body (m). */
    std::array<std::array<double, 3>, 2> positions = {};
    std::array<double, 3>                size      = {}; ///< of the lattice (m)
    /** Depth of the lattice in the plane (m); empty in space. */
    std::optional<double> depth;
    /** Mass of struts and rigid parts (kg); empty if not known. */
    std::optional<double> mass;
  };

  /** A crush curve with what relates it to forces. */
  struct CrushResult
  {
    std::string           axis; ///< of the loading
    double                area, height;
    CrushCurve            curve;
    std::vector<double>   times; ///< of the points of the curve (s)
    CrushFigures          figures;
    std::optional<double> mass; ///< kg

    /** Absorbed energy (J) of @p work per volume (J/m3). */
    double energy(const double work) const
    {
      return work * area * height;
    }

    /** As energy(), per mass (J/kg). */
    std::optional<double> specific_energy(double work) const;
  };

  /** The largest stress of chosen struts in a run. */
  struct LargestStress
  {
    std::string           name;      ///< of the StressProbeDefinition
    double                von_mises; ///< Pa
    double                fibre;     ///< axial and bending, at the place (Pa)
    double                time;      ///< s, or position on a path
    std::string           instant;   ///< the same as text, e.g. `t = 2 s`
    unsigned int          strut;
    double                position; ///< part of its length
    std::optional<double> use;      ///< over the strength
  };

  /** All figures of a run. */
  struct RunFigures
  {
    std::vector<BodyFigures>    bodies;
    std::optional<CrushResult>  crush;
    std::optional<Transmission> transmission;
    std::vector<LargestStress>  stresses;
    /** Class of the filter; empty: none, or the rows are too far apart. */
    std::optional<double> channel_class;
    /** Remarks on figures that are missing. */
    std::vector<std::string> notes;
  };

  /**
   * The crush curve of @p definition in @p history. The loading is along the
   * axis of the largest relative displacement of the bodies; strain counts from
   * the last row before the force begins. Empty if area or height are neither
   * given nor extents of the lattice. Throws InputError without columns for the
   * force.
   */
  std::optional<CrushResult> crush_result(const CrushDefinition &definition,
                                          const CrushGeometry   &geometry,
                                          const RecordedTable   &history);

  /**
   * Evaluates @p history. Throws InputError for columns that are missing.
   * @param bodies names of plates, supports and probes
   * @param geometry for a crush curve only
   */
  RunFigures figures_of_run(const FiguresDefinition        &definition,
                            const std::vector<std::string> &bodies,
                            const CrushGeometry            &geometry,
                            const RecordedTable            &history);

  /** Throws InputError if @p definition needs columns that are not among @p
   * names. */
  void require_columns(const FiguresDefinition        &definition,
                       const std::vector<std::string> &names);
} // namespace auxfem

#endif
