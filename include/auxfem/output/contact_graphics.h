#ifndef auxfem_output_contact_graphics_h
#define auxfem_output_contact_graphics_h

#include <auxfem/equations/equations.h>
#include <auxfem/equations/solution.h>
#include <auxfem/output/line_graphics.h>
#include <auxfem/time/checkpoint_archive.h>

#include <optional>

namespace auxfem
{
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
