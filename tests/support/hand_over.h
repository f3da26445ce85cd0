#ifndef auxfem_tests_support_hand_over_h
#define auxfem_tests_support_hand_over_h

#include <auxfem/state/checkpoint_archive.h>

namespace auxfem::testing_support
{
  /** Saves what @p from remembers by `serialize(archive)`, and restores it in
   * @p to. */
  template <class Object>
  void hand_over(Object &from, Object &to)
  {
    const UnknownLayout layout(MPI_COMM_SELF, 1, {});
    CheckpointData      records;
    CheckpointArchive   saving = CheckpointArchive::saving(records, layout);
    from.serialize(saving);
    CheckpointArchive restoring = CheckpointArchive::restoring(records, layout);
    to.serialize(restoring);
  }
} // namespace auxfem::testing_support

#endif
