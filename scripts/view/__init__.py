"""Pictures of the results of auxfem; see auxfem-view."""
