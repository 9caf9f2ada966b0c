// SPDX-License-Identifier: GPL-3.0-or-later
// frames.jsonl: the same frames as the VTK files, one JSON object for each line, for drawing without VTK.
// Keys: time_s, upstream_level_m, downstream_level_m (null: no pool), blocks [{fixed, outline [[x,y],...]}],
// contacts [[x, y, state]], panels [[x0, y0, x1, y1, p0, p1, in_crack]], bolts [[x0, y0, x1, y1, force, state]],
// triangles [[x0, y0, x1, y1, x2, y2, larger principal stress]] where there are meshes.
#pragma once

#include "bridge/results/result_file.hpp"
#include "solid/watch/frame.hpp"

namespace blockweir::solid::output {

class FrameLog {
 public:
  FrameLog(const std::filesystem::path& folder, results::Begin begin) : file_(folder / "frames.jsonl", begin) {}
  void write(const Frame& frame);

  template <class Archive>
  void serialize(Archive& archive) {
    archive(file_);
  }

 private:
  results::ResultFile file_;
};

}  // namespace blockweir::solid::output
