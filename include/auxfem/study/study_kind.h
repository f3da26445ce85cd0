#ifndef auxfem_study_study_kind_h
#define auxfem_study_study_kind_h

#include <auxfem/study/quantities.h>
#include <auxfem/study/study_report.h>
#include <auxfem/study/study_runs.h>

#include <string>
#include <vector>

namespace auxfem
{
  /** A scene that is studied and what it is looked at by. */
  struct StudyTask
  {
    const Scene                    &scene;
    std::vector<QuantityDefinition> quantities;
  };

  /** One line of the table of studies: a question to a scene. */
  struct StudyKind
  {
    /** As in Study/Kind. */
    std::string name;

    /** Names that its pictures may have. */
    std::vector<std::string> pictures;

    /** The simulations it takes, each once. Throws InputError for one that is
     * wrong, or if there is nothing to compare. */
    std::vector<PlannedRun> (*plan)(const StudyTask &task);

    /** What they show; @p runs are those of plan(), @p further does what they
     * give reason for. Collective. */
    StudyReport (*report)(const StudyTask                &task,
                          const std::vector<MeasuredRun> &runs,
                          StudyRuns                      &further);
  };

  /** All studies the program knows (study/register.cc). */
  const std::vector<StudyKind> &study_registry();

  /** @name Entries of the table, one per file; only register.cc needs them. */
  ///@{
  StudyKind convergence_study();
  StudyKind work_precision_study();
  StudyKind effects_study();
  ///@}
} // namespace auxfem

#endif
