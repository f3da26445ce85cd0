#ifndef auxfem_output_line_graphics_h
#define auxfem_output_line_graphics_h

#include <auxfem/equations/equations.h>
#include <auxfem/state/checkpoint_archive.h>

#include <deal.II/base/data_out_base.h>
#include <deal.II/base/mpi.h>

#include <optional>
#include <string>
#include <vector>

namespace auxfem
{
  /** A field stored at each point of a graphics file. */
  struct GraphicsField
  {
    std::string  name;
    unsigned int n_components = 1; ///< 1: scalar, 3: vector
    std::string  unit;             ///< empty: none
  };

  /**
   * Lines in space with fields, for the writers of deal.II. DataOut cannot draw
   * them, because they have no mesh (connectors) or are curved (arcs).
   */
  class LineGraphics : public dealii::DataOutInterface<1, 3>
  {
  public:
    explicit LineGraphics(const std::vector<GraphicsField> &fields);

    /** Whether there are no lines. */
    bool empty() const
    {
      return patches.empty();
    }

    /** Number of values stored at each point. */
    unsigned int n_components() const;

    /**
     * Adds a line through @p points (m), at least two.
     * @param values n_components() numbers for the first point in the order of
     *   the fields, then those for the second, ...
     */
    void add_line(const std::vector<dealii::Point<3>> &points,
                  const std::vector<float>            &values);

    /** Writes all lines to the .vtu @p file; returns whether that succeeded. */
    bool write_file(const std::string &file) const;

    /** Marks the files with a time (s) and the number of the file. */
    void set_time(double time, unsigned int number);

  private:
    using Patch = dealii::DataOutBase::Patch<1, 3>;

    const std::vector<Patch> &get_patches() const override
    {
      return patches;
    }

    std::vector<std::string> get_dataset_names() const override;
    std::vector<std::tuple<
      unsigned int,
      unsigned int,
      std::string,
      dealii::DataComponentInterpretation::DataComponentInterpretation>>
    get_nonscalar_data_ranges() const override;

    std::vector<GraphicsField> fields;
    std::vector<Patch>         patches;
  };

  /**
   * A time series of graphics files: `NAME/NAME_00000.vtu` on one rank,
   * `NAME/NAME_00000.pvtu` with a `.vtu` for each rank on several. The record
   * `NAME.pvd` lists them with their times and is complete at any moment. All
   * paths are relative to one folder.
   */
  class GraphicsSeries
  {
  public:
    /** Makes the subfolder. Throws InputError if it cannot be made. Collective.
     */
    GraphicsSeries(const std::string &folder,
                   const std::string &name,
                   MPI_Comm           communicator);

    /**
     * Writes the files of one time (s). Throws ComputationError on all ranks if
     * one cannot write, std::bad_alloc on a rank without memory. Collective.
     */
    void write(LineGraphics &graphics, double time);

    /** Name of the record and of the folder. */
    const std::string &series_name() const
    {
      return name;
    }

    /** Whether @p archive contains the series. */
    static bool is_in(const CheckpointArchive &archive,
                      const std::string       &series);

    /**
     * Saves or restores the number of files. A restored series continues the
     * numbering and the record.
     */
    void serialize(CheckpointArchive &archive);

  private:
    static std::string record_name(const std::string &series);

    /**
     * Writes the files of all ranks; returns the name of the file that
     * represents them.
     */
    std::string write_pieces(LineGraphics &graphics) const;

    /**
     * Adds a file to the record by overwriting only its end, so that the cost
     * is linear in the number of files. Throws ComputationError on failure,
     * with the record unchanged.
     */
    void append_to_record(double time, const std::string &file);

    /** Truncates the record after its entries. */
    void restore_record(const std::string &record) const;
    /** Removes files that are not in the record. */
    void remove_later_files() const;

    std::string  folder;
    std::string  name;
    MPI_Comm     communicator;
    unsigned int n_written = 0;
    /** Position of the next entry in the record; 0: there is no record. */
    std::streamoff end_of_entries = 0;
  };

  /** @p name with everything but letters, digits, `-` and `_` replaced by `_`. */
  std::string field_name(const std::string &name);

  /**
   * Files for ParaView of a scene with contact. `plates.pvd` has the outlines
   * of plates, if any; `contacts.pvd` has a short line from the axis to the
   * face of the strut at every contact point. The geometry is that at rest;
   * `displacement` is the vector for Warp By Vector.
   *
   * Fields of contacts: displacement (m), force on the strut (N), gap (m,
   * negative: penetration), numbers of the strut and of the plate or other
   * strut that it touches, -1 for none. Fields of plates: displacement (m),
   * force of the struts on the plate (N), number of the plate.
   */
  class ContactGraphics
  {
  public:
    /** Makes the subfolders of @p folder; see VtuWriter. Collective. */
    ContactGraphics(const Equations   &equations,
                    const std::string &folder,
                    const std::string &prefix);

    /**
     * Names of the series. Without plates the series of contacts starts at the
     * first contact.
     */
    std::vector<std::string> series() const;

    /**
     * Writes the files. Throws ComputationError if writing fails. Collective.
     */
    void write(const Solution &solution);

    /** Saves or restores the numbers of files. */
    void serialize(CheckpointArchive &archive);

  private:
    void start_contacts();
    void write_contacts(const Solution &solution);
    void write_plates(const Solution &solution);

    const Equations              &equations;
    const PlateContact           *plates; ///< nullptr: none
    const StrutContact           *struts; ///< nullptr: they may cross
    const double                  size;   ///< of the lattice (m)
    const std::string             folder, contacts_name;
    std::optional<GraphicsSeries> contact_series;
    /** Series of plates, if there are any. */
    std::optional<GraphicsSeries> plate_series;
  };
} // namespace auxfem

#endif
