#ifndef auxfem_struts_taper_h
#define auxfem_struts_taper_h

#include <auxfem/struts/shapes/cross_section.h>

#include <map>
#include <memory>
#include <vector>

namespace auxfem
{
  class Factors;

  /** Shape whose dimensions vary along the strut: each is a number times an
   * expression in s, which is 0 at the first joint and 1 at the second. */
  class Taper
  {
  public:
    /**
     * Reads `DIMENSION: EXPRESSION; ...` from @p parameter. Throws InputError
     * for unknown dimensions and for factors that are not positive.
     * @param values of the section
     * @param shape entry of its shape, which must outlive the object
     */
    Taper(const ParameterValues             &values,
          const Parameter                   &parameter,
          const RegistryEntry<CrossSection> &shape);
    ~Taper();

    Taper(const Taper &)            = delete;
    Taper &operator=(const Taper &) = delete;

    /** The shape at @p s. Throws InputError if it is impossible there. */
    const CrossSection &shape_at(double s) const;

  private:
    /** Factor of the dimension @p i at @p s; positive. */
    double factor_at(unsigned int i, double s) const;

    const ParameterValues              values;
    const RegistryEntry<CrossSection> &shape;
    std::unique_ptr<double>            position; ///< variable of expressions
    std::unique_ptr<const Factors>     factors;
    std::vector<double>                dimensions; ///< where factors are 1 (SI)
    /** Shapes found so far: some take a second to compute. */
    mutable std::map<double, CrossSection> known;
  };
} // namespace auxfem

#endif
