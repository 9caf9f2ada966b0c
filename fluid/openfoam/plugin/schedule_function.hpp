// SPDX-License-Identifier: GPL-3.0-or-later
// Function object "blockweirSchedule": notifies the session at the end of a time step.
#pragma once

#include <fvMeshFunctionObject.H>

#include "fluid/openfoam/plugin/session.hpp"

namespace blockweir::openfoam {

class ScheduleFunction : public Foam::functionObjects::fvMeshFunctionObject {
 public:
  TypeName("blockweirSchedule")

      /// Ends the run if there is no fvOption "blockweirBlocks", which owns the session.
      ScheduleFunction(const Foam::word& name, const Foam::Time& time, const Foam::dictionary& dict);

  bool execute() override;
  bool write() override { return true; }

 private:
  Session* session_;
};

}  // namespace blockweir::openfoam
