#ifndef auxfem_output_effective_strains_h
#define auxfem_output_effective_strains_h

#include <auxfem/model/lattice_model.h>
#include <auxfem/output/csv_table.h>
#include <auxfem/scene/run_plan.h>
#include <auxfem/state/checkpoint_archive.h>

#include <optional>
#include <string>

namespace auxfem
{
  /**
   * Strains of the lattice as a whole: along x the mean displacement of the
   * joint set `right` minus that of `left`, over the mean distance of these
   * joints along x at rest; likewise for `bottom` and `top` along y, `back` and
   * `front` along z. Axes without both sets, or with coincident sets, have no
   * strain.
   */
  class EffectiveStrains
  {
  public:
    /**
     * Throws InputError if no axis has a strain.
     * @param model must outlive the object.
     */
    explicit EffectiveStrains(const LatticeModel &model);

    /** Throws InputError as the constructor. */
    static void check(const Lattice &lattice);

    /** Axes with a strain: 0, 1, 2 for x, y, z. */
    const std::vector<unsigned int> &axes() const
    {
      return strain_axes;
    }

    /** Columns `strain.x` etc. of the axes. */
    std::vector<Column> columns() const;

    /** This rank's share of each strain, to be summed over the ranks. */
    std::vector<double> values(const State &state) const;

  private:
    /** A displacement times a factor (1/m), a term of a strain. */
    struct Term
    {
      int    unknown; ///< local number, owned by this rank
      double factor;
    };

    std::vector<unsigned int>      strain_axes;
    std::vector<std::vector<Term>> terms; ///< by axis with a strain
  };

  /**
   * Axis along which the lattice is loaded: the only one with prescribed
   * motions, loads or initial velocities of joints on opposite sides, plates,
   * line loads or gravity. It is y if there is none or several.
   */
  unsigned int loaded_axis(const RunPlan &plan, const Lattice &lattice);

  /** Effective strains at the largest shortening or lengthening along the
   * loaded axis. */
  class LargestStrain
  {
  public:
    /** @param axis along which the lattice is loaded. */
    explicit LargestStrain(const unsigned int axis = 1) : loaded(axis)
    {}

    /** The loaded axis. */
    unsigned int axis() const
    {
      return loaded;
    }

    /** Records the strains @p values along @p axes at @p time (s). */
    void add(double                           time,
             const std::vector<unsigned int> &axes,
             const double                    *values);

    void serialize(CheckpointArchive &archive);

    /** Time of the largest strain (s). */
    double time() const
    {
      return time_of_largest;
    }

    /** Strain along @p axis at that time; empty if the axis has none. */
    std::optional<double> along(const unsigned int axis) const
    {
      return strains[axis];
    }

    /**
     * Effective Poisson's ratio: minus the strain along the lateral @p axis
     * over that along the loaded one. Empty for the loaded axis, for axes
     * without strain, and while the loaded strain is zero.
     */
    std::optional<double> poissons_ratio(unsigned int axis) const;

  private:
    unsigned int                         loaded;
    double                               time_of_largest = 0;
    std::array<std::optional<double>, 3> strains;
  };

  /** The letter of an axis: `x`, `y`, `z`. */
  std::string axis_name(unsigned int axis);
} // namespace auxfem

#endif
