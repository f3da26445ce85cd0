#ifndef auxfem_output_rotation_vectors_h
#define auxfem_output_rotation_vectors_h

#include <auxfem/model/lattice_model.h>
#include <auxfem/time/checkpoint_archive.h>

namespace auxfem
{
  /**
   * Chosen rotations in space as rotation vectors since rest (rad), counted on
   * past whole turns from state to state. None in the plane, where rotations
   * are numbers.
   */
  class RotationVectors
  {
  public:
    /** @param model must outlive the object. */
    explicit RotationVectors(const LatticeModel &model);

    /** Chooses the rotation that local unknown @p unknown, a spin, belongs to.
     */
    void choose(int unknown);

    /**
     * Goes on to @p state. The sum of turns in between tells apart vectors
     * that mean the same rotation, so it may be large about a fixed axis; about
     * axes that change it must stay below half a turn.
     */
    void follow(const State &state);

    /** At @p state, the one last followed. */
    void serialize(const State &state, CheckpointArchive &archive);

    /** The entry of local unknown @p unknown (rad), a spin of a chosen one. */
    double operator[](int unknown) const;

    /** Largest angle (rad). */
    double largest() const;

  private:
    /** Names of the chosen ones, the same on any number of ranks. */
    std::vector<unsigned int> numbers() const;

    struct Rotation
    {
      unsigned int index; ///< among DofNumbering::rotations()
      SpaceVector  vector;
      SpaceVector  entries; ///< of State::displacement
    };

    const LatticeModel   &model;
    std::vector<Rotation> rotations; ///< rising by index
  };
} // namespace auxfem

#endif
