// SPDX-License-Identifier: GPL-3.0-or-later
// links: fmt::fmt nlohmann_json::nlohmann_json
// What a stranger gets: an installed package that his build finds, a schema that flatc reads, a reader of frames that
// takes anything, a dummy of the solid.
#include <fmt/format.h>

#include <fstream>

#include "tests/processes.hpp"

namespace blockweir::test::kit_test {
namespace {

using testing::HasSubstr;

const std::string kit = std::string(BLOCKWEIR_SOURCE) + "/bridge/kit/";
const std::string python = "env PYTHONPATH=" + kit + "python /usr/bin/python3 ";

class Kit : public Processes {
 protected:
  /// Of blockweir-dummy with a fluid on its line; what the fluid says goes to "fluid", what the dummy says to "out".
  [[nodiscard]] int dummy(const std::string& options, const std::string& fluid) const {
    const std::string line = "ipc://" + (folder / "line").string();
    const pid_t other = start(
        "env BLOCKWEIR_ENDPOINT=" + line + " BLOCKWEIR_FOLDER=" + folder.string() + " BLOCKWEIR_TIMEOUT_S=10 " + fluid,
        "fluid");
    const int status =
        shell(programs + "/blockweir-dummy " + cases + "cracked-dam-upper --endpoint " + line + " " + options);
    fluid_status_ = end_of(other, 20);
    return status;
  }
  mutable int fluid_status_ = -1;
};

TEST_F(Kit, InstalledIsFoundByAStrangersBuild) {
  const std::string install = "cmake --install " + programs + "/.. --prefix " + (folder / "prefix").string();
  ASSERT_EQ(shell(install), 0) << text("out");
  const bool fortran = fs::exists(programs + "/kit_upper_dam_fortran");
  std::ofstream(folder / "CMakeLists.txt") << fmt::format(R"(
cmake_minimum_required(VERSION 3.25)
project(stranger LANGUAGES C{})
find_package(blockweir 0.1 REQUIRED)
add_executable(in_c {}c/upper_dam.c)
target_link_libraries(in_c PRIVATE blockweir::fluid m)
{})",
                                                          fortran ? " Fortran" : "", kit,
                                                          fortran ? "add_executable(in_fortran " + kit +
                                                                        "fortran/upper_dam.f90 "
                                                                        "${BLOCKWEIR_FORTRAN_MODULE})\n"
                                                                        "target_link_libraries(in_fortran PRIVATE "
                                                                        "blockweir::fluid)\n"
                                                                  : "");
  ASSERT_EQ(shell("cmake -S . -B b -DCMAKE_PREFIX_PATH=" + (folder / "prefix").string()), 0) << text("out");
  ASSERT_EQ(shell("cmake --build b"), 0) << text("out");
  ASSERT_EQ(dummy("--windows 3", (folder / "b/in_c").string()), 0) << text("out") << text("fluid");
  if (fortran) ASSERT_EQ(dummy("--windows 3", (folder / "b/in_fortran").string()), 0) << text("out") << text("fluid");
  // The installed program runs the installed Python module's example.
  EXPECT_EQ(shell("env PYTHONPATH=prefix/share/blockweir/kit/python /usr/bin/python3 -c 'import blockweir_fluid'"), 0)
      << text("out");
}

TEST_F(Kit, SchemaIsReadByPythonAsFlatcMakesIt) {
  ASSERT_EQ(shell("flatc --python --gen-onefile -o . " + std::string(BLOCKWEIR_SOURCE) + "/bridge/wire/messages.fbs"),
            0)
      << text("out");
  EXPECT_EQ(shell("/usr/bin/python3 -c 'import messages_generated as m, inspect; assert inspect.isclass(m.Farewell); "
                  "assert m.Body.Farewell == 4'"),
            0)
      << text("out");
}

TEST_F(Kit, ReaderOfFramesInPythonTakesAnyBytes) {
  const char* const more = std::getenv("BLOCKWEIR_FRAMES");
  EXPECT_EQ(
      shell(python + BLOCKWEIR_SOURCE "/tests/coupling/kit_frames.py " + (more != nullptr ? more : "20000") + " 31"), 0)
      << text("out");
  EXPECT_THAT(text("out"), HasSubstr("frames of seed 31"));
}

TEST_F(Kit, DummyMovesBlocksAndPrintsTheForcesOnThem) {
  ASSERT_EQ(dummy("--windows 2 --move top=0.1,0,0", python + kit + "python/upper_dam.py"), 0) << text("out");
  EXPECT_EQ(fluid_status_, 0) << text("fluid");
  // 9810 (21.702 - 15)^2 / 2 on the top's face; a block that moves sideways feels the same.
  EXPECT_THAT(text("out"), HasSubstr("\n0,0,21.702,top,1,220316.924,0,"));
  EXPECT_THAT(text("out"), HasSubstr("\n1,0.02,21.704,top,1,220448.436,0,"));
}

TEST_F(Kit, DummyTellsBothSidesOfAPanelThatIsNotThere) {
  EXPECT_EQ(dummy("", python + BLOCKWEIR_SOURCE "/tests/coupling/liar.py block"), 1);
  EXPECT_THAT(text("out"),
              HasSubstr("fluid \"a liar\" loads block 1000, edge 3 in window 3, which the scene does not have"));
  EXPECT_THAT(text("fluid"), HasSubstr("heard: the solid stopped in window 4: fluid \"a liar\" loads block 1000"));
}

TEST_F(Kit, DummyRefusesAMoveOfNoBlock) {
  for (const char* move : {"lid=0,0,0", "top=0,0", "top", "top=nan,0,0"}) {
    EXPECT_EQ(shell(programs + "/blockweir-dummy " + cases + "cracked-dam-upper --endpoint ipc://line --move " + move),
              2);
    EXPECT_THAT(text("out"), HasSubstr(fmt::format("--move: found \"{}\"; expected BLOCK=U,V,TURN", move)));
  }
}

TEST_F(Kit, FluidThatRemembersIsToldToSaveAndToRestore) {
  std::ofstream(folder / "counter.py") << R"(
from blockweir_fluid import Fluid
n = 0
def save(window): open(fluid.checkpoint_file(window), "w").write(str(n))
def restore(window):
    global n
    n = window
with Fluid("counter", save=save, restore=restore) as fluid:
    while motion := fluid.receive():
        n += 1
        fluid.send(upstream_level_m=n)
)";
  const std::string counter = python + (folder / "counter.py").string();
  ASSERT_EQ(dummy("--windows 7 --save-every 3", counter), 0) << text("out") << text("fluid");
  EXPECT_EQ(text("checkpoint/external-3"), "3");
  EXPECT_EQ(text("checkpoint/external-6"), "6");
  ASSERT_EQ(dummy("--windows 1 --resume 6", counter), 0) << text("out") << text("fluid");
  EXPECT_THAT(text("out"), HasSubstr("\n6,0.12,7,"));
  std::ofstream(folder / "forgets.py") << "from blockweir_fluid import Fluid\nFluid('forgets')\n";
  EXPECT_EQ(dummy("--windows 1 --resume 6", python + (folder / "forgets.py").string()), 1);
  EXPECT_THAT(text("out"), HasSubstr("this fluid cannot go on from a checkpoint: run it anew"));
}

}  // namespace
}  // namespace blockweir::test::kit_test
