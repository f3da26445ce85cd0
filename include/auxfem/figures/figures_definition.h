#ifndef auxfem_figures_figures_definition_h
#define auxfem_figures_figures_definition_h

#include <auxfem/figures/body_figures.h>
#include <auxfem/figures/crush_curve.h>
#include <auxfem/figures/transmission.h>
#include <auxfem/parameters/subsection_schema.h>

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace auxfem
{
  /** `Crush curve`: two plates or supports that crush the lattice. */
  struct CrushDefinition
  {
    /** The body whose force counts, and the opposite one. */
    std::array<std::string, 2> bodies;
    /** Loaded area (m2) and height (m); empty: those of the lattice. */
    std::optional<double> area, height;
    CrushOptions          options;
  };

  /** `Transmission`: two columns of history.csv. */
  struct TransmissionDefinition
  {
    std::string         input, output;
    TransmissionOptions options;
  };

  /** `Stresses/NAME`: struts whose largest stress is recorded. */
  struct StressProbeDefinition
  {
    std::string           name;
    std::string           struts;   ///< strut set or selection
    std::optional<double> strength; ///< Pa
    std::string           path;     ///< for messages
  };

  /** `Member forces`: struts whose section forces are tabulated. */
  struct MemberForcesDefinition
  {
    std::string         struts; ///< strut set or selection
    std::vector<double> times;  ///< s, rising
    bool                at_end = true;
    unsigned int        points = 2; ///< on each element, at equal distances
    std::string         path;       ///< for messages
  };

  /** Figures that a run reports at its end. */
  struct FiguresDefinition
  {
    /** Whether bodies have figures. */
    bool          figures = true;
    FigureOptions options;
    /** Empty: none. */
    std::optional<CrushDefinition>        crush;
    std::optional<TransmissionDefinition> transmission;
    std::vector<StressProbeDefinition>    stresses;
    std::optional<MemberForcesDefinition> member_forces;
  };

  /** @name Schemas of the subsections, and their readers; throw InputError for
   * contradicting values. */
  ///@{
  SubsectionSchema evaluation_schema();
  void read_evaluation(ParameterValues &values, FiguresDefinition &result);
  SubsectionSchema crush_curve_schema();
  void read_crush_curve(ParameterValues &values, FiguresDefinition &result);
  SubsectionSchema transmission_schema();
  void read_transmission(ParameterValues &values, FiguresDefinition &result);
  SubsectionSchema stresses_schema();
  void read_stress_probe(ParameterValues &values, FiguresDefinition &result);
  SubsectionSchema member_forces_schema();
  void read_member_forces(ParameterValues &values, FiguresDefinition &result);
  ///@}
} // namespace auxfem

#endif
