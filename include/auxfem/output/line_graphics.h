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
  /** What is stored at each point of a graphics file. */
  struct GraphicsField
  {
    std::string  name;
    unsigned int n_components = 1; ///< 1: scalar, 3: vector
    std::string  unit;             ///< empty: none
  };

  /**
   * Lines in space with fields, for the writers of deal.II: what its DataOut
   * cannot draw, as it is no mesh (connectors) or lies on a curve (arcs).
   */
  class LineGraphics : public dealii::DataOutInterface<1, 3>
  {
  public:
    explicit LineGraphics(const std::vector<GraphicsField> &fields);

    /** Whether there is no line. */
    bool empty() const
    {
      return patches.empty();
    }

    /** Numbers stored at each point. */
    unsigned int n_components() const;

    /**
     * Adds a line through @p points (m), at least two.
     * @param values n_components() numbers for the first point in the order of
     *   the fields, then those for the second, ...
     */
    void add_line(const std::vector<dealii::Point<3>> &points,
                  const std::vector<float>            &values);

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
   * A series of graphics files in time: on one rank `NAME/NAME_00000.vtu`, on
   * several `NAME/NAME_00000.pvtu` with a `.vtu` for each; and `NAME.pvd`, the
   * record, which lists them with their times and is whole at any moment. All
   * in one folder, with relative paths.
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
     * Writes the files for one more time (s). Throws ComputationError on all
     * ranks if one cannot write, std::bad_alloc on a rank without memory to.
     * Collective.
     */
    void write(LineGraphics &graphics, double time);

    /** That of the record and of the folder. */
    const std::string &series_name() const
    {
      return name;
    }

    /** Whether @p archive restores a series. */
    static bool is_in(const CheckpointArchive &archive,
                      const std::string       &series);

    /**
     * The number of files so far. A restored series numbers files on; the
     * record NAME.pvd lists those that follow.
     */
    void serialize(CheckpointArchive &archive);

  private:
    static std::string record_name(const std::string &series);

    /** Returns the name of the file that stands for all ranks. */
    std::string write_pieces(LineGraphics &graphics) const;

    /**
     * Adds a file to the record, over the end of the record and with a new end,
     * so that a series costs no more than its length. Throws ComputationError
     * if that fails; the record is then as it was.
     */
    void append_to_record(double time, const std::string &file);

    /** Removes what stands behind the entries. */
    void restore_record(const std::string &record) const;
    /** Those that are not in the record. */
    void remove_later_files() const;

    std::string  folder;
    std::string  name;
    MPI_Comm     communicator;
    unsigned int n_written = 0;
    /** Where the next entry of the record begins; 0: there is no record. */
    std::streamoff end_of_entries = 0;
  };

  /** @p name with everything but letters, digits, `-` and `_` replaced by `_`. */
  std::string field_name(const std::string &name);

  /**
   * Files for ParaView of a scene with contact: `plates.pvd` with the outlines
   * of plates, if there are any, and `contacts.pvd` with a short line, from the
   * axis to the face of the strut, at every point that touches. The geometry is
   * that at rest, as in `solution.pvd`; `displacement` is the vector for Warp
   * By Vector.
   *
   * Fields of contacts: displacement (m), force on the strut (N), gap (m,
   * negative: penetration), numbers of the strut and of the plate or other
   * strut that it touches, -1 for none. Fields of
   * plates: displacement (m), force of the struts on the plate (N), number of
   * the plate.
   */
  class ContactGraphics
  {
  public:
    /** Makes the subfolders of @p folder; see VtuWriter. Collective. */
    ContactGraphics(const Equations   &equations,
                    const std::string &folder,
                    const std::string &prefix);

    /** Names of the series; without plates that of contacts begins with the
     * first touch. */
    std::vector<std::string> series() const;

    /** Throws ComputationError if the disk takes no more. Collective. */
    void write(const Solution &solution);

    /** The numbers of files so far. */
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
    /** If there are any. */
    std::optional<GraphicsSeries> plate_series;
  };
} // namespace auxfem

#endif
