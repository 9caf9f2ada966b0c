! SPDX-License-Identifier: GPL-3.0-or-later
! A fluid of one's own as the partner of blockweir's solid, in Fortran: blockweir_fluid.h says what each call does.
! Compile this file with your own program, and link blockweir_fluid.
module blockweir_fluid
  use, intrinsic :: iso_c_binding
  use, intrinsic :: ieee_arithmetic, only: ieee_value, ieee_quiet_nan
  implicit none
  private

  integer(c_int), parameter, public :: blockweir_end = 0, blockweir_motion_due = 1, blockweir_save = 2, blockweir_error = -1

  ! A handle, and where the blocks are: displacement(6, blocks) and velocity(6, blocks), u, v [m], turn [rad], ex, ey, gxy
  ! of each centroid and their rates.
  type, public :: fluid_line
    integer(c_int64_t) :: window = 0
    real(c_double) :: time_s = 0
    real(c_double), pointer :: displacement(:, :) => null(), velocity(:, :) => null()
    type(c_ptr), private :: handle = c_null_ptr
  contains
    procedure :: open => open_line
    procedure :: blocks, vertices, outline, place, block_name, window_s, duration_s, first_window, error
    procedure :: remembers, checkpoint, receive, send, progress, fail
    procedure :: close => close_line
  end type

  ! As blockweir_motion and blockweir_load in C.
  type, bind(C) :: c_motion
    integer(c_int64_t) :: window
    real(c_double) :: time_s
    type(c_ptr) :: displacement, velocity
  end type
  type, bind(C) :: c_load
    integer(c_size_t) :: panels
    type(c_ptr) :: block, edge, s_from, s_to, pressure_from_pa, pressure_to_pa
    integer(c_size_t) :: cracks_from
    real(c_double) :: upstream_level_m, downstream_level_m, holds_until_s
    integer(c_int) :: breached
    type(c_ptr) :: added_mass
  end type

  interface
    type(c_ptr) function c_open(role, endpoint) bind(C, name="blockweir_open")
      import :: c_ptr, c_char
      character(kind=c_char), intent(in) :: role(*)
      type(c_ptr), value :: endpoint
    end function
    type(c_ptr) function c_error(fluid) bind(C, name="blockweir_error")
      import :: c_ptr
      type(c_ptr), value :: fluid
    end function
    integer(c_size_t) function c_blocks(fluid) bind(C, name="blockweir_blocks")
      import :: c_ptr, c_size_t
      type(c_ptr), value :: fluid
    end function
    integer(c_size_t) function c_vertices(fluid, block) bind(C, name="blockweir_vertices")
      import :: c_ptr, c_size_t
      type(c_ptr), value :: fluid
      integer(c_size_t), value :: block
    end function
    type(c_ptr) function c_outline(fluid, block) bind(C, name="blockweir_outline")
      import :: c_ptr, c_size_t
      type(c_ptr), value :: fluid
      integer(c_size_t), value :: block
    end function
    type(c_ptr) function c_block_name(fluid, block) bind(C, name="blockweir_block_name")
      import :: c_ptr, c_size_t
      type(c_ptr), value :: fluid
      integer(c_size_t), value :: block
    end function
    integer(c_int) function c_place(fluid, block, xy) bind(C, name="blockweir_place")
      import :: c_ptr, c_size_t, c_int, c_double
      type(c_ptr), value :: fluid
      integer(c_size_t), value :: block
      real(c_double), intent(out) :: xy(*)
    end function
    real(c_double) function c_window_s(fluid) bind(C, name="blockweir_window_s")
      import :: c_ptr, c_double
      type(c_ptr), value :: fluid
    end function
    real(c_double) function c_duration_s(fluid) bind(C, name="blockweir_duration_s")
      import :: c_ptr, c_double
      type(c_ptr), value :: fluid
    end function
    integer(c_int64_t) function c_first_window(fluid) bind(C, name="blockweir_first_window")
      import :: c_ptr, c_int64_t
      type(c_ptr), value :: fluid
    end function
    integer(c_int) function c_remembers(fluid) bind(C, name="blockweir_remembers")
      import :: c_ptr, c_int
      type(c_ptr), value :: fluid
    end function
    type(c_ptr) function c_checkpoint(fluid, window) bind(C, name="blockweir_checkpoint")
      import :: c_ptr, c_int64_t
      type(c_ptr), value :: fluid
      integer(c_int64_t), value :: window
    end function
    integer(c_int) function c_receive(fluid, motion) bind(C, name="blockweir_receive")
      import :: c_ptr, c_int, c_motion
      type(c_ptr), value :: fluid
      type(c_motion), intent(out) :: motion
    end function
    integer(c_int) function c_send(fluid, load) bind(C, name="blockweir_send")
      import :: c_ptr, c_int, c_load
      type(c_ptr), value :: fluid
      type(c_load), intent(in) :: load
    end function
    integer(c_int) function c_progress(fluid, text) bind(C, name="blockweir_progress")
      import :: c_ptr, c_int, c_char
      type(c_ptr), value :: fluid
      character(kind=c_char), intent(in) :: text(*)
    end function
    integer(c_int) function c_fail(fluid, text) bind(C, name="blockweir_fail")
      import :: c_ptr, c_int, c_char
      type(c_ptr), value :: fluid
      character(kind=c_char), intent(in) :: text(*)
    end function
    integer(c_int) function c_close(fluid) bind(C, name="blockweir_close")
      import :: c_ptr, c_int
      type(c_ptr), value :: fluid
    end function
    integer(c_size_t) function c_strlen(text) bind(C, name="strlen")
      import :: c_ptr, c_size_t
      type(c_ptr), value :: text
    end function
  end interface

