#ifndef auxfem_scene_mean_deformation_h
#define auxfem_scene_mean_deformation_h

#include <auxfem/loads/time_function.h>
#include <auxfem/parameters/parameter_values.h>
#include <auxfem/parameters/subsection_schema.h>

#include <array>

namespace auxfem
{
  /**
   * `Mean deformation`: what is prescribed of the mean deformation of an
   * infinite lattice. Component (i, j) of the strain is the mean derivative of
   * the displacement u_i by the position x_j at rest; that of the nominal
   * stress is the force along i on an area at rest with its normal along j
   * (Pa).
   */
  struct MeanDeformation
  {
    struct Component
    {
      bool         is_strain_given = false;
      TimeFunction strain; ///< if given
      TimeFunction stress; ///< otherwise (Pa)
    };

    std::array<std::array<Component, 3>, 3> components;

    /** Number of wave vectors along each reciprocal vector for which stability
     * is checked; 0: none. */
    unsigned int stability_waves = 0;

    const Component &component(const unsigned int i, const unsigned int j) const
    {
      return components[i][j];
    }

    /** Whether anything deforms the lattice. */
    bool is_given() const;
  };

  /** Name of the component (@p i, @p j) in parameters and columns, e.g. `xy`. */
  std::string component_name(unsigned int i, unsigned int j);

  /** Schema of `Mean deformation`. */
  SubsectionSchema mean_deformation_schema();

  /** Reads `Mean deformation`. Throws InputError for a stress whose strain is
   * given, too. */
  MeanDeformation read_mean_deformation(ParameterValues &values);
} // namespace auxfem

#endif
