#include <auxfem/study/study_kind.h>

namespace auxfem
{
  const std::vector<StudyKind> &study_registry()
  {
    static const std::vector<StudyKind> registry = {convergence_study(),
                                                    work_precision_study(),
                                                    effects_study()};
    return registry;
  }
} // namespace auxfem
