#ifndef auxfem_scene_scene_space_h
#define auxfem_scene_scene_space_h

#include <auxfem/parameters/declare.h>
#include <auxfem/parameters/registry.h>
#include <auxfem/scene/scene.h>

#include <deal.II/base/tensor.h>

#include <array>
#include <string>

/**
 * @file
 * Entries of the parameter file that come once for each axis or component, or
 * have a meaning in space only.
 */
namespace auxfem
{
  /** Whether component @p c of motion and load is there in the plane. */
  constexpr bool is_in_plane(const unsigned int c)
  {
    return c < 2 || c == rotation_z;
  }

  /**
   * @p entry for component @p c: its name followed by the axis, its sentence
   * (without full stop) by the direction and, where it is so, that it needs
   * space.
   */
  template <class Entry>
  Entry for_component(Entry entry, const unsigned int c)
  {
    const std::string axis(1, "xyz"[c % 3]);
    entry.name += " " + axis;
    entry.sentence += (c < 3 ? " along " : " about ") + axis;
    if (c == rotation_z)
      entry.sentence += ", counterclockwise seen from its positive side";
    entry.sentence += is_in_plane(c) ? "." : "; with Dimension = 3 only.";
    return entry;
  }

  /** @p entry for the axes x, y, z; see for_component(). */
  template <class Entry>
  std::array<Entry, 3> for_axes(const Entry &entry)
  {
    return {{for_component(entry, 0),
             for_component(entry, 1),
             for_component(entry, 2)}};
  }

  /**
   * @p translation along x, y, z and @p rotation about them; see
   * for_component().
   */
  template <class Entry>
  std::array<Entry, n_motion_components>
  for_components(const Entry &translation, const Entry &rotation)
  {
    return {{for_component(translation, 0),
             for_component(translation, 1),
             for_component(translation, 2),
             for_component(rotation, 3),
             for_component(rotation, 4),
             for_component(rotation, 5)}};
  }

  /**
   * Throws the InputError for entry @p name, whose value has a meaning in space
   * only; @p remedy is what a scene in the plane should do about it.
   */
  [[noreturn]] void refuse_in_plane(dealii::ParameterHandler &prm,
                                    const std::string        &name,
                                    const SceneContext       &context,
                                    const std::string        &remedy);

  /**
   * Throws InputError if the scene lies in the plane and @p entry, which has a
   * meaning in space only, is not at its default.
   */
  template <class Entry>
  void require_space(dealii::ParameterHandler &prm,
                     const Entry              &entry,
                     const SceneContext       &context,
                     const std::string        &remedy = "Remove it")
  {
    if (context.dimension == 2 && prm.get(entry.name) != entry.default_value)
      refuse_in_plane(prm, entry.name, context, remedy);
  }

  /**
   * The vector of two or three numbers in @p entry (SI). Throws InputError if
   * it leaves the plane of a scene in the plane.
   */
  dealii::Tensor<1, 3> read_vector(dealii::ParameterHandler &prm,
                                   const QuantityList       &entry,
                                   const SceneContext       &context);

  /**
   * The unit vector along the three numbers in @p entry. Throws InputError if
   * they are zero.
   */
  dealii::Tensor<1, 3> read_unit_vector(dealii::ParameterHandler &prm,
                                        const QuantityList       &entry,
                                        const SceneContext       &context);

  /**
   * Moments of inertia about x, y, z at rest (kg m2) from the numbers in @p
   * entry: these three, or one, the same about every axis. In the plane there
   * is that about z alone. Throws InputError for two numbers.
   */
  dealii::Tensor<1, 3> read_moments_of_inertia(dealii::ParameterHandler &prm,
                                               const QuantityList       &entry,
                                               const SceneContext &context);
} // namespace auxfem

#endif