contains

  ! Connects to the endpoint that BLOCKWEIR_ENDPOINT names; error() says whether it went well.
  subroutine open_line(self, role)
    class(fluid_line), intent(inout) :: self
    character(*), intent(in) :: role
    self%handle = c_open(role // c_null_char, c_null_ptr)
  end subroutine

  integer function blocks(self)
    class(fluid_line), intent(in) :: self
    blocks = int(c_blocks(self%handle))
  end function

  ! Of block 1 to blocks().
  integer function vertices(self, block)
    class(fluid_line), intent(in) :: self
    integer, intent(in) :: block
    vertices = int(c_vertices(self%handle, int(block - 1, c_size_t)))
  end function

  ! outline(2, vertices) as the scene draws it [m].
  function outline(self, block) result(xy)
    class(fluid_line), intent(in) :: self
    integer, intent(in) :: block
    real(c_double), pointer :: xy(:, :)
    call c_f_pointer(c_outline(self%handle, int(block - 1, c_size_t)), xy, [2, self%vertices(block)])
  end function

  ! The same, where the block is now.
  function place(self, block) result(xy)
    class(fluid_line), intent(in) :: self
    integer, intent(in) :: block
    real(c_double), allocatable :: xy(:, :)
    allocate (xy(2, self%vertices(block)))
    if (c_place(self%handle, int(block - 1, c_size_t), xy) /= 0) xy = ieee_value(1.0_c_double, ieee_quiet_nan)
  end function

  function block_name(self, block) result(name)
    class(fluid_line), intent(in) :: self
    integer, intent(in) :: block
    character(:), allocatable :: name
    name = text_of(c_block_name(self%handle, int(block - 1, c_size_t)))
  end function

  real(c_double) function window_s(self)
    class(fluid_line), intent(in) :: self
    window_s = c_window_s(self%handle)
  end function

  real(c_double) function duration_s(self)
    class(fluid_line), intent(in) :: self
    duration_s = c_duration_s(self%handle)
  end function

  ! 0, or the number of the motion with which a run is resumed.
  integer(c_int64_t) function first_window(self)
    class(fluid_line), intent(in) :: self
    first_window = c_first_window(self%handle)
  end function

  ! Empty where all is well, else one line.
  function error(self) result(text)
    class(fluid_line), intent(in) :: self
    character(:), allocatable :: text
    text = text_of(c_error(self%handle))
  end function

  ! receive() then also returns blockweir_save.
  subroutine remembers(self)
    class(fluid_line), intent(inout) :: self
    integer(c_int) :: ignored
    ignored = c_remembers(self%handle)
  end subroutine

  ! File for the state before `window`.
  function checkpoint(self, window) result(file)
    class(fluid_line), intent(in) :: self
    integer(c_int64_t), intent(in) :: window
    character(:), allocatable :: file
    file = text_of(c_checkpoint(self%handle, window))
  end function

  ! blockweir_motion_due, blockweir_save, blockweir_end or blockweir_error.
  integer(c_int) function receive(self)
    class(fluid_line), intent(inout) :: self
    type(c_motion) :: motion
    receive = c_receive(self%handle, motion)
    if (receive <= 0) return
    self%window = motion%window
    self%time_s = motion%time_s
    call c_f_pointer(motion%displacement, self%displacement, [6, self%blocks()])
    call c_f_pointer(motion%velocity, self%velocity, [6, self%blocks()])
  end function

  ! One panel an entry: block and edge count from 1, s_from <= s_to from 0 to 1, pressures in Pa. Panels from
  ! cracks_from on lie in cracks. What is left out: no pool, no crack, no added mass.
  integer(c_int) function send(self, block, edge, s_from, s_to, pressure_from_pa, pressure_to_pa, upstream_level_m, &
                               downstream_level_m, cracks_from, holds_until_s, breached, added_mass)
    class(fluid_line), intent(inout) :: self
    integer, intent(in) :: block(:), edge(:)
    real(c_double), intent(in) :: s_from(:), s_to(:), pressure_from_pa(:), pressure_to_pa(:)
    real(c_double), intent(in), optional :: upstream_level_m, downstream_level_m, holds_until_s
    integer, intent(in), optional :: cracks_from
    logical, intent(in), optional :: breached
    real(c_double), intent(in), contiguous, target, optional :: added_mass(:, :)
    integer(c_int32_t), allocatable, target :: b(:), e(:)
    real(c_double), allocatable, target :: sf(:), st(:), pf(:), pt(:)
    type(c_load) :: load
    integer :: n
    n = size(block)
    if (any([size(edge), size(s_from), size(s_to), size(pressure_from_pa), size(pressure_to_pa)] /= n)) then
      send = self%fail("a load whose columns differ in length")
      return
    end if
    if (present(added_mass)) then
      if (size(added_mass) /= 6 * self%blocks()) then
        send = self%fail("added masses that are not six a block")
        return
      end if
    end if
    allocate (b(n), e(n))  ! own copies: contiguous, and counted from 0
    b = int(block - 1, c_int32_t)
    e = int(edge - 1, c_int32_t)
    sf = s_from; st = s_to; pf = pressure_from_pa; pt = pressure_to_pa
    load%panels = n
    load%block = c_loc(b); load%edge = c_loc(e); load%s_from = c_loc(sf); load%s_to = c_loc(st)
    load%pressure_from_pa = c_loc(pf); load%pressure_to_pa = c_loc(pt)
    load%cracks_from = n
    if (present(cracks_from)) load%cracks_from = cracks_from - 1
    load%upstream_level_m = ieee_value(1.0_c_double, ieee_quiet_nan)
    load%downstream_level_m = load%upstream_level_m
    load%holds_until_s = load%upstream_level_m
    if (present(upstream_level_m)) load%upstream_level_m = upstream_level_m
    if (present(downstream_level_m)) load%downstream_level_m = downstream_level_m
    if (present(holds_until_s)) load%holds_until_s = holds_until_s
    load%breached = 0
    if (present(breached)) load%breached = merge(1, 0, breached)
    load%added_mass = c_null_ptr
    if (present(added_mass)) load%added_mass = c_loc(added_mass)
    send = c_send(self%handle, load)
  end function

  ! To be called while a step takes long, whenever it has come further.
  subroutine progress(self, text)
    class(fluid_line), intent(inout) :: self
    character(*), intent(in) :: text
    integer(c_int) :: ignored
    ignored = c_progress(self%handle, text // c_null_char)
  end subroutine

  ! Tells the solid why this fluid cannot go on; blockweir_error.
  integer(c_int) function fail(self, text)
    class(fluid_line), intent(inout) :: self
    character(*), intent(in) :: text
    fail = c_fail(self%handle, text // c_null_char)
  end function

  ! 0 where the run was complete, else 1: the status that a program should stop with.
  integer(c_int) function close_line(self)
    class(fluid_line), intent(inout) :: self
    close_line = c_close(self%handle)
    self%handle = c_null_ptr
  end function

  function text_of(from) result(text)
    type(c_ptr), intent(in) :: from
    character(:), allocatable :: text
    character(kind=c_char), pointer :: letters(:)
    integer :: i, n
    n = int(c_strlen(from))
    call c_f_pointer(from, letters, [n])
    allocate (character(n) :: text)
    do i = 1, n
      text(i:i) = letters(i)
    end do
  end function

end module
