#ifndef auxfem_struts_grading_h
#define auxfem_struts_grading_h

#include <auxfem/struts/shapes/cross_section.h>

#include <array>
#include <memory>
#include <vector>

namespace auxfem
{
  class Factors;
  struct SectionDefinition;

  /** Where a strut is in the designed lattice. */
  struct StrutPlace
  {
    double       x = 0, y = 0, z = 0; ///< middle of the strut (m)
    unsigned int strut = 0;           ///< its number
    unsigned int cell  = 0;           ///< number of its unit cell
  };

  /** Section whose dimensions and material vary from strut to strut: each
   * varied number is multiplied by an expression in the strut's place. */
  class Grading
  {
  public:
    /**
     * Reads `NAME: EXPRESSION; ...` from @p parameter. Throws InputError for
     * names of no number of @p section.
     * @param values of the section
     * @param read_shape sets the shape of a section from changed values
     */
    Grading(const ParameterValues   &values,
            const Parameter         &parameter,
            const SectionDefinition &section,
            const Parameters        &shape_parameters,
            void (*read_shape)(ParameterValues &, SectionDefinition &));
    ~Grading();

    Grading(const Grading &)            = delete;
    Grading &operator=(const Grading &) = delete;

    /** Sets the bounds of the lattice's joints (m), which expressions may use.
     */
    void set_bounds(const std::array<dealii::Point<3>, 2> &bounds);

    /** The factors at @p place, in the order in which they are written. Throws
     * InputError for those that are not positive. */
    std::vector<double> factors_at(const StrutPlace &place);

    /** @p section with @p factors. Throws InputError if they make it
     * impossible. */
    SectionDefinition with_factors(const std::vector<double> &factors,
                                   const SectionDefinition   &section);

  private:
    struct Variables
    {
      std::array<double, 3> position, lowest, highest; ///< m
      double                strut, cell;
      unsigned int          item;
    };

    ParameterValues                values;
    const Parameter               &parameter;
    std::unique_ptr<Variables>     variables;
    std::unique_ptr<const Factors> factors;
    /** Values where factors are 1 (SI); unused for those of the material. */
    std::vector<double> dimensions;
    void (*const read_shape)(ParameterValues &, SectionDefinition &);
  };
} // namespace auxfem

#endif
