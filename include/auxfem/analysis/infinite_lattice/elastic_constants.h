#ifndef auxfem_analysis_infinite_lattice_elastic_constants_h
#define auxfem_analysis_infinite_lattice_elastic_constants_h

#include <deal.II/base/tensor.h>
#include <deal.II/lac/full_matrix.h>

#include <array>
#include <optional>

namespace auxfem
{
  /**
   * Elastic constants of an anisotropic continuum, in the plane or in space.
   *
   * Vectors of strains and stresses have the order 11, 22, 12 in the plane and
   * 11, 22, 33, 23, 13, 12 in space, with engineering shear strains (Voigt).
   */
  class ElasticConstants
  {
  public:
    using Direction = dealii::Tensor<1, 3>;

    /**
     * @param stiffness 3 x 3 or 6 x 6 (Pa); its symmetric part is used
     */
    explicit ElasticConstants(const dealii::FullMatrix<double> &stiffness);

    /** Dimension of space. */
    unsigned int dimension() const
    {
      return C.m() == 3 ? 2 : 3;
    }

    /** Stiffness (Pa), symmetric. */
    const dealii::FullMatrix<double> &stiffness() const
    {
      return C;
    }

    /** Compliance (1/Pa); empty if the stiffness is singular: the lattice has a
     * mechanism. */
    const std::optional<dealii::FullMatrix<double>> &compliance() const
    {
      return S;
    }

    /** @name Constants of uniaxial stress and of shear between unit vectors;
     * they need a compliance */
    ///@{
    /** Young's modulus along @p n (Pa). */
    double youngs_modulus(const Direction &n) const;

    /** Strain along @p m over that along @p n, negative, under stress along
     * @p n; @p m across @p n. */
    double poissons_ratio(const Direction &n, const Direction &m) const;

    /** Shear modulus between @p n and @p m, which are normal to each other
     * (Pa). */
    double shear_modulus(const Direction &n, const Direction &m) const;

    /** Smallest and largest poissons_ratio() over all directions across @p n. */
    std::array<double, 2> poissons_ratios(const Direction &n) const;

    /** Smallest and largest shear_modulus() over all directions across @p n
     * (Pa). */
    std::array<double, 2> shear_moduli(const Direction &n) const;

    /** Mean stress over the relative change of volume, in the plane of area,
     * under equal stress along all axes (Pa). */
    double bulk_modulus() const;
    ///@}

    /** Relative norm of what the given stiffness lacks to be symmetric. */
    double asymmetry() const
    {
      return asymmetric_part;
    }

    /**
     * Distance from isotropy: the norm of the difference to the nearest
     * isotropic stiffness over that of the stiffness, both as tensors.
     */
    double anisotropy() const;

  private:
    /** Smallest and largest value of a quadratic form, given by its values
     * compliance_along(), over unit vectors across @p n.
     * @param form of two vectors */
    template <class Form>
    std::array<double, 2> range_across(const Direction &n,
                                       const Form      &form) const;

    /** The product a_i b_j S_ijkl c_k d_l. */
    double compliance_along(const Direction &a,
                            const Direction &b,
                            const Direction &c,
                            const Direction &d) const;

    dealii::FullMatrix<double>                C;
    double                                    asymmetric_part = 0;
    std::optional<dealii::FullMatrix<double>> S;
  };
} // namespace auxfem

#endif
