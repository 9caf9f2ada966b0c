! SPDX-License-Identifier: GPL-3.0-or-later
! Still water that rises before the upper cracked dam (cases/cracked-dam-upper): a whole fluid on the kit.
! The level is that of the case: 21.702 m at the start, 22.302 m at 6 s. It presses on the face at x = 0.
program upper_dam
  use, intrinsic :: iso_c_binding, only: dp => c_double, c_int
  use, intrinsic :: iso_fortran_env, only: error_unit
  use blockweir_fluid
  implicit none
  real(dp), parameter :: weight = 1000 * 9.81_dp  ! of water [N/m3]
  integer, parameter :: most = 16  ! panels
  type(fluid_line) :: fluid
  integer :: block(most), edge(most), n, b, e, next
  integer(c_int) :: status
  real(dp), dimension(most) :: s_from, s_to, from_pa, to_pa
  real(dp), allocatable :: now(:, :)
  real(dp), pointer :: drawn(:, :)
  real(dp) :: level, y_from, y_to

  call fluid%open("rising water in Fortran")
  do while (fluid%receive() == blockweir_motion_due)
    level = 21.702_dp + (22.302_dp - 21.702_dp) * min(fluid%time_s / 6, 1.0_dp)
    n = 0
    do b = 1, fluid%blocks()
      drawn => fluid%outline(b)
      now = fluid%place(b)
      do e = 1, size(now, 2)
        next = mod(e, size(now, 2)) + 1
        if (drawn(1, e) /= 0 .or. drawn(1, next) /= 0 .or. n == most) cycle
        n = n + 1
        y_from = now(2, e)  ! downwards, as outlines run counter-clockwise
        y_to = now(2, next)
        block(n) = b
        edge(n) = e
        s_from(n) = min(max((y_from - level) / (y_from - y_to), 0.0_dp), 1.0_dp)
        s_to(n) = 1
        from_pa(n) = weight * max(level - y_from, 0.0_dp)
        to_pa(n) = weight * max(level - y_to, 0.0_dp)
      end do
    end do
    status = fluid%send(block(:n), edge(:n), s_from(:n), s_to(:n), from_pa(:n), to_pa(:n), upstream_level_m=level)
  end do
  if (len(fluid%error()) > 0) write (error_unit, '(2a)') "upper_dam: ", fluid%error()
  if (fluid%close() /= 0) stop 1
end program
