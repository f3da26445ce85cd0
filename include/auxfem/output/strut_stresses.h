#ifndef auxfem_output_strut_stresses_h
#define auxfem_output_strut_stresses_h

#include <auxfem/equations/equations.h>
#include <auxfem/scene/scene.h>
#include <auxfem/struts/effects/struts.h>
#include <auxfem/struts/section_stresses.h>

#include <map>
#include <string>
#include <utility>
#include <vector>

namespace auxfem
{
  /** Stresses at a point of a strut, with the strain of its fibres. */
  struct PointStresses : Stresses
  {
    /** Largest fibre strain without initial strains, with its sign. */
    double fibre_strain = 0;
  };

  /** Stresses of the struts of a lattice; sections are prepared when they are
   * met first. */
  class StrutStresses
  {
  public:
    /** @param model must outlive the object */
    explicit StrutStresses(const LatticeModel &model) : model(model)
    {}

    /** Whether a section of the lattice has a shape. */
    bool exist() const;

    /**
     * Stresses at @p point.
     * @param strut its number
     * @param part of the length of the strut, from 0 to 1
     */
    PointStresses
    at(const StrutPoint &point, unsigned int strut, double part) const;

  private:
    const SectionStresses &section_at(unsigned int section, double part) const;

    const LatticeModel &model;
    /** By section and, where it is tapered, by part of the length. */
    mutable std::map<std::pair<unsigned int, double>, SectionStresses> sections;
  };

  /**
   * The largest von Mises stress in chosen struts, columns of history.csv:
   * `NAME.von_mises` and `NAME.fibre_stress` there (Pa), the number of the
   * strut, the part of its length, and with a strength the stress over it.
   */
  class StressProbe
  {
  public:
    /** Throws InputError for missing sets, struts without shape and if all
     * struts are rigid. @param equations must outlive the probe */
    StressProbe(const StressProbeDefinition &definition,
                const Scene                 &scene,
                const Equations             &equations);

    /** Throws InputError as the constructor. */
    static void check(const StressProbeDefinition &definition,
                      const Scene                 &scene,
                      const Lattice               &lattice);

    std::vector<Column> columns() const;

    /** Values of columns() at @p state, the same on all ranks. Collective. */
    std::vector<double> values(const State &state, MPI_Comm communicator) const;

  private:
    struct Place
    {
      double       von_mises = -1, fibre = 0, part = 0;
      unsigned int strut = 0;
    };

    /** Replaces @p largest by a larger stress in an element. */
    void look_along(const StrutForces &struts,
                    const State       &state,
                    unsigned int       element,
                    Place             &largest) const;

    const StressProbeDefinition definition;
    const Equations            &equations;
    const StrutStresses         stresses;
    std::vector<bool>           is_chosen; ///< by strut
  };
} // namespace auxfem

#endif
